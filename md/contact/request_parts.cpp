#include "md/contact/request_parts.hpp"

namespace asperity::md {

Crystal crystal_of(const AtomRequest& request) {
  return {request.settings.lattice, request.layer.spacing_x(),
          request.youngs_modulus, request.poisson_ratio};
}

Interaction interaction_of(const mechanics::MdSettings& settings) {
  Interaction interaction;
  interaction.energy = settings.interaction_energy;
  interaction.distance = settings.interaction_distance;
  interaction.cutoff = settings.cutoff;
  interaction.taper_begin = 0.9 * settings.cutoff;
  interaction.attraction =
      settings.potential == mechanics::AtomPotential::lennard_jones ? 1.0 : 0.0;
  return interaction;
}

double close_distance(const mechanics::MdSettings& settings) {
  return 2.2 / 3.28 * settings.interaction_distance;
}

} // namespace asperity::md
