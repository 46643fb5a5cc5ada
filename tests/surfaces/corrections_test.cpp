// Tests of surfaces/maps/corrections.hpp: cropping, scan
// lines, spikes and the filling of missing points.
#include "surfaces/maps/corrections.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace asperity::surfaces::corrections_test {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

HeightMap map_of(const Grid& grid,
                 const std::function<double(int, int)>& height) {
  HeightMap map{grid, {}};
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      map.heights.push_back(height(ix, iy));
  return map;
}

TEST(Crop, KeepsThePixelsWhoseCentresAreInside) {
  HeightMap map =
      map_of({6, 5, 6.0, 10.0}, [](int ix, int iy) { return ix + 10.0 * iy; });
  EXPECT_EQ(map.heights[map.grid.index(3, 2)], 23);
  crop(map,
       pixels_of(map.grid, {2.0, 3.5, 3.2, 4.0})); // x: 2.5, 3.5, 4.5; y: 5, 7
  EXPECT_EQ(map.heights, (std::vector<double>{22, 23, 24, 32, 33, 34}));
  EXPECT_EQ(map.grid, (Grid{3, 2, 3.0, 4.0}));
}

TEST(Crop, RefusesAWindowThatIsNotInside) {
  const Grid grid{6, 5, 6.0, 10.0};
  const auto flat = [](int, int) { return 0.0; };
  HeightMap map = map_of(grid, flat);
  EXPECT_THROW(crop(map, pixels_of(map.grid, {2.0, 0.0, 4.1, 5.0})),
               std::domain_error);
  EXPECT_THROW(crop(map, pixels_of(map.grid, {-1.0, 0.0, 3.0, 5.0})),
               std::domain_error);
  EXPECT_THROW(crop(map, pixels_of(map.grid, {0.0, 0.0, 1.2, 5.0})),
               std::domain_error); // one column
  EXPECT_EQ(map.grid, grid);
  crop(map, pixels_of(map.grid, {0.0, 0.0, 6.0, 10.0}));
  EXPECT_EQ(map.grid, grid);
}

// Offsets of rows, of any size, are removed exactly even if some points differ
// in every row or are missing.
TEST(AlignLines, RemovesOffsetsOfRows) {
  const auto relief = [](int ix, int) { return 0.25 * ((ix * 7) % 5); };
  HeightMap map = map_of({9, 6, 1.0, 1.0}, [&](int ix, int iy) {
    const bool is_particle = ix == (3 * iy) % 9;
    return relief(ix, iy) + 8.0 * ((iy * 5) % 3) + (is_particle ? 64.0 : 0.0);
  });
  map.heights[10] = missing;
  align_lines(map);
  for (int iy = 1; iy < 6; ++iy)
    for (int ix = 0; ix < 9; ++ix) {
      const std::size_t index = map.grid.index(ix, iy);
      EXPECT_EQ(std::isnan(map.heights[index]), index == 10);
      if (ix != (3 * iy) % 9 && index != 10) {
        EXPECT_EQ(map.heights[index], relief(ix, iy)) << ix << " " << iy;
      }
    }
}

// In Gaussian noise with three spikes of 30 standard deviations exactly these
// three are marked at a threshold of 8.
TEST(MarkSpikes, FindsThemAndNothingElse) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1.0);
  HeightMap map =
      map_of({40, 30, 1.0, 1.0}, [&](int, int) { return noise(random); });
  for (const std::size_t at : {0U, 555U, 1199U})
    map.heights[at] += 30.0;
  EXPECT_EQ(mark_spikes(map, 8.0), 3U);
  for (std::size_t i = 0; i < 1200; ++i)
    EXPECT_EQ(std::isnan(map.heights[i]), i == 0 || i == 555 || i == 1199) << i;
  EXPECT_THROW(mark_spikes(map, 2.9), std::domain_error);
}

// A spike of 10 standard deviations is not marked at a threshold of 20.
TEST(MarkSpikes, ComparesWithTheThreshold) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 1.0);
  HeightMap map =
      map_of({40, 30, 1.0, 1.0}, [&](int, int) { return noise(random); });
  map.heights[300] += 10.0;
  map.heights[700] += 40.0;
  EXPECT_EQ(mark_spikes(map, 20.0), 1U);
  EXPECT_FALSE(std::isnan(map.heights[300]));
  EXPECT_TRUE(std::isnan(map.heights[700]));
}

TEST(MarkSpikes, FindsTheOnlyStepOfAFlatMap) {
  HeightMap map = map_of({20, 20, 1.0, 1.0}, [](int ix, int iy) {
    return ix == 7 && iy == 8 ? 5.0 : 1.0;
  });
  EXPECT_EQ(mark_spikes(map, 6.0), 1U);
  EXPECT_TRUE(std::isnan(map.heights[map.grid.index(7, 8)]));
}

// A function whose discrete Laplacian vanishes is restored to roundoff, on
// pixels that are not square: x y, x and x^2 - y^2 in units of length.
TEST(FillMissing, RestoresHarmonicHeights) {
  const Grid grid{12, 10, 3.6, 1.0};
  const auto height = [&](int ix, int iy) {
    const double x = ix * grid.spacing_x();
    const double y = iy * grid.spacing_y();
    return 1.0 + x + 2.0 * x * y + x * x - y * y;
  };
  HeightMap map = map_of(grid, height);
  for (int iy = 2; iy < 8; ++iy)
    for (int ix = 3; ix < 10; ++ix)
      map.heights[grid.index(ix, iy)] = missing;
  fill_missing(map);
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      EXPECT_NEAR(map.heights[grid.index(ix, iy)], height(ix, iy), 1e-12)
          << ix << " " << iy;
}

// Missing points at the border are filled without a slope across it, so that a
// row that is missing at the border repeats its neighbour; values stay in
// range.
TEST(FillMissing, FillsHolesAtTheBorder) {
  HeightMap map =
      map_of({5, 4, 1.0, 1.0}, [](int, int iy) { return iy == 0 ? 9.0 : 2.0; });
  for (std::size_t i = 0; i < 5; ++i)
    map.heights[i] = missing;
  fill_missing(map);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(map.heights[i], 2.0, 1e-14);
}

TEST(FillMissing, NeedsAMeasuredPoint) {
  HeightMap map = map_of({2, 2, 1.0, 1.0}, [](int, int) { return 1.0; });
  fill_missing(map);
  EXPECT_EQ(map.heights, (std::vector<double>(4, 1.0)));
  map.heights.assign(4, missing);
  EXPECT_EQ(count_missing(map), 4U);
  EXPECT_THROW(fill_missing(map), std::domain_error);
}

} // namespace asperity::surfaces::corrections_test
