// Tests of results/observables/contact_stiffness.hpp, on curves with known
// derivatives.
#include "results/observables/contact_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace asperity::results::contact_stiffness_test {

const std::vector<double> uneven_gaps{90e-9, 70e-9, 64e-9, 40e-9, 11e-9, 1e-9};

// p = p_1 exp(-u/u_0) has K = p/u_0 at every point including the ends.
// Tolerance: ln p is near 16 and steps of ln p down to 0.7, so one ulp of ln p
// is 16/0.7 eps of a slope; the parabola at an end weighs it some tenfold.
TEST(ContactStiffness, OfAnExponentialIsExactAtUnevenSteps) {
  const double decay_length = 9e-9;
  std::vector<double> pressure;
  for (const double gap : uneven_gaps)
    pressure.push_back(1e7 * std::exp(-gap / decay_length));

  const std::vector<double> stiffness =
      contact_stiffness(uneven_gaps, pressure);

  for (std::size_t i = 0; i < pressure.size(); ++i)
    EXPECT_NEAR(stiffness[i] * decay_length / pressure[i], 1.0, 1e-13) << i;
}

// A parabola in ln p is differentiated exactly, which no two-point formula
// does: K = p (b + 2 c u) for ln p = a - b u - c u^2. Tolerance as above.
TEST(ContactStiffness, TakesTheCurvatureOfLnPressure) {
  const double b = 1e8;  // 1/m
  const double c = 4e14; // 1/m^2
  std::vector<double> pressure;
  for (const double gap : uneven_gaps)
    pressure.push_back(std::exp(16.0 - b * gap - c * gap * gap));

  const std::vector<double> stiffness =
      contact_stiffness(uneven_gaps, pressure);

  for (std::size_t i = 0; i < pressure.size(); ++i)
    EXPECT_NEAR(stiffness[i] / pressure[i] / (b + 2 * c * uneven_gaps[i]), 1.0,
                1e-13)
        << i;
}

// The error decreases with the square of the step. p = cosh has a third
// derivative of ln p; halving the step divides the largest error by four, to
// the next order, which at these steps is below 20 %.
TEST(ContactStiffness, IsOfSecondOrder) {
  const auto largest_error = [](int n_steps) {
    std::vector<double> gap;
    std::vector<double> pressure;
    for (int i = 0; i <= n_steps; ++i) {
      gap.push_back(2.0 - 1.5 * i / n_steps);
      pressure.push_back(1.0 / std::sinh(gap.back()));
    }
    const std::vector<double> stiffness = contact_stiffness(gap, pressure);
    double largest = 0.0;
    for (std::size_t i = 1; i + 1 < gap.size(); ++i)
      largest = std::max(
          largest, std::abs(stiffness[i] - pressure[i] / std::tanh(gap[i])));
    return largest;
  };

  EXPECT_NEAR(std::log2(largest_error(64) / largest_error(128)), 2.0, 0.2);
}

TEST(ContactStiffness, OfTwoPointsIsTheLineAndOfOneNothing) {
  const std::vector<double> two =
      contact_stiffness(std::vector{2.0, 1.0}, std::vector{1.0, std::exp(3.0)});

  EXPECT_NEAR(two[0], 3.0, 1e-14);
  EXPECT_NEAR(two[1] / std::exp(3.0), 3.0, 1e-14);
  EXPECT_TRUE(std::isnan(
      contact_stiffness(std::vector{2.0}, std::vector{1.0}).front()));
  EXPECT_TRUE(contact_stiffness({}, {}).empty());
}

TEST(ContactStiffness, IsNaNWhereThereIsNoSlope) {
  const std::vector<double> stiffness =
      contact_stiffness(std::vector{4.0, 3.0, 2.0, 1.0, 1.0, 0.5},
                        std::vector{0.0, 1.0, 2.0, 4.0, 8.0, 16.0});

  EXPECT_TRUE(std::isnan(stiffness[0])); // p = 0
  EXPECT_TRUE(std::isnan(stiffness[1])); // its neighbour
  EXPECT_TRUE(std::isfinite(stiffness[2]));
  EXPECT_TRUE(std::isnan(stiffness[4])); // two equal gaps
  EXPECT_THROW(contact_stiffness(std::vector{1.0}, {}), std::domain_error);
}

// Between two steps of one load, or before and after a third, is nothing but
// what the solver leaves: here 1e-8 of both numbers.
TEST(ContactStiffness, IsNaNBetweenTwoStepsOfOneLoad) {
  const double off = 1.0 + 1e-8;
  for (const double stiffness : contact_stiffness(std::vector{2.0, 2.0 * off},
                                                  std::vector{1.0, 1.0 * off}))
    EXPECT_TRUE(std::isnan(stiffness)) << stiffness;
  for (const double stiffness : contact_stiffness(
           std::vector{2.0, 1.0, 2.0 * off}, std::vector{1.0, 3.0, 1.0 * off}))
    EXPECT_TRUE(std::isnan(stiffness)) << stiffness;
}

// Loading and unloading are differentiated separately, and values that a method
// stated remain: here its 7, and slopes 2 and 3 of the two branches.
TEST(FillContactStiffness, KeepsBranchesApartAndGivenValues) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<CurvePoint> points;
  for (const double gap : {3.0, 2.0, 1.0, 1.0, 2.0, 3.0}) {
    CurvePoint point;
    point.is_unloading = points.size() >= 3;
    point.mean_gap = gap;
    point.nominal_pressure = std::exp(-(point.is_unloading ? 3.0 : 2.0) * gap);
    point.contact_stiffness = points.size() == 1 ? 7.0 : none;
    points.push_back(point);
  }

  fill_contact_stiffness(points);

  EXPECT_EQ(points[1].contact_stiffness, 7.0);
  for (const std::size_t i : {0U, 2U, 3U, 4U, 5U})
    EXPECT_NEAR(points[i].contact_stiffness / points[i].nominal_pressure,
                points[i].is_unloading ? 3.0 : 2.0, 1e-13)
        << i;
}

} // namespace asperity::results::contact_stiffness_test
