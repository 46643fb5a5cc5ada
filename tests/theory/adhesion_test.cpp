// Tests of theory/persson/adhesion.hpp: the numbers of the surface in Sec. 9,
// the order of the discretisation, similarity, and the limits of both branches.
#include "tests/theory/spectra.hpp"
#include "theory/persson/adhesion.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::theory::adhesion_test {

using std::numbers::pi;

// The rubber on surface 7 of Sec. 9 as far as the text states it: h_0 = 0.2 um,
// E = 5 MPa, nu = 0.5, Dgamma = 0.1 J/m^2; no roll-off.
constexpr AdhesivePair rubber{5e6 / 0.75, 0.1, 0.42, 2.0 / pi};

SelfAffine surface_7() {
  return SelfAffine{0.8, 7.944e5, 7.944e5, 7.944e7, 1.0}.with_rms_height(
      0.2e-6);
}

RoughAdhesion adhesion(int n_steps) {
  return RoughAdhesion(surface_7().spectrum(), rubber, n_steps);
}

// The area factor is the mean of sqrt(1 + s^2) over an exponential distribution
// of s^2. Tolerance: the quadrature's; at 1/xi = 20 the formula changes.
TEST(TrueArea, IsTheMeanOverGaussianSlopes) {
  boost::math::quadrature::exp_sinh<double> quadrature;
  for (const double square : {1e-6, 1.0 / 401.0, 1.0 / 399.0, 0.1, 1.0, 30.0}) {
    const double excess = quadrature.integrate(
        [&](double t) {
          return square * t / (std::sqrt(1.0 + square * t) + 1.0) *
                 std::exp(-t);
        },
        1e-13);
    EXPECT_NEAR((true_area_factor(square) - 1.0) / excess, 1.0,
                1e-12 + 3e-16 / square);
  }
  EXPECT_EQ(true_area_factor(0.0), 1.0);
}

// Complete contact has the closed form Dgamma a(xi^2) - E* (pi/2) int q^2 C,
// without an error from the steps; at h_0 it is -0.1 Dgamma (printed digit).
TEST(RoughAdhesion, CompleteContactHasAClosedForm) {
  const SelfAffine shape = surface_7();
  for (const double ratio : {0.3, 1.0, 1.5}) {
    const double square = ratio * ratio;
    const double expected =
        0.1 *
            true_area_factor(2.0 * pi * square * shape.moment(shape.high, 3)) -
        0.5 * pi * rubber.contact_modulus * square *
            shape.moment(shape.high, 2);

    const AdhesiveState state = adhesion(20).complete_contact(ratio);

    EXPECT_NEAR(state.effective_work / 0.1, expected / 0.1, 1e-12);
    EXPECT_EQ(state.area_fraction, 1.0);
  }
  EXPECT_NEAR(adhesion(20).complete_contact(1.0).effective_work / 0.1, -0.1,
              5e-4);
}

// Verifies that partial contact converges at second order in the steps.
TEST(RoughAdhesion, ConvergesAtSecondOrder) {
  const auto at = [&](int n) { return adhesion(n).partial_contact(0.9); };
  const AdhesiveState coarse = at(40), middle = at(80), fine = at(160);

  EXPECT_TRUE(coarse.converged && middle.converged && fine.converged);
  EXPECT_NEAR(std::log2((coarse.effective_work - middle.effective_work) /
                        (middle.effective_work - fine.effective_work)),
              2.0, 0.1);
  EXPECT_NEAR(std::log2((coarse.area_fraction - middle.area_fraction) /
                        (middle.area_fraction - fine.area_fraction)),
              2.0, 0.25);
}

// The state changes at h/h_0 = 0.871, where partial contact has A/A_0 = 0.499
// (printed digits), extrapolated from two discretisations.
TEST(RoughAdhesion, FlipsWhereSectionNineDoes) {
  const RoughAdhesion coarse = adhesion(50), fine = adhesion(100);
  const double flip_coarse = coarse.flip(0.8, 1.0);
  const double flip_fine = fine.flip(0.8, 1.0);
  const double area_coarse = coarse.partial_contact(flip_coarse).area_fraction;
  const double area_fine = fine.partial_contact(flip_fine).area_fraction;

  EXPECT_NEAR((4.0 * flip_fine - flip_coarse) / 3.0, 0.871, 5e-4);
  EXPECT_NEAR((4.0 * area_fine - area_coarse) / 3.0, 0.499, 5e-4);
  EXPECT_EQ(fine.equilibrium(0.999 * flip_fine).area_fraction, 1.0);
  EXPECT_LT(fine.equilibrium(1.001 * flip_fine).area_fraction, 0.5);
}

// With increasing roughness the binding energy only decreases, partial contact
// still has one at h_0 where complete contact has none, and sufficiently rough
// surfaces separate.
TEST(RoughAdhesion, SweepDecreasesAndEndsSeparated) {
  const RoughAdhesion contact = adhesion(60);
  double last = rubber.work_of_adhesion * 1.01;
  for (const double ratio : {0.2, 0.5, 0.8, 0.87, 0.9, 1.0, 1.1}) {
    const AdhesiveState state = contact.equilibrium(ratio);
    ASSERT_TRUE(state.exists && state.converged) << ratio;
    EXPECT_LT(state.effective_work, last);
    EXPECT_GT(state.area_fraction, 0.0);
    last = state.effective_work;
  }
  EXPECT_LT(contact.complete_contact(1.0).effective_work, 0.0);
  EXPECT_FALSE(contact.equilibrium(1.5).exists);
  EXPECT_TRUE(contact.equilibrium(1.5).converged);
}

// gamma_eff(q) is Dgamma at q_1; the stress distribution has unit mass at q_L
// and only loses mass. Both are exact.
TEST(RoughAdhesion, StateGoesFromCompleteToTrueContact) {
  const AdhesiveState state = adhesion(60).partial_contact(0.9);

  EXPECT_EQ(state.area_fractions.front(), 1.0);
  EXPECT_TRUE(std::is_sorted(state.area_fractions.rbegin(),
                             state.area_fractions.rend()));
  EXPECT_EQ(state.area_fractions.back(), state.area_fraction);
  EXPECT_EQ(state.effective_works.front(), state.effective_work);
  EXPECT_NEAR(state.effective_works.back() / 0.1, 1.0, 1e-15);
  EXPECT_TRUE(
      std::is_sorted(state.wavevectors.begin(), state.wavevectors.end()));
  EXPECT_EQ(state.wavevectors.size(), state.area_fractions.size());
}

// Only Dgamma q_0/E* matters besides the shape of the spectrum: lengths and
// stresses scale. Tolerance: roundoff through the iteration's 1e-10.
TEST(RoughAdhesion, ScalesWithLengthAndModulus) {
  SelfAffine larger = surface_7();
  larger.low *= 0.01;
  larger.roll_off *= 0.01;
  larger.high *= 0.01;
  larger = larger.with_rms_height(0.2e-4);
  AdhesivePair stiffer = rubber;
  stiffer.contact_modulus *= 7.0;
  stiffer.work_of_adhesion *= 700.0;
  const RoughAdhesion other(larger.spectrum(), stiffer, 40);

  const AdhesiveState scaled = other.partial_contact(0.9);
  const AdhesiveState state = adhesion(40).partial_contact(0.9);

  EXPECT_NEAR(scaled.effective_work / 700.0 / state.effective_work, 1.0, 1e-8);
  EXPECT_NEAR(scaled.area_fraction / state.area_fraction, 1.0, 1e-8);
}

// Surfaces that cannot detach (c -> inf) or that are hardly rough stay in
// complete contact: both branches agree.
TEST(RoughAdhesion, IsCompleteWhereNothingDetaches) {
  AdhesivePair strong = rubber;
  strong.detachment_factor = 100.0;
  const RoughAdhesion contact(surface_7().spectrum(), strong, 40);

  EXPECT_NEAR(contact.partial_contact(0.7).area_fraction, 1.0, 1e-12);
  EXPECT_NEAR(contact.partial_contact(0.7).effective_work /
                  contact.complete_contact(0.7).effective_work,
              1.0, 1e-9);
  EXPECT_NEAR(adhesion(40).partial_contact(0.1).area_fraction, 1.0, 1e-12);
}

// Verifies JKR's (3 pi/2) R gamma_eff, zero without a binding energy, and the
// refusal of invalid arguments.
TEST(RoughAdhesion, PullsOffAsJkrAndRefuses) {
  EXPECT_NEAR(rough_pull_off_force(0.01, 0.04), 1.5 * pi * 4e-4, 1e-18);
  EXPECT_EQ(rough_pull_off_force(0.01, -0.04), 0.0);
  EXPECT_THROW(rough_pull_off_force(0.0, 0.04), std::domain_error);
  AdhesivePair bad = rubber;
  bad.work_of_adhesion = 0.0;
  EXPECT_THROW(RoughAdhesion(surface_7().spectrum(), bad, 40),
               std::domain_error);
  EXPECT_THROW(RoughAdhesion(surface_7().spectrum(), rubber, 3),
               std::domain_error);
  EXPECT_THROW(
      RoughAdhesion(HeightSpectrum(std::vector<SpectrumShell>{{1e7, 1e-17}}),
                    rubber, 40),
      std::domain_error);
  EXPECT_THROW(adhesion(40).flip(0.5, 0.6), std::domain_error);
  EXPECT_THROW(adhesion(40).complete_contact(0.0), std::domain_error);
}

} // namespace asperity::theory::adhesion_test
