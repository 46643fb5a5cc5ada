// Tests of contact/solvers/mirrored_adhesion.hpp and of the operator on a
// quarter of a cell.
#include "base/mirrored_convolution.hpp"
#include "contact/operators/fourier_operator.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/mirrored_adhesion.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace asperity::contact::mirrored_adhesion_test {

constexpr Grid cell{64, 48, 1.0, 0.6};

/// The field of the cell that equals its mirror images.
template <class Real>
std::vector<Real> unfolded(const std::vector<Real>& quarter) {
  const Grid part = quarter_of(cell);
  std::vector<Real> whole(cell.size());
  for (int y = 0; y < cell.points_y; ++y)
    for (int x = 0; x < cell.points_x; ++x)
      whole[cell.index(x, y)] =
          quarter[part.index(std::min(x, cell.points_x - 1 - x),
                             std::min(y, cell.points_y - 1 - y))];
  return whole;
}

template <class Real>
void expect_near(const std::vector<Real>& found, const std::vector<Real>& exact,
                 double accuracy) {
  ASSERT_EQ(found.size(), exact.size());
  const auto largest = static_cast<double>(std::abs(*std::ranges::max_element(
      exact, {}, [](Real value) { return std::abs(value); })));
  ASSERT_GT(largest, 0.0);
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_NEAR(static_cast<double>(found[i]), static_cast<double>(exact[i]),
                accuracy * largest)
        << i;
}

class MirroredOperators : public testing::TestWithParam<int> {
protected:
  FourierOperator whole = problems::unit_halfspace(cell);
  std::unique_ptr<SurfaceOperator> quarter =
      problems::unit_halfspace(cell, GetParam()).mirrored();
};

TEST_P(MirroredOperators, DoWhatTheWholeDoes) {
  const std::vector<double> field =
      problems::random_field(quarter_of(cell).size());
  ASSERT_EQ(quarter->grid(), quarter_of(cell));
  EXPECT_EQ(quarter->short_wave_compliance(), whole.short_wave_compliance());
  std::vector<double> part = field;
  std::vector<double> all = unfolded(field);

  quarter->displacement(part, part);
  whole.displacement(all, all);
  expect_near(unfolded(part), all, 1e-14);

  quarter->pressure_of(part, part);
  whole.pressure_of(all, all);
  expect_near(unfolded(part), all, 1e-14);

  std::vector<float> estimate(field.begin(), field.end());
  std::vector<float> of_all = unfolded(estimate);
  quarter->clone()->pressure_estimate(estimate, 0.03, estimate);
  whole.pressure_estimate(of_all, 0.03, of_all);
  expect_near(unfolded(estimate), of_all, 3e-6);
}

INSTANTIATE_TEST_SUITE_P(Threads, MirroredOperators, testing::Values(1, 3));

TEST(MirroredAdhesion, OddNumbersOfPointsHaveNoQuarter) {
  EXPECT_EQ(problems::unit_halfspace({63, 48, 1.0, 0.6}).mirrored(), nullptr);
  EXPECT_EQ(problems::unit_halfspace({64, 47, 1.0, 0.6}).mirrored(), nullptr);
}

std::vector<double> mirrored_heights() {
  const std::vector<double> rough = problems::rough_heights(cell, {});
  std::vector<double> quarter(quarter_of(cell).size());
  const Grid part = quarter_of(cell);
  for (int y = 0; y < part.points_y; ++y)
    for (int x = 0; x < part.points_x; ++x)
      quarter[part.index(x, y)] = 0.1 * rough[cell.index(x, y)];
  return unfolded(quarter);
}

TEST(MirroredAdhesion, IsThatOfHeightsThatEqualTheirMirrorImages) {
  const FourierOperator whole = problems::unit_halfspace(cell);
  std::vector<double> heights = mirrored_heights();
  EXPECT_TRUE(MirroredAdhesion::of(whole, heights).has_value());
  const double largest = std::ranges::max(heights);
  heights[cell.index(3, 5)] += 1e-13 * largest;
  EXPECT_TRUE(MirroredAdhesion::of(whole, heights).has_value());
  heights[cell.index(3, 5)] += 1e-11 * largest;
  EXPECT_FALSE(MirroredAdhesion::of(whole, heights).has_value());
  EXPECT_FALSE(MirroredAdhesion::of(whole, problems::rough_heights(cell, {})));
}

// Heights shifted by a node do not equal their mirror images about the middle
// lines: the same problem on all nodes.
class MirroredPaths : public testing::TestWithParam<mechanics::ContactLaw> {
protected:
  static std::vector<double> shifted(const std::vector<double>& field) {
    std::vector<double> moved(field.size());
    for (int y = 0; y < cell.points_y; ++y)
      for (int x = 0; x < cell.points_x; ++x)
        moved[cell.periodic_index(x + 1, y + 1)] = field[cell.index(x, y)];
    return moved;
  }

  static LoadSequence path(const std::vector<double>& heights) {
    const double work = 2e-6;
    const mechanics::ContactInterface law =
        mechanics::ContactSettings{
            .law = GetParam(),
            .work_of_adhesion = work,
            .range =
                mechanics::Quantity{std::sqrt(work * cell.spacing_x() / 0.1),
                                    mechanics::ReferenceUnit::si}}
            .in_si({.contact_modulus = 1.0, .spacing = cell.spacing_x()});
    return {problems::unit_halfspace(cell).clone(), heights, law,
            1e-10 * problems::rms(heights), 2000};
  }
};

TEST_P(MirroredPaths, AreThoseOfTheWholeCell) {
  const std::vector<double> heights = mirrored_heights();
  LoadSequence of_quarter = path(heights);
  LoadSequence of_all = path(shifted(heights));
  for (const double reduced_gap : {2.0, 1.0, 0.6, 1.5}) {
    const mechanics::LoadTarget target{mechanics::Control::mean_gap,
                                       reduced_gap * problems::rms(heights)};
    const ContactSolution quarter = of_quarter.solve(target);
    const ContactSolution all = of_all.solve(target);
    ASSERT_TRUE(quarter.converged && all.converged);
    EXPECT_NEAR(quarter.nominal_pressure, all.nominal_pressure,
                1e-6 * std::abs(all.nominal_pressure));
    expect_near(shifted(quarter.gap), all.gap, 1e-6);
    expect_near(shifted(quarter.pressure), all.pressure, 1e-6);
    expect_near(shifted(quarter.displacement), all.displacement, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, MirroredPaths,
                         testing::Values(mechanics::ContactLaw::exponential,
                                         mechanics::ContactLaw::dugdale,
                                         mechanics::ContactLaw::lennard_jones));

} // namespace asperity::contact::mirrored_adhesion_test
