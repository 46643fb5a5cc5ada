// Tests of measured maps and exact shapes whose rows several ranks build: the
// heights have the bits of one process. Tolerance: none.
#include "input/input_error.hpp"
#include "surfaces/formats/map_writer.hpp"
#include "surfaces/formats/row_file.hpp"
#include "surfaces/measured_rows.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include "tests/message_of.hpp"
#include "tests/surfaces/measured_files.hpp"

namespace asperity::surfaces::measured_rows_test {

using namespace tests_of_rows;

TEST(MeasuredRows, HaveTheBitsOfOneProcess) {
  SurfaceSpec surface = measured(npy_file("plain.npy", heights_of_file()));
  for (const auto level :
       {mechanics::Levelling::none, mechanics::Levelling::plane,
        mechanics::Levelling::bow})
    for (const auto edges :
         {mechanics::Edges::periodic, mechanics::Edges::mirror,
          mechanics::Edges::free}) {
      surface.level = level;
      surface.edges = edges;
      expect_bits_of_one_process(surface);
    }
}

TEST(MeasuredRows, HaveTheBitsOfOneProcessInAWindowOnAForm) {
  SurfaceSpec surface = measured(npy_file("window.npy", heights_of_file()));
  surface.crop = mechanics::MapWindow{3e-6, 2e-6, 20e-6, 0.0};
  surface.length_y = 20e-6;
  surface.form_radius = 1e-3;
  surface.edges = mechanics::Edges::mirror;

  EXPECT_EQ(surface_grid(surface).points_x, 40);
  expect_bits_of_one_process(surface);
}

TEST(MeasuredRows, OfExactShapesHaveTheBitsOfOneProcess) {
  for (const SurfaceKind kind : {SurfaceKind::sphere, SurfaceKind::punch,
                                 SurfaceKind::wave_1d, SurfaceKind::wave_2d}) {
    SurfaceSpec surface;
    surface.kind = kind;
    surface.length = 4.0;
    surface.points = 36;
    surface.radius = 1.0;
    surface.recess = 0.5;
    surface.tilt = 0.1;
    surface.amplitude = 0.3;
    surface.wavelength = 1.3333;
    expect_bits_of_one_process(surface);
  }
}

TEST(MeasuredRows, SayWhyTheWholeMapIsNeeded) {
  const SurfaceSpec complete =
      measured(npy_file("complete.npy", heights_of_file()));
  const std::string other = npy_file("other.dat", heights_of_file());
  std::ofstream(other, std::ios::binary) << std::string("\1\2\0\3", 4);

  EXPECT_EQ(reason_for_whole_map(complete), "");
  EXPECT_EQ(reason_for_whole_map(measured(other)),
            "the format of the map cannot be read by rows");
}

/// Writes heights as text.
std::string text_file(const std::string& name, const std::string& header,
                      const std::vector<double>& heights, std::size_t width,
                      const std::string& line_end, bool has_commas) {
  std::string text = header;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    std::string number = fmt::format("{:.9f}", heights[i]);
    if (has_commas)
      std::ranges::replace(number, '.', ',');
    text += number + ((i + 1) % width == 0 ? line_end : "\t");
    if (i == 2 * width - 1)
      text += "# a comment" + line_end + line_end;
  }
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("measured_rows_" + name);
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

TEST(MeasuredRows, OfATextHaveTheBitsOfOneProcess) {
  const std::vector<double> heights = heights_of_file();
  expect_bits_of_one_process(
      measured(text_file("plain.txt", "", heights, columns, "\n", false)));
  SurfaceSpec surface = measured(
      text_file("windows.txt", "\xEF\xBB\xBFheights of a map\r\nh=24 w=37\r\n",
                heights, columns, "\r\n", true));
  surface.crop = mechanics::MapWindow{3e-6, 2e-6, 20e-6, 20e-6};
  surface.edges = mechanics::Edges::mirror;
  surface.level = mechanics::Levelling::bow;
  expect_bits_of_one_process(surface);

  SurfaceSpec gwyddion = measured(text_file(
      "gwyddion.txt",
      "# Channel: Topography\n# Width: 37 um\n# Height: 24 um\n# Value units: "
      "nm\n",
      heights, columns, "\n", false));
  gwyddion.length = gwyddion.height_unit = std::nullopt;
  expect_bits_of_one_process(gwyddion);
  EXPECT_EQ(described_map(gwyddion).channel, "Topography");
}

// The text is longer than the pieces that are in memory, and read from lines in
// the middle.
TEST(MeasuredRows, OfALongTextHaveTheBitsOfOneProcess) {
  constexpr std::size_t width = 1600;
  std::vector<double> heights;
  for (std::size_t i = 0; i < 100 * width; ++i)
    heights.push_back(std::sin(1e-3 * static_cast<double>(i * i % 10007)));
  const std::string path =
      text_file("long.txt", "", heights, width, "\n", false);
  ASSERT_GT(std::filesystem::file_size(path), 1500000U);
  expect_bits_of_one_process(measured(path));

  const ScanRequest request{mechanics::MapFormat::automatic, {}, {4e-6, 1e-9}};
  const HeightMap whole = read_scan(path, request).map;
  const std::vector<double> late = row_file(path, request)->rows(95, 4);
  EXPECT_TRUE(std::ranges::equal(
      late, std::span(whole.heights).subspan(95 * width, 4 * width)));
}

// Its last line has no end, and the file changes between two runs.
TEST(MeasuredRows, OfATextAreThoseOfTheFileThatIsThere) {
  const std::string path =
      (std::filesystem::path(testing::TempDir()) / "measured_rows_changing.txt")
          .string();
  const ScanRequest request{mechanics::MapFormat::automatic, {}, {4e-6, 1e-9}};
  for (const std::string& text :
       {std::string("1 2 3 4\n4 3 2 1.5"), std::string("1 2 3 4 5\n4 2 2 1 7"),
        std::string("\n\n1 2 3 4\n4 2 2 8\n1 2 1 3\n")}) {
    std::ofstream(path) << text;
    const HeightMap whole = read_scan(path, request).map;
    const auto file = row_file(path, request);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->grid, whole.grid);
    EXPECT_EQ(file->missing, 0U);
    EXPECT_EQ(file->rows(0, whole.grid.points_y), whole.heights);
    EXPECT_TRUE(std::ranges::equal(
        file->rows(1, 1),
        std::span(whole.heights)
            .subspan(static_cast<std::size_t>(whole.grid.points_x),
                     static_cast<std::size_t>(whole.grid.points_x))));
  }
  std::ofstream(path) << "1 2 3 4\n4 3 2\n";
  EXPECT_EQ(
      tests::message_of<input::InputError>([&] { row_file(path, request); }),
      tests::message_of<input::InputError>([&] { read_scan(path, request); }));
}

/// Writes the heights of measured_files.hpp as a list x y z whose positions are
/// rounded.
SurfaceSpec list_of_points(const std::string& name, bool is_descending,
                           bool is_by_column = false) {
  const std::vector<double> heights = heights_of_file();
  std::string text = "x,y,z\n";
  for (std::size_t at = 0; at < heights.size(); ++at) {
    const std::size_t x = is_by_column ? at / rows_of_file : at % columns;
    const std::size_t row = is_by_column ? at % rows_of_file : at / columns;
    const std::size_t y = is_descending ? rows_of_file - 1 - row : row;
    const std::size_t i = y * columns + x;
    const double rounding = 0.002 * std::sin(static_cast<double>(i));
    text += fmt::format("{},{},{}\n", 0.5 * static_cast<double>(x) + rounding,
                        static_cast<double>(y) / 3.0 - rounding,
                        i % 100 == 7 ? "nan" : fmt::to_string(heights[i]));
    if (i % 200 == 0)
      text += "# a comment\n\n";
  }
  SurfaceSpec surface = measured(npy_file(name, heights));
  std::ofstream(surface.file) << text;
  surface.length = std::nullopt;
  surface.length_unit = 1e-6;
  surface.max_missing = 0.05;
  return surface;
}

TEST(MeasuredRows, OfAListHaveTheBitsOfOneProcess) {
  for (const bool is_descending : {false, true}) {
    SurfaceSpec surface = list_of_points("list.txt", is_descending);
    expect_bits_of_one_process(surface);
    EXPECT_EQ(described_map(surface).missing, 9U);
    EXPECT_EQ(described_map(surface).reader, "own reader of lists x y z");
    surface.format = mechanics::MapFormat::xyz;
    surface.edges = mechanics::Edges::mirror;
    expect_bits_of_one_process(surface);
  }
}

TEST(MeasuredRows, OfAListByColumnsHaveTheBitsOfOneProcess) {
  SurfaceSpec surface = list_of_points("by_column.txt", false, true);
  expect_bits_of_one_process(surface);
  EXPECT_EQ(described_map(surface).missing, 9U);
  surface.crop = mechanics::MapWindow{3e-6, 2e-6, 10e-6, 0.0};
  expect_bits_of_one_process(surface);
}

TEST(MeasuredRows, OfAFlatMapAreRefusedAsInOneProcess) {
  const SurfaceSpec flat = measured(
      npy_file("flat.npy", std::vector<double>(columns * rows_of_file, 7.0)));
  const std::string expected =
      tests::message_of<input::InputError>([&] { build_surface(flat, 0); });
  ASSERT_NE(expected.find("the surface is flat"), std::string::npos);

  tests::on_thread_ranks(2, [&](RankGroup& ranks) {
    const SharedRows rows(surface_grid(flat), ranks, {0, 4, 24});
    EXPECT_EQ(tests::message_of<input::InputError>(
                  [&] { build_rows(flat, 0, rows); }),
              expected);
  });
}

TEST(MeasuredRows, OfAnHdf5FileAreThoseOfTheWholeFile) {
  const std::string path =
      (std::filesystem::path(testing::TempDir()) / "measured_rows.h5").string();
  const Grid grid{5, 4, 5e-6, 4e-6};
  HeightMap map{grid, std::vector<double>(grid.size())};
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    map.heights[i] = 1e-9 / static_cast<double>(i + 3);
  write_map(path, map, "a map");
  const HeightMap whole = read_scan(path, {}).map;

  const auto file = row_file(path, {});
  ASSERT_TRUE(file);
  EXPECT_EQ(file->grid, whole.grid);
  const std::vector<double> two = file->rows(1, 2);
  EXPECT_TRUE(std::ranges::equal(two, std::span(whole.heights).subspan(5, 10)));
  EXPECT_ANY_THROW(file->rows(3, 2));
}

} // namespace asperity::surfaces::measured_rows_test
