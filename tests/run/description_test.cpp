// Tests of run/plan/description.hpp: the numbers by which adhesion is judged
// are those of the shape that is pressed, on any grid.
#include "run/plan/description.hpp"
#include "run/plan/run_options.hpp"
#include "tests/run/planned_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>

namespace asperity::run::description_test {

class Description : public PlannedRun {
protected:
  std::map<std::string, double> numbers_of(const std::string& text) {
    const cases::Case contact_case =
        cases::read_case_text(text, (folder / "case.toml").string());
    std::map<std::string, double> numbers;
    for (const DerivedNumber& number :
         describe_case(contact_case, {folder / "out", {}, false, 2, "", &cache})
             .derived)
      numbers[number.name] = number.value;
    return numbers;
  }

  /// The case adhesive-sphere.
  static std::string sphere(int points, const std::string& surface) {
    return fmt::format(R"(schema = 1
title = "A sphere"
[surface]
{}
[material]
contact_modulus = "1 GPa"
[load]
nominal_pressure = ["-5 MPa", 0]
[halfspace]
boundaries = "free"
contact = "dugdale"
work_of_adhesion = "50 mJ/m^2"
range = "1.529 nm"
)",
                       fmt::format(fmt::runtime(surface), points));
  }
};

// The curvature is 1/R, Tabor's parameter (w^2 R/(E*^2 rho^3))^(1/3), and the
// slope the mean over the square, L/(R sqrt6), whatever the grid.
TEST_F(Description, JudgesAdhesionOfASphereByItsShape) {
  const double tabor = std::cbrt(0.05 * 0.05 * 1e-6 / 1e18 / 1e-27) /
                       1.529; // lengths in nm below the root
  const double slope = 215.7e-9 / 1e-6 / std::sqrt(6.0);
  const double sticks = 0.5 * slope * 1e9 * 1.529e-9 / 0.05 *
                        std::pow(slope * slope / (2e6 * 1.529e-9), 2.0 / 3.0);
  EXPECT_NEAR(tabor, 0.8877, 1e-4);
  for (const int points : {32, 128}) {
    const auto numbers =
        numbers_of(sphere(points, "kind = \"sphere\"\nlength = \"215.7 nm\"\n"
                                  "points = {}\nradius = \"1 um\""));

    EXPECT_NEAR(numbers.at("rms_curvature"), 1e6, 1.0);
    EXPECT_NEAR(numbers.at("tabor_parameter"), tabor, 1e-9);
    EXPECT_NEAR(numbers.at("stickiness"), sticks, 1e-9);
    EXPECT_NEAR(numbers.at("stickiness"), 2.5, 0.01);
  }
}

// The same shape as a measured map that is pressed once: its mirror images and
// the edges between them are not pressed.
TEST_F(Description, JudgesAdhesionOfAFreeMapInside) {
  for (const int points : {16, 64}) {
    std::ofstream file(folder / "map.txt");
    file.precision(17);
    for (int iy = 0; iy < points; ++iy)
      for (int ix = 0; ix < points; ++ix) {
        const double x = (ix + 0.5) / points - 0.4; // the apex is not central
        const double y = (iy + 0.5) / points - 0.5;
        file << -0.5e-6 * std::pow(215.7e-3, 2) * (x * x + y * y)
             << (ix + 1 < points ? ' ' : '\n');
      }
    file.close();
    const auto numbers = numbers_of(sphere(
        points,
        "kind = \"measured\"\nfile = \"map.txt\"\nheight_unit = \"1 m\"\n"
        "length = \"215.7 nm\"\nlevel = \"none\"\nedges = \"free\""));

    EXPECT_NEAR(numbers.at("rms_curvature"), 1e6, 1e2) << points;
    EXPECT_NEAR(numbers.at("tabor_parameter"), 0.8877, 1e-3) << points;
  }
}

// Curvature has no bound at the tip of a cone.
TEST_F(Description, DoesNotStateTheCurvatureOfATip) {
  const auto numbers = numbers_of(
      sphere(32, "kind = \"cone\"\nlength = \"215.7 nm\"\npoints = {}\n"
                 "slope = 0.01"));

  EXPECT_FALSE(numbers.contains("rms_curvature"));
  EXPECT_FALSE(numbers.contains("tabor_parameter"));
  EXPECT_FALSE(numbers.contains("stickiness"));
  EXPECT_TRUE(numbers.contains("work_of_adhesion"));
}

} // namespace asperity::run::description_test
