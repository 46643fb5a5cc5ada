// Tests of surfaces/maps/resample.hpp.
#include "surfaces/maps/resample.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/realization.hpp"
#include "tests/base/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace asperity::surfaces::resample_test {

constexpr double length_x = 3.0;
constexpr double length_y = 2.0;

Grid grid_of(int points_x, int points_y) {
  return {points_x, points_y, length_x, length_y};
}

/// White noise in every mode, including the Nyquist rows.
HeightMap noise(int points_x, int points_y) {
  HeightMap map{grid_of(points_x, points_y), {}};
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (std::size_t i = 0; i < map.grid.size(); ++i)
    map.heights.push_back(number(generator));
  return map;
}

double largest_difference(const HeightMap& a, const HeightMap& b) {
  EXPECT_EQ(a.grid, b.grid);
  return tests::largest_difference(a.heights, b.heights);
}

double mean_square_difference(const HeightMap& a, const HeightMap& b) {
  EXPECT_EQ(a.grid, b.grid);
  if (a.heights.size() != b.heights.size())
    return NAN;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.heights.size(); ++i)
    sum += std::pow(a.heights[i] - b.heights[i], 2);
  return sum / static_cast<double>(a.heights.size());
}

/// The interpolation of a unit value at one of n nodes, at a fraction of the
/// period from it.
double cardinal(double part, int n) {
  const double angle = std::numbers::pi * part;
  if (std::abs(std::sin(angle)) < 1e-12)
    return 1.0;
  return std::sin(n * angle) /
         (n * (n % 2 == 0 ? std::tan(angle) : std::sin(angle)));
}

/// The interpolation in closed form, node by node.
HeightMap plain_interpolation(const HeightMap& map, const Grid& target) {
  HeightMap result{target, std::vector<double>(target.size())};
  const Grid& grid = map.grid;
  for (int ty = 0; ty < target.points_y; ++ty)
    for (int tx = 0; tx < target.points_x; ++tx)
      for (int iy = 0; iy < grid.points_y; ++iy)
        for (int ix = 0; ix < grid.points_x; ++ix)
          result.heights[target.index(tx, ty)] +=
              map.heights[grid.index(ix, iy)] *
              cardinal(double(tx) / target.points_x -
                           double(ix) / grid.points_x,
                       grid.points_x) *
              cardinal(double(ty) / target.points_y -
                           double(iy) / grid.points_y,
                       grid.points_y);
  return result;
}

struct Sides {
  int from_x, from_y, to_x, to_y;
};

class ResampleFiner : public ::testing::TestWithParam<Sides> {};

// On a finer grid, nested or not, odd or even, the result is the trigonometric
// interpolation, including the Nyquist rows, and nothing is dropped. Tolerance:
// a sum of 200 terms of order one, 200 eps.
TEST_P(ResampleFiner, IsTheInterpolationOfTheNodes) {
  const Sides sides = GetParam();
  const HeightMap map = noise(sides.from_x, sides.from_y);
  const Grid target = grid_of(sides.to_x, sides.to_y);

  const Resampled finer = resample(map, target);

  EXPECT_LT(largest_difference(finer.map, plain_interpolation(map, target)),
            5e-14);
  EXPECT_EQ(finer.dropped, 0.0);
}

// Resampling on a finer grid and back gives the same map. Tolerance: four
// transforms, 1e-15 each.
TEST_P(ResampleFiner, IsInvertedByResamplingBack) {
  const Sides sides = GetParam();
  const HeightMap map = noise(sides.from_x, sides.from_y);

  const Resampled back =
      resample(resample(map, grid_of(sides.to_x, sides.to_y)).map, map.grid);

  EXPECT_LT(largest_difference(back.map, map), 1e-14);
  EXPECT_LT(back.dropped, 1e-28);
}

INSTANTIATE_TEST_SUITE_P(
    Sides, ResampleFiner,
    ::testing::Values(Sides{8, 6, 16, 18}, Sides{8, 6, 10, 14},
                      Sides{8, 7, 9, 16}, Sides{5, 9, 12, 11},
                      Sides{8, 6, 8, 10}, Sides{12, 12, 18, 13}));

// What a coarser grid drops is the mean square of the difference of the two
// interpolations, computed on a grid that represents both and their squares.
// Tolerance: roundoff of a sum of 40^2 terms.
TEST(ResampleCoarser, ReportsHowMuchItDrops) {
  const HeightMap map = noise(12, 14);
  const Grid fine = grid_of(40, 40);
  for (const Grid& target : {grid_of(8, 14), grid_of(8, 8), grid_of(7, 10),
                             grid_of(16, 6), grid_of(12, 12)}) {
    const Resampled coarse = resample(map, target);

    const double difference = mean_square_difference(
        resample(map, fine).map, resample(coarse.map, fine).map);
    EXPECT_GT(coarse.dropped, 0.01);
    EXPECT_NEAR(coarse.dropped / difference, 1.0, 1e-12);
  }
}

TEST(Resample, LeavesAMapOnItsOwnGridAsItIs) {
  const HeightMap map = noise(8, 6);

  const Resampled same = resample(map, map.grid);

  EXPECT_EQ(same.map.heights, map.heights);
  EXPECT_EQ(same.dropped, 0.0);
}

IsotropicSpectrum rough_spectrum(double highest) {
  constexpr double unit = 2.0 * std::numbers::pi;
  IsotropicSpectrum spectrum = SelfAffineSpectrum::with_rms_height(
                                   {0.7, unit, 3.0 * unit, 20.0 * unit}, 1.0)
                                   .isotropic();
  spectrum.kinks.back() = highest * unit;
  spectrum.density = [=, whole = spectrum.density](double q) {
    return is_in_band(q, 0.0, highest * unit) ? whole(q) : 0.0;
  };
  return spectrum;
}

// A surface whose short waves are removed is the one that is realised without
// them. 13 is the |q| of (5, 12), which stays. Tolerance: as for two
// realisations.
TEST(LowPassed, LeavesTheLongWaves) {
  const Grid grid{64, 64, 1.0, 1.0};
  const HeightMap whole = realize(rough_spectrum(20.0), grid, {4, 0});

  const HeightMap long_waves = low_passed(whole, 13.0 * 2.0 * std::numbers::pi);

  EXPECT_LT(largest_difference(long_waves,
                               realize(rough_spectrum(13.0), grid, {4, 0})),
            1e-14);
  EXPECT_GT(largest_difference(long_waves, whole), 0.01);
}

TEST(LowPassed, LeavesTheMeanAloneAtZero) {
  const HeightMap map = noise(8, 6);

  const HeightMap flat = low_passed(map, 0.0);

  for (const double height : flat.heights)
    EXPECT_NEAR(height, mean_height(map), 1e-15);
  EXPECT_LT(largest_difference(low_passed(map, 1e9), map), 1e-14);
}

TEST(Resample, RefusesWhatIsNotTheSameRectangle) {
  const HeightMap map = noise(8, 6);

  EXPECT_THROW(resample(map, {8, 6, 3.0, 2.1}), std::domain_error);
  EXPECT_THROW(resample(map, {8, 6, 3.1, 2.0}), std::domain_error);
  EXPECT_THROW(resample(map, grid_of(0, 6)), std::domain_error);
  EXPECT_THROW(low_passed(map, -1.0), std::domain_error);
}

} // namespace asperity::surfaces::resample_test
