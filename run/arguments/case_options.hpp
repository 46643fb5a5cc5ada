#pragma once

// The values that a command line gives to the options that stand for keys of a
// case (input/case_options.hpp), as entries of the case.

#include "input/case_options.hpp"
#include "input/refusals.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::run {

/// What is run with the options.
struct AskedOf {
  bool are_maps = false;       ///< cases that the program makes for maps
  bool has_free_edges = false; ///< only loads by pressure can be prescribed
  /// Only the options of this group are read.
  std::optional<input::OptionGroup> group = {};
};

/// The values that a user gives to the options.
class CaseOptions {
public:
  /// Where the value of an option is stored, at a stable address.
  std::string& place(std::string_view name);
  /// The value of an option; "" if it is not given.
  std::string value(std::string_view name) const;

  bool has(std::string_view name) const { return !value(name).empty(); }

  bool empty() const; ///< no option is given

  /// Returns the entries "key.path=value" of a case that the options stand for.
  /// Where a case has another key for the same thing, it is removed.
  /// @param refusals  of options without an entry: an unknown fluid, a range of
  ///                  pressures without two ends, a word that is no number; and
  ///                  --friction with adhesion or hardness
  std::vector<std::string> overrides(const AskedOf& asked,
                                     input::Refusals& refusals) const;

  /// The words of a command line that give the same options.
  std::vector<std::string> words() const;

  /// Names the option in the place of the key in each line of a refusal by the
  /// reader of cases, if the option was given. A mistake that the line before
  /// states is left out, and so is that the key of such an option is missing:
  /// it was refused.
  /// @param has_hints  add to what is missing the option that gives it
  std::string with_options(const std::string& refusal, bool has_hints) const;

private:
  std::map<std::string, std::string, std::less<>> values_;
};

/// A fluid flows through the gap, under a pressure drop of 100 kPa.
/// @param fluid  one of studies::named_fluids, or a viscosity, "0.1 Pa s"
/// @throws input::InputError  it is none of them
std::vector<std::string> flow_overrides(const std::string& fluid);

/// Returns pressures up to 0.3 E* h' and back, and on to tensions at which
/// faces part, as a list in TOML.
/// @param scale  of the pressures in the place of E* h' of each map, rounded to
///               two digits [Pa] > 0
std::string adhesive_loads(std::optional<double> scale);

/// Returns loads that are easy to read, from the largest below `low` to the
/// smallest above `high`, as a list in TOML: ["10 kPa", "15 kPa", ...]. They
/// are 1, 1.5, 2, 3, 5 and 7 times powers of ten, or for more than 2.6 decades
/// 1, 2 and 5 times.
/// @param low, high  [Pa], 0 < low < high
/// @param highest    [Pa], which no load exceeds
std::string round_loads(double low, double high, double highest);

} // namespace asperity::run
