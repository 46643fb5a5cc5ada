// Tests of the surface between the points of a map: what each interpolation is
// exact for, its error on an unresolved map, and that the block uses it.
#include "fem/solution/height_interpolation.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity::fem::height_interpolation_test {

using mechanics::HeightInterpolation;

constexpr double length = 1e-6; // m

std::vector<SurfacePlace> random_places(std::size_t count) {
  const std::vector<double> numbers = random_field(2 * count, 3);
  std::vector<SurfacePlace> places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back({length * numbers[2 * i], length * numbers[2 * i + 1]});
  return places;
}

template <typename Heights>
std::vector<double> map_of(const Grid& grid, const Heights& heights) {
  std::vector<double> map(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      map[grid.index(ix, iy)] =
          heights(ix * grid.spacing_x(), iy * grid.spacing_y());
  return map;
}

/// The largest error at random places.
template <typename Heights>
double error_of(const Grid& grid, const Heights& heights,
                HeightInterpolation between,
                const std::vector<SurfacePlace>& places = random_places(200)) {
  const std::vector<double> found =
      interpolated(grid, map_of(grid, heights), between, places);
  std::vector<double> expected;
  for (const SurfacePlace& place : places)
    expected.push_back(heights(place[0], place[1]));
  return largest_difference(found, expected);
}

/// A wave with these numbers of periods per side.
auto wave(int periods_x, int periods_y) {
  return [=](double x, double y) {
    return std::cos(2.0 * std::numbers::pi * (periods_x * x + periods_y * y) /
                        length +
                    0.7);
  };
}

// Every wave longer than two spacings is exact to the rounding of a sum of 20
// products of weights below 1, also on grids with an odd number of points.
TEST(BandLimitedHeights, AreExactForSineWaves) {
  for (const Grid& grid :
       {Grid{16, 20, length, length}, Grid{15, 21, length, length}})
    for (const auto& [x, y] : {std::pair{1, 0}, {3, -2}, {7, 9}})
      EXPECT_LT(error_of(grid, wave(x, y), HeightInterpolation::band_limited),
                1e-13);
}

// The wave of two spacings is a cosine through its nodes.
TEST(BandLimitedHeights, TakeTheShortestWaveAsCosine) {
  const Grid grid{16, 16, length, length};
  const auto shortest = [](double x, double) {
    return std::cos(16.0 * std::numbers::pi * x / length);
  };

  EXPECT_LT(error_of(grid, shortest, HeightInterpolation::band_limited), 1e-13);
}

// A bilinear function is exact between the nodes of the map, which is periodic:
// the last cell of each direction joins the last node to the first.
TEST(BilinearHeights, AreExactForABilinearFunction) {
  const Grid grid{16, 20, length, length};
  const auto plane = [](double x, double y) {
    return 0.3 + 2.0 * x / length - y / length + 1.7 * x * y / length / length;
  };
  std::vector<SurfacePlace> inside;
  for (SurfacePlace place : random_places(200))
    inside.push_back({place[0] * 15.0 / 16.0, place[1] * 19.0 / 20.0});

  EXPECT_LT(error_of(grid, plane, HeightInterpolation::bilinear, inside),
            1e-14);
  EXPECT_GT(error_of(grid, plane, HeightInterpolation::band_limited, inside),
            0.1);
}

// All are exact at the nodes, and at the nodes of the neighbouring periods.
TEST(InterpolatedHeights, AreThoseOfTheMapAtItsNodes) {
  const Grid grid{8, 6, length, length};
  const std::vector<double> map = random_field(grid.size(), 1);
  for (const auto between :
       {HeightInterpolation::bicubic, HeightInterpolation::band_limited,
        HeightInterpolation::bilinear})
    for (const double periods : {-1.0, 0.0, 1.0}) {
      const std::vector<double> found = interpolated(
          grid, map, between,
          std::vector<SurfacePlace>{{3 * grid.spacing_x() + periods * length,
                                     5 * grid.spacing_y() - periods * length}});
      EXPECT_NEAR(found[0], map[grid.index(3, 5)], 1e-13);
    }
}

// The error of a wave falls with the points per wavelength: in the middle of
// two nodes, where it is largest, a bilinear crest is low by 1 - cos(pi/n), and
// bicubic weights (-1, 9, 9, -1)/16 give (9 cos(pi/n) - cos(3 pi/n))/8.
TEST(InterpolatedHeights, HaveTheErrorOfTheirOrder) {
  for (const int points : {4, 8, 16}) {
    const Grid grid{4 * points, 4, length, length};
    const double angle = std::numbers::pi / points;
    const std::vector<SurfacePlace> crest{
        {length / 4.0 + 0.5 * grid.spacing_x(), 0.0}};
    const auto crested = [&](double x, double) {
      return std::cos(2.0 * angle * (x - crest[0][0]) / grid.spacing_x());
    };
    const auto error = [&](HeightInterpolation between) {
      return error_of(grid, crested, between, crest);
    };

    EXPECT_NEAR(error(HeightInterpolation::bilinear), 1.0 - std::cos(angle),
                1e-13);
    EXPECT_NEAR(error(HeightInterpolation::bicubic),
                1.0 - (9.0 * std::cos(angle) - std::cos(3.0 * angle)) / 8.0,
                1e-13);
    EXPECT_NEAR(error(HeightInterpolation::band_limited), 0.0, 1e-13);
  }
}

/// Error between the points of every eighth point of a self-affine surface of
/// 256 points per side (H = 0.8), rms over rms height.
/// @param points_a_wave  of the coarse map, on the shortest wave of the surface
double error_of_map(double points_a_wave, HeightInterpolation between) {
  const double unit = 2.0 * std::numbers::pi / length;
  const Grid fine{256, 256, length, length};
  const Grid coarse{32, 32, length, length};
  const surfaces::SelfAffineShape shape{0.8, unit, 2.0 * unit,
                                        32.0 / points_a_wave * unit};
  const std::vector<double> heights =
      surfaces::realize(
          surfaces::SelfAffineSpectrum::with_rms_slope(shape, 0.1).isotropic(),
          fine, {7, 0})
          .heights;
  std::vector<double> map;
  std::vector<SurfacePlace> places;
  double square = 0.0;
  for (int iy = 0; iy < 256; ++iy)
    for (int ix = 0; ix < 256; ++ix) {
      places.push_back({ix * fine.spacing_x(), iy * fine.spacing_y()});
      square += std::pow(heights[fine.index(ix, iy)], 2);
      if (ix % 8 == 0 && iy % 8 == 0)
        map.push_back(heights[fine.index(ix, iy)]);
    }
  const std::vector<double> found = interpolated(coarse, map, between, places);
  double error = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i)
    error += std::pow(found[i] - heights[i], 2);
  return std::sqrt(error / square);
}

// What docs/numerics/full-block.md states: a resolved map is exact only if it
// is band-limited; of a map that does not resolve the surface, all
// interpolations miss about the same.
TEST(InterpolatedHeights, MissWhatTheMapDoesNotResolve) {
  for (const double points : {8.0, 4.0, 2.5, 1.0, 0.5}) {
    const double waves =
        error_of_map(points, HeightInterpolation::band_limited);
    const double cubic = error_of_map(points, HeightInterpolation::bicubic);
    const double linear = error_of_map(points, HeightInterpolation::bilinear);
    RecordProperty("error " + std::to_string(points),
                   std::to_string(waves) + " " + std::to_string(cubic) + " " +
                       std::to_string(linear));
    if (points > 2.0) {
      EXPECT_LT(waves, 1e-12) << points;
      EXPECT_LT(cubic, 0.5 * linear) << points;
    } else {
      EXPECT_GT(waves, 0.1) << points;
      EXPECT_LT(std::abs(cubic / waves - 1.0), 0.2) << points;
      EXPECT_LT(std::abs(linear / waves - 1.0), 0.2) << points;
    }
  }
}

// The block evaluates the heights of its Gauss points in this way: a flat
// block in full contact with a soft penalty k follows heights h with the
// pressure k h about its mean, to the compliance of the block, and the gap
// between the nodes does not enter. On a wave of four points, the mean square
// of the pressure at Gauss points differs between the interpolations.
TEST(InterpolatedHeights, AreThoseOfTheContactPoints) {
  const Grid grid{8, 8, length, length};
  const std::vector<double> heights = wave_heights(grid, 1e-9, 2);
  std::vector<double> gaps;
  for (const auto between :
       {HeightInterpolation::bicubic, HeightInterpolation::band_limited,
        HeightInterpolation::bilinear}) {
    BlockProblem problem = boxes_problem(grid, 1, {soft_modulus, 0.3}, length);
    problem.contact_at = mechanics::ContactPoints::gauss;
    problem.height_interpolation = between;
    const double penalty = 1e-6 * soft_modulus / length;
    const BlockSolution found = make_full_block(problem)->solve(
        heights, {mechanics::Control::mean_gap, 0.0},
        {mechanics::ContactLaw::penalty, penalty, 1e-10, 50});
    ASSERT_TRUE(found.converged) << found.note;
    gaps.push_back(found.nominal_pressure / penalty);
  }
  // A rigid block: p_0 = k <max(h, 0)> over the two Gauss points of each cell,
  // at t = (1 -+ 1/sqrt(3))/2 between nodes of heights 1, 0, -1, 0 nm.
  const double t = 0.5 - 0.5 / std::sqrt(3.0);
  const auto mean = [](double near, double far) {
    return 1e-9 * 0.25 * 2.0 * (near + far) / 2.0;
  };
  const auto cubic = [](double s) { // nodes 0, 1, 0, -1 at -1, 0, 1, 2
    return 1.0 + 0.5 * s * s * (-5.0 + 3.0 * s) - 0.5 * s * s * (s - 1.0);
  };
  const auto cosine = [](double s) {
    return std::cos(0.5 * std::numbers::pi * s);
  };
  EXPECT_NEAR(gaps[0] / mean(cubic(t), cubic(1.0 - t)), 1.0, 1e-5);
  EXPECT_NEAR(gaps[1] / mean(cosine(t), cosine(1.0 - t)), 1.0, 1e-5);
  EXPECT_NEAR(gaps[2] / mean(1.0 - t, t), 1.0, 1e-5);
}

} // namespace asperity::fem::height_interpolation_test
