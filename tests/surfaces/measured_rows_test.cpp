// Tests of measured maps and exact shapes whose rows several ranks build: the
// heights have the bits of one process. Tolerance: none.
#include "input/input_error.hpp"
#include "surfaces/formats/map_writer.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/measured_rows.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
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

// A text is described from a copy in memory, and one process builds its map.
TEST(MeasuredRows, OfATextNeedTheWholeMap) {
  const std::vector<double> heights = heights_of_file();
  std::string text = "x,y,z\n";
  for (std::size_t i = 0; i < heights.size(); ++i)
    text += fmt::format("{},{},{}\n", i % columns, i / columns,
                        i % 100 == 7 ? "nan" : fmt::to_string(heights[i]));
  SurfaceSpec surface = measured(npy_file("list.txt", heights));
  std::ofstream(surface.file) << text;
  surface.length = std::nullopt;
  surface.length_unit = 1e-6;
  surface.max_missing = 0.05;
  surface.crop = mechanics::MapWindow{3e-6, 2e-6, 20e-6, 0.0};
  surface.edges = mechanics::Edges::mirror;

  EXPECT_EQ(reason_for_whole_map(surface),
            "the format of the map cannot be read by rows");
  EXPECT_EQ(surface_grid(surface), build_surface(surface, 0).grid);
  const MeasuredMap described = described_map(surface);
  EXPECT_EQ(described.missing, measured_map(surface).missing);
  EXPECT_EQ(described.reader, "own reader of lists x y z");
  const SharedRows rows(surface_grid(surface));
  EXPECT_THROW(measured_rows(surface, rows), std::domain_error);
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

  const OpenMap file = open_map(path, {});
  EXPECT_TRUE(file.reads_rows);
  EXPECT_EQ(file.grid, whole.grid);
  const std::vector<double> two = file.rows(1, 2);
  EXPECT_TRUE(std::ranges::equal(two, std::span(whole.heights).subspan(5, 10)));
  EXPECT_ANY_THROW(file.rows(3, 2));
}

} // namespace asperity::surfaces::measured_rows_test
