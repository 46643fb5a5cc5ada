// Tests of the Euler characteristic of results/observables/area_estimate.hpp:
// shapes for which it is known by counting.
#include "results/observables/area_estimate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "tests/results/shapes.hpp"

namespace asperity::results::euler_number_test {

constexpr double modulus = 2e9; // E* [Pa]

// Patches minus holes, wherever the periodic boundary cuts them.
TEST(EulerNumber, CountsPatchesMinusHoles) {
  const Grid grid{40, 40, 1.0, 1.0};
  const auto euler = [&](auto is_inside) {
    return euler_characteristic(grid, shape(grid, is_inside));
  };
  const auto disc = [](double x, double y, double centre, double radius) {
    return std::hypot(periodic_distance(x, centre, 1.0),
                      periodic_distance(y, centre, 1.0)) < radius;
  };

  for (const double centre : {0.0, 0.13, 0.5}) {
    EXPECT_EQ(
        euler([&](double x, double y) { return disc(x, y, centre, 0.3); }),
        1.0);
    EXPECT_EQ(euler([&](double x, double y) {
                return disc(x, y, centre, 0.3) && !disc(x, y, centre, 0.1);
              }),
              0.0); // a ring
    EXPECT_EQ(
        euler([&](double x, double y) { return !disc(x, y, centre, 0.3); }),
        -1.0);
  }
  EXPECT_EQ(euler([](double x, double) { return x < 0.5; }), 0.0); // a strip
  EXPECT_EQ(euler([](double, double) { return false; }), 0.0);
  EXPECT_EQ(euler([](double, double) { return true; }), 0.0);
}

// Beyond a free border there is no contact: full contact is one patch, a strip
// too, and contacts on opposite sides of the map are two. The border has no
// gap, so that the lines of a contact that reaches it end with its cells.
TEST(FreeBorder, EndsAContact) {
  const Grid grid{12, 8, 1.2, 0.8};
  const auto euler = [&](auto is_inside) {
    return euler_characteristic(grid, shape(grid, is_inside), Border::free);
  };
  EXPECT_EQ(euler([](double, double) { return true; }), 1.0);
  EXPECT_EQ(euler([](double x, double) { return x < 0.5; }), 1.0);
  EXPECT_EQ(euler([](double x, double) { return x < 0.25 || x > 0.85; }), 2.0);
  EXPECT_EQ(euler([](double x, double y) {
              return std::abs(x - 0.6) > 0.15 || std::abs(y - 0.4) > 0.15;
            }),
            0.0); // a frame around a hole
  const std::vector<double> full(grid.size(), modulus);
  const std::vector<double> no_gap(grid.size(), 0.0);
  EXPECT_EQ(line_area_fraction(grid, full, no_gap, modulus, Border::free), 1.0);
}

// Contact and its complement have opposite Euler characteristics on a periodic
// surface, whose own is 0. Exact: multiples of a quarter.
RC_GTEST_PROP(EulerNumber, ChangesSignWithTheComplement, ()) {
  const Grid grid{8, 6, 1.0, 1.0};
  std::vector<double> pressure(grid.size());
  std::vector<double> complement(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    pressure[i] = *rc::gen::inRange(0, 2);
    complement[i] = 1.0 - pressure[i];
  }

  RC_ASSERT(euler_characteristic(grid, pressure) ==
            -euler_characteristic(grid, complement));
}

} // namespace asperity::results::euler_number_test
