// Tests of theory/persson/persson.hpp against numbers that were computed by
// another program and with 25-digit arithmetic, and against the limits.
#include "theory/persson/persson.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tests/message_of.hpp"
#include "tests/theory/spectra.hpp"

namespace asperity::theory::persson_test {

// The numbers are printed to 12 digits: half a unit of the last, relative.
constexpr double printed = 5e-12;

void expect_relative(double found, double expected, double tolerance) {
  EXPECT_NEAR(found / expected, 1.0, tolerance);
}

const PerssonContact& contact_of_the_paper() {
  static const PerssonContact contact(surface_of_the_paper().spectrum(),
                                      modulus_of_the_paper, 0.42);
  return contact;
}

TEST(PerssonNumbers, AreaAndSlopeOfThePaperSurface) {
  const PerssonContact& contact = contact_of_the_paper();
  const double modulus = contact.contact_modulus();

  expect_relative(modulus, 93.734822729e9, 6e-12);
  expect_relative(contact.spectrum().rms_slope(), 0.262100632367, printed);
  expect_relative(contact.stress_variance() / modulus / modulus,
                  8.58709268588e-3, printed);
  expect_relative(contact.area_fraction(0.0129 * modulus), 0.078413492782,
                  7e-12); // 11 digits
  expect_relative(contact.area_fraction(0.26 * modulus), 0.952740904245,
                  printed);
  const ProfileMoments& moments = contact.spectrum().profile_moments();
  expect_relative(moments.slope, 0.0343483707435, printed);
  expect_relative(moments.curvature, 4.56504373376e15, printed);
}

TEST(PerssonNumbers, AsymptoteAndEnergyOfThePaperSurface) {
  const PerssonContact& contact = contact_of_the_paper();
  const double modulus = contact.contact_modulus();

  expect_relative(contact.gap_decay_length(), 0.449096071810e-9, printed);
  expect_relative(contact.pressure_prefactor(), 0.142713227090, printed);
  expect_relative(contact.full_contact_energy() / modulus, 5.70377829805e-11,
                  printed);
}

struct GapNumber {
  double pressure_ratio; // p/E*
  double gap_nm;
};

class PerssonGap : public ::testing::TestWithParam<GapNumber> {};

TEST_P(PerssonGap, OfThePaperSurface) {
  const PerssonContact& contact = contact_of_the_paper();
  const double pressure = GetParam().pressure_ratio * contact.contact_modulus();
  const double gap = GetParam().gap_nm * 1e-9;

  expect_relative(contact.mean_gap(pressure), gap, printed);
  // d ln p = -(u/D) d ln u, and u/D < 8 at all five.
  expect_relative(contact.nominal_pressure(gap), pressure, 8.0 * printed);
}

INSTANTIATE_TEST_SUITE_P(Numbers, PerssonGap,
                         ::testing::Values(GapNumber{1e-4, 3.26046930741},
                                           GapNumber{1e-3, 2.21400169600},
                                           GapNumber{0.01, 1.11463074774},
                                           GapNumber{0.1, 0.117902898647},
                                           GapNumber{0.26, 2.66732592806e-3}));

TEST(PerssonNumbers, SpectrumToAtomicMagnification) {
  SelfAffine shape;
  shape.high = 216.0 * shape.roll_off;
  const PerssonContact contact(shape.with_rms_height(1e-9).spectrum(),
                               modulus_of_the_paper, 0.42);

  expect_relative(contact.spectrum().rms_slope(), 0.767233712675, printed);
  expect_relative(contact.gap_decay_length(), 0.485674623196e-9, printed);
  expect_relative(contact.pressure_prefactor(), 0.170256208727, printed);
}

// Printed to 9 and 8 digits: 5e-9 absolute in numbers around 1 and 0.4.
TEST(PerssonNumbers, PureSelfAffine) {
  const SelfAffine shape{0.8, 1e6, 1e6, 1e8, 1e-30};
  const PerssonContact contact(shape.spectrum(), 1e9, 0.5);
  const double rms_height = contact.spectrum().rms_height();

  EXPECT_NEAR(contact.gap_decay_length() / (0.5 * rms_height), 1.05357529,
              5e-9);
  EXPECT_NEAR(contact.pressure_prefactor() /
                  (persson_epsilon(0.5) * shape.low * rms_height),
              0.41918634, 5e-9);
}

TEST(PerssonEpsilon, MatchesTheTable) {
  EXPECT_NEAR(persson_epsilon(0.38), 5.496775152921, 5e-13);
  EXPECT_NEAR(persson_epsilon(0.40), 4.680731370202, 5e-13);
  EXPECT_NEAR(persson_epsilon(0.42), 4.047310599503, 5e-13);
  EXPECT_NEAR(persson_epsilon(0.45), 3.334036041446, 5e-13);
  EXPECT_NEAR(persson_epsilon(1.0), 0.749306001288, 5e-13);
}

// Every reference digit above also holds for a spectrum of shells that sample
// the formula; two resolutions give the order of the sampling, midpoint in ln
// q, which is two away from the kink. The remainder of Richardson's
// extrapolation is of order four.
TEST(PerssonShells, ConvergeToTheFormula) {
  const SelfAffine shape = surface_of_the_paper();
  const auto gap_with = [&](int n_half) { // shells on each branch
    std::vector<SpectrumShell> shells;
    const auto sample = [&](double low, double high) {
      const double step = std::log(high / low) / n_half;
      for (int i = 0; i < n_half; ++i) {
        const double q = low * std::exp(step * (i + 0.5));
        shells.push_back({q, 2.0 * std::numbers::pi * q * q * shape(q) * step});
      }
    };
    sample(shape.low, shape.roll_off);
    sample(shape.roll_off, shape.high);
    return PerssonContact(HeightSpectrum(shells), modulus_of_the_paper, 0.42)
        .mean_gap(0.1 * modulus_of_the_paper);
  };
  const double exact =
      contact_of_the_paper().mean_gap(0.1 * modulus_of_the_paper);

  const double coarse = gap_with(500) / exact - 1.0;
  const double fine = gap_with(1000) / exact - 1.0;

  EXPECT_LT(std::abs(fine), 1e-5);
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

// p(u) needs no asymptote as initial guess: below gamma = 1.7e-3 eps is
// infinite, and u(p) nearly all cubic. Tolerance as in the test of the
// identities.
TEST(PerssonExtremes, PressureOfTheGapAtTinyGamma) {
  const PerssonContact contact = contact_of_the_paper().with_gamma(1e-4);
  for (const double gap : {1e-12, 1e-10, 5e-10}) {
    const double pressure = contact.nominal_pressure(gap);

    expect_relative(contact.mean_gap(pressure), gap, 1e-13);
  }
}

// fit_gamma finds the gamma from which the points were computed; with a
// constant error of the gap added it changes by the least squares of that
// error.
TEST(FitGamma, RecoversTheGammaOfACurve) {
  const PerssonContact& contact = contact_of_the_paper();
  const PerssonContact exact = contact.with_gamma(0.37);
  std::vector<GapPoint> points;
  for (const double ratio : {1e-3, 3e-3, 1e-2, 3e-2, 1e-1})
    points.push_back({ratio * contact.contact_modulus(),
                      exact.mean_gap(ratio * contact.contact_modulus())});

  EXPECT_NEAR(fit_gamma(contact, points), 0.37, 1e-13);

  const auto misfit = [&](double gamma) {
    double sum = 0.0;
    for (const GapPoint& point : points)
      sum +=
          std::pow(contact.with_gamma(gamma).mean_gap(point.nominal_pressure) -
                       point.mean_gap,
                   2);
    return sum;
  };
  for (GapPoint& point : points)
    point.mean_gap += 1e-11;
  const double best = fit_gamma(contact, points);
  EXPECT_LT(misfit(best), misfit(best + 1e-4));
  EXPECT_LT(misfit(best), misfit(best - 1e-4));
}

TEST(PerssonInput, RefusesBadArgumentsByName) {
  const HeightSpectrum spectrum = surface_of_the_paper().spectrum();
  const PerssonContact& contact = contact_of_the_paper();

  EXPECT_TRUE(tests::message_of<std::domain_error>([&] {
                PerssonContact(spectrum, 0.0, 0.4);
              }).starts_with("contact_modulus = 0"));
  EXPECT_TRUE(tests::message_of<std::domain_error>([&] {
                PerssonContact(spectrum, 1.0, 1.5);
              }).starts_with("gamma = 1.5"));
  EXPECT_TRUE(tests::message_of<std::domain_error>([&] {
                contact.with_gamma(0.0);
              }).starts_with("gamma = 0"));
  EXPECT_TRUE(tests::message_of<std::domain_error>([&] {
                contact.mean_gap(0.0);
              }).starts_with("nominal_pressure = 0"));
  EXPECT_TRUE(tests::message_of<std::domain_error>([&] {
                contact.nominal_pressure(-1e-9);
              }).starts_with("mean_gap = -1e-09"));
  EXPECT_TRUE(tests::message_of<std::domain_error>([&] {
                fit_gamma(contact, {});
              }).starts_with("number of points = 0"));
}

} // namespace asperity::theory::persson_test
