// Tests of measured maps with missing points whose rows several ranks read: the
// heights have the bits of one process. Tolerance: none.
#include "input/input_error.hpp"
#include "surfaces/measured_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/message_of.hpp"
#include "tests/surfaces/measured_files.hpp"

namespace asperity::surfaces::missing_rows_test {

using namespace tests_of_rows;

/// Heights with a hole over the bounds of all ranks, one in a corner, one at a
/// side, and single points, also diagonal ones. Columns and rows of the points.
std::vector<double> heights_with_holes() {
  std::vector<double> heights = heights_of_file();
  const auto remove = [&](std::size_t x, std::size_t y) {
    heights[y * columns + x] = std::numeric_limits<double>::quiet_NaN();
  };
  for (std::size_t y = 1; y < 22; ++y)
    remove(11, y);
  for (const auto& [x, y] : {std::pair{0, 0},
                             {1, 0},
                             {0, 1},
                             {36, 9},
                             {36, 10},
                             {20, 5},
                             {21, 6},
                             {22, 5},
                             {5, 23},
                             {30, 0}})
    remove(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
  return heights;
}

SurfaceSpec with_holes(const std::string& file) {
  SurfaceSpec surface = measured(file);
  surface.length_y = 20e-6; // pixels are not square
  surface.max_missing = 0.05;
  return surface;
}

TEST(MissingRows, HaveTheBitsOfOneProcess) {
  SurfaceSpec surface = with_holes(npy_file("holes.npy", heights_with_holes()));
  for (const auto edges :
       {mechanics::Edges::periodic, mechanics::Edges::mirror}) {
    surface.edges = edges;
    expect_bits_of_one_process(surface);
  }
  EXPECT_EQ(described_map(surface).missing, 31U);
}

// The window has some of the holes and cuts one.
TEST(MissingRows, HaveTheBitsOfOneProcessInAWindow) {
  SurfaceSpec surface = with_holes(npy_file("cut.npy", heights_with_holes()));
  surface.max_missing = 0.1;
  surface.crop = mechanics::MapWindow{8e-6, 4e-6, 20e-6, 0.0};
  surface.level = mechanics::Levelling::bow;
  expect_bits_of_one_process(surface);
}

TEST(MissingRows, AreRefusedAsInOneProcess) {
  SurfaceSpec few = with_holes(npy_file("few.npy", heights_with_holes()));
  SurfaceSpec none = few;
  few.max_missing = 0.01;
  none.fill = mechanics::Filling::none;
  const SurfaceSpec all = with_holes(npy_file(
      "all.npy", std::vector<double>(columns * rows_of_file,
                                     std::numeric_limits<double>::infinity())));
  EXPECT_EQ(reason_for_whole_map(all), "all points are missing");
  for (const SurfaceSpec& surface : {few, none}) {
    const std::string expected = tests::message_of<input::InputError>(
        [&] { build_surface(surface, 0); });
    ASSERT_NE(expected.find("31 of 888 points are missing"), std::string::npos);
    EXPECT_EQ(tests::message_of<input::InputError>(
                  [&] { reason_for_whole_map(surface); }),
              expected);
  }
}

/// The holes have a number instead of NaN.
std::vector<double> heights_with_marks() {
  std::vector<double> heights = heights_with_holes();
  for (double& height : heights)
    if (std::isnan(height))
      height = -9999.0;
  return heights;
}

TEST(MissingRows, HaveTheNumberOfTheCase) {
  SurfaceSpec surface = with_holes(npy_file("mark.npy", heights_with_marks()));
  surface.missing_value = -9999.0;

  expect_bits_of_one_process(surface);

  EXPECT_EQ(described_map(surface).missing, 31U);
}

// Every rank finds the mark, whichever has rows with it.
TEST(MissingRows, MarksAreRefusedByAllRanks) {
  const SurfaceSpec surface =
      with_holes(npy_file("refused.npy", heights_with_marks()));
  const auto message = [&](const auto& act) {
    return tests::message_of<input::InputError>(act);
  };
  const std::string expected = message([&] { measured_map(surface); });
  EXPECT_NE(expected.find("31 point(s) have the number -9999"),
            std::string::npos);
  const Grid grid = measured_grid(surface);
  tests::on_thread_ranks(3, [&](RankGroup& ranks) {
    const SharedRows rows(grid, ranks, bounds_of(grid.points_y, 3));
    EXPECT_EQ(message([&] { measured_rows(surface, rows); }), expected);
  });
}

} // namespace asperity::surfaces::missing_rows_test
