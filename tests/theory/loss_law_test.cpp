// Tests of theory/persson/loss_law.hpp and of PerssonContact::with_law against
// the published scheme, the defining equations, exact identities and the public
// GFMD ensemble.
#include "tests/message_of.hpp"
#include "tests/theory/spectra.hpp"
#include "theory/persson/loss_law.hpp"
#include "theory/persson/persson.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::theory::loss_law_test {

using boost::math::quadrature::gauss_kronrod;
using std::numbers::pi;

double wang_mueser_factor(double gamma, double area) {
  return gamma - 2.0 / 9.0 * area * area +
         (11.0 / 9.0 - gamma) * std::pow(area, 4);
}

PerssonContact paper_contact() {
  return {surface_of_the_paper().spectrum(), modulus_of_the_paper, 0.42};
}

/// Both laws with the parameters of their publications.
std::vector<PerssonContact> contacts() {
  return {paper_contact().with_law(LossLaw::wang_mueser(5.0 / 9.0)),
          paper_contact().with_law(LossLaw::xu(0.45))};
}

// P = erf(p/sqrt(2 [gamma + (1 - gamma) P] V_f)), the published equation.
// Tolerance: the interpolation of s(x).
TEST(LossLaw, XuAreaSolvesItsEquation) {
  for (const double gamma : {0.1, 0.45, 0.9})
    for (const double x : {1e-8, 1e-3, 0.1, 0.7, 1.9}) {
      const double area =
          std::erf(x * std::sqrt(LossLaw::xu(gamma).variance_reduction(x)));

      const double expected =
          std::erf(x / std::sqrt(gamma + (1.0 - gamma) * area));
      EXPECT_NEAR(area / expected, 1.0, 1e-9) << gamma << " " << x;
    }
}

// dV = S(P) dV_f, step by step through the scales as published, V at the end of
// each step. That scheme is of first order: twice the steps, half the error.
TEST(LossLaw, WangMueserAreaIsThatOfSmallSteps) {
  const double gamma = 5.0 / 9.0;
  const LossLaw law = LossLaw::wang_mueser(gamma);
  const auto by_steps = [&](double x, int steps) { // p = 1, V_f = 1/(2 x^2)
    double variance = 0.0;
    double last_full = 0.0;
    double area = 1.0;
    for (int i = 1; i <= steps; ++i) {
      const double full =
          0.5 / (x * x) * std::pow(1e-6, 1.0 - double(i) / steps);
      for (int inner = 0; inner < 60; ++inner)
        area = std::erf(
            1.0 / std::sqrt(2.0 * (variance + wang_mueser_factor(gamma, area) *
                                                  (full - last_full))));
      variance += wang_mueser_factor(gamma, area) * (full - last_full);
      last_full = full;
    }
    return area;
  };
  for (const double x : {0.05, 0.3, 1.0}) {
    const double exact = std::erf(x * std::sqrt(law.variance_reduction(x)));

    const double coarse = by_steps(x, 2000) - exact;
    const double fine = by_steps(x, 4000) - exact;

    EXPECT_LT(std::abs(fine), 1e-3 * exact) << x;
    EXPECT_NEAR(coarse / fine, 2.0, 0.05) << x;
  }
}

// W = P dV/dV_f with V_f = 1/x^2 and V = V_f/F, by central differences, whose
// error is the square of the step.
TEST(LossLaw, EnergyIsReducedLikeTheVariance) {
  for (const LossLaw& law : {LossLaw::wang_mueser(0.4), LossLaw::xu(0.3)})
    for (const double x : {1e-4, 0.05, 0.4, 1.2, 2.5}) {
      const auto variance = [&](double at) {
        return 1.0 / (at * at * law.variance_reduction(at));
      };
      const double low = x * (1.0 - 1e-3);
      const double high = x * (1.0 + 1e-3);
      const double slope = (variance(low) - variance(high)) /
                           (1.0 / (low * low) - 1.0 / (high * high));
      const double area = std::erf(x * std::sqrt(law.variance_reduction(x)));

      EXPECT_NEAR(law.energy(x) / (area * slope), 1.0, 2e-5) << x;
    }
}

// With gamma = 1 Xu's law is Persson's original theory, as is Eq. (10).
TEST(LossLaw, XuWithoutLossIsThePapersTheory) {
  const PerssonContact paper = paper_contact().with_gamma(1.0);
  const PerssonContact contact = paper.with_law(LossLaw::xu(1.0));
  for (const double ratio : {1e-7, 1e-4, 1e-2, 0.1, 0.6}) {
    const double pressure = ratio * modulus_of_the_paper;

    EXPECT_NEAR(contact.area_fraction(pressure) / paper.area_fraction(pressure),
                1.0, 1e-9);
    EXPECT_NEAR(contact.elastic_energy(pressure) /
                    paper.elastic_energy(pressure),
                1.0, 1e-9);
    EXPECT_NEAR(contact.mean_gap(pressure) / paper.mean_gap(pressure), 1.0,
                1e-8);
    EXPECT_NEAR(contact.mean_gap_slope(pressure) /
                    paper.mean_gap_slope(pressure),
                1.0, 1e-8);
  }
  EXPECT_NEAR(contact.pressure_prefactor() / paper.pressure_prefactor(), 1.0,
              1e-9);
}

// (6) holds for every law: int_0^p D dp' = U_el, and D = -du/dln p.
TEST(LossLaw, WorkOfTheLoadIsTheElasticEnergy) {
  for (const PerssonContact& contact : contacts())
    for (const double ratio : {1e-4, 1e-2, 0.3}) {
      const double pressure = ratio * modulus_of_the_paper;
      const double work = gauss_kronrod<double, 61>::integrate(
          [&](double root) {
            return 2.0 * root * contact.mean_gap_slope(root * root);
          },
          0.0, std::sqrt(pressure), 10, 1e-11);
      const double fall = gauss_kronrod<double, 61>::integrate(
          [&](double p) { return contact.mean_gap_slope(p) / p; }, pressure,
          2.0 * pressure, 10, 1e-11);

      EXPECT_NEAR(contact.elastic_energy(pressure) / work, 1.0, 1e-8);
      EXPECT_NEAR(
          (contact.mean_gap(pressure) - contact.mean_gap(2.0 * pressure)) /
              fall,
          1.0, 1e-8);
      EXPECT_NEAR(contact.nominal_pressure(contact.mean_gap(pressure)) /
                      pressure,
                  1.0, 1e-9);
    }
}

// Light load: A = sqrt(8/(pi gamma)) p/(E* h') and u = u_0 ln(beta E*/p) with
// u_0 = sqrt(gamma) u_0(1). The next terms are of the order of the load.
TEST(LossLaw, LightLoadHasTheRootOfGamma) {
  const double gammas[] = {5.0 / 9.0, 0.45};
  for (std::size_t i = 0; i < 2; ++i) {
    const PerssonContact contact = contacts()[i];
    const double pressure = 1e-8 * modulus_of_the_paper;
    const double reduced = 1e-8 / contact.spectrum().rms_slope();

    EXPECT_NEAR(contact.area_fraction(pressure) /
                    (std::sqrt(8.0 / (pi * gammas[i])) * reduced),
                1.0, 1e-6);
    EXPECT_NEAR(contact.gap_decay_length() /
                    paper_contact().with_gamma(1.0).gap_decay_length(),
                std::sqrt(gammas[i]), 1e-12);
    EXPECT_NEAR(contact.mean_gap_slope(pressure) / contact.gap_decay_length(),
                1.0, 1e-5);
    EXPECT_NEAR(contact.asymptotic_pressure(contact.mean_gap(pressure)) /
                    pressure,
                1.0, 1e-5);
  }
}

TEST(LossLaw, FullContactIsThatOfEveryLaw) {
  for (const PerssonContact& contact : contacts()) {
    const double crushing =
        6.0 * modulus_of_the_paper * contact.spectrum().rms_slope();

    EXPECT_NEAR(contact.area_fraction(crushing), 1.0, 1e-12);
    EXPECT_NEAR(contact.elastic_energy(crushing) /
                    contact.full_contact_energy(),
                1.0, 1e-10);
    EXPECT_NEAR(contact.stress_variance(crushing) / contact.stress_variance(),
                1.0, 1e-10);
  }
}

// The pressure distribution of a law has its area and the load.
TEST(LossLaw, PressureDistributionHasAreaAndLoad) {
  for (const PerssonContact& contact : contacts()) {
    const double pressure = 0.02 * modulus_of_the_paper;
    const PressureMoments moments = contact.pressure_moments(pressure);

    EXPECT_NEAR(moments.area_fraction / contact.area_fraction(pressure), 1.0,
                1e-14);
    EXPECT_NEAR(moments.nominal_pressure / pressure, 1.0, 1e-14);
  }
}

// The public GFMD ensemble (repository xylcsi/PerssonModelFudgeFactor): E* = 1
// Pa, q_L = 1e4/m, q_1 = 1e6/m, H = 0.8, h_rms = 6 um. Both laws meet its areas
// to 5 %, where Eq. (4) is up to 28 % below; at light load their energies are
// far above it (wang-mueser 62 %, xu 56 %), that of Eq. (10) 14 %. The
// deviations were computed by another program, to 0.1 %.
TEST(LossLaw, DeviationsFromThePublicEnsemble) {
  const SelfAffine shape = SelfAffine{0.8, 1e4, 1e4, 1e6}.with_rms_height(6e-6);
  const PerssonContact paper(shape.spectrum(), 1.0, 0.45);
  const PerssonContact wang = paper.with_law(LossLaw::wang_mueser(5.0 / 9.0));
  const PerssonContact xu = paper.with_law(LossLaw::xu(0.45));
  const auto percent = [](double found, double published) {
    return 100.0 * (found / published - 1.0);
  };
  const double tolerance = 0.15;

  EXPECT_NEAR(percent(paper.area_fraction(0.005), 0.0399348), -27.8, tolerance);
  EXPECT_NEAR(percent(wang.area_fraction(0.005), 0.0399348), -3.0, tolerance);
  EXPECT_NEAR(percent(xu.area_fraction(0.005), 0.0399348), 5.0, tolerance);
  EXPECT_NEAR(percent(wang.area_fraction(0.065), 0.432595), 4.6, tolerance);
  EXPECT_NEAR(percent(xu.area_fraction(0.065), 0.432595), -0.7, tolerance);
  EXPECT_NEAR(percent(paper.elastic_energy(0.005), 1.31138e-8), 14.1,
              tolerance);
  EXPECT_NEAR(percent(wang.elastic_energy(0.005), 1.31138e-8), 62.0, tolerance);
  EXPECT_NEAR(percent(xu.elastic_energy(0.005), 1.31138e-8), 56.4, tolerance);
  EXPECT_NEAR(percent(xu.elastic_energy(0.113), 1.88027e-7), 5.8, tolerance);
}

TEST(LossLaw, RefusesGammaByName) {
  EXPECT_TRUE(tests::message_of<std::domain_error>([] {
                LossLaw::xu(0.0);
              }).starts_with("gamma = 0"));
  EXPECT_TRUE(tests::message_of<std::domain_error>([] {
                LossLaw::wang_mueser(0.01);
              }).starts_with("gamma = 0.01"));
}

} // namespace asperity::theory::loss_law_test
