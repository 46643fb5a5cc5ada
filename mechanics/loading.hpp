#pragma once

// The load: which quantity is prescribed, one load step, and the loading path.

#include "mechanics/quantity.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace asperity::mechanics {

/// The quantity that a load step prescribes: p_0, the mean of the pressure, or
/// the mean gap.
enum class Control { nominal_pressure, mean_gap };

/// The prescribed quantity of one load step in SI units.
struct LoadTarget {
  Control control = Control::nominal_pressure;
  double amount = 0.0; ///< p_0 [Pa], > 0 without adhesion, or mean gap [m]
  /// k [Pa/m] > 0 of a spring through which a mean gap d is prescribed, p_0 =
  /// k (u - d) at the mean gap u; infinite without one. Of adhesion only.
  double spring = std::numeric_limits<double>::infinity();
};

/// [load]: the loading path as steps in the order in which they run. A cycle
/// "load-unload" is expanded; is_unloading[i] marks the unloading steps.
struct LoadingPath {
  Control control = Control::nominal_pressure;
  std::vector<Quantity> targets; ///< p_0 [Pa] or mean gap [m] per step
  std::vector<bool> is_unloading;
  std::optional<Quantity> spring; ///< LoadTarget::spring [Pa/m]
  bool may_be_tensile = false;    ///< whether p_0 <= 0 is allowed

  LoadTarget target(std::size_t step, const Scales& scales) const {
    LoadTarget own{control, targets[step].in_si(scales)};
    if (spring)
      own.spring = spring->in_si(scales);
    return own;
  }
};

} // namespace asperity::mechanics
