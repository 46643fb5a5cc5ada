// Tests of surfaces/maps/self_affine.hpp: amplitude, ends and moments.
#include "surfaces/maps/self_affine.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace asperity::surfaces::self_affine_test {

// The surface of the paper's molecular dynamics, cut at zeta = 4.
constexpr SelfAffineShape paper{0.8, 6.04e7, 1.81e8, 4.0 * 1.81e8};

/// 2 pi int q^(1+order) C dq by Simpson's rule in ln q, a piece at a time.
double moment_by_quadrature(const SelfAffineSpectrum& spectrum, int order) {
  const auto& shape = spectrum.shape();
  const auto piece = [&](double start, double end) {
    const int n_panels = 2000;
    const double step = std::log(end / start) / (2 * n_panels);
    double sum = 0.0;
    for (int i = 0; i <= 2 * n_panels; ++i) {
      const double q = start * std::exp(i * step);
      const double weight = i == 0 || i == 2 * n_panels ? 1 : i % 2 ? 4 : 2;
      sum += weight * std::pow(q, order + 2) * spectrum(q);
    }
    return sum * step / 3.0;
  };
  return 2.0 * std::numbers::pi *
         (piece(shape.wavevector_low, shape.wavevector_roll_off) +
          piece(shape.wavevector_roll_off, shape.wavevector_high));
}

// Verifies the rms slopes of the paper's surface, computed in 25-digit
// arithmetic by another program. Tolerance: half of the last of their 12
// digits.
TEST(SelfAffineSpectrum, HasThePapersSlope) {
  const auto cut = SelfAffineSpectrum::with_rms_height(paper, 1e-9);
  SelfAffineShape full_shape = paper;
  full_shape.wavevector_high = 216.0 * paper.wavevector_roll_off;
  const auto full = SelfAffineSpectrum::with_rms_height(full_shape, 1e-9);

  EXPECT_NEAR(cut.rms_slope(), 0.262100632367, 5e-13);
  EXPECT_NEAR(full.rms_slope(), 0.767233712675, 5e-13);
}

// Nayak's m_4 = (3 pi/4) int q^5 C dq of the same source, which is 3/8 of the
// moment of order 4. Tolerance: its 12 digits.
TEST(SelfAffineSpectrum, HasThePapersCurvature) {
  const auto spectrum = SelfAffineSpectrum::with_rms_height(paper, 1e-9);

  EXPECT_NEAR(0.375 * spectrum.moment(4) / 4.56504373376e15, 1.0, 2e-12);
  EXPECT_NEAR(spectrum.rms_curvature(), 0.5 * std::sqrt(spectrum.moment(4)),
              1e-6);
}

// A unit of length that is a power of two changes no bit, so that metamorphic
// pairs of the robustness tests have the same surface. Of a million arguments
// std::pow rounds some 400 differently.
TEST(SelfAffineSpectrum, KeepsItsBitsInUnitsOfPowersOfTwo) {
  constexpr double unit = 0x1p-20;
  int different = 0;
  for (int i = 0; i < 20000; ++i) {
    const double low = 1e6 + 1.234567 * i;
    const SelfAffineShape shape{0.6, low, 3.1 * low, 47.3 * low};
    const SelfAffineShape scaled{0.6, unit * shape.wavevector_low,
                                 unit * shape.wavevector_roll_off,
                                 unit * shape.wavevector_high};
    const auto plain = SelfAffineSpectrum::with_rms_slope(shape, 0.1);
    const auto other = SelfAffineSpectrum::with_rms_slope(scaled, 0.1);
    different += other.moment(2) != plain.moment(2) ||
                 other(5.0 * unit * low) * 0x1p-80 != plain(5.0 * low);
  }
  EXPECT_EQ(different, 0);
}

// The closed forms equal their integrals for any shape. Tolerance: Simpson's
// error, step^4/180 * |f''''| / f with step <= ln(1e4) / 4000 and an exponent
// of at most 6, is below 1e-9 even where a steep end dominates; 1e-8 leaves a
// decade.
TEST(SelfAffineSpectrum, HasTheMomentsOfItsIntegrals) {
  const bool holds = rc::check([] {
    const double hurst = *rc::gen::inRange(0, 101) / 100.0;
    const double roll_off = 1.0 + *rc::gen::inRange(0, 1000) / 100.0;
    const double high = roll_off * (1.1 + *rc::gen::inRange(0, 1000));
    const auto spectrum =
        SelfAffineSpectrum::with_rms_slope({hurst, 1.0, roll_off, high}, 0.1);
    for (const int order : {0, 2, 4}) {
      const double by_quadrature = moment_by_quadrature(spectrum, order);
      RC_ASSERT(std::abs(spectrum.moment(order) / by_quadrature - 1.0) < 1e-8);
    }
  });
  EXPECT_TRUE(holds);
}

// <h^2> for H = 0 and <|grad h|^2> for H = 1 are logarithmic: 2 pi C_0 q_0^2
// ln(q_1/q_0) and 2 pi C_0 q_0^4 ln(q_1/q_0) without a plateau.
TEST(SelfAffineSpectrum, TakesItsLogarithmicEnds) {
  const double two_pi = 2.0 * std::numbers::pi;
  const auto flat = SelfAffineSpectrum::with_rms_height({0.0, 3, 3, 300}, 1.0);
  const auto smooth = SelfAffineSpectrum::with_rms_slope({1.0, 3, 3, 300}, 1.0);

  EXPECT_NEAR(flat.plateau() * two_pi * 9.0 * std::log(100.0), 1.0, 1e-14);
  EXPECT_NEAR(smooth.plateau() * two_pi * 81.0 * std::log(100.0), 1.0, 1e-14);
}

TEST(SelfAffineSpectrum, HasTheRequestedRms) {
  const auto by_height = SelfAffineSpectrum::with_rms_height(paper, 2e-9);
  const auto by_slope = SelfAffineSpectrum::with_rms_slope(paper, 0.1);

  EXPECT_NEAR(by_height.rms_height() / 2e-9, 1.0, 1e-15);
  EXPECT_NEAR(by_slope.rms_slope(), 0.1, 1e-16);
}

TEST(SelfAffineSpectrum, IsFlatThenFallsAndIsClosedAtBothEnds) {
  const auto spectrum =
      SelfAffineSpectrum::with_rms_height({0.5, 1.0, 2.0, 8.0}, 1.0);
  const double plateau = spectrum.plateau();

  EXPECT_EQ(spectrum(1.0), plateau);
  EXPECT_EQ(spectrum(2.0), plateau);
  EXPECT_NEAR(spectrum(4.0) / plateau, 1.0 / 8.0, 1e-15); // 2^(-2-2H)
  EXPECT_NEAR(spectrum(8.0) / plateau, 1.0 / 64.0, 1e-15);
  EXPECT_GT(spectrum(8.0 * (1.0 + 1e-12)), 0.0); // an end that was rounded
  EXPECT_GT(spectrum(1.0 - 1e-12), 0.0);
  EXPECT_EQ(spectrum(8.0 * (1.0 + 1e-8)), 0.0);
  EXPECT_GT(spectrum(1.0 - 0.9e-4), 0.0); // printed with five digits
  EXPECT_EQ(spectrum(1.0 - 1.1e-4), 0.0);
}

TEST(SelfAffineSpectrum, NamesEachOfItsKinksOnce) {
  const auto with = SelfAffineSpectrum::with_rms_height({0.5, 1, 2, 8}, 1.0);
  const auto without = SelfAffineSpectrum::with_rms_height({0.5, 2, 2, 8}, 1.0);

  EXPECT_EQ(with.isotropic().kinks, (std::vector<double>{1.0, 2.0, 8.0}));
  EXPECT_EQ(without.isotropic().kinks, (std::vector<double>{2.0, 8.0}));
}

std::string message_of(const SelfAffineShape& shape, double rms_height) {
  return tests::message_of<std::domain_error>(
      [&] { SelfAffineSpectrum::with_rms_height(shape, rms_height); });
}

TEST(SelfAffineSpectrum, RefusesAnImpossibleShapeByName) {
  EXPECT_EQ(message_of({1.2, 1, 2, 8}, 1.0),
            "hurst = 1.2, but must be between 0 and 1 [1]");
  EXPECT_EQ(message_of({0.8, 0, 2, 8}, 1.0),
            "wavevector_low = 0, but must be finite and > 0 [rad/m]");
  EXPECT_EQ(message_of({0.8, 3, 2, 8}, 1.0),
            "wavevector_roll_off = 2, but must be between 3 and 1.79769e+308 "
            "[rad/m]");
  EXPECT_EQ(message_of({0.8, 1, 2, 1.5}, 1.0),
            "wavevector_high = 1.5, but must be between 2 and 1.79769e+308 "
            "[rad/m]");
  EXPECT_EQ(message_of({0.8, 2, 2, 2}, 1.0),
            "wavevector_high = 2, but must be above wavevector_low: a band of "
            "zero width has no power");
  EXPECT_EQ(message_of({0.8, 1, 2, 8}, -1.0),
            "rms_height = -1, but must be finite and > 0 [m]");
}

} // namespace asperity::surfaces::self_affine_test
