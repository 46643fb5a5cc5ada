#pragma once

// What the keys of a case are set to, as the file has them: for what varies a
// case without knowing what its keys mean.

#include "cases/text/node.hpp"
#include "cases/types/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::app {

class CaseValues {
public:
  explicit CaseValues(const cases::Case& contact_case);

  /// The value of a key of a table, "fem.hard" and "growth": the table's own,
  /// else that of the table it is a variant of, else the vocabulary's default.
  std::optional<cases::Node> value(const std::string& table,
                                   const std::string& key) const;

  /// True if the table itself sets the key.
  bool is_set(const std::string& table, const std::string& key) const;

  /// Overrides that write every length of the file which is given in node
  /// spacings ("8 h") in metres, at the case's own spacing: another number of
  /// points then leaves surface and block what they are.
  std::vector<std::string> without_spacings(double spacing) const;

private:
  cases::Node file_;
};

/// "fem" of "fem.hard".
std::string kind_of_method(const std::string& name);

/// The value multiplied, its unit kept, as an override writes it; empty if it
/// is no number and no quantity.
std::string scaled_value(const cases::Node& value, double factor);

/// The number before any unit; NaN if there is none.
double leading_number(const cases::Node& value);

} // namespace asperity::app
