// Claims about reports/exact.hpp: curves made from the textbook's formulas,
// written out here, have no error; a known offset is the error found.
#include "reports/exact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity::reports {
namespace {

constexpr double contact_modulus = 2e9; // Pa

cases::Case wave_case() {
  cases::Case wave;
  wave.surface.kind = cases::SurfaceKind::wave_1d;
  wave.surface.length = 1e-6;
  wave.surface.amplitude = 3e-9;
  wave.surface.wavelength = 1e-6;
  return wave;
}

cases::Case sphere_case() {
  cases::Case sphere;
  sphere.surface.kind = cases::SurfaceKind::sphere;
  sphere.surface.length = 1e-3;
  sphere.surface.radius = 10e-3;
  return sphere;
}

results::Result result_of(const std::vector<results::CurvePoint>& points) {
  results::Result result;
  result.contact_modulus = contact_modulus;
  result.methods = {{"halfspace", "halfspace", "", {{points, {}, 0.0}}}};
  return result;
}

MethodSummary summary_of(const results::Result& result,
                         const cases::Case& exact_case) {
  MethodSummary summary;
  add_exact_quantities(result, exact_case, result.methods.front(), summary);
  return summary;
}

// Westergaard 1939, with offsets in amplitudes and in contact fraction.
results::Result wave_result(double gap_offset, double area_offset) {
  const cases::SurfaceSpec surface = wave_case().surface;
  const double full = std::numbers::pi * contact_modulus * surface.amplitude /
                      surface.wavelength;
  std::vector<results::CurvePoint> points;
  for (const double load : {0.05, 0.3, 0.9}) {
    results::CurvePoint point;
    point.nominal_pressure = load * full;
    point.mean_gap = surface.amplitude *
                     (1.0 - load + load * std::log(load) + gap_offset * load);
    point.area_fraction_corrected =
        2.0 / std::numbers::pi * std::asin(std::sqrt(load)) - area_offset;
    points.push_back(point);
  }
  return result_of(points);
}

// Claim: the largest offset, 0.9 of the given one, is the error. Tolerance:
// rounding.
TEST(ExactQuantities, FindTheOffsetFromWestergaard) {
  const MethodSummary none = summary_of(wave_result(0.0, 0.0), wave_case());
  const MethodSummary some = summary_of(wave_result(-1e-3, 0.02), wave_case());

  EXPECT_NEAR(none.quantities.at("mean_gap_error").value, 0.0, 1e-13);
  EXPECT_NEAR(none.quantities.at("area_error").value, 0.0, 1e-13);
  EXPECT_NEAR(some.quantities.at("mean_gap_error").value, 0.9e-3, 1e-13);
  EXPECT_NEAR(some.quantities.at("area_error").value, 0.02, 1e-13);
  EXPECT_EQ(none.quantities.count("approach_error"), 0U);
}

// Hertz on a periodic square: approach a^2/R less S F/(pi E* L), the mean gap
// falling from the height of the crest.
results::Result sphere_result(double stretch) {
  const double side = 1e-3;
  const double radius = 10e-3;
  const double top = 4e-6;
  std::vector<results::CurvePoint> points;
  for (const double contact_radius : {0.05e-3, 0.1e-3}) {
    const double load =
        4.0 * contact_modulus * std::pow(contact_radius, 3) / (3.0 * radius);
    const double approach = stretch * contact_radius * contact_radius / radius;
    const double neighbours =
        3.9002649200019564 * load / (std::numbers::pi * contact_modulus * side);
    results::CurvePoint point;
    point.nominal_pressure = load / (side * side);
    point.mean_gap = top - (approach - neighbours);
    point.area_fraction_corrected = std::numbers::pi *
                                    std::pow(stretch * contact_radius, 2) /
                                    (side * side);
    points.push_back(point);
  }
  results::Result result = result_of(points);
  result.surfaces.resize(1);
  result.surfaces.front().highest = top;
  return result;
}

TEST(ExactQuantities, FindTheRelativeErrorOfHertz) {
  const MethodSummary none = summary_of(sphere_result(1.0), sphere_case());
  const MethodSummary some = summary_of(sphere_result(1.03), sphere_case());

  EXPECT_NEAR(none.quantities.at("approach_error").value, 0.0, 1e-9);
  EXPECT_NEAR(none.quantities.at("contact_radius_error").value, 0.0, 1e-12);
  EXPECT_NEAR(some.quantities.at("approach_error").value, 0.03, 1e-9);
  EXPECT_NEAR(some.quantities.at("contact_radius_error").value, 0.03, 1e-12);
}

// Claim: rows that did not converge are not held against anything.
TEST(ExactQuantities, LeaveOutFailedRows) {
  results::Result result = wave_result(0.0, 0.0);
  auto& points = result.methods.front().realizations.front().points;
  points[1].mean_gap = 1.0;
  points[1].status = results::StepStatus::not_converged;

  const MethodSummary summary = summary_of(result, wave_case());

  EXPECT_NEAR(summary.quantities.at("mean_gap_error").value, 0.0, 1e-13);
}

// Claim: between the two limits of the 2-D wave nothing is known, and nothing
// is claimed.
TEST(ExactPoint, IsEmptyBetweenTheLimitsOfTheTwoDimensionalWave) {
  cases::SurfaceSpec surface = wave_case().surface;
  surface.kind = cases::SurfaceKind::wave_2d;
  const double full = std::numbers::sqrt2 * std::numbers::pi * contact_modulus *
                      surface.amplitude / surface.wavelength;

  const auto area_at = [&](double load) {
    return exact_point(surface, contact_modulus, load * full, 0.0)
        .area_fraction;
  };

  EXPECT_NEAR(area_at(1e-3),
              std::numbers::pi *
                  std::pow(3e-3 / (8.0 * std::numbers::pi), 2.0 / 3.0),
              1e-14);
  EXPECT_NEAR(area_at(0.95), 1.0 - 1.5 / std::numbers::pi * 0.05, 1e-14);
  EXPECT_TRUE(std::isnan(area_at(0.5)));
}

} // namespace
} // namespace asperity::reports
