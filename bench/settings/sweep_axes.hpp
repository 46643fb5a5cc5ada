#pragma once

// The keys of a method that trade cost for error, and the values a benchmark
// gives them. Internal to the sweep.

#include <limits>
#include <string>
#include <vector>

#include "bench/settings/case_values.hpp"

namespace asperity::app {

/// One value of a key. The coordinate falls to 0 towards the limit; NaN where
/// the key is a word or the approach has no order.
struct AxisValue {
  std::string text; ///< as an override has it
  double coordinate = std::numeric_limits<double>::quiet_NaN();
  bool is_own = false;
};

/// Coarse to fine.
struct Axis {
  std::string key;
  std::string title;
  std::vector<AxisValue> values;
  double order = std::numeric_limits<double>::quiet_NaN(); ///< theoretical, of
                                                           ///< gap and energy
  std::string source; ///< where the order is from, or why there is none
};

/// The axes of a method: every one whose key its vocabulary has and that acts
/// with the method's other settings, the case's own value among its values.
std::vector<Axis> axes_of(const CaseValues& values, const std::string& method);

/// True if the answer of that kind of method has a limit in the points of the
/// surface: not the theory's, and not that of atoms, whose lattice is what it
/// is.
bool varies_with_points(const std::string& kind);

} // namespace asperity::app
