// Tests of the quantities of a path with adhesion, on paths whose energy is
// U = k (u - u_0)^2/2 - w_eff, so that p = -k (u - u_0).
#include "reports/analysis/exact.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::reports::adhesion_quantities_test {

using results::CurvePoint;

constexpr double stiffness = 1e14; // Pa/m
constexpr double rms_height = 1e-8;
constexpr double work = 0.05; // J/m^2

struct Branch {
  double gap;            ///< u_0 [m]
  double effective_work; ///< w_eff [J/m^2]
};

CurvePoint row_at(const Branch& branch, double mean_gap, bool is_unloading) {
  CurvePoint row;
  const double way = mean_gap - branch.gap;
  row.is_unloading = is_unloading;
  row.mean_gap = mean_gap;
  row.nominal_pressure = -stiffness * way;
  row.area_fraction = 0.5 - way / rms_height;
  row.elastic_energy = 0.5 * stiffness * way * way;
  row[columns::adhesive_energy] = -branch.effective_work;
  row.status = results::StepStatus::converged;
  return row;
}

/// @param steps  of the path of the case; 0: not known
MethodSummary summary_of(const std::vector<CurvePoint>& rows,
                         std::size_t steps = 0) {
  cases::Case contact_case;
  contact_case.load.targets.resize(steps);
  mechanics::HalfspaceSettings settings;
  settings.contact.law = mechanics::ContactLaw::exponential;
  settings.contact.work_of_adhesion = work;
  contact_case.methods = {{"halfspace", settings}};
  results::Result result;
  result.contact_modulus = 1e9;
  result.methods = {{"halfspace", "halfspace", "", {{rows, {}, 0.0}}}};
  result.surfaces.emplace_back().rms_height = rms_height;
  MethodSummary summary;
  add_adhesion_quantities(result, contact_case, result.methods.front(),
                          summary);
  return summary;
}

/// Two methods with these rows, the first of them without a summary.
double difference_of(const std::vector<CurvePoint>& rows,
                     const std::vector<CurvePoint>& others) {
  cases::Case contact_case;
  mechanics::HalfspaceSettings settings;
  settings.contact.law = mechanics::ContactLaw::morse;
  settings.contact.work_of_adhesion = work;
  contact_case.methods = {{"halfspace", settings}, {"halfspace.b", settings}};
  results::Result result;
  result.contact_modulus = 1e9;
  result.methods = {{"halfspace", "halfspace", "", {{others, {}, 0.0}}},
                    {"halfspace.b", "halfspace", "", {{rows, {}, 0.0}}}};
  result.surfaces.emplace_back().rms_height = rms_height;
  MethodSummary summary;
  add_adhesion_quantities(result, contact_case, result.methods.back(), summary);
  return summary.quantities.at("adhesive_difference").value;
}

constexpr Branch outside{3e-8, 0.01}, inside{1e-8, 0.04};

// A path by mean gaps, on which no row is without load: the states between rows
// are exact for this energy.
TEST(AdhesionQuantities, FindTheStatesWithoutLoadOfBothBranches) {
  std::vector<CurvePoint> rows;
  for (const double gap : {4e-8, 3.3e-8, 2.6e-8})
    rows.push_back(row_at(outside, gap, false));
  rows.push_back(row_at(inside, 0.5e-8, false));
  for (const double gap : {0.7e-8, 1.3e-8, 2e-8})
    rows.push_back(row_at(inside, gap, true));
  rows.push_back(row_at(outside, 4e-8, true));

  auto quantities = summary_of(rows).quantities;

  const double near = 1e-12;
  EXPECT_NEAR(quantities["unloaded_gap_approach"].value, 3.0, near);
  EXPECT_NEAR(quantities["unloaded_area_approach"].value, 0.5, near);
  EXPECT_NEAR(quantities["effective_work_approach"].value, 0.2, near);
  EXPECT_NEAR(quantities["unloaded_gap_retraction"].value, 1.0, near);
  EXPECT_NEAR(quantities["effective_work_retraction"].value, 0.8, near);
  EXPECT_NEAR(quantities["pull_off_pressure"].value, stiffness * 1e-8 / 1e9,
              near);
}

// The largest tension of an interrupted path may be one of a jump into contact,
// and is none of the pull-off that it has not reached.
TEST(AdhesionQuantities, HaveNoPullOffOfAnInterruptedPath) {
  std::vector<CurvePoint> rows{row_at(outside, 4e-8, false),
                               row_at(outside, 3.3e-8, false)};
  rows.back()[columns::jump_pressure] = -5.0 * stiffness * 1e-8;

  const Estimate whole = summary_of(rows, 2).quantities["pull_off_pressure"];
  const Estimate part = summary_of(rows, 7).quantities["pull_off_pressure"];

  EXPECT_NEAR(whole.value, 5.0 * stiffness * 1e-8 / 1e9, 1e-12);
  EXPECT_FALSE(part.has_value());
  EXPECT_EQ(part.remark, "the path has 2 of its 7 steps");
}

// A path by pressures has rows without load. Faces that a tension has parted
// carry none, either, but are no such state.
TEST(AdhesionQuantities, TakeRowsWithoutLoadAsTheyAre) {
  CurvePoint parted = row_at({3e-8, 0.0}, 3e-8, false);
  parted.area_fraction = 0.0;
  const std::vector<CurvePoint> rows{parted, row_at(outside, 3e-8, false),
                                     row_at(inside, 0.0, false),
                                     row_at(inside, 1e-8, true)};
  auto quantities = summary_of(rows).quantities;
  EXPECT_NEAR(quantities["effective_work_approach"].value, 0.2, 1e-12);
  EXPECT_NEAR(quantities["effective_work_retraction"].value, 0.8, 1e-12);

  auto loaded = summary_of({rows[2]}).quantities;
  EXPECT_FALSE(loaded["effective_work_approach"].has_value());
  EXPECT_EQ(loaded["effective_work_approach"].remark,
            "no state without load on the approach");
}

// Where p goes from compression to tension with a falling mean gap, U has its
// largest value, not its smallest.
TEST(AdhesionQuantities, LeaveOutStatesWithTheLargestEnergy) {
  CurvePoint first = row_at(inside, 2e-8, false);
  CurvePoint second = row_at(inside, 0.5e-8, false);
  std::swap(first.nominal_pressure, second.nominal_pressure);
  auto quantities = summary_of({first, second}).quantities;
  EXPECT_FALSE(quantities["effective_work_approach"].has_value());
}

// Rows of the same step count if they have the same gap.
TEST(AdhesionQuantities, TellHowFarMethodsPart) {
  std::vector<CurvePoint> rows, others;
  for (const int step : {0, 1, 2, 4}) {
    const double gap = (4 - step) * 1e-8;
    others.push_back(row_at({2e-8, 0.0}, gap, false));
    rows.push_back(row_at({2.1e-8, 0.0}, gap, false));
    rows.back().step = others.back().step = step;
  }
  rows[0].nominal_pressure = rows[2].mean_gap = 1.0; // the largest, and no gap
  rows[0].status = results::StepStatus::not_converged;
  rows[3].step = 3;
  rows[3].nominal_pressure = 1.0;

  EXPECT_NEAR(difference_of(rows, others), 0.05, 1e-12);
  EXPECT_TRUE(std::isnan(difference_of({rows[2], rows[3]}, others)));
}

} // namespace asperity::reports::adhesion_quantities_test
