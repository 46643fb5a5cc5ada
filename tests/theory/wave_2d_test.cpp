// Tests of theory/exact/wave_2d.hpp: each limit against a numerical solution by
// the simplest solver, within the range that its header states.
#include "theory/exact/wave_2d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "tests/theory/plain_contact.hpp"

namespace asperity::theory::wave_2d_test {

using std::numbers::pi;

constexpr double amplitude = 0.5, modulus = 3.0; // lambda = 1
const Wave2dContact wave(amplitude, 1.0, modulus);

// The crests lie between nodes so that the symmetry of the grid does not reduce
// the error.
PlainContact numerical(double ratio, int points) {
  const Grid grid{points, points, 1.0, 1.0};
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix)
      heights[grid.index(ix, iy)] = amplitude *
                                    std::cos(2.0 * pi * (ix + 0.3) / points) *
                                    std::cos(2.0 * pi * (iy + 0.17) / points);
  return press(grid, heights, modulus, ratio * wave.full_contact_pressure(),
               120);
}

// The error of a counted area is about 0.1 contact perimeter times spacing;
// this is for n round spots or holes of radius r in the unit cell, doubled.
double counting_error(int n_spots, double area, int points) {
  const double radius = std::sqrt(area / (n_spots * pi));
  return 2.0 * 0.1 * n_spots * 2.0 * pi * radius / points;
}

// The error of light_mean_gap is 0.6 to 0.7 D P^{4/3}, the fourth order of the
// crest. (Without the contribution of the neighbours it would be D P.)
TEST(Wave2dLight, MeanGapHasTheStatedError) {
  for (const double ratio : {0.003, 0.01, 0.03}) {
    const double pressure = ratio * wave.full_contact_pressure();

    const double error =
        numerical(ratio, 64).mean_gap - wave.light_mean_gap(pressure);

    const double scaled = error / (amplitude * std::pow(ratio, 4.0 / 3.0));
    EXPECT_GT(scaled, 0.55) << "P = " << ratio;
    EXPECT_LT(scaled, 0.72) << "P = " << ratio;
  }
}

// light_area_fraction is too small by at most a relative 0.8 P^{2/3}.
TEST(Wave2dLight, AreaHasTheStatedError) {
  const int points = 128;
  for (const double ratio : {0.01, 0.03, 0.1}) {
    const double limit =
        wave.light_area_fraction(ratio * wave.full_contact_pressure());
    const double area = numerical(ratio, points).area_fraction;

    const double counting = counting_error(2, limit, points);
    EXPECT_GT(area, limit - counting) << "P = " << ratio;
    EXPECT_LT(area, limit * (1.0 + 0.8 * std::pow(ratio, 2.0 / 3.0)) + counting)
        << "P = " << ratio;
  }
}

// heavy_mean_gap is too small by a relative 0.3 to 0.5 times (1 - P). At 128
// points the numerical gap has a relative error of 0.002.
TEST(Wave2dHeavy, MeanGapHasTheStatedError) {
  for (const double ratio : {0.7, 0.8, 0.9, 0.95}) {
    const double limit =
        wave.heavy_mean_gap(ratio * wave.full_contact_pressure());
    const double gap = numerical(ratio, 128).mean_gap;

    const double resolution = 0.002;
    EXPECT_GT(gap / limit, 1.0 + 0.3 * (1.0 - ratio) - resolution)
        << "P = " << ratio;
    EXPECT_LT(gap / limit, 1.0 + 0.5 * (1.0 - ratio) + resolution)
        << "P = " << ratio;
  }
}

// 1 - heavy_area_fraction is too small by at most a relative 0.5 (1 - P).
TEST(Wave2dHeavy, AreaHasTheStatedError) {
  const int points = 128;
  for (const double ratio : {0.7, 0.9}) {
    const double limit =
        1.0 - wave.heavy_area_fraction(ratio * wave.full_contact_pressure());
    const double open = 1.0 - numerical(ratio, points).area_fraction;

    const double counting = counting_error(2, limit, points);
    EXPECT_GT(open, limit - counting) << "P = " << ratio;
    EXPECT_LT(open, limit * (1.0 + 0.5 * (1.0 - ratio)) + counting)
        << "P = " << ratio;
  }
}

// Full contact begins at p* and its energy is (1/2) mean of p u over the cell.
// Reference: the mean of products of the fields on a grid, which is exact for
// them.
TEST(Wave2dFull, HasTheEnergyOfItsFields) {
  const double full = wave.full_contact_pressure();
  const int points = 16;
  double mean = 0.0;
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix) {
      const double shape =
          std::cos(2.0 * pi * ix / points) * std::cos(2.0 * pi * iy / points);
      mean += 0.5 * full * shape * amplitude * shape / (points * points);
    }

  EXPECT_NEAR(wave.full_contact_energy() / mean, 1.0, 1e-14);
  EXPECT_EQ(wave.heavy_area_fraction(full), 1.0);
  EXPECT_EQ(wave.heavy_mean_gap(full), 0.0);
}

TEST(Wave2dInput, RefusesBadArguments) {
  EXPECT_THROW(wave.light_mean_gap(-1.0), std::domain_error);
  EXPECT_THROW(wave.heavy_mean_gap(-1.0), std::domain_error);
  EXPECT_THROW(Wave2dContact(0.0, 1.0, 1.0), std::domain_error);
  EXPECT_THROW(Wave2dContact(1.0, 0.0, 1.0), std::domain_error);
  EXPECT_THROW(Wave2dContact(1.0, 1.0, 0.0), std::domain_error);
}

} // namespace asperity::theory::wave_2d_test
