// Tests of theory/persson/magnification.hpp: the unresolved roughness obeys the
// same theory, volume is conserved as the surfaces separate, and invalid
// arguments are refused.
#include "tests/theory/spectra.hpp"
#include "theory/persson/magnification.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::theory::magnification_test {

using std::numbers::pi;

// The paper's Fig. 15: 1.3 GPa, magnifications relative to the roll-off.
constexpr double pressure = 1.3e9;

MagnifiedContact surface_under(double nominal_pressure) {
  const SelfAffine shape = surface_of_the_paper();
  return MagnifiedContact(
      PerssonContact(shape.spectrum(), modulus_of_the_paper, 0.42),
      nominal_pressure, shape.roll_off);
}

// Verifies A and h_rms by the closed moments of the self-affine formula.
// Tolerance: roundoff of some thousand positive terms.
TEST(Magnification, AreaAndHeightAreMomentsAboveAndBelow) {
  const SelfAffine shape = surface_of_the_paper();
  const MagnifiedContact contact = surface_under(pressure);
  const double ratio = pressure / modulus_of_the_paper;
  for (const double zeta : {0.4, 0.9, 1.0, 2.5}) {
    const double q = zeta * shape.roll_off;
    const double resolved = shape.moment(q, 3);
    const double hidden = shape.moment(shape.high, 1) - shape.moment(q, 1);

    EXPECT_NEAR(contact.area_fraction(zeta) /
                    std::erf(ratio / std::sqrt(pi * resolved)),
                1.0, 1e-13);
    EXPECT_NEAR(contact.rms_height(zeta) / std::sqrt(2.0 * pi * hidden), 1.0,
                1e-13);
    EXPECT_NEAR(contact.apparent_pressure(zeta) * contact.area_fraction(zeta) /
                    pressure,
                1.0, 1e-15);
  }
}

// Outside zeta_0..zeta_1 nothing changes: at zeta_0 there is the complete
// contact of (4) and (14), from zeta_1 on no gap; the volume that separates
// between them is the mean gap. q_ref shifts zeta_0.
TEST(Magnification, EndsAreCompleteContactAndNoGap) {
  const MagnifiedContact contact = surface_under(pressure);
  const double lowest = contact.lowest_magnification();
  const double highest = contact.highest_magnification();

  EXPECT_NEAR(lowest, 6.04e7 / 1.81e8, 1e-15);
  EXPECT_NEAR(highest, 4.0, 1e-15);
  for (const double zeta : {0.01 * lowest, lowest}) {
    EXPECT_EQ(contact.area_fraction(zeta), 1.0);
    EXPECT_NEAR(contact.mean_gap(zeta) / contact.contact().mean_gap(pressure),
                1.0, 1e-15);
    EXPECT_NEAR(contact.mean_gap_as_printed(zeta) / contact.mean_gap(zeta), 1.0,
                1e-13);
  }
  EXPECT_NEAR(contact.opening_gap(lowest, highest) *
                  (1.0 - contact.area_fraction(highest)) /
                  contact.mean_gap(lowest),
              1.0, 1e-13);
  for (const double zeta : {highest, 50.0}) {
    EXPECT_NEAR(contact.area_fraction(zeta) /
                    contact.contact().area_fraction(pressure),
                1.0, 1e-14);
    EXPECT_EQ(contact.rms_height(zeta), 0.0);
    EXPECT_EQ(contact.mean_gap(zeta), 0.0);
    EXPECT_EQ(contact.mean_gap_as_printed(zeta), 0.0);
    EXPECT_EQ(contact.opening_gap(zeta), 0.0);
  }
}

// Verifies (23) as an integral over wavevectors, with w(q, zeta) inside and
// either w outside. Tolerance: tanh-sinh's and the lost digits of q - q_L.
TEST(Magnification, GapIsThePapersIntegralInEitherReading) {
  const SelfAffine shape = surface_of_the_paper();
  const MagnifiedContact contact = surface_under(pressure);
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double zeta = 1.5, low = zeta * shape.roll_off;
  SelfAffine above = shape; // only q^{-2-2H} is left
  above.low = above.roll_off = low;
  above.strength = shape(low);
  const double ratio = contact.apparent_pressure(zeta) / modulus_of_the_paper;
  const auto gap = [&](bool as_printed) {
    return quadrature.integrate(
        [&](double t) {
          const double q = low + t * t;
          const double inner =
              1.0 / std::sqrt(pi * above.moment_over(t * t, 3));
          const double outer =
              as_printed ? 1.0 / std::sqrt(pi * shape.moment(q, 3)) : inner;
          const double x = inner * ratio;
          return x < 25.0 ? 2.0 * t * std::sqrt(pi) * q * q * shape(q) * outer *
                                gap_kernel(x).at(0.42)
                          : 0.0;
        },
        0.0, std::sqrt(shape.high - low), 1e-13);
  };

  EXPECT_NEAR(contact.mean_gap(zeta) / gap(false), 1.0, 1e-12);
  EXPECT_NEAR(contact.mean_gap_as_printed(zeta) / gap(true), 1.0, 1e-12);
  EXPECT_LT(contact.mean_gap_as_printed(zeta), contact.mean_gap(zeta));
}

// (25) is the limit of its own finite step, to second order in the step:
// halving it reduces the difference to a quarter.
TEST(Magnification, SeparationGapIsTheLimitOfASmallStep) {
  const MagnifiedContact contact = surface_under(pressure);
  for (const double zeta : {0.5, 0.8, 1.5, 3.0}) {
    const double limit = contact.opening_gap(zeta);
    const auto error = [&](double step) {
      return contact.opening_gap(zeta * std::exp(-step),
                                 zeta * std::exp(step)) /
                 limit -
             1.0;
    };

    const double order = std::log2(error(0.02) / error(0.01));

    EXPECT_NEAR(order, 2.0, 0.01) << "zeta " << zeta;
    EXPECT_LT(std::abs(error(0.01)), 0.01) << "zeta " << zeta;
  }
}

// With a single shell the whole area separates in one step, at the mean gap
// divided by that area; (25) itself has no meaning there.
TEST(Magnification, ShellsSeparateInSteps) {
  const PerssonContact rough(
      HeightSpectrum(std::vector<SpectrumShell>{{1e7, 1e-17}, {4e7, 1e-18}}),
      2e9, 0.4);
  const MagnifiedContact contact(rough, 1e7, 1e7);
  const double area = contact.area_fraction(1.0);

  EXPECT_EQ(contact.area_fraction(0.99), 1.0);
  EXPECT_EQ(contact.area_fraction(3.9), area);
  EXPECT_LT(contact.area_fraction(4.0), area);
  EXPECT_NEAR(contact.opening_gap(0.5, 5.0) *
                  (1.0 - contact.area_fraction(5.0)) / rough.mean_gap(1e7),
              1.0, 1e-14);
  EXPECT_THROW(contact.opening_gap(1.0), std::domain_error);
  EXPECT_THROW(contact.opening_gap(1.5, 2.5), std::domain_error);
}

// Verifies the inverse of A(zeta), which has no value when the area stays
// larger. Tolerance: roundoff of A over dA/dln zeta, and of q - q_L.
TEST(Magnification, OfAnAreaInvertsTheArea) {
  const MagnifiedContact contact = surface_under(pressure);
  for (const double zeta : {0.35, 1.0, 3.99}) {
    const auto found =
        contact.magnification_of_area(contact.area_fraction(zeta));
    ASSERT_TRUE(found.has_value());
    const double condition = 1e-3 / (contact.area_fraction(zeta * 0.9995) -
                                     contact.area_fraction(zeta * 1.0005));
    EXPECT_NEAR(*found / zeta, 1.0, 1e-15 * condition + 1e-13);
  }
  EXPECT_FALSE(contact.magnification_of_area(0.01).has_value());
}

// Verifies the polymer surrogate of Sec. 8 at 10 MPa and E* = 2 GPa, computed
// by another program. Tolerance: half a unit of the last printed digit.
TEST(Magnification, PolymerSurrogateHasItsPrintedNumbers) {
  const double reference = 2.0 * pi / 10e-6;
  const SelfAffine polymer =
      SelfAffine{0.95, 2.0 * reference, 4.5 * reference, 128.0 * reference, 1.0}
          .with_rms_height(34e-9);
  const MagnifiedContact contact(PerssonContact(polymer.spectrum(), 2e9, 0.38),
                                 10e6, reference);

  EXPECT_NEAR(contact.mean_gap(1.0) / 34e-9, 1.215, 5e-4);
  EXPECT_NEAR(contact.mean_gap(10.0) / contact.mean_gap(1.0), 0.032, 5e-4);
  EXPECT_NEAR(contact.area_fraction(10.0), 0.077, 5e-4);
  EXPECT_NEAR(contact.contact().gap_decay_length() / 34e-9, 0.409, 5e-4);
}

TEST(Magnification, RefusesWhatIsOutsideItsRange) {
  const MagnifiedContact contact = surface_under(pressure);
  EXPECT_THROW(surface_under(0.0), std::domain_error);
  EXPECT_THROW(MagnifiedContact(contact.contact(), 1.0, -1.0),
               std::domain_error);
  EXPECT_THROW(contact.mean_gap(0.0), std::domain_error);
  EXPECT_THROW(contact.magnification_of_area(1.0), std::domain_error);
}

} // namespace asperity::theory::magnification_test
