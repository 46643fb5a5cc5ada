// Tests of reports/analysis/exact.hpp for punches: a known offset from a
// textbook formula is the error that is found.
#include "reports/analysis/warnings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/reports/exact_samples.hpp"

namespace asperity::reports::exact_punch_test {

// A flat punch on a periodic square: approach F/(2 E* a) minus S F/(pi E* L). A
// tilted one has no exact solution here. Tolerance: roundoff.
TEST(ExactPunch, FindTheRelativeErrorOfAPunch) {
  cases::Case punch = sphere_case();
  punch.surface.kind = mechanics::SurfaceKind::punch;
  punch.surface.radius = 0.1e-3;
  const double load = 2.0 * contact_modulus * 0.1e-3 * 1e-7; // approach 1e-7 m
  results::CurvePoint point;
  point.nominal_pressure = load / 1e-6;
  point.mean_gap =
      4e-6 - 1.03 * 1e-7 +
      3.9002649200019564 * load / (std::numbers::pi * contact_modulus * 1e-3);
  point.area_fraction_corrected = std::numbers::pi * 0.01;
  results::Result result = result_of({point});
  result.surfaces.resize(1);
  result.surfaces.front().highest = 4e-6;

  const MethodSummary summary = summary_of(result, punch);
  punch.surface.tilt = 1e-4;
  const MethodSummary tilted = summary_of(result, punch);

  EXPECT_NEAR(summary.quantities.at("approach_error").value, 0.03, 1e-9);
  EXPECT_NEAR(summary.quantities.at("contact_radius_error").value, 0.0, 1e-12);
  EXPECT_FALSE(tilted.quantities.at("approach_error").has_value());
  EXPECT_NEAR(tilted.quantities.at("area_error").value, 0.0, 1e-12);
}

/// The mean over a square of side L of (2 d/pi) asin(a/r), or d for r < a, by
/// polar coordinates: the integral along a ray has a closed form.
double mean_displacement(double approach, double a, double side) {
  const int rays = 1000;
  double sum = 0.0;
  for (int i = 0; i < rays; ++i) {
    const double r =
        0.5 * side / std::cos((i + 0.5) / rays * std::numbers::pi / 4.0);
    sum += 0.5 * a * a + (0.5 * r * r * std::asin(a / r) +
                          0.5 * a * std::sqrt(r * r - a * a) -
                          0.25 * std::numbers::pi * a * a) *
                             2.0 / std::numbers::pi;
  }
  return approach * sum * 2.0 * std::numbers::pi / rays / (side * side);
}

// Pressed once on a half-space, a punch displaces the surface by
// (2 d/pi) asin(a/r), and not by what a sphere does: the mean gap is the height
// of its end minus d plus the mean of that. Tolerance: the disc of nodes of
// spacing h, (h/a)^(3/2) of the displacement in a ring of width h.
TEST(ExactPunch, HasItsOwnDisplacementWithFreeBoundaries) {
  cases::Case punch = sphere_case();
  punch.surface.kind = mechanics::SurfaceKind::punch;
  punch.surface.radius = 0.15e-3;
  punch.surface.points = 256;
  mechanics::HalfspaceSettings free;
  free.has_free_boundaries = true;
  punch.methods.push_back({"halfspace", free});
  const double load = 2.0 * contact_modulus * 0.15e-3 * 1e-7;
  const auto with_approach = [&](double approach) {
    results::CurvePoint point;
    point.nominal_pressure = load / 1e-6;
    point.mean_gap = 4e-6 - approach + mean_displacement(1e-7, 0.15e-3, 1e-3);
    point.area_fraction_corrected = std::numbers::pi * 0.0225;
    results::Result result = result_of({point});
    result.surfaces.resize(1);
    result.surfaces.front().highest = 4e-6;
    return summary_of(result, punch).quantities.at("approach_error").value;
  };

  EXPECT_NEAR(with_approach(1e-7), 0.0, 1e-3);
  EXPECT_NEAR(with_approach(1.03e-7), 0.03, 1e-3);
}

// A block with free sides is neither a half-space nor an array: only the radius
// of a contact is compared, and of a wave nothing. A wave with free boundaries
// is not that of Westergaard.
TEST(ExactPoint, IsOfTheBoundaryOfTheMethod) {
  cases::Case sphere = sphere_case();
  mechanics::FemSettings block;
  block.full.sides = mechanics::BlockSides::free;
  sphere.methods.push_back({"halfspace", block});
  results::CurvePoint point;
  point.nominal_pressure = 1e3;
  point.mean_gap = 1e-6;
  point.area_fraction_corrected = 0.01;
  results::Result result = result_of({point});
  result.surfaces.resize(1);
  result.surfaces.front().highest = 4e-6;
  cases::Case wave = sphere;
  wave.surface.kind = mechanics::SurfaceKind::wave_1d;
  wave.surface.amplitude = wave.surface.wavelength = 1e-6;

  const MethodSummary on_sphere = summary_of(result, sphere);
  const MethodSummary on_wave = summary_of(result, wave);

  const auto& approach = on_sphere.quantities.at("approach_error");
  EXPECT_FALSE(approach.has_value());
  EXPECT_EQ(approach.remark, "there is no exact solution with free sides");
  EXPECT_TRUE(on_sphere.quantities.at("contact_radius_error").has_value());
  EXPECT_FALSE(on_wave.quantities.at("area_error").has_value());
  EXPECT_FALSE(on_wave.quantities.at("mean_gap_error").has_value());
  EXPECT_TRUE(std::isnan(
      exact_point(wave.surface, contact_modulus, 1e3, 0.0, true).mean_gap));
}

// The surface around the end, 1e-7 m behind it, touches above an approach of
// 1.17e-7 m. Steps above are not compared, and the remark says from which load
// on. Tolerance: roundoff.
TEST(ExactPunch, StopWhereTheRecessOfAPunchTouches) {
  cases::Case punch = sphere_case();
  punch.surface.kind = mechanics::SurfaceKind::punch;
  punch.surface.radius = 0.1e-3;
  punch.surface.recess = 1e-7;
  std::vector<results::CurvePoint> points;
  for (const double approach : {1e-7, 1.2e-7}) {
    results::CurvePoint point;
    point.nominal_pressure = 2.0 * contact_modulus * 0.1e-3 * approach / 1e-6;
    point.area_fraction_corrected =
        approach > 1.1e-7 ? 0.9 : std::numbers::pi * 0.01;
    points.push_back(point);
  }
  results::Result both = result_of(points);
  results::Result above = result_of({points.back()});
  results::Result below = result_of({points.front()});

  const Estimate some = summary_of(both, punch).quantities.at("area_error");
  const Estimate none = summary_of(above, punch).quantities.at("area_error");
  const Estimate all = summary_of(below, punch).quantities.at("area_error");

  EXPECT_NEAR(some.value, 0.0, 1e-12);
  EXPECT_EQ(some.remark.find("largest over the load steps below "), 0U)
      << some.remark;
  EXPECT_NE(some.remark.find("where the recess of the punch touches"),
            std::string::npos);
  EXPECT_FALSE(none.has_value());
  EXPECT_EQ(none.remark.find("there is no load step below "), 0U)
      << none.remark;
  EXPECT_EQ(all.remark, "largest over the loads with an exact solution");
  const auto names = [&](const results::Result& result) {
    std::string keys;
    for (const Warning& warning : warnings_of(result, punch))
      keys += warning.kind + " ";
    return keys;
  };
  EXPECT_NE(names(both).find("recess_touches"), std::string::npos);
  EXPECT_EQ(names(below).find("recess_touches"), std::string::npos);
}

MethodSummary stiffness_of(const results::Result& result,
                           const cases::Case& contact_case) {
  MethodSummary summary;
  add_stiffness_quantities(result, contact_case, result.methods.front(),
                           summary);
  return summary;
}

/// A flat punch of radius 0.1 mm on a clamped block of 1 mm side and depth.
cases::Case punch_case() {
  cases::Case punch = sphere_case();
  punch.surface.kind = mechanics::SurfaceKind::punch;
  punch.surface.radius = 0.1e-3;
  punch.surface.points = 64;
  punch.material.poisson_ratio = 0.3;
  punch.methods.push_back({"fem", mechanics::FemSettings{}});
  return punch;
}

// Compliances of a periodic clamped block, 2 % and 3 % of the contact's own
// 1/(2 E* a) and (2 - nu)/(8 G a) too large. With free sides there is nothing
// to compare with. Tolerance: roundoff.
TEST(ExactPunch, FindTheErrorOfTheStiffness) {
  cases::Case punch = punch_case();
  const double shear = 0.5 * contact_modulus * 0.7, side = 1e-3, a = 0.1e-3;
  const double others = 3.9002649200019564 / (2.0 * std::numbers::pi * side);
  results::CurvePoint point;
  point.nominal_pressure = 1e4;
  point.normal_stiffness =
      1.0 / (1.02 / (2.0 * contact_modulus * a) +
             0.4 / (2.0 * 0.7 * shear * side) - 0.7 / shear * others);
  point.tangential_stiffness =
      1.0 / (1.03 * 1.7 / (8.0 * shear * a) + 1.0 / (shear * side) -
             0.85 / shear * others);
  results::Result result = result_of({point});
  result.methods.front().name = "fem";
  const MethodSummary periodic = stiffness_of(result, punch);
  std::get<mechanics::FemSettings>(punch.methods.front().settings).full.sides =
      mechanics::BlockSides::free;
  const MethodSummary free = stiffness_of(result, punch);

  EXPECT_NEAR(periodic.quantities.at("normal_stiffness_error").value,
              1.0 - 1.0 / 1.02, 1e-12);
  EXPECT_NEAR(periodic.quantities.at("tangential_stiffness_error").value,
              1.0 - 1.0 / 1.03, 1e-12);
  EXPECT_FALSE(free.quantities.at("normal_stiffness_error").has_value());
  EXPECT_EQ(free.quantities.at("normal_stiffness_error").remark,
            "there is no exact solution with free sides");
}

// A moment 5 % above (4/3) E* a^3 angle. Below an approach of 2 a angle the
// edge of the punch lifts, and there is no exact moment. Tolerance: roundoff.
TEST(ExactPunch, FindTheErrorOfTheMoment) {
  cases::Case punch = punch_case();
  punch.surface.tilt = 1e-4;
  const double a = 0.1e-3;
  const double exact = 4.0 / 3.0 * contact_modulus * a * a * a * 1e-4;
  const auto pressed = [&](double approach) {
    results::CurvePoint point;
    const double load = 2.0 * contact_modulus * a * approach;
    point.nominal_pressure = load / 1e-6;
    point.pressure_centre_x = 1.05 * exact / load;
    return stiffness_of(result_of({point}), punch)
        .quantities.at("moment_error");
  };

  EXPECT_NEAR(pressed(2.1 * a * 1e-4).value, 0.05, 1e-12);
  EXPECT_FALSE(pressed(1.9 * a * 1e-4).has_value());
}

} // namespace asperity::reports::exact_punch_test
