#pragma once

// A contact law for tests that add one to the list: a hard wall with an
// attraction that falls as a power of the gap.

#include "mechanics/contact_law.hpp"

#include <cmath>
#include <limits>

namespace asperity::tests {

/// W = -w (1 - g/rho)^power up to the gap rho [J/m^2], power >= 2, or a
/// derivative of it by the gap.
inline double power_energy(const mechanics::ContactInterface& own, double gap,
                           int power, int derivatives) {
  double factor = -own.work_of_adhesion;
  for (int i = 0; i < derivatives; ++i)
    factor *= (i - power) / own.adhesion_range;
  const double depth = 1.0 - gap / own.adhesion_range;
  return depth > 0.0 ? factor * std::pow(depth, power - derivatives) : 0.0;
}

/// @param share  of W' and W'' that the law states; 1 is right
template <int power, int share = 1>
mechanics::ContactLawTraits power_law(const char* name) {
  using Own = mechanics::ContactInterface;
  mechanics::ContactLawTraits law;
  law.name = name;
  law.words = "a hard wall with adhesion by a power";
  law.has_wall = true;
  law.surface_solver = mechanics::SurfaceSolver::adhesive;
  law.energy = [](const Own& own, double gap) {
    return power_energy(own, gap, power, 0);
  };
  law.pressure = [](const Own& own, double gap) {
    return -share * power_energy(own, gap, power, 1);
  };
  law.stiffness = [](const Own& own, double gap) {
    return share * power_energy(own, gap, power, 2);
  };
  law.pressure_bounds = [](const Own& own) {
    return mechanics::PressureBounds{own.pressure(0.0),
                                     std::numeric_limits<double>::infinity()};
  };
  law.range = [](const Own& own) { return own.adhesion_range; };
  law.least_gap = law.strongest_gap = [](const Own&) { return 0.0; };
  return law;
}

} // namespace asperity::tests
