// Tests of contact/operators/mirrored_operator.hpp, and of loading paths on a
// quarter of a cell.
#include "base/ranks/mirrored_convolution.hpp"
#include "contact/operators/mirrored_operator.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace asperity::contact::mirrored_test {

constexpr Grid cell{64, 48, 1.0, 0.6};

void expect_near(const std::vector<double>& found,
                 const std::vector<double>& exact, double accuracy) {
  ASSERT_EQ(found.size(), exact.size());
  const double largest = std::abs(*std::ranges::max_element(
      exact, {}, [](double value) { return std::abs(value); }));
  ASSERT_GT(largest, 0.0);
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_NEAR(found[i], exact[i], accuracy * largest) << i;
}

/// A grid and a number of threads.
using Setting = std::pair<Grid, int>;

class MirroredOperators : public testing::TestWithParam<Setting> {};

TEST_P(MirroredOperators, DoWhatTheWholeDoes) {
  const auto& [grid, threads] = GetParam();
  FourierOperator whole = problems::unit_halfspace(grid);
  const std::unique_ptr<SurfaceOperator> quarter =
      problems::unit_halfspace(grid, threads).mirrored();
  ASSERT_EQ(quarter->grid(), quarter_of(grid));
  EXPECT_EQ(quarter->short_wave_compliance(), whole.short_wave_compliance());
  const std::vector<double> field =
      problems::random_field(quarter_of(grid).size());
  std::vector<double> part = field;
  std::vector<double> all = unfolded(field, grid);

  quarter->displacement(part, part);
  whole.displacement(all, all);
  expect_near(unfolded(part, grid), all, 1e-14);

  quarter->pressure_of(part, part);
  whole.pressure_of(all, all);
  expect_near(unfolded(part, grid), all, 1e-14);

  const std::vector<double> unfolded_field = unfolded(field, grid);
  const auto expect_same_in_float = [&, own = grid](const auto& apply) {
    std::vector<float> of_part(field.begin(), field.end());
    std::vector<float> of_all(unfolded_field.begin(), unfolded_field.end());
    apply(*quarter->clone(), of_part);
    apply(whole, of_all);
    expect_near(
        unfolded(std::vector<double>(of_part.begin(), of_part.end()), own),
        {of_all.begin(), of_all.end()}, 3e-6);
  };
  expect_same_in_float([](SurfaceOperator& any, std::span<float> values) {
    any.pressure_estimate(values, 0.03, values);
  });
  expect_same_in_float([](SurfaceOperator& any, std::span<float> values) {
    any.displacement_change(values, values);
  });
}

INSTANTIATE_TEST_SUITE_P(Grids, MirroredOperators,
                         testing::Values(Setting{cell, 1}, Setting{cell, 3},
                                         Setting{{62, 46, 1.0, 0.6}, 1},
                                         Setting{{2, 30, 1.0, 1.0}, 1},
                                         Setting{{34, 2, 1.0, 1.0}, 1}));

TEST(MirroredOperator, OddNumbersOfPointsHaveNoQuarter) {
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
  return unfolded(quarter, cell);
}

TEST(MirroredOperator, IsForHeightsThatEqualTheirMirrorImages) {
  std::vector<double> heights = mirrored_heights();
  EXPECT_TRUE(equals_mirror_images(heights, cell));
  const double largest = std::ranges::max(heights);
  heights[cell.index(3, 5)] += 1e-13 * largest;
  EXPECT_TRUE(equals_mirror_images(heights, cell));
  heights[cell.index(3, 5)] += 1e-11 * largest;
  EXPECT_FALSE(equals_mirror_images(heights, cell));
  EXPECT_FALSE(equals_mirror_images(problems::rough_heights(cell, {}), cell));
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

  static LoadSequence path(std::unique_ptr<SurfaceOperator> elasticity,
                           const std::vector<double>& heights) {
    mechanics::ContactInterface interface;
    if (GetParam() != mechanics::ContactLaw::hard) {
      const double work = 2e-6;
      interface =
          mechanics::ContactSettings{
              .law = GetParam(),
              .work_of_adhesion = work,
              .range =
                  mechanics::Quantity{std::sqrt(work * cell.spacing_x() / 0.1),
                                      mechanics::ReferenceUnit::si}}
              .in_si({.contact_modulus = 1.0, .spacing = cell.spacing_x()});
    }
    return {std::move(elasticity), heights, interface,
            1e-10 * problems::rms(heights), 2000};
  }
};

TEST_P(MirroredPaths, AreThoseOfTheWholeCell) {
  const std::vector<double> heights = mirrored_heights();
  const FourierOperator whole = problems::unit_halfspace(cell);
  LoadSequence of_quarter =
      path(whole.mirrored(), first_quarter(heights, cell));
  LoadSequence of_all = path(whole.clone(), shifted(heights));
  for (const double reduced_gap : {2.0, 1.0, 0.6, 1.5}) {
    const mechanics::LoadTarget target{mechanics::Control::mean_gap,
                                       reduced_gap * problems::rms(heights)};
    const ContactSolution quarter = of_quarter.solve(target);
    const ContactSolution all = of_all.solve(target);
    ASSERT_TRUE(quarter.converged && all.converged);
    EXPECT_NEAR(quarter.nominal_pressure, all.nominal_pressure,
                1e-6 * std::abs(all.nominal_pressure));
    expect_near(shifted(unfolded(quarter.gap, cell)), all.gap, 1e-6);
    expect_near(shifted(unfolded(quarter.pressure, cell)), all.pressure, 1e-6);
    expect_near(shifted(unfolded(quarter.displacement, cell)), all.displacement,
                1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, MirroredPaths,
                         testing::Values(mechanics::ContactLaw::hard,
                                         mechanics::ContactLaw::exponential,
                                         mechanics::ContactLaw::dugdale,
                                         mechanics::ContactLaw::lennard_jones));

} // namespace asperity::contact::mirrored_test
