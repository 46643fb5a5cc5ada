// Verifies the image of a map: its data file places every value where its block
// lies, in the units that the figure states.
#include "reports/figures/map_image.hpp"
#include "reports/figures/map_stacks.hpp"

#include <gtest/gtest.h>

namespace asperity::reports::map_image_test {

TEST(MapImage, PlacesValuesAtTheCentresOfTheirBlocks) {
  const Grid grid{3, 2, 6e-6, 2e-6};
  const MapImage image = map_image(
      grid, std::vector<double>{1e-9, 2e-9, 3e-9, -4e-9, 5e-9, 60e-9}, 1e-9);

  EXPECT_EQ(image.least, -4.0);
  EXPECT_DOUBLE_EQ(image.largest, 60.0);
  EXPECT_EQ(map_csv(image), "3,1,3,5\n"
                            "0.5,1,2,3\n"
                            "1.5,-4,5,60\n");
  EXPECT_EQ(map_csv(image, 10.0), "3,1,3,5\n"
                                  "0.5,0.1,0.2,0.3\n"
                                  "1.5,-0.4,0.5,6\n");
  const ChartPanel panel = map_panel(image, "a", "height");
  EXPECT_EQ(panel.x.low, 0.0);
  EXPECT_EQ(panel.x.high, 6.0);
  EXPECT_EQ(panel.y.high, 2.0);
}

// 515 points become 171 blocks of three, which end two points before the map.
TEST(MapImage, DoesNotStretchBlocksOverPointsThatAreLeftOut) {
  const Grid grid{515, 1, 515e-6, 1e-6};
  std::vector<double> map(grid.size(), 1.0);
  map[3] = 4.0;
  const MapImage image = map_image(grid, map, 1.0);

  EXPECT_EQ(image.columns, 171);
  EXPECT_EQ(image.rows, 1);
  EXPECT_DOUBLE_EQ(image.pitch_x, 3.0);
  EXPECT_DOUBLE_EQ(image.pitch_y, 1.0);
  EXPECT_EQ(image.values[0], 1.0);
  EXPECT_EQ(image.values[1], 2.0);
  EXPECT_EQ(map_csv(image).substr(0, 16), "171,1.5,4.5,7.5,");
}

// Of 1000 heights up to 10 nm, five are spikes: the colours leave them out, and
// the caption says so.
TEST(MapImage, ColoursAreNotThoseOfAFewSpikes) {
  const Grid grid{100, 10, 1e-6, 1e-6};
  std::vector<double> map(grid.size(), 10e-9);
  for (std::size_t i = 0; i < map.size(); i += 2)
    map[i] = -8e-9;
  const MapImage even = map_image(grid, map, 1e-9);
  EXPECT_DOUBLE_EQ(height_span(even), 10.0);
  EXPECT_EQ(span_note(even), "");
  for (std::size_t i = 0; i < 5; ++i)
    map[i] = 500e-9;
  const MapImage spiked = map_image(grid, map, 1e-9);
  EXPECT_DOUBLE_EQ(height_span(spiked), 13.0);
  EXPECT_EQ(span_note(spiked), " Colours end beyond 99 % of the heights.");
}

// The shorter side keeps two tics at least.
TEST(MapImage, ChoosesTicsForTheLongerSide) {
  const auto tics = [](double length_x, double length_y) {
    const ChartPanel panel = map_panel(
        map_image({1, 1, length_x, length_y}, std::vector<double>{0.0}, 1.0),
        "a", "height");
    return std::pair(panel.x.tick_step, panel.y.tick_step);
  };
  EXPECT_EQ(tics(40e-6, 160e-6), std::pair(25.0, 50.0));
  EXPECT_EQ(tics(60e-6, 160e-6), std::pair(50.0, 50.0));
  EXPECT_EQ(tics(160e-6, 160e-6), std::pair(50.0, 50.0));
}

// Rows are so long that a piece of a map in a file has two of seven, while a
// block has three.
TEST(MapImage, IsThatOfAMapInMemoryIfItIsReadByPieces) {
  const Grid grid{(1 << 21) + 3, 7, 1.0, 1.0};
  std::vector<double> map(grid.size());
  std::vector<double> other(grid.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    map[i] = static_cast<double>(i * i % 10007);
    other[i] = static_cast<double>(i % 101);
  }
  const auto stored = [&](const std::vector<double>& values) {
    const auto width = static_cast<std::size_t>(grid.points_x);
    return results::StoredMap{
        7, width, [&values, width](std::size_t first, std::size_t count) {
          EXPECT_LE(count, 2U);
          const auto begin =
              values.begin() + static_cast<std::ptrdiff_t>(first * width);
          return std::vector<double>(
              begin, begin + static_cast<std::ptrdiff_t>(count * width));
        }};
  };
  const results::StoredMap one = stored(map);
  const results::StoredMap two = stored(other);

  EXPECT_EQ(reduced(grid, one, 3).values, reduced(grid, map, 3).values);
  const std::vector<double> difference =
      reduced_difference(grid, one, two, 3).values;
  for (std::size_t i = 0; i < map.size(); ++i)
    map[i] -= other[i];
  EXPECT_EQ(difference, reduced(grid, map, 3).values);
  EXPECT_EQ(difference.size(), 2U * 2U);
}

// With adhesion the largest tension is no contact, and a closed node in tension
// is: the shares of two blocks of two nodes.
TEST(MapImage, OfContactIsThatOfTheArea) {
  const Grid grid{4, 1, 1.0, 1.0};
  const std::vector<double> pressure{-1e-12, -3.0, -2.0, 5.0},
      gap{1.0, 0.5, 0.0, 0.0};
  using mechanics::ContactField;
  const auto shares = [&](ContactField field) {
    return reduced_contact(grid, pressure, gap, {field, 0.0}, 2).values;
  };

  EXPECT_EQ(shares(ContactField::gap), (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(shares(ContactField::pressure), (std::vector<double>{0.0, 0.5}));
}

// The colours of the browser end where those on paper do, though its map is
// finer: one node of 4 in a block of four nodes is 1 on paper.
TEST(MapImage, HasTheColoursOfThePrintedMapInTheBrowser) {
  const Grid grid{512, 512, 1e-6, 1e-6};
  std::vector<double> map(grid.size(), 0.0);
  map[0] = 4.0;
  MapStack stack = stack_on(grid);

  const PackedMap packed = add_map(stack, grid, map, 1.0, 512);

  EXPECT_EQ(packed.high, 4.0);
  EXPECT_EQ(packed.shown_high, 1.0);
  EXPECT_EQ(packed.shown_high, map_image(grid, map, 1.0).largest);
}

} // namespace asperity::reports::map_image_test
