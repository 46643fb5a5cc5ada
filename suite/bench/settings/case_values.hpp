#pragma once

// Gives access to the values of the keys of a case as the file has them, for
// code that varies a case without knowing the meaning of its keys.

#include "input/text/node.hpp"
#include "input/types/case.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::bench {

class CaseValues {
public:
  explicit CaseValues(const cases::Case& contact_case);

  /// Returns the value of a key of a table, such as "fem.hard" and "growth":
  /// the value in the table itself, otherwise that of the table of which it is
  /// a variant, otherwise the default of the vocabulary.
  std::optional<cases::Node> value(const std::string& table,
                                   const std::string& key) const;

  /// True if the table itself sets the key.
  bool is_set(const std::string& table, const std::string& key) const;

  /// Returns overrides that convert every length of the file that is given in
  /// node spacings ("8 h") to metres, with the case's own spacing. Another
  /// number of points then does not change the surface and the block. Cell
  /// sizes in [mesh] keep to the spacing.
  std::vector<std::string> without_spacings(double spacing) const;

private:
  std::shared_ptr<const cases::Node> file_;
};

/// Returns the value multiplied by the factor, in its original unit, as an
/// override writes it; empty if it is neither a number nor a quantity.
std::string scaled_value(const cases::Node& value, double factor);

/// Returns the number before any unit; NaN if there is none.
double leading_number(const cases::Node& value);

} // namespace asperity::bench
