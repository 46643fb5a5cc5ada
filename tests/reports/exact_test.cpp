// Tests of reports/analysis/exact.hpp: curves from textbook formulas, which are
// written out here, have no error; a known offset is the error that is found.
// Those of spheres and waves come first, those of punches last.
#include "reports/analysis/warnings.hpp"
#include "reports/pages/report.hpp"
#include "results/types/method_columns.hpp"
#include "tests/reports/drawn.hpp"
#include "tests/reports/exact_samples.hpp"
#include "theory/exact/punches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace asperity::reports::exact_test {

cases::Case wave_case() {
  cases::Case wave;
  wave.surface.kind = mechanics::SurfaceKind::wave_1d;
  wave.surface.length = 1e-6;
  wave.surface.amplitude = 3e-9;
  wave.surface.wavelength = 1e-6;
  return wave;
}

// Westergaard 1939, with offsets in amplitudes and in contact fraction.
results::Result wave_result(double gap_offset, double area_offset) {
  const mechanics::SurfaceSpec surface = wave_case().surface;
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

// The largest offset, 0.9 of the given one, is the error. Tolerance: roundoff.
TEST(ExactQuantities, FindTheOffsetFromWestergaard) {
  const MethodSummary none = summary_of(wave_result(0.0, 0.0), wave_case());
  const MethodSummary some = summary_of(wave_result(-1e-3, 0.02), wave_case());

  EXPECT_NEAR(none.quantities.at("mean_gap_error").value, 0.0, 1e-13);
  EXPECT_NEAR(none.quantities.at("area_error").value, 0.0, 1e-13);
  EXPECT_NEAR(some.quantities.at("mean_gap_error").value, 0.9e-3, 1e-13);
  EXPECT_NEAR(some.quantities.at("area_error").value, 0.02, 1e-13);
  EXPECT_EQ(none.quantities.count("approach_error"), 0U);
}

// The figures state the same errors beside the name of the method.
TEST(ExactFigures, StateTheErrors) {
  const cases::Case wave = wave_case();
  results::Result result = wave_result(-1e-3, 0.02);
  result.surfaces.emplace_back();
  result.surfaces[0].rms_height = wave.surface.amplitude / std::numbers::sqrt2;

  const std::vector<Figure> figures =
      drawn(figures::exact, entry_of(result, wave));

  ASSERT_EQ(figures.size(), 2U);
  EXPECT_NE(figures[0].caption.find("Largest error: halfspace 0.02."),
            std::string::npos)
      << figures[0].caption;
  EXPECT_NE(figures[1].caption.find("halfspace 0.0009."), std::string::npos)
      << figures[1].caption;
}

// Hertz on a periodic square: the neighbours displace the surface under the
// sphere by F/(pi E* L) [-S + (T/4)(r^2 + 2 a^2/5)/L^2], so that 1/R' = 1/R +
// T F/(2 pi E* L^3) and the approach is a^2/R' minus the rest, where the mean
// gap decreases from the height of the crest. S and T are lattice sums.
struct ArraySphere {
  double load = 0.0;     ///< F = 4 E* a^3/(3 R') [N]
  double approach = 0.0; ///< of the array [m]
};

/// A sphere of radius 10 mm in an array of period 1 mm.
ArraySphere array_sphere(double contact_radius) {
  const double side = 1e-3, radius = 10e-3;
  const double curvature_sum = 9.0336216831008; // T
  const double cubic = 4.0 * contact_modulus * std::pow(contact_radius, 3) / 3;
  const double bend = curvature_sum / (2.0 * std::numbers::pi *
                                       contact_modulus * std::pow(side, 3));
  const double load = cubic / radius / (1.0 - cubic * bend);
  const double square = contact_radius * contact_radius;
  return {load, square * (1.0 / radius + bend * load) -
                    load / (std::numbers::pi * contact_modulus * side) *
                        (3.9002649200019564 -
                         curvature_sum * square / (10.0 * side * side))};
}

results::Result sphere_result(double stretch) {
  const double side = 1e-3;
  const double top = 4e-6;
  std::vector<results::CurvePoint> points;
  for (const double contact_radius : {0.05e-3, 0.1e-3}) {
    const auto [load, approach] = array_sphere(contact_radius);
    const double alone =
        std::cbrt(std::pow(0.75 * load / contact_modulus, 2) / 10e-3);
    results::CurvePoint point;
    point.nominal_pressure = load / (side * side);
    point.mean_gap = top - approach - (stretch - 1.0) * alone;
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

// A maximum stress and a depth that are 2 % and 5 % off Hertz's 0.620 p_0 and
// 0.481 a (nu = 0.3; Johnson, Sec. 4.2) have these errors. Tolerance: printed
// digits.
TEST(ExactQuantities, FindTheErrorOfTheStressInside) {
  cases::Case sphere = sphere_case();
  sphere.material.poisson_ratio = 0.3;
  results::Result result = sphere_result(1.0);
  const double radius = 0.1e-3;
  const double load = array_sphere(radius).load;
  const double peak = 1.5 * load / (std::numbers::pi * radius * radius);
  result.tables = {{"stress-inside-halfspace",
                    "",
                    {{"nominal_pressure", "Pa", {load / 1e-6}},
                     {"von_mises", "Pa", {1.02 * 0.620 * peak}},
                     {"depth", "m", {0.95 * 0.481 * radius}}}}};

  const MethodSummary summary = summary_of(result, sphere);

  EXPECT_NEAR(summary.quantities.at("von_mises_error").value, 0.02, 1e-3);
  EXPECT_NEAR(summary.quantities.at("von_mises_depth_error").value, 0.05, 2e-3);
  EXPECT_EQ(summary_of(sphere_result(1.0), sphere)
                .quantities.count("von_mises_error"),
            0U);
}

// Rows that did not converge have no error.
TEST(ExactQuantities, LeaveOutFailedRows) {
  results::Result result = wave_result(0.0, 0.0);
  auto& points = result.methods.front().realizations.front().points;
  points[1].mean_gap = 1.0;
  points[1].status = results::StepStatus::not_converged;

  const MethodSummary summary = summary_of(result, wave_case());

  EXPECT_NEAR(summary.quantities.at("mean_gap_error").value, 0.0, 1e-13);
}

// Of one contact on a half-space, Hertz' radius is (3 F R/(4 E*))^(1/3), here
// 0.49 and 0.51 of the length: the second reaches the border. In an array the
// solution is that with 1/R' = 1/R + T F/(2 pi E* L^3), up to 0.3 lengths.
TEST(ExactPoint, OfASphereNeedsAContactInsideTheSquare) {
  const mechanics::SurfaceSpec surface = sphere_case().surface;
  const auto exact = [&](double radius_over_length, bool is_free) {
    return exact_point(surface, contact_modulus,
                       4.0 / 3.0 * std::pow(radius_over_length, 3.0) * 0.1 *
                           contact_modulus,
                       0.0, is_free)
        .contact_radius;
  };
  const double flatter = 1.0 + 9.0336216831008 * 4.0 / 3.0 *
                                   std::pow(0.3, 3.0) /
                                   (2.0 * std::numbers::pi);

  EXPECT_NEAR(exact(0.49, true), 0.49e-3, 1e-12);
  EXPECT_TRUE(std::isnan(exact(0.51, true)));
  EXPECT_NEAR(exact(0.3, false), 0.3e-3 / std::cbrt(flatter), 1e-12);
  EXPECT_TRUE(std::isnan(exact(0.32, false)));
}

// The 2-D wave has an exact solution at every load: near Hertz's limit, which
// is too small by some relative 0.75 P^(2/3), near the limit of full contact,
// whose open area is too small by up to a relative 0.5 (1 - P), and between the
// two where neither limit applies. Tolerance: these fractions, and a tenth of
// them for "some".
TEST(ExactPoint, IsKnownAtEveryLoadOfTheTwoDimensionalWave) {
  mechanics::SurfaceSpec surface = wave_case().surface;
  surface.kind = mechanics::SurfaceKind::wave_2d;
  const double full = std::numbers::sqrt2 * std::numbers::pi * contact_modulus *
                      surface.amplitude / surface.wavelength;
  const auto light = [](double load) {
    return std::numbers::pi *
           std::pow(3.0 * load / (8.0 * std::numbers::pi), 2.0 / 3.0);
  };

  const auto exact = [&](double load) {
    return exact_point(surface, contact_modulus, load * full, 0.0, false);
  };

  EXPECT_NEAR(exact(1e-3).area_fraction / light(1e-3) - 1.0, 0.0075, 0.00075);
  EXPECT_GT(exact(0.5).area_fraction, light(0.5));
  EXPECT_LT(exact(0.5).area_fraction, 1.0 - 0.5 * 1.5 / std::numbers::pi);
  const double open = 1.0 - exact(0.95).area_fraction;
  EXPECT_GT(open, 0.05 * 1.5 / std::numbers::pi);
  EXPECT_LT(open, 0.05 * 1.5 / std::numbers::pi * 1.025);
  EXPECT_EQ(exact(0.0).mean_gap, surface.amplitude);
  EXPECT_GT(exact(0.5).mean_gap, exact(0.6).mean_gap);
  EXPECT_EQ(exact(1.0).mean_gap, 0.0);
}

// Rows from the closed forms of the light end differ from the exact solution at
// P = 0.001 by the known error of these forms: 0.75 P^(2/3) of the area, 0.65
// P^(4/3) amplitudes of the gap, to a tenth of either.
TEST(ExactQuantities, HaveTheErrorOfTheTwoDimensionalWave) {
  cases::Case egg_box = wave_case();
  egg_box.surface.kind = mechanics::SurfaceKind::wave_2d;
  const double load = 1e-3;
  const double area =
      std::numbers::pi *
      std::pow(3.0 * load / (8.0 * std::numbers::pi), 2.0 / 3.0);
  const double amplitude = egg_box.surface.amplitude;
  const double radius =
      1e-12 / (4.0 * std::pow(std::numbers::pi, 2)) / amplitude;
  const double full = std::numbers::sqrt2 * std::numbers::pi * contact_modulus *
                      amplitude / 1e-6;
  const double crest = 0.5 * load * full * 1e-12; // two crests per cell
  results::CurvePoint point;
  point.nominal_pressure = load * full;
  point.area_fraction_corrected = area;
  point.mean_gap =
      amplitude -
      std::cbrt(std::pow(0.75 * crest / contact_modulus, 2) / radius) +
      3.9002649200019564 * crest * std::numbers::sqrt2 /
          (std::numbers::pi * contact_modulus * 1e-6);

  const MethodSummary summary = summary_of(result_of({point}), egg_box);

  EXPECT_NEAR(summary.quantities.at("area_error").value /
                  (area * 0.75 * std::pow(load, 2.0 / 3.0)),
              1.0, 0.1);
  EXPECT_NEAR(summary.quantities.at("mean_gap_error").value /
                  (0.65 * std::pow(load, 4.0 / 3.0)),
              1.0, 0.1);
}

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

// A cone and a rounded punch have the mean of their own displacement over the
// nodes: with few nodes, the plain sum over all of them. Tolerance: roundoff.
TEST(ExactPoint, OfAnIndenterHasTheMeanOfItsDisplacement) {
  mechanics::SurfaceSpec surface;
  surface.kind = mechanics::SurfaceKind::cone;
  surface.length = 1e-3;
  surface.points = 12;
  surface.slope = 0.05;
  surface.radius = 0.1e-3;
  surface.edge_radius = 20e-3;
  const double load = 0.5, top = 4e-6;
  const auto mean_of = [](const auto& displacement) {
    double sum = 0.0;
    for (int iy = -6; iy < 6; ++iy)
      for (int ix = -6; ix < 6; ++ix)
        sum += displacement(std::hypot(ix, iy) * 1e-3 / 12);
    return sum / 144;
  };
  const theory::Cone cone(surface.slope, contact_modulus);
  const theory::RoundedPunch punch(surface.radius, surface.edge_radius,
                                   contact_modulus);
  const theory::PunchContact spot = punch.contact(load);

  const ExactPoint pointed =
      exact_point(surface, contact_modulus, load / 1e-6, top, true);
  surface.kind = mechanics::SurfaceKind::rounded_punch;
  const ExactPoint rounded =
      exact_point(surface, contact_modulus, load / 1e-6, top, true);

  EXPECT_NEAR(pointed.mean_gap,
              top - cone.contact(load).approach +
                  mean_of([&](double r) { return cone.displacement(load, r); }),
              1e-18);
  EXPECT_NEAR(pointed.elastic_energy, load * cone.contact(load).approach / 3e-6,
              1e-12);
  EXPECT_NEAR(rounded.mean_gap, top - spot.approach + mean_of([&](double r) {
                                  return punch.displacement(spot, r);
                                }),
              1e-18);
  EXPECT_DOUBLE_EQ(rounded.contact_radius, spot.contact_radius);
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
  point[columns::normal_stiffness] =
      1.0 / (1.02 / (2.0 * contact_modulus * a) +
             0.4 / (2.0 * 0.7 * shear * side) - 0.7 / shear * others);
  point[columns::tangential_stiffness] =
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
    point[columns::pressure_centre.x] = 1.05 * exact / load;
    return stiffness_of(result_of({point}), punch)
        .quantities.at("moment_error");
  };

  EXPECT_NEAR(pressed(2.1 * a * 1e-4).value, 0.05, 1e-12);
  EXPECT_FALSE(pressed(1.9 * a * 1e-4).has_value());
}

} // namespace asperity::reports::exact_test
