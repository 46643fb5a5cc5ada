#include "theory/persson/leakage.hpp"

#include "base/require.hpp"

#include <cmath>
#include <numbers>

namespace asperity::theory {

Leak leakage(const MagnifiedContact& contact, const Fluid& fluid,
             double pressure_drop, double critical_area) {
  require_not_negative("density", fluid.density, "kg/m^3");
  require_positive("viscosity", fluid.viscosity, "Pa s");
  require_not_negative("pressure_drop", pressure_drop, "Pa");
  const std::optional<double> found =
      contact.magnification_of_area(critical_area);
  if (!found)
    return {};
  const double before = *found * (1.0 - 1e-9); // closer than any other shell
  Leak leak;
  leak.percolates = true;
  leak.magnification = *found;
  leak.pore_size = 2.0 * std::numbers::pi * contact.lowest_magnification() /
                   (*found * contact.contact().spectrum().wavevector_low());
  leak.pore_gap = contact.contact().spectrum().has_density()
                      ? contact.opening_gap(*found)
                      : contact.opening_gap(before, *found);
  leak.mass_flow = fluid.density * std::pow(leak.pore_gap, 3) * pressure_drop /
                   (12.0 * fluid.viscosity);
  return leak;
}

} // namespace asperity::theory
