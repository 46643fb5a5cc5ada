#pragma once

// The keys of a method that trade cost for error, and the values that a
// benchmark assigns to them. It is internal to the plan.

#include "suite/bench/settings/case_values.hpp"

#include <limits>
#include <string>
#include <vector>

namespace asperity::bench {

/// One value of a key. The coordinate decreases to 0 towards the limit; it is
/// NaN if the key is a keyword or convergence has no order.
struct AxisValue {
  std::string text; ///< as in an override
  double coordinate = std::numeric_limits<double>::quiet_NaN();
  bool is_own = false;
};

/// An axis, with values from coarse to fine.
struct Axis {
  std::string key;
  std::string title;
  std::vector<AxisValue> values;
  /// Theoretical order of gap and energy.
  double order = std::numeric_limits<double>::quiet_NaN();
  std::string source; ///< source of the order, or why there is none
};

/// Returns the axes of a method: those whose key is in its vocabulary and has
/// an effect with the method's other settings. The case's own value is among
/// the values.
std::vector<Axis> axes_of(const CaseValues& values, const std::string& method);

/// True if the results of that kind of method converge with the number of
/// points of the surface. Those of the theory do not, nor do those of atoms,
/// whose lattice is fixed.
bool varies_with_points(const std::string& kind);

} // namespace asperity::bench
