// Tests of measured maps and exact shapes whose rows several ranks build: the
// heights have the bits of one process, also with missing points, lines that
// are aligned, spikes that are removed, and spheres and cylinders that are
// fitted. Tolerance: none.
#include "input/input_error.hpp"
#include "surfaces/formats/map_writer.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/measured_rows.hpp"
#include "tests/message_of.hpp"
#include "tests/surfaces/measured_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
                                 SurfaceKind::cone, SurfaceKind::rounded_punch,
                                 SurfaceKind::wave_1d, SurfaceKind::wave_2d}) {
    SurfaceSpec surface;
    surface.kind = kind;
    surface.length = 4.0;
    surface.points = 36;
    surface.radius = 1.0;
    surface.recess = 0.5;
    surface.tilt = surface.slope = 0.1;
    surface.edge_radius = 3.0;
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
  const SurfaceSpec all = with_holes(
      npy_file("all.npy",
               std::vector<double>(columns * rows_of_file,
                                   std::numeric_limits<double>::quiet_NaN())));
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

using mechanics::Edges;
using mechanics::Levelling;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Lines with offsets, spikes at the bounds of ranks, missing points, and a
/// line without any height.
std::vector<double> faulty_heights() {
  std::vector<double> heights = heights_of_file();
  for (std::size_t y = 0; y < rows_of_file; ++y)
    for (std::size_t x = 0; x < columns; ++x) {
      double& height = heights[y * columns + x];
      height += 40.0 * static_cast<double>(y * 5 % 7);
      if (y == 13 || (x + 3 * y) % 29 == 0)
        height = missing;
      else if ((x * x + y) % 83 == 5)
        height += 900.0;
    }
  return heights;
}

SurfaceSpec faulty(const std::string& name) {
  SurfaceSpec surface = measured(npy_file(name, faulty_heights()));
  surface.length_y = 20e-6;
  surface.max_missing = 0.2;
  return surface;
}

TEST(CorrectedRows, OnASphereOrCylinderHaveTheBitsOfOneProcess) {
  SurfaceSpec surface = measured(npy_file("round.npy", heights_of_file()));
  for (const Levelling level : {Levelling::sphere, Levelling::cylinder})
    for (const Edges edges : {Edges::periodic, Edges::mirror}) {
      surface.level = level;
      surface.edges = edges;
      expect_bits_of_one_process(surface);
    }
}

TEST(CorrectedRows, OfAlignedLinesHaveTheBitsOfOneProcess) {
  SurfaceSpec surface = faulty("lines.npy");
  surface.align_lines = mechanics::LineAlignment::median;
  expect_bits_of_one_process(surface);
  surface.edges = Edges::mirror;
  expect_bits_of_one_process(surface);
}

TEST(CorrectedRows, WithoutSpikesHaveTheBitsOfOneProcess) {
  SurfaceSpec surface = faulty("spikes.npy");
  for (const double threshold : {3.0, 8.0}) {
    surface.spikes = threshold;
    EXPECT_GT(described_map(surface).spikes, 0U);
    expect_bits_of_one_process(surface);
  }
  surface.align_lines = mechanics::LineAlignment::median;
  surface.level = Levelling::sphere;
  surface.crop = mechanics::MapWindow{3e-6, 2e-6, 20e-6, 10e-6};
  surface.edges = Edges::free;
  expect_bits_of_one_process(surface);
}

// The median of the deviations is 0, so that their mean is the scale.
TEST(CorrectedRows, OfTerracesHaveTheBitsOfOneProcess) {
  std::vector<double> heights(rows_of_file * columns, 1.0);
  for (std::size_t i = 0; i < heights.size(); i += 71)
    heights[i] = 2.0 + static_cast<double>(i % 3);
  SurfaceSpec surface = measured(npy_file("terraces.npy", heights));
  surface.spikes = 30.0;
  EXPECT_GT(described_map(surface).spikes, 0U);
  expect_bits_of_one_process(surface);
}

TEST(CorrectedRows, InAWindowHaveTheBitsOfOneProcess) {
  SurfaceSpec surface = faulty("window_of_edges.npy");
  surface.edges = Edges::window;
  expect_bits_of_one_process(surface);
  surface.spikes = 6.0;
  surface.level = Levelling::cylinder;
  expect_bits_of_one_process(surface);
}

// The numbers of missing points and spikes and the effect of the window are
// those that one process reports.
TEST(CorrectedRows, ReportWhatOneProcessReports) {
  SurfaceSpec surface = faulty("facts.npy");
  surface.spikes = 6.0;
  surface.edges = Edges::window;
  const MeasuredMap whole = measured_map(surface);
  const EdgeEffect effect = edge_effect(surface);
  ASSERT_GT(whole.missing, 0U);
  ASSERT_GT(whole.spikes, 0U);
  for (int n = 1; n <= 4; ++n)
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      const SharedRows rows(whole.map.grid, ranks,
                            bounds_of(whole.map.grid.points_y, n));
      MapFacts facts;
      static_cast<void>(measured_rows(surface, rows, &facts));
      EXPECT_EQ(facts.missing, whole.missing);
      EXPECT_EQ(facts.spikes, whole.spikes);
      ASSERT_TRUE(facts.effect);
      EXPECT_EQ(facts.effect->measured.rms_height, effect.measured.rms_height);
      EXPECT_EQ(facts.effect->measured.rms_slope, effect.measured.rms_slope);
      EXPECT_EQ(facts.effect->pressed.rms_height, effect.pressed.rms_height);
      EXPECT_EQ(facts.effect->pressed.rms_slope, effect.pressed.rms_slope);
    });
}

/// Builds rows on ranks of one row each, where possible.
std::string message_on_ranks(const SurfaceSpec& surface, int n) {
  std::string message;
  tests::on_thread_ranks(n, [&](RankGroup& ranks) {
    std::vector<int> bounds;
    for (int r = 0; r < n; ++r)
      bounds.push_back(r);
    const Grid grid = surface_grid(surface);
    bounds.push_back(grid.points_y);
    const SharedRows rows(grid, ranks, bounds);
    const std::string own = tests::message_of<input::InputError>(
        [&] { measured_rows(surface, rows); });
    if (ranks.rank() == n - 1)
      message = own;
    else
      EXPECT_NE(own, "");
  });
  return message;
}

// All ranks refuse what one process refuses, with its message: flat maps, too
// many spikes, and forms that do not reach over the map.
TEST(CorrectedRows, AreRefusedAsInOneProcess) {
  SurfaceSpec flat = measured(
      npy_file("flat_rows.npy", std::vector(rows_of_file * columns, 7.0)));
  flat.align_lines = mechanics::LineAlignment::median;
  flat.spikes = 6.0;
  flat.edges = Edges::window;
  SurfaceSpec flat_sphere = flat;
  flat_sphere.level = Levelling::sphere;
  SurfaceSpec spikes = measured(npy_file("many.npy", faulty_heights()));
  spikes.spikes = 3.0;
  spikes.max_missing = 0.085;
  for (const auto& refused : {std::pair(flat, "the surface is flat"),
                              std::pair(flat_sphere, "the surface is flat"),
                              std::pair(spikes, "points are missing")}) {
    const auto& surface = refused.first;
    const std::string expected =
        tests::message_of<input::InputError>([&] { measured_map(surface); });
    ASSERT_NE(expected.find(refused.second), std::string::npos) << expected;
    EXPECT_EQ(reason_for_whole_map(surface), "");
    EXPECT_EQ(message_on_ranks(surface, 4), expected);
  }
}

// Ranks of one row each.
TEST(CorrectedRows, OfSingleRowsHaveTheBitsOfOneProcess) {
  SurfaceSpec surface = faulty("single.npy");
  surface.spikes = 6.0;
  surface.align_lines = mechanics::LineAlignment::median;
  surface.level = Levelling::sphere;
  surface.edges = Edges::window;
  const HeightMap whole = build_surface(surface, 0);
  constexpr int n = rows_of_file;
  tests::on_thread_ranks(n, [&](RankGroup& ranks) {
    std::vector<int> bounds;
    for (int r = 0; r <= n; ++r)
      bounds.push_back(r);
    const SharedRows rows(whole.grid, ranks, bounds);
    EXPECT_TRUE(std::ranges::equal(
        measured_rows(surface, rows),
        std::span(whole.heights)
            .subspan(whole.grid.index(0, rows.first()), rows.size())));
  });
}

} // namespace asperity::surfaces::measured_rows_test
