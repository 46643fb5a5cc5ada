#include "surfaces/analysis/contact_fitness.hpp"

#include "base/shown_number.hpp"

#include <fmt/format.h>

#include <numbers>

namespace asperity::surfaces {
namespace {

/// Mean square height or slope of a ring.
double fitness_weight(const SpectrumRing& ring, bool is_slope) {
  return ring.mean_square_height *
         (is_slope ? ring.wavevector * ring.wavevector : 1.0);
}

/// The wavelength of the ring at which the sum from the longest wave reaches a
/// share of the whole [m].
double wavelength_at(const std::vector<SpectrumRing>& rings, bool is_slope,
                     double share) {
  double whole = 0.0, sum = 0.0;
  for (const SpectrumRing& ring : rings)
    whole += fitness_weight(ring, is_slope);
  for (const SpectrumRing& ring : rings)
    if (sum += fitness_weight(ring, is_slope);
        sum >= share * whole && ring.wavevector > 0.0)
      return 2.0 * std::numbers::pi / ring.wavevector;
  return 0.0;
}

} // namespace

ContactFitness contact_fitness(const std::vector<SpectrumRing>& rings,
                               std::optional<double> noise, double spacing,
                               double side) {
  ContactFitness fitness;
  double whole = 0.0, beyond = 0.0;
  for (const SpectrumRing& ring : rings) {
    const double square = fitness_weight(ring, true);
    whole += square;
    beyond += noise && ring.wavevector > *noise ? square : 0.0;
  }
  fitness.noise_share = whole > 0.0 ? beyond / whole : 0.0;
  fitness.points_per_wave = wavelength_at(rings, true, 0.4) / spacing;
  if (const double longest = wavelength_at(rings, false, 0.5); longest > 0.0)
    fitness.waves_per_scan = side / longest;
  return fitness;
}

std::string fitness_sentence(const ContactFitness& fitness) {
  const bool area = fitness.serves_area();
  const bool gap = fitness.serves_gap();
  const auto needs = [](bool is_met, double limit) {
    return is_met ? std::string() : fmt::format(", and {:g} are needed", limit);
  };
  return fmt::format(
      "The map is good enough {} (noise has {} % of the slope{}; {} points per "
      "steep wave{}; {} high waves per scan{}).",
      area && gap ? "for contact area and mean gap"
      : area      ? "for the contact area, but not for the mean gap of other "
                    "places"
      : gap       ? "for the mean gap, but not for the contact area"
            : "neither for the contact area nor for the mean gap of other "
              "places",
      digits_text(100.0 * fitness.noise_share, 2),
      fitness.noise_share <= ContactFitness::most_noise
          ? ""
          : ", and at most 20 % are allowed",
      digits_text(fitness.points_per_wave, 2),
      needs(fitness.points_per_wave >= ContactFitness::least_points,
            ContactFitness::least_points),
      digits_text(fitness.waves_per_scan, 2),
      needs(fitness.waves_per_scan >= ContactFitness::least_waves,
            ContactFitness::least_waves));
}

} // namespace asperity::surfaces
