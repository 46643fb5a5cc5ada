// Tests of contact/solvers/winkler.hpp: the solution satisfies the conditions
// of the contact problem, and its contact area is the bearing area.
#include "contact/solvers/winkler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::contact::winkler_test {

constexpr auto by_pressure = mechanics::Control::nominal_pressure;
constexpr auto by_gap = mechanics::Control::mean_gap;

// Springs of 2 Pa/m compressed to level 2 carry 2 (5 - 2) = 6 Pa and 2 (3 - 2)
// = 2 Pa at two of the four nodes.
TEST(Winkler, HasTheClosedFormForFourNodes) {
  const std::vector<double> heights = {1.0, 5.0, 3.0, -9.0};

  const ContactSolution found =
      winkler_contact(heights, 2.0, {by_pressure, 2.0});

  EXPECT_EQ(found.pressure, (std::vector<double>{0.0, 6.0, 2.0, 0.0}));
  EXPECT_EQ(found.gap, (std::vector<double>{1.0, 0.0, 0.0, 11.0}));
  EXPECT_EQ(found.displacement, (std::vector<double>{-1.0, 2.0, 0.0, -1.0}));
  EXPECT_EQ(found.mean_gap, 3.0);
  EXPECT_EQ(found.nominal_pressure, 2.0);
  EXPECT_TRUE(found.converged);
}

class WinklerOnRoughness : public testing::TestWithParam<double> {
protected:
  /// The quantiles of the normal distribution of rms 1 m, which have mean 0;
  /// 4096 of them represent a Gaussian surface.
  static std::vector<double> gaussian() {
    std::vector<double> heights;
    for (int i = 0; i < 4096; ++i) {
      double low = -9.0, high = 9.0;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(-middle / std::numbers::sqrt2) < (i + 0.5) / 4096.0
             ? low
             : high) = middle;
      }
      heights.push_back(low);
    }
    return heights;
  }
};

// Verifies gap = u + w - h with w = (p - p_0)/k of mean 0, p >= 0, gap >= 0 and
// p gap = 0, for a load or for the mean gap that it gives. The counted area is
// the bearing area erfc(s/sqrt(2))/2 at the level s = u - p_0/k of the springs,
// to one node of 4096.
TEST_P(WinklerOnRoughness, SatisfiesTheConditions) {
  constexpr double stiffness = 3e5;
  const std::vector<double> heights = gaussian();
  const double load = GetParam() * stiffness;

  const ContactSolution found =
      winkler_contact(heights, stiffness, {by_pressure, load});

  EXPECT_NEAR(found.nominal_pressure / load, 1.0, 1e-12);
  double sum = 0.0;
  int touching = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    EXPECT_NEAR(found.gap[i],
                found.mean_gap + found.displacement[i] - heights[i], 1e-12);
    EXPECT_EQ(found.pressure[i] * found.gap[i], 0.0);
    EXPECT_TRUE(found.pressure[i] >= 0.0 && found.gap[i] >= 0.0);
    sum += found.displacement[i];
    touching += found.pressure[i] > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(sum, 0.0, 1e-9);
  const double level = found.mean_gap - load / stiffness;
  EXPECT_NEAR(touching / 4096.0, 0.5 * std::erfc(level / std::numbers::sqrt2),
              1.0 / 4096.0);
  if (found.mean_gap > 1e-9) {
    const ContactSolution again =
        winkler_contact(heights, stiffness, {by_gap, found.mean_gap});
    EXPECT_NEAR(again.nominal_pressure / load, 1.0, 1e-9);
  }
}

// From one node in contact to all of them.
INSTANTIATE_TEST_SUITE_P(Loads, WinklerOnRoughness,
                         testing::Values(1e-6, 1e-3, 0.1, 1.0, 3.0, 20.0));

TEST(Winkler, HasNoContactAboveTheHighestNode) {
  const std::vector<double> heights = {-1.0, 1.0};
  const ContactSolution found = winkler_contact(heights, 1.0, {by_gap, 1.5});
  EXPECT_EQ(found.nominal_pressure, 0.0);
  EXPECT_EQ(found.gap, (std::vector<double>{2.5, 0.5}));
}

TEST(Winkler, RefusesWhatIsOutOfRange) {
  const std::vector<double> flat = {0.0};
  EXPECT_THROW(winkler_contact({}, 1.0, {by_pressure, 1.0}), std::domain_error);
  EXPECT_THROW(winkler_contact(flat, 0.0, {by_pressure, 1.0}),
               std::domain_error);
  EXPECT_THROW(winkler_contact(flat, 1.0, {by_gap, 0.0}), std::domain_error);
  EXPECT_THROW(
      winkler_contact(std::vector<double>{NAN}, 1.0, {by_pressure, 1.0}),
      std::domain_error);
}

} // namespace asperity::contact::winkler_test
