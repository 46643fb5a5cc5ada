// Tests of theory/persson/leakage.hpp: the critical constriction is where the
// area percolates, the flow is Poiseuille's, and a tight seal does not leak.
#include "tests/theory/spectra.hpp"
#include "theory/persson/leakage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::theory::leakage_test {

constexpr double modulus = 10e6, reference = 1e4;
constexpr Fluid water{1e3, 1e-3};

SelfAffine rough_steel() {
  return SelfAffine{0.8, 1e4, 1e4, 1e7, 1.0}.with_rms_height(5e-6);
}

MagnifiedContact seal(const HeightSpectrum& spectrum, double load) {
  return MagnifiedContact(PerssonContact(spectrum, modulus, 0.42), load,
                          reference);
}

// At zeta* the resolved moment is that of the critical area, by the closed
// antiderivative; the flow is rho u_1^3 Dp/(12 eta). Tolerance: that of the
// root finder.
TEST(Leakage, PoreIsWhereTheAreaIsCritical) {
  const SelfAffine shape = rough_steel();
  const MagnifiedContact contact = seal(shape.spectrum(), 0.3e6);

  const Leak leak = leakage(contact, water, 1e5);

  ASSERT_TRUE(leak.percolates);
  const double resolved = shape.moment(leak.magnification * reference, 3);
  EXPECT_NEAR(
      std::erf(0.3e6 / modulus / std::sqrt(std::numbers::pi * resolved)),
      square_lattice_critical_area, 1e-12);
  EXPECT_EQ(leak.pore_gap, contact.opening_gap(leak.magnification));
  EXPECT_NEAR(leak.pore_size * leak.magnification * reference,
              2.0 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(leak.mass_flow * 12.0 * 1e-3 /
                  (1e3 * std::pow(leak.pore_gap, 3) * 1e5),
              1.0, 1e-14);
}

// Under a larger load the critical constriction is at a larger magnification
// and narrower, and finally there is none.
TEST(Leakage, DecreasesWithTheLoadToZero) {
  Leak last = leakage(seal(rough_steel().spectrum(), 0.1e6), water, 1e5);
  for (const double load : {0.2e6, 0.4e6, 0.8e6}) {
    const Leak leak = leakage(seal(rough_steel().spectrum(), load), water, 1e5);
    ASSERT_TRUE(leak.percolates) << load;
    EXPECT_GT(leak.magnification, last.magnification);
    EXPECT_LT(leak.mass_flow, last.mass_flow);
    last = leak;
  }
  EXPECT_FALSE(
      leakage(seal(rough_steel().spectrum(), 50e6), water, 1e5).percolates);
}

// A formula that is divided into fine shells gives the same leakage. Tolerance:
// the steps are 2 % in q; u_1 is a mean over one step, of first order at its
// upper end.
TEST(Leakage, OfFineShellsIsThatOfTheFormula) {
  const SelfAffine shape = rough_steel();
  std::vector<SpectrumShell> shells;
  for (double q = shape.low; q < 0.999 * shape.high;) {
    const double next = std::min(shape.high, 1.02 * q);
    const double share = shape.moment(next, 1) - shape.moment(q, 1);
    shells.push_back({std::sqrt(q * next), 2.0 * std::numbers::pi * share});
    q = next;
  }

  const Leak smooth = leakage(seal(shape.spectrum(), 0.3e6), water, 1e5);
  const Leak steps = leakage(seal(HeightSpectrum(shells), 0.3e6), water, 1e5);

  ASSERT_TRUE(steps.percolates);
  EXPECT_NEAR(steps.magnification / smooth.magnification, 1.0, 0.02);
  EXPECT_NEAR(steps.pore_gap / smooth.pore_gap, 1.0, 0.05);
}

// A fluid whose viscosity is not set has no value that could be used by
// mistake; it is refused like a viscosity of zero.
TEST(Leakage, RefusesWhatIsOutsideItsRange) {
  const MagnifiedContact contact = seal(rough_steel().spectrum(), 0.3e6);
  EXPECT_THROW(leakage(contact, {1e3, 0.0}, 1e5), std::domain_error);
  EXPECT_THROW(leakage(contact, Fluid{.density = 1e3}, 1e5), std::domain_error);
  EXPECT_THROW(leakage(contact, {-1.0, 1e-3}, 1e5), std::domain_error);
  EXPECT_THROW(leakage(contact, water, -1e5), std::domain_error);
  EXPECT_THROW(leakage(contact, water, 1e5, 1.0), std::domain_error);
}

} // namespace asperity::theory::leakage_test
