// Tests of theory/persson/persson.hpp against numbers that were computed by
// another program and with 25-digit arithmetic, against the limits, and by
// exact identities for random spectra, loads and gammas.
#include "tests/message_of.hpp"
#include "tests/theory/spectra.hpp"
#include "theory/persson/persson.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

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
}

using std::numbers::pi;

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 100001) * 1e-5;
}

double log_between(double low, double high) {
  return std::exp(between(std::log(low), std::log(high)));
}

SelfAffine any_shape() {
  SelfAffine shape;
  shape.hurst = between(0.05, 0.98);
  shape.low = log_between(1e3, 1e9);
  shape.roll_off = shape.low * log_between(1.0, 20.0);
  shape.high = shape.roll_off * log_between(1.01, 500.0);
  return shape.with_rms_height(log_between(1e-3, 3.0) / shape.high);
}

PerssonContact any_contact(const SelfAffine& shape) {
  return PerssonContact(shape.spectrum(), log_between(1e5, 1e12),
                        between(0.05, 1.0));
}

double any_pressure(const PerssonContact& contact) {
  return contact.contact_modulus() * contact.spectrum().rms_slope() *
         log_between(1e-6, 2.0);
}

double relative(double found, double expected) {
  return std::abs(found / expected - 1.0);
}

// Verifies (14) as the paper writes it, an integral over q with w(q) in closed
// form. Tolerance: tanh-sinh's own, 1e-12.
RC_GTEST_PROP(PerssonIdentity, GapIsThePapersIntegralOverWavevectors, ()) {
  const SelfAffine shape = any_shape();
  const PerssonContact contact = any_contact(shape);
  const double pressure = any_pressure(contact);
  boost::math::quadrature::tanh_sinh<double> quadrature;

  // q = q_L + t^2 keeps the digits of q - q_L next to q_L.
  const auto integrand = [&](double t) {
    const double q = shape.low + t * t;
    const double w = 1.0 / std::sqrt(pi * shape.moment_over(t * t, 3));
    const double x = w * pressure / contact.contact_modulus();
    if (!(x < 25.0))
      return 0.0;
    return 2.0 * t * std::sqrt(pi) * q * q * shape(q) * w *
           gap_kernel(x).at(contact.gamma());
  };
  const double kink = std::sqrt(shape.roll_off - shape.low);
  const double end = std::sqrt(shape.high - shape.low);
  double gap = 0.0;
  if (kink > 0.0)
    gap = quadrature.integrate(integrand, 0.0, kink, 1e-13) +
          boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
              integrand, kink, end, 15, 1e-13);
  else
    gap = quadrature.integrate(integrand, 0.0, end, 1e-13);

  RC_ASSERT(relative(contact.mean_gap(pressure), gap) < 1e-12);
}

// Verifies (6), the work of the load is the elastic energy: int_u^inf p du' =
// int_0^p D dp' = U_el(p)/A_0. Tolerance: the quadrature's.
RC_GTEST_PROP(PerssonIdentity, WorkOfTheLoadIsTheElasticEnergy, ()) {
  const PerssonContact contact = any_contact(any_shape());
  const double pressure = any_pressure(contact);
  boost::math::quadrature::tanh_sinh<double> quadrature;

  const double work = quadrature.integrate(
      [&](double p) { return p > 0.0 ? contact.mean_gap_slope(p) : 0.0; }, 0.0,
      pressure, 1e-13);

  RC_ASSERT(relative(contact.elastic_energy(pressure), work) < 1e-12);
}

// D is the derivative of (14): int D dln p' over a factor of two is the
// decrease of the gap. Tolerance: roundoff of the difference, eps u/D, with u/D
// < 20.
RC_GTEST_PROP(PerssonIdentity, SlopeIntegratesToTheFallOfTheGap, ()) {
  const PerssonContact contact = any_contact(any_shape());
  const double pressure = any_pressure(contact);

  const double fall =
      contact.mean_gap(pressure) - contact.mean_gap(2.0 * pressure);

  const double integral =
      boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
          [&](double p) { return contact.mean_gap_slope(p) / p; }, pressure,
          2.0 * pressure, 5, 1e-14);
  RC_ASSERT(relative(fall, integral) < 1e-12);
  RC_ASSERT(relative(contact.contact_stiffness(pressure) *
                         contact.mean_gap_slope(pressure),
                     pressure) < 1e-15);
}

// p(u) inverts u(p) over the whole range of doubles, near full contact and at
// separations where only the asymptote remains. Tolerance: p carries the error
// of u times u/D, and u rounds to some 1e-14.
RC_GTEST_PROP(PerssonIdentity, PressureOfTheGapUndoesTheGap, ()) {
  const PerssonContact contact = any_contact(any_shape());
  const double gap =
      contact.spectrum().rms_height() * log_between(1e-250, 250.0);

  const double pressure = contact.nominal_pressure(gap);

  const double condition =
      std::max(1.0, contact.mean_gap_slope(pressure) / gap);
  RC_ASSERT(relative(contact.mean_gap(pressure), gap) < 3e-14 * condition);
}

// The energy of full contact is E* (pi/2) int q^2 C dq, in closed form.
RC_GTEST_PROP(PerssonIdentity, EnergySaturatesInFullContact, ()) {
  const SelfAffine shape = any_shape();
  const PerssonContact contact = any_contact(shape);
  const double expected =
      0.5 * pi * contact.contact_modulus() * shape.moment(shape.high, 2);
  const double crushing =
      1e12 * contact.contact_modulus() * contact.spectrum().rms_slope();

  RC_ASSERT(relative(contact.full_contact_energy(), expected) < 1e-12);
  RC_ASSERT(relative(contact.elastic_energy(crushing), expected) < 1e-12);
  RC_ASSERT(contact.mean_gap(crushing) == 0.0);
}

// (14) tends to (17), u -> u_0 ln(beta E*/p). Tolerance: the first correction,
// c p/E* with c = 2 Lambda/(sqrt(pi) q_L) of the next test, where abs(Lambda) <
// 3, doubled; and roundoff.
RC_GTEST_PROP(PerssonIdentity, GapTendsToTheAsymptote, ()) {
  const SelfAffine shape = any_shape();
  const PerssonContact contact = any_contact(shape);
  const double ratio =
      contact.spectrum().rms_slope() * log_between(1e-15, 1e-9);
  const double pressure = ratio * contact.contact_modulus();

  const double gap = contact.mean_gap(pressure);

  const double asymptote = contact.gap_decay_length() *
                           std::log(contact.pressure_prefactor() / ratio);
  const double correction = 2.0 * 3.0 / (std::sqrt(pi) * shape.low) * ratio;
  RC_ASSERT(std::abs(gap - asymptote) < 2.0 * correction + 1e-13 * gap);
  RC_ASSERT(relative(contact.asymptotic_pressure(asymptote), pressure) < 1e-12);
}

// For p -> 0 D - u_0 = c p/E*, c = 2 Lambda/(sqrt(pi) q_L), Lambda = -gamma
// sqrt(pi) + 3 (1 - gamma) int erf^2 e^{-x^2} dx/x^2. The slope is extrapolated
// from p and 2p; the remainder is of second order, measured 1e-6.
TEST(PerssonSmallPressure, SlopeHasItsFirstCorrection) {
  const SelfAffine shape = surface_of_the_paper();
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double integral = quadrature.integrate(
      [](double x) {
        return x > 0.0 ? std::pow(std::erf(x) / x, 2) * std::exp(-x * x)
                       : 4.0 / pi;
      },
      0.0, 6.7);
  EXPECT_NEAR(integral, 0.895209904530044, 1e-14);
  for (const double gamma : {0.1, 0.42, 1.0}) {
    const PerssonContact contact(shape.spectrum(), 1.0, gamma);
    const double lambda =
        -gamma * std::sqrt(pi) + 3.0 * (1.0 - gamma) * integral;
    const double expected = 2.0 * lambda / (std::sqrt(pi) * shape.low);
    const auto quotient = [&](double pressure) {
      return (contact.mean_gap_slope(pressure) - contact.gap_decay_length()) /
             pressure;
    };

    const double extrapolated = 2.0 * quotient(1e-6) - quotient(2e-6);

    EXPECT_NEAR(extrapolated / expected, 1.0, 1e-6) << "gamma " << gamma;
  }
}

// A narrow band has u_0 = sqrt(2/pi) gamma h_rms; one shell is the limit
// itself, and a formula of relative width 1e-6 differs from it by as much.
TEST(PerssonNarrowBand, DecaysOverSqrtTwoOverPiOfItsHeight) {
  const double gamma = 0.42, height = 3e-9, q = 2e8;
  const HeightSpectrum shell(std::vector<SpectrumShell>{{q, height * height}});
  SelfAffine band{0.8, q, q, q * (1.0 + 1e-6), 1.0};
  band = band.with_rms_height(height);

  const double expected = std::sqrt(2.0 / pi) * gamma * height;
  const PerssonContact of_shell(shell, 1e9, gamma);
  const PerssonContact of_band(band.spectrum(), 1e9, gamma);
  EXPECT_NEAR(of_shell.gap_decay_length() / expected, 1.0, 1e-14);
  EXPECT_NEAR(of_band.gap_decay_length() / expected, 1.0, 1e-6);
  EXPECT_NEAR(of_band.mean_gap(1e7) / of_shell.mean_gap(1e7), 1.0, 1e-6);
}

// Verifies (16) as the paper writes it, with its logarithm under the integral.
TEST(PerssonEpsilon, IsThePapersIntegral) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double gamma : {0.2, 0.42, 0.9}) {
    const double ratio = (1.0 - gamma) / gamma;
    const double exponent = -quadrature.integrate(
        [&](double x) {
          const double probability = std::erf(x);
          const double density = 2.0 / std::sqrt(pi) * std::exp(-x * x);
          return std::log(x) * std::exp(-x * x) *
                 (6.0 * ratio * probability * density -
                  (1.0 + 3.0 * ratio * probability * probability) * 2.0 * x);
        },
        0.0, 6.7);

    EXPECT_NEAR(std::log(persson_epsilon(gamma)), exponent, 1e-13);
  }
}

} // namespace asperity::theory::persson_test
