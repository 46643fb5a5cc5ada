// Tests of measured maps whose rows several ranks correct: lines are aligned,
// spikes removed, spheres and cylinders fitted and edges windowed with the bits
// of one process. Tolerance: none.
#include "input/input_error.hpp"
#include "surfaces/measured_rows.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/message_of.hpp"
#include "tests/surfaces/measured_files.hpp"

namespace asperity::surfaces::corrected_rows_test {

using namespace tests_of_rows;
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

} // namespace asperity::surfaces::corrected_rows_test
