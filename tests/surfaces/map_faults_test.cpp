// Tests of what a prepared map is warned of (surfaces/measured_map.hpp):
// spikes, form and missing points, and no false alarm on clean self-affine
// maps.
#include "surfaces/measured_map.hpp"
#include "tests/folder.hpp"
#include "tests/surfaces/instrument_maps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace asperity::surfaces::map_faults_test {

class MapFaultsTest : public tests::FolderTest {
protected:
  /// What is found of the map when it is read from a file [um].
  MapFaults
  faults_of(const HeightMap& map,
            mechanics::Levelling level = mechanics::Levelling::plane) {
    const std::string file = folder / "map.txt";
    std::ofstream text(file);
    text.precision(12);
    for (int iy = map.grid.points_y; iy-- > 0;) {
      for (int ix = 0; ix < map.grid.points_x; ++ix) {
        const double height = map.heights[map.grid.index(ix, iy)];
        if (std::isnan(height))
          text << "nan ";
        else
          text << 1e6 * height << ' ';
      }
      text << '\n';
    }
    text.close();
    mechanics::SurfaceSpec surface;
    surface.kind = mechanics::SurfaceKind::measured;
    surface.file = file;
    surface.length = map.grid.length_x;
    surface.height_unit = 1e-6;
    surface.level = level;
    surface.max_missing = 0.5;
    return measured_map(surface).faults;
  }
};

/// A ground surface of 0.43 um rms.
HeightMap ground() {
  HeightMap map = measured({.points = 128, .hurst = 0.7, .seed = 3});
  double square = 0.0;
  for (const double height : map.heights)
    square += height * height / static_cast<double>(map.heights.size());
  for (double& height : map.heights)
    height *= 0.43e-6 / std::sqrt(square);
  return map;
}

std::size_t words_of(const std::string& line) {
  std::istringstream words("warning: map: " + line);
  return static_cast<std::size_t>(
      std::distance(std::istream_iterator<std::string>(words), {}));
}

TEST_F(MapFaultsTest, SpikesAreCounted) {
  HeightMap map = ground();
  for (std::size_t k = 0; k < 15; ++k)
    map.heights[(map.heights.size() / 15) * k + 700] += 5e-6;

  const MapFaults found = faults_of(map);

  EXPECT_EQ(found.spikes.count, 15U);
  EXPECT_NEAR(found.spikes.highest, 5e-6, 0.5e-6);
  const std::vector<std::string> warnings = warnings_of(found);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().substr(0, 19), "15 spikes of up to ");
  EXPECT_NE(warnings.front().find("; --remove-spikes 8 removes them"),
            std::string::npos)
      << warnings.front();
  EXPECT_LE(words_of(warnings.front()), 20U);
}

// The two ends of a scratch have one neighbour in it, as the points of a pair.
TEST_F(MapFaultsTest, ScratchesAndStepsAreNoSpikes) {
  HeightMap along = ground();
  HeightMap oblique = ground();
  HeightMap step = ground();
  for (int i = 0; i < 128; ++i) {
    along.heights[along.grid.index(i, 40)] -= 5e-6;
    oblique.heights[oblique.grid.index(i, i)] -= 5e-6;
    for (int k = 100; k < 128; ++k)
      step.heights[step.grid.index(k, i)] += 5e-6;
  }

  EXPECT_LE(faults_of(along).spikes.count, 2U);
  EXPECT_LE(faults_of(oblique).spikes.count, 2U);
  EXPECT_EQ(faults_of(step).spikes.count, 0U);
}

// Clean surfaces of H = 0.3 to 0.9 with and without a roll-off in the map.
TEST_F(MapFaultsTest, CleanMapsCauseNoWarning) {
  double with_roll_off = 0.0;
  double without = 0.0;
  for (int k = 0; k < 28; ++k) {
    const bool has_roll_off = k % 2 == 0;
    const MapFaults found =
        faults_of(measured({.points = 96,
                            .hurst = 0.3 + 0.1 * (k % 7),
                            .roll_off = has_roll_off ? 4.0 : 0.3,
                            .seed = static_cast<std::uint64_t>(100 + k)}));
    EXPECT_EQ(warnings_of(found), std::vector<std::string>()) << k;
    double& largest = has_roll_off ? with_roll_off : without;
    largest = std::max(largest, found.form_share);
  }
  EXPECT_LT(with_roll_off, 0.2);
  EXPECT_GT(without, 0.2); // long waves are partly a form
}

TEST_F(MapFaultsTest, FormIsReportedUnlessItIsRemoved) {
  HeightMap map = ground();
  for (int iy = 0; iy < 128; ++iy)
    for (int ix = 0; ix < 128; ++ix)
      map.heights[map.grid.index(ix, iy)] +=
          20e-6 * std::pow((ix - 63.5) / 63.5, 2);

  const std::vector<std::string> warnings = warnings_of(faults_of(map));

  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().find("form: a second-order surface explains 9"),
            0U)
      << warnings.front();
  EXPECT_LE(words_of(warnings.front()), 20U);
  EXPECT_EQ(warnings_of(faults_of(map, mechanics::Levelling::bow)),
            std::vector<std::string>());
}

TEST_F(MapFaultsTest, MissingPointsAreCounted) {
  HeightMap map = ground();
  for (std::size_t k = 0; k < 164; ++k)
    map.heights[100 * k] = std::numeric_limits<double>::quiet_NaN();

  const std::vector<std::string> warnings = warnings_of(faults_of(map));

  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().find("164 of 16384 points (1 %) are missing"), 0U)
      << warnings.front();
  EXPECT_LE(words_of(warnings.front()), 20U);
}

} // namespace asperity::surfaces::map_faults_test
