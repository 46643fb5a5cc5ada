#pragma once

// Map files and the comparison of the rows that several ranks build from them
// with the heights of one process.

#include "surfaces/build.hpp"
#include "surfaces/formats/npy.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace asperity::surfaces::tests_of_rows {

using mechanics::SurfaceKind;
using mechanics::SurfaceSpec;

inline constexpr std::size_t columns = 37;
inline constexpr std::size_t rows_of_file = 24;

/// Tilted and bent, with irregular heights.
inline std::vector<double> heights_of_file() {
  std::vector<double> heights;
  for (std::size_t y = 0; y < rows_of_file; ++y)
    for (std::size_t x = 0; x < columns; ++x) {
      const auto i = static_cast<double>(x), j = static_cast<double>(y);
      heights.push_back(5.0 + 0.3 * i - 0.2 * j + 0.01 * i * i - 0.02 * i * j +
                        std::sin(7.0 * i + 3.0 * j * j));
    }
  return heights;
}

/// Writes an .npy file to a folder of its own.
inline std::string npy_file(const std::string& name,
                            const std::vector<double>& heights) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("measured_rows_" + name);
  std::ofstream(path, std::ios::binary)
      << npy_bytes(heights, rows_of_file, columns);
  return path.string();
}

inline SurfaceSpec measured(const std::string& file) {
  SurfaceSpec surface;
  surface.kind = SurfaceKind::measured;
  surface.file = file;
  surface.length = 37e-6;
  surface.height_unit = 1e-9;
  return surface;
}

/// Unequal shares with even bounds.
inline std::vector<int> bounds_of(int points, int n) {
  std::vector<int> bounds{0};
  for (int r = 1; r < n; ++r)
    bounds.push_back(r * (r + 1));
  bounds.push_back(points);
  return bounds;
}

/// Compares the rows of 1 to 4 ranks with the surface of one process.
inline void expect_bits_of_one_process(const SurfaceSpec& surface) {
  const HeightMap whole = build_surface(surface, 0);
  EXPECT_EQ(reason_for_whole(surface), "");
  EXPECT_EQ(surface_grid(surface), whole.grid);
  for (int n = 1; n <= 4; ++n)
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      const SharedRows rows(whole.grid, ranks,
                            bounds_of(whole.grid.points_y, n));
      const std::vector<double> own = build_rows(surface, 0, rows);
      EXPECT_TRUE(std::ranges::equal(
          own, std::span(whole.heights)
                   .subspan(whole.grid.index(0, rows.first()), rows.size())));
    });
}

} // namespace asperity::surfaces::tests_of_rows
