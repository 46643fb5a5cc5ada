#pragma once

// Comparison of the rows of a map file with the file as a whole.

#include "input/input_error.hpp"
#include "surfaces/formats/row_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "tests/message_of.hpp"

namespace asperity::surfaces::tests_of_rows {

/// Writes a file of this test program. Each call writes another file, because
/// what is known of a file is found again only if its size or time changes.
inline std::string written(const std::string& name, const std::string& bytes) {
  static int n_files = 0;
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) /
      ("rows_" + std::to_string(++n_files) + "_" + name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

/// Compares some rows, missing points included.
inline void expect_rows(const RowFile& file, const Scan& whole, int first,
                        int count) {
  const std::vector<double> rows = file.rows(first, count);
  const auto width = static_cast<std::size_t>(whole.map.grid.points_x);
  ASSERT_EQ(rows.size(), width * static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t node = static_cast<std::size_t>(first) * width + i;
    const bool is_missing =
        !whole.is_missing.empty() && whole.is_missing[node] != 0;
    ASSERT_EQ(std::isfinite(rows[i]), !is_missing) << node;
    if (!is_missing) {
      ASSERT_EQ(rows[i], whole.map.heights[node]) << node;
    }
  }
}

/// Points without a height in a window.
inline std::size_t missing_of(const Scan& whole, const PixelWindow& window) {
  std::size_t missing = 0;
  for (int y = 0; y < window.grid.points_y; ++y)
    for (int x = 0; x < window.grid.points_x; ++x)
      if (!whole.is_missing.empty() &&
          whole.is_missing[whole.map.grid.index(window.first_x + x,
                                                window.first_y + y)] != 0)
        ++missing;
  return missing;
}

/// The rows have the bits of the file as a whole, in any order of calls.
inline void expect_rows_of(const std::string& path,
                           const ScanRequest& request) {
  const Scan whole = read_scan(path, request);
  const auto file = row_file(path, request);
  ASSERT_TRUE(file);
  const Grid& grid = whole.map.grid;
  EXPECT_EQ(file->grid, grid);
  EXPECT_EQ(file->reader, whole.reader);
  EXPECT_EQ(file->channel, whole.channel);
  EXPECT_EQ(file->missing.value_or(count_missing(whole)), count_missing(whole));
  const int n = grid.points_y;
  for (const int first : {0, n / 2, n / 3, n - 1, 0})
    for (const int count : {1, n / 2, n})
      expect_rows(*file, whole, first, std::max(1, std::min(count, n - first)));
  if (file->missing_in) {
    const PixelWindow all{0, 0, grid};
    EXPECT_EQ(file->missing_in(all), count_missing(whole));
    PixelWindow part{grid.points_x / 2, n / 3, grid};
    part.grid.points_x -= part.first_x;
    part.grid.points_y -= part.first_y;
    EXPECT_EQ(file->missing_in(part), missing_of(whole, part));
  }
}

/// Both readers refuse the file, with the same message, which is returned.
inline std::string refusal_of(const std::string& path,
                              const ScanRequest& request) {
  const std::string expected =
      tests::message_of<input::InputError>([&] { read_scan(path, request); });
  EXPECT_NE(expected, "");
  EXPECT_EQ(
      tests::message_of<input::InputError>([&] { row_file(path, request); }),
      expected);
  return expected;
}

} // namespace asperity::surfaces::tests_of_rows
