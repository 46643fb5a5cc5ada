#include "surfaces/formats/known_file.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/x3p_points.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::surfaces {
namespace {

constexpr const char* x3p_reader = "own reader of X3P";

/// What is known of a file that has been read once.
struct KnownX3p {
  bool are_points_listed = false; ///< nothing else is known then
  Grid grid;
  std::size_t missing = 0; ///< points without a height
};

KnownX3p known_x3p(const std::string& path) {
  const X3pFile file(std::make_unique<ZipArchive>(path), path);
  KnownX3p known;
  known.are_points_listed = file.are_points_listed();
  if (known.are_points_listed)
    return known;
  file.check_sum_of_document();
  known.grid = X3pPoints(file).read_all([&](std::span<const double> heights) {
    known.missing += static_cast<std::size_t>(std::ranges::count_if(
        heights, [](double height) { return !std::isfinite(height); }));
  });
  return known;
}

/// A file whose rows are read.
struct OpenX3p {
  explicit OpenX3p(const std::string& path)
      : stamp(path),
        file(std::make_unique<ZipArchive>(path), path),
        points(file) {}

  FileStamp stamp;
  X3pFile file;
  X3pPoints points;
};

} // namespace

Scan read_x3p_scan(std::string_view bytes, const std::string& name) {
  const X3pFile file(std::make_unique<ZipArchive>(bytes, name), name);
  file.check_sum_of_document();
  Scan scan;
  scan.map.grid =
      X3pPoints(file).read_all([&](std::span<const double> heights) {
        scan.map.heights.reserve(file.count());
        scan.map.heights.insert(scan.map.heights.end(), heights.begin(),
                                heights.end());
      });
  mark_missing(scan, name);
  scan.numbers.has_own_marks = true;
  scan.reader = x3p_reader;
  return scan;
}

std::optional<RowFile> x3p_row_file(const std::string& path,
                                    const ScanRequest& request) {
  if (names_another(request.channel, ""))
    return std::nullopt;
  refuse_scale(request.scale, path);
  const auto open = std::make_shared<OpenX3p>(path);
  const auto known =
      known_of_file<KnownX3p>(path, 0, [&] { return known_x3p(path); });
  if (known->are_points_listed)
    return std::nullopt;
  RowFile file{known->grid, "", x3p_reader, {}};
  file.rows = [path, open](int first, int count) {
    open->stamp.require_unchanged(path);
    std::vector<double> rows = open->points.rows(first, count);
    open->stamp.require_unchanged(path);
    return rows;
  };
  file.missing = known->missing;
  file.numbers.has_own_marks = true;
  return file;
}

} // namespace asperity::surfaces
