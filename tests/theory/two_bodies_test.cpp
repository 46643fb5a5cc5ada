// Tests of tests/theory/two_bodies.hpp: compliances add, and so do the mean
// squares of heights and slopes.
#include "tests/theory/spectra.hpp"
#include "tests/theory/two_bodies.hpp"
#include "theory/persson/persson.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace asperity::theory::two_bodies_test {

// Equal bodies halve E*; with a rigid body it is that of the other. Tolerance:
// roundoff.
TEST(TwoBodies, CompliancesAdd) {
  const ElasticBody gold{77.2e9, 0.42}, rigid{1e40, 0.3};

  EXPECT_NEAR(contact_modulus(gold) / modulus_of_the_paper, 1.0, 1e-15);
  EXPECT_NEAR(combined_contact_modulus(gold, gold) / modulus_of_the_paper, 0.5,
              1e-15);
  EXPECT_NEAR(combined_contact_modulus(gold, rigid) / modulus_of_the_paper, 1.0,
              1e-15);
  EXPECT_THROW(contact_modulus({0.0, 0.3}), std::domain_error);
  EXPECT_THROW(contact_modulus({1.0, 0.6}), std::domain_error);
  EXPECT_THROW(contact_modulus({1.0, -1.0}), std::domain_error);
}

// For two different formulas over different ranges every moment is the sum of
// the two closed ones. Tolerance: roundoff of the quadrature.
TEST(TwoBodies, MomentsOfFormulasAdd) {
  const SelfAffine fine = surface_of_the_paper();
  SelfAffine coarse{0.6, 2e7, 1e8, 3e8, 1.0};
  coarse = coarse.with_rms_height(2e-9);

  const HeightSpectrum both =
      combined_spectrum(fine.spectrum(), coarse.spectrum());

  EXPECT_NEAR(both.rms_height() / std::sqrt(5e-18), 1.0, 1e-14);
  EXPECT_NEAR(both.full_contact_moment() /
                  (fine.moment(fine.high, 2) + coarse.moment(coarse.high, 2)),
              1.0, 1e-14);
  EXPECT_NEAR(std::pow(both.rms_slope(), 2) /
                  (std::pow(fine.spectrum().rms_slope(), 2) +
                   std::pow(coarse.spectrum().rms_slope(), 2)),
              1.0, 1e-14);
  EXPECT_EQ(both.wavevector_low(), coarse.low);
  EXPECT_EQ(both.wavevector_high(), fine.high);
}

// Two statistically equal surfaces are one surface that is sqrt2 times as
// rough: the gap of twice the spectrum under one load, as two patches of the
// polymer film.
TEST(TwoBodies, TwoEqualSurfacesAreOneRougherByRootTwo) {
  const SelfAffine shape = surface_of_the_paper();
  const HeightSpectrum twice =
      shape.with_rms_height(std::sqrt(2.0) * 1e-9).spectrum();

  const PerssonContact both(
      combined_spectrum(shape.spectrum(), shape.spectrum()), 1e9, 0.4);

  EXPECT_NEAR(both.mean_gap(1e7) /
                  PerssonContact(twice, 1e9, 0.4).mean_gap(1e7),
              1.0, 1e-13);
}

// Shells are joined, also at one wavevector; a formula and shells are not.
TEST(TwoBodies, ShellsJoin) {
  const HeightSpectrum first(
      std::vector<SpectrumShell>{{1e7, 1e-18}, {3e7, 2e-18}});
  const HeightSpectrum second(
      std::vector<SpectrumShell>{{2e7, 4e-18}, {3e7, 1e-18}});
  const HeightSpectrum merged(
      std::vector<SpectrumShell>{{1e7, 1e-18}, {2e7, 4e-18}, {3e7, 3e-18}});

  const HeightSpectrum both = combined_spectrum(first, second);

  EXPECT_NEAR(both.rms_height() / merged.rms_height(), 1.0, 1e-15);
  EXPECT_NEAR(PerssonContact(both, 1e9, 0.4).mean_gap(1e6) /
                  PerssonContact(merged, 1e9, 0.4).mean_gap(1e6),
              1.0, 1e-13);
  EXPECT_THROW(combined_spectrum(first, surface_of_the_paper().spectrum()),
               std::domain_error);
}

} // namespace asperity::theory::two_bodies_test
