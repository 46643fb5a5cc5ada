// Whether a map is good enough for contact: each number has its limit, and
// alone decides on its question.
#include "surfaces/analysis/contact_fitness.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace asperity::surfaces {
namespace {

constexpr double spacing = 1e-8, side = 1e-6;

double waves(double wavelength) {
  return 2.0 * std::numbers::pi / wavelength;
}

/// Two waves: one with the height, one with the slope.
std::vector<SpectrumRing> two_waves(double high, double steep) {
  const auto ring = [](double wavelength, double height) {
    return SpectrumRing{.wavevector = waves(wavelength),
                        .density = 1.0,
                        .degrees_of_freedom = 2.0,
                        .mean_square_height = height};
  };
  return {ring(high, 1.0), ring(steep, 0.3)};
}

TEST(ContactFitness, CountsPointsAndWaves) {
  const ContactFitness fitness =
      contact_fitness(two_waves(side / 5.0, 6.0 * spacing), {}, spacing, side);
  EXPECT_NEAR(fitness.waves_per_scan, 5.0, 1e-12);
  EXPECT_NEAR(fitness.points_per_wave, 6.0, 1e-12);
  EXPECT_EQ(fitness.noise_share, 0.0);
  EXPECT_TRUE(fitness.serves_area());
  EXPECT_TRUE(fitness.serves_gap());
  EXPECT_EQ(fitness_sentence(fitness),
            "The map is good enough for contact area and mean gap (noise has 0 "
            "% of the slope; 6 points per steep wave; 5 high waves per scan).");
}

TEST(ContactFitness, RefusesTheAreaForNoiseAndForFewPoints) {
  const auto noisy = contact_fitness(two_waves(side / 5.0, 6.0 * spacing),
                                     waves(10.0 * spacing), spacing, side);
  EXPECT_GT(noisy.noise_share, 0.2);
  EXPECT_FALSE(noisy.serves_area());
  EXPECT_TRUE(noisy.serves_gap());
  const auto coarse =
      contact_fitness(two_waves(side / 5.0, 3.0 * spacing), {}, spacing, side);
  EXPECT_FALSE(coarse.serves_area());
  EXPECT_NE(fitness_sentence(coarse).find(
                "for the mean gap, but not for the contact area"),
            std::string::npos);
  EXPECT_NE(fitness_sentence(coarse).find(
                "3 points per steep wave, and 4 are needed"),
            std::string::npos);
}

TEST(ContactFitness, RefusesTheGapForFewLongWaves) {
  const auto small =
      contact_fitness(two_waves(side / 2.0, 6.0 * spacing), {}, spacing, side);
  EXPECT_TRUE(small.serves_area());
  EXPECT_FALSE(small.serves_gap());
}

} // namespace
} // namespace asperity::surfaces
