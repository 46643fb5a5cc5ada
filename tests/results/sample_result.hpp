#pragma once

// Artificial rows, maps and folders for the tests of the result file.

#include "results/observables/height_numbers.hpp"
#include "results/result_writer.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace asperity::results {

/// A temporary folder that is removed at the end of the test.
class ResultFolder : public ::testing::Test {
protected:
  void SetUp() override { std::filesystem::remove_all(folder_); }

  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ("asperity_results_" + std::to_string(::getpid()) + "_" +
       ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

inline CaseInfo sample_case() {
  return {"polymer",
          "A \"polymer\", 10 µm",
          "schema = 1\r\n# ü\n",
          "0af3",
          2e9,
          "quantity,value,unit,uncertainty,source\nü,1,1,0,\"a, b\"\n"};
}

/// A row whose numbers all differ and depend on the step.
inline CurvePoint sample_point(int step) {
  CurvePoint point;
  point.step = step;
  point.nominal_pressure = 1e6 * std::exp(0.1 * step);
  point.mean_gap = 40e-9 / (1 + step);
  point.area_fraction = 0.01 * std::sqrt(step + 1.0);
  point.area_fraction_corrected = 0.9 * point.area_fraction;
  point[columns::area_fraction_fit] = 0.8 * point.area_fraction;
  point[columns::area_fraction_moment] = 0.7 * point.area_fraction;
  point.contact_perimeter = 1e6 / (3 + step);
  point.elastic_energy = 1e-3 / (7 + step);
  point.contact_energy = 1e-5 / (11 + step);
  point.contact_stiffness = 1e14 / (13 + step);
  point.iterations = 20 + step;
  point.residual = 1e-9 / (17 + step);
  point[columns::certified_gap_error] = 1e-12 / (47 + step);
  point[columns::estimated_gap_error] = 1e-10 / (53 + step);
  point.cpu_time = 0.1 * step;
  point[columns::transforms] = 40 + step;
  point[columns::transform_time] = 0.05 * step;
  point[columns::observation_time] = 0.01 * step;
  point[columns::linear_iterations] = 100 + step;
  point[columns::preconditioner_setups] = 1 + step;
  point[columns::unknowns] = 3000.0 + step;
  point[columns::memory] = 1e8 / (19 + step);
  point[columns::normal_stiffness] = 1e5 / (31 + step);
  point[columns::tangential_stiffness] = 1e5 / (37 + step);
  point[columns::pressure_centre.x] = -1e-6 / (41 + step);
  point[columns::pressure_centre.y] = 1e-6 / (43 + step);
  point[columns::von_mises] = 1e7 / (23 + step);
  point[columns::von_mises_depth] = 1e-6 / (29 + step);
  point[columns::plastic_work] = 1e-3 / (59 + step);
  point[columns::plastic_strain] = 1e-2 / (61 + step);
  point[columns::adhesive_energy] = -1e-3 / (67 + step);
  point[columns::repulsive_area] = 1.0 / (71 + step);
  point[columns::tensile_area] = 1.0 / (73 + step);
  point[columns::smallest_stiffness] = 1e12 / (79 + step);
  point[columns::attractive_load] = 1e7 / (89 + step);
  point[columns::jump_pressure] = -1e7 / (97 + step);
  point[columns::jump_gap] = -1e-9 / (101 + step);
  point[columns::plastic_area] = 1.0 / (83 + step);
  point.status =
      step % 3 == 2 ? StepStatus::not_converged : StepStatus::converged;
  point.is_unloading = step % 2 == 1;
  point.note =
      step % 3 == 2 ? "did not converge after " + std::to_string(step) : "";
  return point;
}

inline bool is_same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// Bit for bit, NaN equal to NaN.
inline void expect_same(const CurvePoint& a, const CurvePoint& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_PRED2(is_same, a.nominal_pressure, b.nominal_pressure);
  EXPECT_PRED2(is_same, a.mean_gap, b.mean_gap);
  EXPECT_PRED2(is_same, a.area_fraction, b.area_fraction);
  EXPECT_PRED2(is_same, a.area_fraction_corrected, b.area_fraction_corrected);
  EXPECT_PRED2(is_same, a[columns::area_fraction_fit],
               b[columns::area_fraction_fit]);
  EXPECT_PRED2(is_same, a[columns::area_fraction_moment],
               b[columns::area_fraction_moment]);
  EXPECT_PRED2(is_same, a.contact_perimeter, b.contact_perimeter);
  EXPECT_PRED2(is_same, a.elastic_energy, b.elastic_energy);
  EXPECT_PRED2(is_same, a.contact_energy, b.contact_energy);
  EXPECT_EQ(a[columns::linear_iterations], b[columns::linear_iterations]);
  EXPECT_EQ(a[columns::preconditioner_setups],
            b[columns::preconditioner_setups]);
  EXPECT_PRED2(is_same, a[columns::unknowns], b[columns::unknowns]);
  EXPECT_PRED2(is_same, a[columns::memory], b[columns::memory]);
  EXPECT_PRED2(is_same, a[columns::normal_stiffness],
               b[columns::normal_stiffness]);
  EXPECT_PRED2(is_same, a[columns::tangential_stiffness],
               b[columns::tangential_stiffness]);
  EXPECT_PRED2(is_same, a[columns::pressure_centre.x],
               b[columns::pressure_centre.x]);
  EXPECT_PRED2(is_same, a[columns::pressure_centre.y],
               b[columns::pressure_centre.y]);
  EXPECT_PRED2(is_same, a[columns::von_mises], b[columns::von_mises]);
  EXPECT_PRED2(is_same, a[columns::von_mises_depth],
               b[columns::von_mises_depth]);
  EXPECT_PRED2(is_same, a[columns::plastic_work], b[columns::plastic_work]);
  EXPECT_PRED2(is_same, a[columns::plastic_strain], b[columns::plastic_strain]);
  EXPECT_PRED2(is_same, a[columns::adhesive_energy],
               b[columns::adhesive_energy]);
  EXPECT_PRED2(is_same, a[columns::repulsive_area], b[columns::repulsive_area]);
  EXPECT_PRED2(is_same, a[columns::tensile_area], b[columns::tensile_area]);
  EXPECT_PRED2(is_same, a[columns::smallest_stiffness],
               b[columns::smallest_stiffness]);
  EXPECT_PRED2(is_same, a[columns::attractive_load],
               b[columns::attractive_load]);
  EXPECT_PRED2(is_same, a[columns::jump_pressure], b[columns::jump_pressure]);
  EXPECT_PRED2(is_same, a[columns::jump_gap], b[columns::jump_gap]);
  EXPECT_PRED2(is_same, a[columns::plastic_area], b[columns::plastic_area]);
  EXPECT_PRED2(is_same, a.contact_stiffness, b.contact_stiffness);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_PRED2(is_same, a.residual, b.residual);
  EXPECT_PRED2(is_same, a[columns::certified_gap_error],
               b[columns::certified_gap_error]);
  EXPECT_PRED2(is_same, a[columns::estimated_gap_error],
               b[columns::estimated_gap_error]);
  EXPECT_PRED2(is_same, a.cpu_time, b.cpu_time);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.is_unloading, b.is_unloading);
  EXPECT_EQ(a.note, b.note);
}

/// Fills the numbers that follow from the heights.
inline void fill_numbers(SurfaceRecord& surface) {
  const HeightNumbers numbers = height_numbers(surface);
  surface.rms_height = numbers.rms_height;
  surface.rms_slope = numbers.rms_slope.low;
  surface.rms_curvature = numbers.rms_curvature;
  surface.skewness = numbers.skewness;
  surface.kurtosis = numbers.kurtosis;
  surface.highest = numbers.highest;
}

inline SurfaceRecord sample_surface(int points_x, int points_y) {
  SurfaceRecord surface;
  surface.grid = {points_x, points_y, 1e-6, 2e-6};
  for (std::size_t i = 0; i < surface.grid.size(); ++i)
    surface.heights.push_back(1e-9 * std::sin(static_cast<double>(i)));
  fill_numbers(surface);
  surface.spectrum = {{6e6, 1e-30}, {12e6, 2e-31}};
  return surface;
}

/// Bit for bit.
inline void expect_same(const SurfaceRecord& a, const SurfaceRecord& b) {
  EXPECT_EQ(a.grid, b.grid);
  EXPECT_EQ(a.map, b.map);
  EXPECT_EQ(a.heights, b.heights);
  EXPECT_EQ(a.rms_height, b.rms_height);
  EXPECT_EQ(a.rms_slope, b.rms_slope);
  EXPECT_EQ(a.rms_curvature, b.rms_curvature);
  EXPECT_EQ(a.skewness, b.skewness);
  EXPECT_EQ(a.kurtosis, b.kurtosis);
  EXPECT_EQ(a.highest, b.highest);
  ASSERT_EQ(a.spectrum.size(), b.spectrum.size());
  for (std::size_t i = 0; i < a.spectrum.size(); ++i) {
    EXPECT_EQ(a.spectrum[i].wavevector, b.spectrum[i].wavevector);
    EXPECT_EQ(a.spectrum[i].spectrum, b.spectrum[i].spectrum);
  }
}

} // namespace asperity::results
