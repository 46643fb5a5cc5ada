// Tests with files of real instruments, which are not part of the project:
// sizes, units and rms values that the tests of another program state for them.
#include "base/child_process.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/maps/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace asperity::surfaces::real_maps_test {

namespace fs = std::filesystem;

/// Folder of the files, given by the environment.
fs::path data_folder() {
  const char* const named = std::getenv("ASPERITY_TEST_DATA");
  return named != nullptr ? fs::path(named) : fs::path();
}

class RealMaps : public testing::Test {
protected:
  void SetUp() override {
    if (!fs::is_directory(data_folder()))
      GTEST_SKIP() << "ASPERITY_TEST_DATA names no folder of real maps";
  }
};

// The rms height about the mean and the sides are those that the tests of
// SurfaceTopography state (test/IO/test_x3p.py), to all of their digits.
TEST_F(RealMaps, X3pOfAnOpticalProfiler) {
  Scan scan = read_scan(data_folder() / "x3p-2.x3p", {});
  EXPECT_EQ(scan.map.grid.points_x, 650);
  EXPECT_EQ(scan.map.grid.points_y, 650);
  EXPECT_NEAR(scan.map.grid.length_x, 8.29767313942749e-05, 1e-18);
  EXPECT_NEAR(scan.map.grid.length_y, 0.0002044783737930349, 1e-17);
  remove_mean(scan.map);
  EXPECT_NEAR(statistics(scan.map).rms_height, 7.728033273597876e-08,
              1e-20); // sums of 4e5 squares in another order
  EXPECT_EQ(scan.reader, "own reader of X3P");
}

TEST_F(RealMaps, SdfExampleOfTheStandard) {
  const Scan scan = read_scan(data_folder() / "sdf-1.sdf", {});
  EXPECT_EQ(scan.map.grid.points_x, 7);
  EXPECT_EQ(scan.map.grid.points_y, 4);
  EXPECT_NEAR(scan.map.grid.length_x, 7e-6, 1e-18);
  EXPECT_NEAR(scan.map.heights[1], 0.99874e-6, 1e-20);
}

TEST_F(RealMaps, GwyddionText) {
  const Scan afm = read_scan(data_folder() / "afm-20um-256.txt", {});
  EXPECT_EQ(afm.map.grid.points_x, 256);
  EXPECT_NEAR(afm.map.grid.length_x, 20e-6, 1e-18);
  EXPECT_EQ(afm.channel, "Topography");
  const Scan tiny =
      read_scan(data_folder() / "gwyddion-export-english.txt", {});
  EXPECT_NEAR(tiny.map.grid.length_x, 12.34e-6, 1e-18);
  EXPECT_NEAR(tiny.map.grid.length_y, 5.6789e-6, 1e-18);
}

// Where Gwyddion reads a file as well, it agrees with our reader.
TEST_F(RealMaps, AgreeWithGwyddion) {
  if (program_on_path("gwyddion").empty())
    GTEST_SKIP() << "skipped: needs gwyddion";
  for (const std::string name : {"x3p-2.x3p", "sdf-1.sdf"}) {
    const Scan own = read_scan(data_folder() / name, {});
    const Scan other = read_scan(data_folder() / name, {"convert", {}, {}});
    ASSERT_EQ(own.map.heights.size(), other.map.heights.size()) << name;
    EXPECT_NEAR(own.map.grid.length_x, other.map.grid.length_x,
                1e-14 * own.map.grid.length_x);
    double difference = 0.0;
    for (std::size_t i = 0; i < own.map.heights.size(); ++i)
      difference = std::max(
          difference, std::abs(own.map.heights[i] - other.map.heights[i]));
    EXPECT_LT(difference, 1e-20) << name; // m; roundoff of heights of 1 um
  }
}

} // namespace asperity::surfaces::real_maps_test
