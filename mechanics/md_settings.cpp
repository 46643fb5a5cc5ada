#include "mechanics/md_settings.hpp"

#include "base/require.hpp"

#include <cmath>
#include <numbers>

namespace asperity::mechanics {

int incommensurate_atoms(int layer_atoms) {
  require_positive("layer_atoms", layer_atoms, "1");
  return 2 *
         static_cast<int>(std::lround(0.5 * std::numbers::phi * layer_atoms));
}

std::optional<ContactInterface> MdSettings::flat_law(double length,
                                                     int points) const {
  if (!is_adhesive())
    return std::nullopt;
  const int side = atoms.value_or(points);
  const double density =
      side / length *
      (substrate_atoms.value_or(incommensurate_atoms(side)) / length);
  ContactInterface law{ContactLaw::lennard_jones_layers};
  law.work_of_adhesion = 0.6 * std::cbrt(4.0) * std::numbers::pi *
                         interaction_energy *
                         std::pow(density * interaction_distance, 2);
  law.adhesion_range = interaction_distance / std::pow(2.0, 1.0 / 6.0);
  return law;
}

} // namespace asperity::mechanics
