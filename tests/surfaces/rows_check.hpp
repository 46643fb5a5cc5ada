#pragma once

// Map files, their refusals, and the comparison of some rows of a file with the
// file as a whole.

#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace asperity::surfaces::tests_of_rows {

/// Writes a file of this test program, each call another one.
inline std::string written(const std::string& name, const std::string& bytes) {
  static int n_files = 0;
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) /
      ("rows_" + std::to_string(++n_files) + "_" + name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

/// Compares some rows, missing points included.
inline void expect_rows(const OpenMap& file, const Scan& whole, int first,
                        int count) {
  const std::vector<double> rows = file.rows(first, count);
  const auto width = static_cast<std::size_t>(whole.map.grid.points_x);
  ASSERT_EQ(rows.size(), width * static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t node = static_cast<std::size_t>(first) * width + i;
    const bool is_missing = std::isnan(whole.map.heights[node]);
    ASSERT_EQ(std::isfinite(rows[i]), !is_missing) << node;
    if (!is_missing) {
      ASSERT_EQ(rows[i], whole.map.heights[node]) << node;
    }
  }
}

/// The rows have the bits of the file as a whole, in any order of calls.
inline void expect_rows_of(const std::string& path,
                           const ScanRequest& request) {
  const Scan whole = read_scan(path, request);
  const OpenMap file = open_map(path, request);
  EXPECT_EQ(file.grid, whole.map.grid);
  const int n = file.grid.points_y;
  for (const int first : {0, n / 2, n / 3, n - 1, 0})
    for (const int count : {1, n / 2, n})
      expect_rows(file, whole, first, std::max(1, std::min(count, n - first)));
}

/// The message by which a file is refused.
inline std::string refusal_of(const std::string& path,
                              const ScanRequest& request) {
  return tests::message_of<input::InputError>(
      [&] { read_scan(path, request); });
}

} // namespace asperity::surfaces::tests_of_rows
