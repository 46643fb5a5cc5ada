// Tests of surfaces/maps/round_form.hpp: spheres, cylinders and planes are
// removed exactly, and the roughness on them remains.
#include "surfaces/maps/round_form.hpp"
#include "surfaces/maps/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace asperity::surfaces::round_form_test {

/// Heights over x, y [m] from the middle of a map of 40 by 30 um.
HeightMap form_of(const std::function<double(double, double)>& height) {
  HeightMap map{{40, 25, 40e-6, 30e-6}, {}};
  for (int iy = 0; iy < map.grid.points_y; ++iy)
    for (int ix = 0; ix < map.grid.points_x; ++ix)
      map.heights.push_back(height((ix - 19.5) * map.grid.spacing_x(),
                                   (iy - 12.0) * map.grid.spacing_y()));
  return map;
}

double largest_left(const HeightMap& map) {
  double largest = 0.0;
  for (const double height : map.heights)
    largest = std::max(largest, std::abs(height));
  return largest;
}

// Any part of a sphere, convex or concave, is removed to roundoff, also where a
// paraboloid would leave micrometres.
TEST(RoundForm, RemovesSpheres) {
  for (const double radius : {30e-6, 200e-6, 1.0}) {
    for (const double sign : {1.0, -1.0}) {
      HeightMap map = form_of([&](double x, double y) {
        return 1e-3 + sign * std::sqrt(radius * radius - std::pow(x - 3e-6, 2) -
                                       std::pow(y + 2e-6, 2));
      });
      remove_sphere(map);
      // A radius of 1 m is lost in the roundoff of its heights.
      EXPECT_LT(largest_left(map), radius == 1.0 ? 1e-15 : 1e-18)
          << radius << " " << sign;
    }
  }
}

TEST(RoundForm, RemovesPlanes) {
  HeightMap map = form_of([](double x, double y) { return 0.1 * x - 0.2 * y; });
  remove_sphere(map);
  EXPECT_LT(largest_left(map), 1e-18);
  map = form_of([](double x, double y) { return 0.1 * x - 0.2 * y; });
  remove_cylinder(map);
  EXPECT_LT(largest_left(map), 1e-18);
}

TEST(RoundForm, RemovesCylindersInAnyDirection) {
  for (const double angle : {0.0, 0.4, 1.57, 2.5}) {
    HeightMap map = form_of([&](double x, double y) {
      const double across = y * std::cos(angle) - x * std::sin(angle);
      const double along = x * std::cos(angle) + y * std::sin(angle);
      return 0.01 * along -
             std::sqrt(1.6e-9 - std::pow(across - 4e-6, 2)); // radius 40 um
    });
    remove_cylinder(map);
    EXPECT_LT(largest_left(map), 1e-17) << angle;
  }
}

// A wave on a sphere keeps its rms height: the sphere takes 4 parameters of
// 1000 points, which is less than a percent of a short wave.
TEST(RoundForm, KeepsTheRoughness) {
  const auto wave = [](double x, double y) {
    return 1e-8 * std::cos(2e6 * x) * std::cos(1.5e6 * y);
  };
  HeightMap rough = form_of(wave);
  remove_mean(rough);
  HeightMap map = form_of([&](double x, double y) {
    return wave(x, y) + std::sqrt(2.5e-9 - x * x - y * y);
  });
  remove_sphere(map);
  EXPECT_NEAR(statistics(map).rms_height / statistics(rough).rms_height, 1.0,
              0.01);
}

} // namespace asperity::surfaces::round_form_test
