#pragma once

// A formula of a case file, in x, y and z. Owns the parser.

#include <array>
#include <memory>
#include <string>

namespace asperity::cases {

/// A muParser expression in x, y and z; `pi` is known too. Copies share one
/// parser: not for several threads at once.
class Expression {
public:
  /// @throws std::domain_error  the parser's own message and the column
  explicit Expression(const std::string& text);

  /// @throws std::domain_error  as the constructor
  double at(const std::array<double, 3>& place) const;

private:
  struct Bound;
  std::shared_ptr<Bound> bound_;
};

} // namespace asperity::cases
