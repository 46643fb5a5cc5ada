// Tests of surfaces/realization.hpp and random_modes.hpp: a surface is
// determined by its key and not by its grid, and has the spectrum from which it
// was made.
#include "base/fourier.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"
#include "tests/base/fields.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::surfaces::realization_test {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double length = 1e-5; // m
constexpr double unit = two_pi / length;

Grid square(int points) {
  return {points, points, length, length};
}

/// Waves of 1 to 20 periods, rolled off at 4, rms height 1 nm.
IsotropicSpectrum spectrum() {
  static const SelfAffineShape shape{0.8, unit, 4 * unit, 20 * unit};
  return SelfAffineSpectrum::with_rms_height(shape, 1e-9).isotropic();
}

double largest_difference(const HeightMap& a, const HeightMap& b) {
  return tests::largest_difference(a.heights, b.heights);
}

// Verifies that 64 and 256 points sample one surface. Tolerance: two transforms
// of some 1200 waves each, log2(256^2) eps h_rms sqrt(..) < 1e-14 h_rms.
TEST(Realization, IsTheSameSurfaceOnAFinerGrid) {
  for (const auto amplitudes :
       {mechanics::Amplitudes::spectrum, mechanics::Amplitudes::gaussian}) {
    const HeightMap coarse =
        realize(spectrum(), square(64), {7, 2}, amplitudes);
    const HeightMap fine = realize(spectrum(), square(256), {7, 2}, amplitudes);

    for (int iy = 0; iy < 64; ++iy)
      for (int ix = 0; ix < 64; ++ix)
        EXPECT_NEAR(coarse.heights[coarse.grid.index(ix, iy)],
                    fine.heights[fine.grid.index(4 * ix, 4 * iy)], 1e-23);
  }
}

// A larger q_1 adds waves and leaves the others unchanged, so that surfaces
// that differ by their cut-off are equal below it (same plateau).
TEST(Realization, KeepsItsLongWavesWhenTheCutOffIsRaised) {
  const auto long_waves = spectrum();
  auto with_short = long_waves;
  with_short.kinks.back() = 30 * unit;
  const auto short_alone = [&] {
    auto alone = with_short;
    alone.density = [inner = long_waves](double q) {
      return is_in_band(q, 0.0, inner.wavevector_high()) ? 0.0 : 1e-36;
    };
    return alone;
  }();
  with_short.density = [=](double q) {
    return long_waves.density(q) + short_alone.density(q);
  };

  const HeightMap all = realize(with_short, square(64), {1, 0});
  HeightMap sum = realize(long_waves, square(64), {1, 0});
  const HeightMap rest = realize(short_alone, square(64), {1, 0});
  for (std::size_t i = 0; i < sum.heights.size(); ++i)
    sum.heights[i] += rest.heights[i];

  EXPECT_LT(largest_difference(all, sum), 1e-22);
}

TEST(Realization, DependsOnSeedAndRealization) {
  const HeightMap map = realize(spectrum(), square(64), {7, 0});

  EXPECT_EQ(largest_difference(map, realize(spectrum(), square(64), {7, 0})),
            0.0);
  EXPECT_GT(largest_difference(map, realize(spectrum(), square(64), {8, 0})),
            1e-9);
  EXPECT_GT(largest_difference(map, realize(spectrum(), square(64), {7, 1})),
            1e-9);
}

// |a_q|^2 = C(q) (2 pi)^2/(L_x L_y) mode by mode, here on a rectangle,
// by the transform of the map. Tolerance: roundoff of the transforms against
// the largest mode.
TEST(Realization, HasExactlyTheSpectrumItCameFrom) {
  const Grid grid{64, 90, length, 1.5 * length};
  const IsotropicSpectrum requested = spectrum();
  const HeightMap map = realize(requested, grid, {3, 0});
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  RealFourier(grid).forward(map.heights, modes);

  const double mode_area = two_pi * two_pi / grid.area();
  const auto count = static_cast<double>(grid.size());
  const double largest = requested.density(unit) * mode_area;
  std::size_t at = 0;
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx <= grid.points_x / 2; ++jx, ++at) {
      const double q = std::hypot(
          wavevector(jx, grid.length_x),
          wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y));
      EXPECT_NEAR(std::norm(modes[at] / count),
                  requested.density(q) * mode_area, 1e-13 * largest)
          << jx << " " << jy;
    }
}

// <|a_q|^2> = s_q^2 for Gaussian amplitudes, and |a_q|^2 is exponential.
// Statistics: some 600 modes in each of 20 surfaces, mean of n exponentials is
// 1 +- 1/sqrt(n), their mean square 2 +- sqrt(20/n): 4 sigma.
TEST(Realization, HasGaussianAmplitudesOnDemand) {
  const IsotropicSpectrum requested = spectrum();
  const Grid grid = square(64);
  const auto count = static_cast<double>(grid.size());
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  double n = 0.0;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (int realization = 0; realization < 20; ++realization) {
    RealFourier(grid).forward(realize(requested, grid, {5, realization},
                                      mechanics::Amplitudes::gaussian)
                                  .heights,
                              modes);
    for (int j = 0; j < 64; ++j)
      for (int i = 1; i < 32; ++i) {
        const double density =
            requested.density(unit * std::hypot(i, signed_wavenumber(j, 64)));
        if (density == 0.0)
          continue;
        const auto at = static_cast<std::size_t>(j * 33 + i);
        const double power =
            std::norm(modes[at] / count) / (density * unit * unit);
        n += 1.0;
        sum += power;
        sum_of_squares += power * power;
      }
  }

  EXPECT_NEAR(sum / n, 1.0, 4.0 / std::sqrt(n));
  EXPECT_NEAR(sum_of_squares / n, 2.0, 4.0 * std::sqrt(20.0 / n));
}

std::string message_of(const IsotropicSpectrum& requested, const Grid& grid,
                       const RandomKey& key) {
  return tests::message_of<std::domain_error>(
      [&] { realize(requested, grid, key); });
}

// The largest wavevector, of 20 periods, needs 42 points to be below the
// Nyquist row.
TEST(Realization, RefusesAGridThatIsTooCoarse) {
  EXPECT_EQ(points_needed(20 * unit, length), 42);
  EXPECT_EQ(points_needed(20.5 * unit, length), 42);
  EXPECT_EQ(message_of(spectrum(), square(40), {}),
            "points_x = 40, but must be >= 42 to resolve the shortest "
            "wavelength of 5e-07 m over 1e-05 m");
  EXPECT_EQ(message_of(spectrum(), square(42), {}), "accepted");
}

TEST(Realization, RefusesWhatItCannotMake) {
  IsotropicSpectrum empty = spectrum();
  empty.kinks = {1.1 * unit, 1.2 * unit};
  empty.density = [](double q) {
    return is_in_band(q, 1.1 * unit, 1.2 * unit) ? 1.0 : 0.0;
  };

  EXPECT_EQ(message_of(empty, square(64), {}),
            "the band from 691150 to 753982 rad/m contains no wavevector that "
            "fits the periodic cell of 1e-05 m by 1e-05 m");
  EXPECT_EQ(message_of(spectrum(), square(64), {1, -1}),
            "realization = -1, but must be finite and >= 0 [1]");
}

// Both numbers of a draw are uniform and the two are independent. Statistics:
// 16 bins of n = 40 000 draws, chi^2 with 15 degrees of freedom exceeds 44.3
// once in 10 000 times; with the 256 cells of pairs (255 degrees of freedom),
// 347.7.
TEST(DrawMode, IsUniform) {
  std::vector<double> first(16), second(16), pairs(256);
  const int half = 100;
  for (int i = -half; i < half; ++i)
    for (int j = -half; j < half; ++j) {
      const UniformPair draw = draw_mode({42, 0}, i, j);
      ASSERT_TRUE(draw.first > 0.0 && draw.first < 1.0);
      ASSERT_TRUE(draw.second > 0.0 && draw.second < 1.0);
      const auto a = static_cast<std::size_t>(16 * draw.first);
      const auto b = static_cast<std::size_t>(16 * draw.second);
      first[a] += 1;
      second[b] += 1;
      pairs[16 * a + b] += 1;
    }

  const auto chi_squared = [](const std::vector<double>& counts) {
    const double expected = 40000.0 / static_cast<double>(counts.size());
    double sum = 0.0;
    for (const double count : counts)
      sum += (count - expected) * (count - expected) / expected;
    return sum;
  };
  EXPECT_LT(chi_squared(first), 44.3);
  EXPECT_LT(chi_squared(second), 44.3);
  EXPECT_LT(chi_squared(pairs), 347.7);
}

TEST(DrawMode, DependsOnEveryPartOfTheKey) {
  const double draw = draw_mode({42, 3}, 5, -7).second;

  EXPECT_EQ(draw, draw_mode({42, 3}, 5, -7).second);
  EXPECT_NE(draw, draw_mode({43, 3}, 5, -7).second);
  EXPECT_NE(draw, draw_mode({42 + (1ULL << 40), 3}, 5, -7).second);
  EXPECT_NE(draw, draw_mode({42, 4}, 5, -7).second);
  EXPECT_NE(draw, draw_mode({42, 3}, -7, 5).second);
  EXPECT_NE(draw, draw_mode({42, 3}, 5, 7).second);
  EXPECT_NE(draw, draw_mode({42, 3, RandomStream{2}}, 5, -7).second);
}

} // namespace asperity::surfaces::realization_test
