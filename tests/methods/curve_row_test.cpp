// Tests of run/methods/curve_row.hpp: no map ends a run. For any fields there
// is a row, in which a missing number is NaN with a reason in the note.
#include "base/special_numbers.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/curve_row.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace asperity::methods::curve_row_test {

constexpr int points = 16;

using PressureAt = std::function<double(int node)>;

/// The row of a solution with these pressures [Pa] and a gap of 1 nm where they
/// are 0.
results::CurvePoint row_of(const PressureAt& pressure_at,
                           bool has_middle = false) {
  SurfaceOfCase surface;
  surface.record.grid = {points, points, 1e-6, 1e-6};
  surface.scales.rms_height = 1e-9;
  contact::ContactSolution solution;
  for (int node = 0; node < points * points; ++node) {
    solution.pressure.push_back(pressure_at(node));
    solution.gap.push_back(solution.pressure.back() == 0.0 ? 1e-9 : 0.0);
    solution.displacement.push_back(1e-10 * (node % 3));
  }
  solution.converged = true;
  return observe(std::move(solution),
                 {{},
                  0.0,
                  results::halfspace_area_coefficients,
                  1e9,
                  true,
                  results::Border::periodic,
                  {},
                  has_middle},
                 surface)
      .row;
}

bool is_named(const results::CurvePoint& row, const std::string& column) {
  return row.note.find(column + " is not determined: ") != std::string::npos;
}

// Open, full, uniform, a single node, a checkerboard, one node that is not
// finite, all of them, the limits of a double: each has a row, in which a
// number from the maps is finite, or NaN and named in the note.
TEST(CurveRow, OfAnyFieldsIsARow) {
  const std::vector<PressureAt> fields{
      [](int) { return 0.0; },
      [](int) { return 1e6; },
      [](int node) { return 1e6 + node; },
      [](int node) { return node == 7 ? 1e6 : 0.0; },
      [](int node) { return (node + node / points) % 2 == 0 ? 1e6 : 0.0; },
      [](int node) { return node == 7 ? not_a_number : 1e6; },
      [](int node) { return node == 7 ? infinity : 0.0; },
      [](int node) { return node == 7 ? -infinity : 1e6; },
      [](int) { return not_a_number; },
      [](int node) { return 1e308 * (1.0 + node % 2 * 0.5); },
      [](int node) { return 5e-324 * (node % 2); },
      [](int node) { return node % 2 == 0 ? 1.0 : -1.0; },
  };
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const results::CurvePoint row = row_of(fields[i]);
    for (const char* column :
         {"area_fraction", "area_fraction_corrected", "area_fraction_fit",
          "area_fraction_moment", "contact_perimeter", "elastic_energy",
          "contact_energy"}) {
      const double number = results::curve_column(column).get(row);
      EXPECT_EQ(std::isfinite(number), !is_named(row, column))
          << "field " << i << ", " << column << " = " << number << "; "
          << row.note;
    }
  }
}

// Only a surface with a middle has a centre of pressure.
TEST(CurveRow, HasTheCentreOfPressureOfAShape) {
  const auto one = [](int node) { return node == 7 ? 1e6 : 0.0; };

  EXPECT_DOUBLE_EQ(row_of(one, true)[columns::pressure_centre.x],
                   -1e-6 / points);
  EXPECT_DOUBLE_EQ(row_of(one, true)[columns::pressure_centre.y], -0.5e-6);
  EXPECT_TRUE(std::isnan(row_of(one, false)[columns::pressure_centre.x]));
}

// Half of the nodes in contact carry the hardness; the imprint is 2 nm deep in
// the mean. Edges and distribution are then not those of elastic contact.
TEST(CurveRow, HasThePlasticAreaAndWork) {
  SurfaceOfCase surface;
  surface.record.grid = {points, points, 1e-6, 1e-6};
  surface.scales.rms_height = 1e-9;
  Observation observation;
  observation.area_coefficients = results::halfspace_area_coefficients;
  observation.contact_modulus = 1e9;
  observation.hardness = 1e6;
  const auto row_at = [&](double highest, double imprint) {
    contact::ContactSolution solution;
    for (int node = 0; node < points * points; ++node) {
      solution.pressure.push_back(node % 4 == 0   ? highest
                                  : node % 4 == 1 ? 3e5
                                                  : 0.0);
      solution.gap.push_back(node % 4 < 2 ? 0.0 : 1e-9);
      solution.displacement.push_back(0.0);
    }
    solution.mean_imprint = imprint;
    return observe(std::move(solution), observation, surface).row;
  };
  const results::CurvePoint yielding = row_at(1e6, 2e-9);
  EXPECT_DOUBLE_EQ(yielding[columns::plastic_area], 0.25);
  EXPECT_DOUBLE_EQ(yielding.area_fraction, 0.5);
  EXPECT_DOUBLE_EQ(yielding[columns::plastic_work], 2e-3);
  EXPECT_TRUE(std::isnan(yielding.area_fraction_corrected));
  EXPECT_EQ(yielding.note, "");
  const results::CurvePoint elastic = row_at(9e5, 0.0);
  EXPECT_EQ(elastic[columns::plastic_area], 0.0);
}

// Verifies the text of the note; a row without a missing number has none.
TEST(CurveRow, ReportsWhatIsNotDetermined) {
  const results::CurvePoint one =
      row_of([](int node) { return node == 7 ? 1e6 : 0.0; });
  EXPECT_TRUE(is_named(one, "area_fraction_corrected")) << one.note;
  EXPECT_NE(one.note.find("area_fraction_fit is not determined: too few nodes "
                          "are in contact for a histogram"),
            std::string::npos)
      << one.note;
  EXPECT_DOUBLE_EQ(one.area_fraction, 1.0 / (points * points));
  EXPECT_EQ(row_of([](int node) { return 1e6 + node; }).note, "");
}

// A step with a number that is not finite where the curve or the maps need one
// did not converge, and no such map is saved; any other step is unchanged.
TEST(CurveRow, OfANonFiniteStepDidNotConverge) {
  const auto answer_of = [](double mean_gap, double gap) {
    StepAnswer answer;
    answer.row.nominal_pressure = 1e6;
    answer.row.mean_gap = mean_gap;
    answer.pressure = {1.0, 2.0};
    answer.gap = {0.0, gap};
    distrust_non_finite(answer);
    return answer;
  };
  const StepAnswer good = answer_of(1e-9, 1e-9);
  EXPECT_EQ(good.row.status, results::StepStatus::converged);
  EXPECT_EQ(good.row.note, "");
  EXPECT_EQ(good.gap.size(), 2U);

  const StepAnswer no_gap = answer_of(not_a_number, 1e-9);
  EXPECT_EQ(no_gap.row.status, results::StepStatus::not_converged);
  EXPECT_EQ(no_gap.row.note,
            "the mean gap or the nominal pressure is not finite");
  EXPECT_EQ(no_gap.gap.size(), 2U);

  const StepAnswer no_maps = answer_of(1e-9, infinity);
  EXPECT_EQ(no_maps.row.status, results::StepStatus::not_converged);
  EXPECT_TRUE(no_maps.pressure.empty() && no_maps.gap.empty());
}

} // namespace asperity::methods::curve_row_test
