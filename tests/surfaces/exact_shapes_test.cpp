// Tests of surfaces/maps/exact_shapes.hpp: position and height of the shapes.
#include "surfaces/maps/exact_shapes.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::surfaces::exact_shapes_test {

constexpr Grid grid{32, 16, 4.0, 2.0};

// There is one maximum, at the centre node, from which the height decreases by
// r^2/(2R). Tolerance: roundoff of heights of order one.
TEST(Paraboloid, HasItsTopAtTheCentreNode) {
  const HeightMap map = paraboloid(grid, 2.5);

  const auto top = std::max_element(map.heights.begin(), map.heights.end());
  EXPECT_EQ(top - map.heights.begin(),
            static_cast<std::ptrdiff_t>(grid.index(16, 8)));
  const double one_right = map.heights[grid.index(17, 8)];
  const double corner = map.heights[grid.index(0, 0)];
  EXPECT_NEAR(*top - one_right, 0.125 * 0.125 / 5.0, 1e-15);
  EXPECT_NEAR(*top - corner, (4.0 + 1.0) / 5.0, 1e-15);
  EXPECT_NEAR(mean_height(map), 0.0, 1e-16);
}

TEST(Paraboloid, IsSymmetricAboutItsTop) {
  const HeightMap map = paraboloid(grid, 2.5);

  for (int d = 1; d < 8; ++d) {
    EXPECT_EQ(map.heights[grid.index(16 + d, 8)],
              map.heights[grid.index(16 - d, 8)]);
    EXPECT_EQ(map.heights[grid.index(16, 8 + d)],
              map.heights[grid.index(16, 8 - d)]);
  }
}

// The wave has the formula of its header, equal heights are equal bit for bit,
// the mean is 0 and the mean square D^2/2 (1-D) or D^2/4 (2-D).
TEST(Waves, FollowTheirFormula) {
  const HeightMap line = wave_1d(grid, 3.0, 1.0);
  const HeightMap egg_box = wave_2d(grid, 3.0, 1.0);
  const double two_pi = 2.0 * std::numbers::pi;

  double squares_line = 0.0;
  double squares_egg_box = 0.0;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double along_x = std::cos(two_pi * ix * grid.spacing_x());
      const double along_y = std::cos(two_pi * iy * grid.spacing_y());
      const std::size_t at = grid.index(ix, iy);
      EXPECT_NEAR(line.heights[at], 3.0 * along_x, 1e-14);
      EXPECT_NEAR(egg_box.heights[at], 3.0 * along_x * along_y, 1e-14);
      squares_line += line.heights[at] * line.heights[at];
      squares_egg_box += egg_box.heights[at] * egg_box.heights[at];
    }
  EXPECT_NEAR(squares_line / 512.0, 4.5, 1e-13);
  EXPECT_NEAR(squares_egg_box / 512.0, 2.25, 1e-13);
  EXPECT_EQ(line.heights[grid.index(1, 0)], line.heights[grid.index(25, 7)]);
}

// A third of 4 m printed with five digits fits three times.
TEST(Waves, FitTheCellWhenTheirLengthIsPrinted) {
  const HeightMap map = wave_1d({36, 4, 4.0, 2.0}, 3.0, 1.3333);

  EXPECT_EQ(map.heights[0], map.heights[12]);
  EXPECT_EQ(map.heights[0], map.heights[24]);
}

// The end is a plane of the given slope about the middle, with the height 0
// there, and the recess lies everywhere else. Tolerance: roundoff of the mean.
TEST(FlatPunch, HasATiltedEndAndARecess) {
  const HeightMap map = flat_punch({16, 16, 4.0, 4.0}, 1.0, 0.5, 0.1);
  const double middle = map.heights[8 * 16 + 8];

  EXPECT_NEAR(map.heights[8 * 16 + 12] - middle, 0.1, 1e-15);
  EXPECT_NEAR(map.heights[8 * 16 + 4] - middle, -0.1, 1e-15);
  EXPECT_NEAR(map.heights[12 * 16 + 8] - middle, 0.0, 1e-15);
  EXPECT_NEAR(map.heights[8 * 16 + 13] - middle, -0.5, 1e-15);
  EXPECT_NEAR(map.heights[11 * 16 + 11] - middle, -0.5, 1e-15);
}

TEST(FlatPunch, RefusesARecessAboveItsEnd) {
  EXPECT_EQ(tests::message_of<std::domain_error>([] {
              flat_punch({16, 16, 4.0, 4.0}, 1.0, 0.5, 0.5);
            }),
            "tilt = 0.5, but must be less than recess over radius [1]");
  EXPECT_EQ(tests::message_of<std::domain_error>([] {
              flat_punch({16, 16, 4.0, 4.0}, 2.0, 0.5, 0.0);
            }),
            "radius = 2, but must be less than half of each side [m]");
}

// The height falls by slope r, and by (r - b)^2/(2 R) beyond the flat end.
// Tolerance: roundoff.
TEST(Indenters, FallFromTheirMiddle) {
  const HeightMap pointed = cone(grid, 0.3);
  const HeightMap rounded = rounded_punch(grid, 0.5, 2.0);
  const auto below = [&](const HeightMap& map, int ix, int iy) {
    return map.heights[grid.index(16, 8)] - map.heights[grid.index(ix, iy)];
  };

  EXPECT_NEAR(below(pointed, 19, 12), 0.3 * 0.125 * 5.0, 1e-15);
  EXPECT_NEAR(below(rounded, 20, 8), 0.0, 1e-15);
  EXPECT_NEAR(below(rounded, 22, 8), 0.25 * 0.25 / 4.0, 1e-15);
  EXPECT_NEAR(below(rounded, 16, 0), 0.5 * 0.5 / 4.0, 1e-15);
  EXPECT_NEAR(mean_height(pointed), 0.0, 1e-16);
}

TEST(ExactShapes, RefuseBadArgumentsByName) {
  EXPECT_EQ(tests::message_of<std::domain_error>([] { paraboloid(grid, 0.0); }),
            "radius = 0, but must be finite and > 0 [m]");
  EXPECT_EQ(tests::message_of<std::domain_error>([] { cone(grid, -1.0); }),
            "slope = -1, but must be finite and > 0 [1]");
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [] { rounded_punch(grid, 1.0, 1.0); }),
            "radius = 1, but must be less than half of each side [m]");
  EXPECT_EQ(
      tests::message_of<std::domain_error>([] { wave_1d(grid, -1.0, 1.0); }),
      "amplitude = -1, but must be finite and > 0 [m]");
  EXPECT_EQ(
      tests::message_of<std::domain_error>([] { wave_1d(grid, 1.0, 1.5); }),
      "length_x = 4, but must be an integer multiple of wavelength = 1.5 m");
  EXPECT_EQ(
      tests::message_of<std::domain_error>([] { wave_2d(grid, 1.0, 4.0); }),
      "length_y = 2, but must be an integer multiple of wavelength = 4 m");
  EXPECT_EQ(
      tests::message_of<std::domain_error>([] { wave_1d(grid, 1.0, 0.25); }),
      "wavelength = 0.25, but must be longer than two node spacings, "
      "0.25 m");
}

} // namespace asperity::surfaces::exact_shapes_test
