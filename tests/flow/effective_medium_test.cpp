// Bruggeman's effective medium against its solutions in closed form.
#include "mechanics/flow/effective_medium.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::flow::effective_medium_test {
namespace {

using Numbers = std::vector<double>;

TEST(EffectiveMedium, OneGap) {
  EXPECT_NEAR(effective_medium(Numbers(100, 2e-9)), 8e-27, 1e-36);
}

TEST(EffectiveMedium, TwoPhasesOfEqualShare) {
  // K^2 = k_1 k_2, the exact value by duality.
  EXPECT_NEAR(effective_medium(Numbers{1.0, 2.0}, Numbers{0.5, 0.5}),
              std::sqrt(8.0), 1e-10);
}

TEST(EffectiveMedium, OpenAndClosed) {
  // K = k (1 - 2 A/A_0), 0 from 1/2 on.
  EXPECT_NEAR(effective_medium(Numbers{2.0}, Numbers{0.7}), 8.0 * 0.4, 1e-9);
  EXPECT_NEAR(effective_medium(Numbers{2.0}, Numbers{0.501}), 8.0 * 0.002,
              1e-10);
  EXPECT_EQ(effective_medium(Numbers{2.0}, Numbers{0.5}), 0.0);
  EXPECT_EQ(effective_medium(Numbers{2.0, 0.0, 0.0}), 0.0);
  EXPECT_NEAR(effective_medium(Numbers{2.0, 2.0, 2.0, 0.0}), 4.0, 1e-9);
}

TEST(EffectiveMedium, LognormalGapHasItsGeometricMean) {
  // exp<ln k>, exact in two dimensions, by the symmetry of ln k.
  Numbers gaps, shares;
  double total = 0.0;
  for (int i = -400; i <= 400; ++i) {
    const double x = 0.02 * i;
    gaps.push_back(3e-9 * std::exp(x));
    shares.push_back(std::exp(-0.5 * x * x));
    total += shares.back();
  }
  for (double& share : shares)
    share /= total;
  EXPECT_NEAR(effective_medium(gaps, shares) / 27e-27, 1.0, 1e-9);
}

TEST(EffectiveMedium, SizesMustAgree) {
  EXPECT_THROW(effective_medium(Numbers{1.0}, Numbers{}), std::domain_error);
}

} // namespace
} // namespace asperity::flow::effective_medium_test
