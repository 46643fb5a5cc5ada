#pragma once

// Artificial rows, maps and folders for the tests of the result file.

#include "results/observables/height_numbers.hpp"
#include "results/result_writer.hpp"

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
  point.area_fraction_fit = 0.8 * point.area_fraction;
  point.area_fraction_moment = 0.7 * point.area_fraction;
  point.contact_perimeter = 1e6 / (3 + step);
  point.elastic_energy = 1e-3 / (7 + step);
  point.contact_energy = 1e-5 / (11 + step);
  point.contact_stiffness = 1e14 / (13 + step);
  point.iterations = 20 + step;
  point.residual = 1e-9 / (17 + step);
  point.certified_gap_error = 1e-12 / (47 + step);
  point.estimated_gap_error = 1e-10 / (53 + step);
  point.cpu_time = 0.1 * step;
  point.transforms = 40 + step;
  point.transform_time = 0.05 * step;
  point.observation_time = 0.01 * step;
  point.linear_iterations = 100 + step;
  point.preconditioner_setups = 1 + step;
  point.unknowns = 3000.0 + step;
  point.memory = 1e8 / (19 + step);
  point.normal_stiffness = 1e5 / (31 + step);
  point.tangential_stiffness = 1e5 / (37 + step);
  point.stick_stiffness_x = 1e15 / (38 + step);
  point.stick_stiffness_y = 1e15 / (39 + step);
  point.pressure_centre_x = -1e-6 / (41 + step);
  point.pressure_centre_y = 1e-6 / (43 + step);
  point.von_mises = 1e7 / (23 + step);
  point.von_mises_depth = 1e-6 / (29 + step);
  point.plastic_work = 1e-3 / (59 + step);
  point.plastic_strain = 1e-2 / (61 + step);
  point.adhesive_energy = -1e-3 / (67 + step);
  point.repulsive_area = 1.0 / (71 + step);
  point.tensile_area = 1.0 / (73 + step);
  point.smallest_stiffness = 1e12 / (79 + step);
  point.attractive_load = 1e7 / (89 + step);
  point.jump_pressure = -1e7 / (97 + step);
  point.jump_gap = -1e-9 / (101 + step);
  point.plastic_area = 1.0 / (83 + step);
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
  EXPECT_PRED2(is_same, a.area_fraction_fit, b.area_fraction_fit);
  EXPECT_PRED2(is_same, a.area_fraction_moment, b.area_fraction_moment);
  EXPECT_PRED2(is_same, a.contact_perimeter, b.contact_perimeter);
  EXPECT_PRED2(is_same, a.elastic_energy, b.elastic_energy);
  EXPECT_PRED2(is_same, a.contact_energy, b.contact_energy);
  EXPECT_EQ(a.linear_iterations, b.linear_iterations);
  EXPECT_EQ(a.preconditioner_setups, b.preconditioner_setups);
  EXPECT_PRED2(is_same, a.unknowns, b.unknowns);
  EXPECT_PRED2(is_same, a.memory, b.memory);
  EXPECT_PRED2(is_same, a.normal_stiffness, b.normal_stiffness);
  EXPECT_PRED2(is_same, a.tangential_stiffness, b.tangential_stiffness);
  EXPECT_PRED2(is_same, a.stick_stiffness_x, b.stick_stiffness_x);
  EXPECT_PRED2(is_same, a.stick_stiffness_y, b.stick_stiffness_y);
  EXPECT_PRED2(is_same, a.pressure_centre_x, b.pressure_centre_x);
  EXPECT_PRED2(is_same, a.pressure_centre_y, b.pressure_centre_y);
  EXPECT_PRED2(is_same, a.von_mises, b.von_mises);
  EXPECT_PRED2(is_same, a.von_mises_depth, b.von_mises_depth);
  EXPECT_PRED2(is_same, a.plastic_work, b.plastic_work);
  EXPECT_PRED2(is_same, a.plastic_strain, b.plastic_strain);
  EXPECT_PRED2(is_same, a.adhesive_energy, b.adhesive_energy);
  EXPECT_PRED2(is_same, a.repulsive_area, b.repulsive_area);
  EXPECT_PRED2(is_same, a.tensile_area, b.tensile_area);
  EXPECT_PRED2(is_same, a.smallest_stiffness, b.smallest_stiffness);
  EXPECT_PRED2(is_same, a.attractive_load, b.attractive_load);
  EXPECT_PRED2(is_same, a.jump_pressure, b.jump_pressure);
  EXPECT_PRED2(is_same, a.jump_gap, b.jump_gap);
  EXPECT_PRED2(is_same, a.plastic_area, b.plastic_area);
  EXPECT_PRED2(is_same, a.contact_stiffness, b.contact_stiffness);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_PRED2(is_same, a.residual, b.residual);
  EXPECT_PRED2(is_same, a.certified_gap_error, b.certified_gap_error);
  EXPECT_PRED2(is_same, a.estimated_gap_error, b.estimated_gap_error);
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
