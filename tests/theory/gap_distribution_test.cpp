// Tests of theory/persson/gap_distribution.hpp, and of the monotone decrease of
// u(zeta) and u_1(zeta) that makes it a distribution.
#include "tests/theory/spectra.hpp"
#include "theory/persson/gap_distribution.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace asperity::theory::gap_distribution_test {

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 100001) * 1e-5;
}

double log_between(double low, double high) {
  return std::exp(between(std::log(low), std::log(high)));
}

MagnifiedContact any_contact() {
  SelfAffine shape;
  shape.hurst = between(0.05, 0.98);
  shape.roll_off = shape.low * log_between(1.0, 20.0);
  shape.high = shape.roll_off * log_between(1.5, 100.0);
  shape = shape.with_rms_height(log_between(1e-3, 1.0) / shape.high);
  const PerssonContact contact(shape.spectrum(), 1e9, between(0.05, 1.0));
  const double load =
      1e9 * contact.spectrum().rms_slope() * log_between(1e-3, 1.0);
  return MagnifiedContact(contact, load, shape.low * log_between(0.1, 10.0));
}

// With increasing magnification h_rms, A, u and u_1 decrease, u_1 lies above u,
// and the pressure in the apparent contact increases. No tolerance but
// roundoff.
RC_GTEST_PROP(GapDistributionProperty, EverythingFallsWithMagnification, ()) {
  const MagnifiedContact contact = any_contact();
  const double low = contact.lowest_magnification();
  const double high = contact.highest_magnification();
  const double near = low * std::pow(high / low, between(0.02, 0.9));
  const double far = near * std::pow(high / near, between(0.05, 0.95));

  RC_ASSERT(contact.rms_height(far) < contact.rms_height(near));
  RC_ASSERT(contact.area_fraction(far) <= contact.area_fraction(near));
  RC_ASSERT(contact.mean_gap(far) < contact.mean_gap(near) ||
            contact.mean_gap(near) == 0.0);
  RC_ASSERT(contact.opening_gap(far) < contact.opening_gap(near) ||
            contact.opening_gap(near) == 0.0 ||
            std::isinf(contact.opening_gap(far)));
  RC_ASSERT(contact.opening_gap(near) >= contact.mean_gap(near));
}

GapDistribution of_the_paper(double load) {
  const SelfAffine shape = surface_of_the_paper();
  return GapDistribution(MagnifiedContact(
      PerssonContact(shape.spectrum(), modulus_of_the_paper, 0.42), load,
      shape.roll_off));
}

// P_u is the derivative of Psi. The reference is the increase of Psi over a
// step of ln u, of fourth order after one extrapolation. Tolerance: the fourth
// order itself, up to 3e-4 at this step; halving it must reduce it by a factor
// near 16.
TEST(GapDistribution, DensityIsTheDerivativeOfTheCumulative) {
  for (const double load : {0.1e9, 1.3e9, 10e9}) {
    const GapDistribution gaps = of_the_paper(load);
    for (const double gap : {3e-11, 5e-10, 2e-9}) {
      const auto quotient = [&](double step) {
        const double high = gap * std::exp(step), low = gap * std::exp(-step);
        return (gaps.cumulative(high) - gaps.cumulative(low)) /
               (2.0 * step * gap);
      };
      const auto error = [&](double step) {
        const double extrapolated =
            (4.0 * quotient(0.5 * step) - quotient(step)) / 3.0;
        return std::abs(extrapolated / gaps.density(gap) - 1.0);
      };

      EXPECT_LT(error(0.05), 1e-3) << load << ' ' << gap;
      EXPECT_LT(error(0.025), 0.1 * error(0.05) + 1e-8) << load << ' ' << gap;
    }
  }
}

// The limits of Psi are the weight of the delta function at u = 0 and 1 at
// infinity; far out 1 - Psi decreases as 1/(u ln^2 u) within its slow
// corrections.
TEST(GapDistribution, RunsFromTheContactWeightToOne) {
  const GapDistribution gaps = of_the_paper(1.3e9);

  EXPECT_NEAR(gaps.cumulative(1e-60), gaps.contact_weight(), 1e-3);
  EXPECT_GT(gaps.cumulative(1e-60), gaps.contact_weight());
  EXPECT_GT(gaps.cumulative(1e-6), 0.999);
  EXPECT_LT(gaps.cumulative(1e-6), 1.0);
  EXPECT_THROW(gaps.density(0.0), std::domain_error);
  const PerssonContact shells(
      HeightSpectrum(std::vector<SpectrumShell>{{1e7, 1e-17}}), 2e9, 0.4);
  EXPECT_THROW(GapDistribution(MagnifiedContact(shells, 1e7, 1e7)),
               std::domain_error);
}

} // namespace asperity::theory::gap_distribution_test
