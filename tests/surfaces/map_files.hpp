#pragma once

// Map files of tests, how they are refused, and which of their points have no
// height.

#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace asperity::surfaces::tests_of_formats {

/// Writes a file of this test program, each call another one.
inline std::string written(const std::string& name, const std::string& bytes) {
  static int n_files = 0;
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) /
      ("map_" + std::to_string(++n_files) + "_" + name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

/// The message by which a file is refused.
inline std::string refusal_of(const std::string& path,
                              const ScanRequest& request) {
  return tests::message_of<input::InputError>(
      [&] { read_scan(path, request); });
}

/// 1 for each missing point, else 0.
inline std::vector<char> missing_of(const Scan& scan) {
  std::vector<char> missing;
  for (const double height : scan.map.heights)
    missing.push_back(std::isnan(height) ? 1 : 0);
  return missing;
}

/// The heights, 0 at missing points.
inline std::vector<double> or_zero(const Scan& scan) {
  std::vector<double> heights = scan.map.heights;
  std::ranges::replace_if(
      heights, [](double height) { return std::isnan(height); }, 0.0);
  return heights;
}

} // namespace asperity::surfaces::tests_of_formats
