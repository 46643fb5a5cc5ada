// Tests of run/methods/load_steps.hpp: a surface that equals its mirror images
// is solved on a quarter of it, and answered on all of it.
#include "contact/operators/halfspace.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/load_steps.hpp"
#include "surfaces/maps/edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity::methods::mirrored_map_test {

constexpr Grid cell{64, 48, 1e-6, 0.75e-6};
constexpr double rms_height = 4e-9;

/// Heights of a map, without symmetry, and its mirror images.
std::vector<double> heights_of_cell() {
  surfaces::HeightMap map{{32, 24, 0.5e-6, 0.375e-6}, {}};
  for (int y = 0; y < map.grid.points_y; ++y)
    for (int x = 0; x < map.grid.points_x; ++x)
      map.heights.push_back(4e-9 * (std::sin(0.7 * x + 0.4 * y) +
                                    std::sin(0.3 * x - 0.8 * y) + 0.02 * x));
  return surfaces::with_edges(std::move(map), mechanics::Edges::mirror).heights;
}

/// The field one node further in both directions, which does not equal its
/// mirror images about the middle lines.
std::vector<double> shifted(const std::vector<double>& field) {
  std::vector<double> moved(field.size());
  for (int y = 0; y < cell.points_y; ++y)
    for (int x = 0; x < cell.points_x; ++x)
      moved[cell.periodic_index(x + 1, y + 1)] = field[cell.index(x, y)];
  return moved;
}

std::unique_ptr<StepSolver>
solver_of(const std::vector<double>& heights,
          const mechanics::ContactInterface& interface = {}) {
  LoadStepsSetting setting;
  setting.interface = interface;
  setting.gap_tolerance = 1e-18;
  setting.max_iterations = 2000;
  setting.rms_height = rms_height;
  setting.observation.contact_modulus = 1e9;
  setting.observation.hardness = interface.hardness;
  setting.observation.local_compliance = interface.local_compliance();
  return make_load_steps(
      contact::halfspace_operator(cell, mechanics::halfspace(1e9)).clone(),
      heights, setting);
}

StepTarget pressed(double pressure) {
  return {{mechanics::Control::nominal_pressure, pressure}};
}

void expect_same(const std::vector<double>& found,
                 const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  const double largest = std::ranges::max(expected);
  ASSERT_GT(largest, 0.0);
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_NEAR(found[i], expected[i], 1e-6 * largest) << i;
}

class MirroredMap : public testing::TestWithParam<mechanics::ContactInterface> {
};

TEST_P(MirroredMap, HasTheAnswersOfTheWholeCell) {
  const std::vector<double> heights = heights_of_cell();
  const auto quarter = solver_of(heights, GetParam());
  const auto whole = solver_of(shifted(heights), GetParam());
  // A field of a step of the quarter is smaller.
  (void)quarter->solve(pressed(1e6));
  (void)whole->solve(pressed(1e6));
  EXPECT_LT(3 * quarter->state().size(), whole->state().size());

  for (const double pressure : {2e6, 1e7}) {
    const StepAnswer own = quarter->solve(pressed(pressure));
    const StepAnswer all = whole->solve(pressed(pressure));

    ASSERT_EQ(own.row.status, results::StepStatus::converged) << own.row.note;
    EXPECT_EQ(own.grid, cell);
    EXPECT_NEAR(own.row.mean_gap, all.row.mean_gap, 1e-6 * all.row.mean_gap);
    EXPECT_EQ(own.row.area_fraction, all.row.area_fraction);
    expect_same(shifted(own.pressure), all.pressure);
    expect_same(shifted(own.gap), all.gap);
    // A bound by the root of the roundoff of an energy: 4e-6 of h_rms.
    EXPECT_LT(own.row[columns::certified_gap_error], 2e-5 * rms_height);
    EXPECT_LT(all.row[columns::certified_gap_error], 2e-5 * rms_height);
  }
}

TEST_P(MirroredMap, ContinuesFromItsState) {
  const std::vector<double> heights = heights_of_cell();
  const auto first = solver_of(heights, GetParam());
  (void)first->solve(pressed(2e6));
  const auto second = solver_of(heights, GetParam());
  second->restore(first->state());
  EXPECT_EQ(second->solve(pressed(1e7)).pressure,
            first->solve(pressed(1e7)).pressure);
}

mechanics::ContactInterface soft() {
  return {mechanics::ContactLaw::penalty, 1e18};
}

mechanics::ContactInterface with_hardness() {
  mechanics::ContactInterface interface;
  interface.hardness = 6e7;
  return interface;
}

INSTANTIATE_TEST_SUITE_P(Laws, MirroredMap,
                         testing::Values(mechanics::ContactInterface{}, soft(),
                                         with_hardness()));

} // namespace asperity::methods::mirrored_map_test
