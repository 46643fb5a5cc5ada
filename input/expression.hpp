#pragma once

// A formula of the user as a function of x, y and z. Encapsulates the parser.

#include <array>
#include <memory>
#include <string>

namespace asperity::input {

/// A muParser expression in x, y and z, with the constant `pi`. Copies share
/// one parser, so the class is not thread-safe.
class Expression {
public:
  /// Parses a formula.
  ///
  /// @throws std::domain_error  with the message of the parser and the column
  explicit Expression(const std::string& text);

  /// Evaluates the formula at a point.
  ///
  /// @throws std::domain_error  as for the constructor
  double at(const std::array<double, 3>& place) const;

private:
  struct Bound;
  std::shared_ptr<Bound> bound_;
};

} // namespace asperity::input
