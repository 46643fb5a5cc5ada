#include "md/interface/interaction.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::md {

void require_interaction(const Interaction& interaction) {
  require_positive("energy", interaction.energy, "J");
  require_positive("distance", interaction.distance, "m");
  require_positive("taper_begin", interaction.taper_begin, "m");
  require_positive("cutoff", interaction.cutoff, "m");
  require_between("attraction", interaction.attraction, 0.0, 1.0, "1");
  if (interaction.cutoff <= interaction.taper_begin)
    refuse_argument("cutoff", interaction.cutoff,
                    fmt::format("> taper_begin = {} m",
                                number_text(interaction.taper_begin)));
}

PairTerm pair_term(const Interaction& interaction, double distance) {
  require_interaction(interaction);
  require_positive("distance", distance, "m");
  const auto sixth_power = [&](double r) {
    return std::pow(interaction.distance / r, 6);
  };
  const double y = sixth_power(distance);
  const double y_begin = sixth_power(interaction.taper_begin);
  const double y_end = sixth_power(interaction.cutoff);
  if (y <= y_end)
    return {};

  const double width = y_begin - y_end;
  const double full = y_begin - interaction.attraction;
  double steepness = y - interaction.attraction; // derivative of U/2 with
                                                 // respect to y
  double energy = 0.0;
  if (y < y_begin) {
    const double t = (y - y_end) / width;
    steepness = t * t * ((3.0 - 2.0 * t) * full - (1.0 - t) * width);
    energy = 2.0 * width * t * t * t *
             ((1.0 - 0.5 * t) * full - (1.0 / 3.0 - 0.25 * t) * width);
  } else
    energy = width * (full - width / 6.0) +
             (y - y_begin) * (y + y_begin - 2.0 * interaction.attraction);
  return {interaction.energy * energy,
          12.0 * interaction.energy * y * steepness / (distance * distance)};
}

} // namespace asperity::md
