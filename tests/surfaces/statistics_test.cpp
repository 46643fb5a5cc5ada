// Tests of surfaces/maps/statistics.hpp, mode_power.hpp and shells.hpp.
#include "surfaces/maps/exact_shapes.hpp"
#include "surfaces/maps/mode_power.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/realization.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>
#include <vector>

namespace asperity::surfaces::statistics_test {

constexpr double pi = std::numbers::pi;
constexpr double length = 1e-5;
constexpr double unit = 2.0 * pi / length;

/// White noise from the generator of the surfaces, Nyquist modes included.
HeightMap noise(const Grid& grid, int realization) {
  HeightMap map{grid, std::vector<double>(grid.size())};
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      map.heights[grid.index(ix, iy)] =
          draw_mode({99, realization}, ix, iy).first;
  remove_mean(map);
  return map;
}

/// D cos(2 pi x/l): skewness 0, kurtosis 3/2, rms D/sqrt2, slope q D/sqrt2,
/// half the Laplacian q^2 D/(2 sqrt2). Tolerance: roundoff.
TEST(Statistics, AreThoseOfACosine) {
  const HeightMap map = wave_1d({64, 16, length, length}, 2e-9, length / 4);
  const Statistics found = statistics(map);

  const double q = 4 * unit;
  EXPECT_NEAR(found.rms_height / (2e-9 / std::sqrt(2.0)), 1.0, 1e-14);
  EXPECT_NEAR(found.rms_slope / (2e-9 * q / std::sqrt(2.0)), 1.0, 1e-13);
  EXPECT_NEAR(found.rms_curvature / (1e-9 * q * q / std::sqrt(2.0)), 1.0,
              1e-12);
  EXPECT_NEAR(found.skewness, 0.0, 1e-13);
  EXPECT_NEAR(found.kurtosis, 1.5, 1e-13);
  EXPECT_NEAR(found.highest, 2e-9, 1e-23);
  EXPECT_NEAR(found.lowest, -2e-9, 1e-23);
}

// On a rectangle with unequal spacings the slope of an oblique wave is |q|
// D/sqrt2: both directions, each with its own length.
TEST(Statistics, CountBothDirectionsOfTheSlope) {
  const Grid grid{32, 24, 2.0, 3.0};
  HeightMap map{grid, {}};
  for (int iy = 0; iy < 24; ++iy)
    for (int ix = 0; ix < 32; ++ix)
      map.heights.push_back(
          std::cos(2.0 * pi * (3.0 * ix / 32.0 - 2.0 * iy / 24.0)));

  const double q = 2.0 * pi * std::hypot(3.0 / 2.0, 2.0 / 3.0);
  EXPECT_NEAR(statistics(map).rms_slope, q / std::sqrt(2.0), 1e-12);
}

// Skewness and kurtosis of a grid of single spikes at a fraction s of the
// nodes: (1-2s)/sqrt(s(1-s)) and (1-3s+3s^2)/(s(1-s)) (Bernoulli).
TEST(Statistics, HaveTheSignOfTheirSkewness) {
  HeightMap map{{8, 8, 1.0, 1.0}, std::vector<double>(64)};
  for (std::size_t i = 0; i < 8; ++i)
    map.heights[8 * i + (3 * i) % 8] = 1.0;

  const Statistics found = statistics(map);

  const double variance = 0.125 * 0.875;
  EXPECT_NEAR(found.skewness, 0.75 / std::sqrt(variance), 1e-13);
  EXPECT_NEAR(found.kurtosis, (1 - 0.375 + 3.0 / 64.0) / variance, 1e-13);
}

// Parseval's theorem: the modes sum to <h^2>, including the Nyquist rows, for
// even and odd sides; rms_height is computed without the transform.
TEST(ModePower, AddsUpToTheMeanSquareHeight) {
  for (const Grid& grid : {Grid{16, 16, 1, 1}, Grid{15, 16, 1, 2},
                           Grid{16, 9, 3, 1}, Grid{7, 5, 1, 1}}) {
    const HeightMap map = noise(grid, 0);
    double power = 0.0;
    int modes = 0;
    each_column(map, [&](int jx, std::span<const double> of_column) {
      power += std::accumulate(of_column.begin(), of_column.end(), 0.0);
      modes += modes_in_column(grid, jx) * static_cast<int>(of_column.size());
    });

    EXPECT_NEAR(power / std::pow(statistics(map).rms_height, 2), 1.0, 1e-13);
    EXPECT_EQ(modes, static_cast<int>(grid.size())); // and q = 0, without power
  }
}

// Shells preserve <h^2> and <|grad h|^2> of the map for any map and any number
// of shells. Tolerance: roundoff of a few hundred terms.
TEST(Shells, PreserveHeightAndSlopeOfTheMap) {
  const bool holds = rc::check([] {
    const Grid grid{*rc::gen::inRange(2, 40), *rc::gen::inRange(2, 40), 1.0,
                    *rc::gen::inRange(1, 20) / 10.0};
    const HeightMap map = noise(grid, *rc::gen::inRange(0, 1000));
    const Statistics found = statistics(map);
    double height = 0.0;
    double slope = 0.0;
    double previous = 0.0;
    for (const Shell& shell :
         spectral_shells(map, *rc::gen::inRange(1, 300) / 100.0)) {
      height += shell.mean_square_height;
      slope += std::pow(shell.wavevector, 2) * shell.mean_square_height;
      RC_ASSERT(shell.wavevector > previous);
      previous = shell.wavevector;
    }
    RC_ASSERT(std::abs(std::sqrt(height) / found.rms_height - 1.0) < 1e-12);
    RC_ASSERT(std::abs(std::sqrt(slope) / found.rms_slope - 1.0) < 1e-12);
  });
  EXPECT_TRUE(holds);
}

// Spread over annuli, too, the shells have the map's <h^2>, and its <|grad
// h|^2> unless the lowest annulus would contain q = 0 (a side above three
// others).
TEST(Shells, SpreadKeepHeightAndSlopeOfTheMap) {
  const bool holds = rc::check([] {
    const Grid grid{*rc::gen::inRange(2, 40), *rc::gen::inRange(2, 40), 1.0,
                    *rc::gen::inRange(4, 30) / 10.0};
    const HeightMap map = noise(grid, *rc::gen::inRange(0, 1000));
    const double mode_area =
        wavevector(1, grid.length_x) * wavevector(1, grid.length_y);
    const IsotropicSpectrum spread =
        spread_spectrum(spectral_shells(map), mode_area);
    double height = 0.0;
    double slope = 0.0;
    for (std::size_t i = 0; i + 1 < spread.kinks.size(); ++i) {
      const double low = spread.kinks[i];
      const double high = spread.kinks[i + 1];
      RC_ASSERT(low > 0.0 && high > low);
      const double density = spread.density(std::midpoint(low, high));
      RC_ASSERT(density >= 0.0);
      height += std::numbers::pi * density * (high * high - low * low);
      slope += 0.5 * std::numbers::pi * density *
               (std::pow(high, 4) - std::pow(low, 4));
    }
    const Statistics found = statistics(map);
    RC_ASSERT(std::abs(std::sqrt(height) / found.rms_height - 1.0) < 1e-9);
    RC_ASSERT(std::abs(std::sqrt(slope) / found.rms_slope - 1.0) < 1e-9);
    RC_ASSERT(std::abs(spread.mean_square_slope / slope - 1.0) < 1e-9);
  });
  EXPECT_TRUE(holds);
}

HeightMap realized(const SelfAffineSpectrum& spectrum, int points) {
  return realize(spectrum.isotropic(), {points, points, length, length},
                 {7, 0});
}

// The spectrum that is measured on a realisation is the formula from which it
// was made: to roundoff where each |q| has its shell, within the change of C
// across a shell (2.5 % of q, exponent 3.6) above; nothing beyond the band.
TEST(Shells, MeasureTheFormulaThatTheSurfaceCameFrom) {
  const auto spectrum = SelfAffineSpectrum::with_rms_height(
      {0.8, unit, 4 * unit, 60 * unit}, 1e-9);
  const HeightMap map = realized(spectrum, 128);

  const std::vector<Shell> shells = spectral_shells(map);

  std::ptrdiff_t exact = 0;
  for (const Shell& shell : shells) {
    const double ratio =
        shell_density(shell, map.grid) / spectrum(shell.wavevector);
    const bool is_exact = shell.wavevector < 7.99 * unit;
    exact += is_exact;
    if (is_exact || shell.wavevector < 58 * unit) {
      EXPECT_NEAR(ratio, 1.0, is_exact ? 1e-11 : 1e-3) << shell.wavevector;
    }
  }
  std::set<int> sums_of_two_squares;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      sums_of_two_squares.insert(i * i + j * j);
  const auto below_64 = std::distance(sums_of_two_squares.upper_bound(0),
                                      sums_of_two_squares.lower_bound(64));
  EXPECT_EQ(exact, below_64);
  EXPECT_LE(shells.back().wavevector, 60 * unit);
  EXPECT_LT(shells.size(), 220u);
}

/// Relative error of rms height, slope and curvature of a realisation against
/// the closed forms, with this number of waves per side at the roll-off.
std::vector<double> errors_against_closed_forms(int waves, int points) {
  const auto spectrum = SelfAffineSpectrum::with_rms_height(
      {0.8, waves / 2 * unit, waves * unit, 3 * waves * unit}, 1e-9);
  const Statistics found = statistics(realized(spectrum, points));
  return {std::abs(found.rms_height / spectrum.rms_height() - 1.0),
          std::abs(found.rms_slope / spectrum.rms_slope() - 1.0),
          std::abs(found.rms_curvature / spectrum.rms_curvature() - 1.0)};
}

// Sums over modes tend to the integrals of the formula as the cell grows
// relative to the waves. Tolerance: the difference between a lattice and a disc
// decreases faster than the ratio of circumference to area, so that a cell four
// times as large leaves less than a quarter of the error; it starts below
// 1/waves.
TEST(Statistics, ConvergeToTheClosedFormsOfTheSpectrum) {
  const auto small = errors_against_closed_forms(10, 64);
  const auto large = errors_against_closed_forms(40, 256);

  for (std::size_t i = 0; i < small.size(); ++i) {
    EXPECT_LT(small[i], 0.1) << i;
    EXPECT_LT(large[i], 0.25 * small[i]) << i;
  }
}

// The shells of a surface do not depend on the grid on which it is sampled.
TEST(Shells, AreThoseOfTheSurfaceAndNotOfTheGrid) {
  const auto spectrum = SelfAffineSpectrum::with_rms_height(
      {0.8, unit, 4 * unit, 30 * unit}, 1e-9);

  const auto coarse = spectral_shells(realized(spectrum, 64));
  const auto fine = spectral_shells(realized(spectrum, 256));

  ASSERT_EQ(coarse.size(), fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    EXPECT_NEAR(coarse[i].wavevector / fine[i].wavevector, 1.0, 1e-12);
    EXPECT_NEAR(coarse[i].mean_square_height / fine[i].mean_square_height, 1.0,
                1e-10);
    EXPECT_EQ(coarse[i].modes, fine[i].modes);
  }
}

TEST(Statistics, ReportThatAFlatMapHasNoShape) {
  const HeightMap flat{{4, 4, 1.0, 1.0}, std::vector<double>(16, 0.5)};

  EXPECT_EQ(statistics(flat).rms_height, 0.0);
  EXPECT_TRUE(std::isnan(statistics(flat).kurtosis));
  EXPECT_TRUE(spectral_shells(flat).empty());
}

TEST(Statistics, RefuseImpossibleBins) {
  const HeightMap map = noise({4, 4, 1.0, 1.0}, 0);

  EXPECT_THROW(spectral_shells(map, 0.0), std::domain_error);
}

} // namespace asperity::surfaces::statistics_test
