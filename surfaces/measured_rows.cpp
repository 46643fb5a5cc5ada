#include "surfaces/measured_rows.hpp"

#include "base/field_sums.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/row_file.hpp"
#include "surfaces/maps/corrections.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/levelling.hpp"
#include "surfaces/maps/missing_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "ranks/rank_sums.hpp"

namespace asperity::surfaces {
namespace {

using mechanics::SurfaceSpec;

/// Heights in memory while the missing points are found.
constexpr std::size_t counted_at_a_time = std::size_t{1} << 19;

/// Reads rows of the part of a map that a case uses.
class WindowReader {
public:
  WindowReader(RowFile file, const SurfaceSpec& surface)
      : file_(std::move(file)),
        name_(surface.file),
        window_(window_of_map(surface, file_.grid)) {}

  const Grid& grid() const { return window_.grid; }

  const RowFile& file() const { return file_; }

  /// Heights as in the file [m].
  std::vector<double> measured(int first, int count) const {
    std::vector<double> heights = file_.rows(window_.first_y + first, count);
    const auto width = static_cast<std::size_t>(file_.grid.points_x);
    const auto kept = static_cast<std::size_t>(window_.grid.points_x);
    if (kept == width)
      return heights;
    for (std::size_t row = 0; row < static_cast<std::size_t>(count); ++row)
      std::copy_n(
          heights.begin() +
              static_cast<std::ptrdiff_t>(
                  row * width + static_cast<std::size_t>(window_.first_x)),
          kept, heights.begin() + static_cast<std::ptrdiff_t>(row * kept));
    heights.resize(static_cast<std::size_t>(count) * kept);
    return heights;
  }

  /// Finds the heights of missing points, from the whole map, which is read by
  /// pieces.
  void fill(const SurfaceSpec& surface) {
    MissingPoints points(grid());
    const auto width = static_cast<std::size_t>(grid().points_x);
    each_piece([&](std::span<const double> heights) {
      for (std::size_t at = 0; at < heights.size(); at += width) {
        const std::span<const double> row = heights.subspan(at, width);
        points.take_row(row,
                        [&](std::size_t x) { return !std::isfinite(row[x]); });
      }
    });
    require_few_missing(surface, points.count(), grid().size());
    filled_ = points.filled();
  }

  /// Heights of the map, with those of missing points if they were found.
  std::vector<double> complete(int first, int count) const {
    std::vector<double> heights = measured(first, count);
    const std::size_t begin = grid().index(0, first);
    for (auto point =
             std::ranges::lower_bound(filled_, begin, {}, &FilledPoint::index);
         point != filled_.end() && point->index < begin + heights.size();
         ++point)
      heights[point->index - begin] = point->height;
    return heights;
  }

  /// The same, without missing points.
  std::vector<double> all_known(int first, int count) const {
    std::vector<double> heights = complete(first, count);
    if (!all_finite(heights))
      throw input::InputError(name_ + ": points are missing that were there "
                                      "when the run began");
    return heights;
  }

  std::size_t count_missing() const {
    if (file_.missing && grid() == file_.grid)
      return *file_.missing;
    std::size_t missing = 0;
    each_piece([&](std::span<const double> heights) {
      missing += static_cast<std::size_t>(std::ranges::count_if(
          heights, [](double height) { return !std::isfinite(height); }));
    });
    return missing;
  }

private:
  /// Calls take(heights) for some rows after the other.
  template <class Take>
  void each_piece(const Take& take) const {
    const int at_a_time = static_cast<int>(std::max<std::size_t>(
        1, counted_at_a_time / static_cast<std::size_t>(file_.grid.points_x)));
    for (int row = 0; row < grid().points_y; row += at_a_time)
      take(measured(row, std::min(at_a_time, grid().points_y - row)));
  }

  RowFile file_;
  std::string name_;
  PixelWindow window_;
  std::vector<FilledPoint> filled_; ///< by their indices
};

std::optional<WindowReader> reader_of(const SurfaceSpec& surface) {
  std::optional<RowFile> file = row_file(surface.file, request_of_map(surface));
  if (!file)
    return std::nullopt;
  return WindowReader(std::move(*file), surface);
}

/// The correction that needs the whole map, in the words of the case.
std::string correction_of_whole_map(const SurfaceSpec& surface) {
  if (surface.align_lines != mechanics::LineAlignment::none)
    return "surface.align_lines compares all lines";
  if (surface.spikes)
    return "surface.remove_spikes compares all points";
  if (surface.level == mechanics::Levelling::sphere ||
      surface.level == mechanics::Levelling::cylinder)
    return "surface.level fits a sphere or a cylinder";
  if (surface.edges == mechanics::Edges::window)
    return "the effect of surface.edges = \"window\" is recorded";
  return "";
}

std::string reason_of(const SurfaceSpec& surface,
                      const std::optional<WindowReader>& reader) {
  std::string correction = correction_of_whole_map(surface);
  if (!correction.empty())
    return correction;
  if (!reader)
    return "the format of the map cannot be read by rows";
  const std::size_t missing = reader->count_missing();
  if (missing == reader->grid().size())
    return "all points are missing";
  require_few_missing(surface, missing, reader->grid().size());
  return "";
}

double largest_of(const SharedRows& rows, std::span<const double> heights) {
  double largest = 0.0;
  for (const double height : heights)
    largest = std::max(largest, std::abs(height));
  return rank_max(rows.ranks(), largest);
}

/// The rows of the map itself, divided among the same ranks.
SharedRows rows_of_map(const Grid& grid, const SharedRows& rows) {
  if (grid == rows.grid() || rows.ranks() == nullptr)
    return grid == rows.grid() ? rows : SharedRows(grid);
  const int n_ranks = rows.ranks()->size();
  std::vector<int> bounds;
  for (int r = 0; r <= n_ranks; ++r)
    bounds.push_back(
        static_cast<int>(std::int64_t{grid.points_y} * r / n_ranks));
  return {grid, *rows.ranks(), std::move(bounds)};
}

/// The rows of this process of the mirrored map (with_edges()).
std::vector<double> mirrored_rows(const WindowReader& reader,
                                  std::span<const TrendTerm> trend,
                                  const SharedRows& rows) {
  const int n = reader.grid().points_y;
  const int begin = rows.first();
  const int end = begin + rows.count();
  const auto image = [n](int row) { return std::min(row, 2 * n - 1 - row); };
  const int first = std::min(image(begin), image(end - 1));
  const int last =
      begin < n && end > n ? n - 1 : std::max(image(begin), image(end - 1));
  std::vector<double> own = reader.all_known(first, last - first + 1);
  subtract_trend(reader.grid(), trend, first, own);
  const auto width = static_cast<std::size_t>(reader.grid().points_x);
  std::vector<double> heights(rows.size());
  for (int row = begin; row < end; ++row) {
    const std::span<const double> from = std::span(own).subspan(
        static_cast<std::size_t>(image(row) - first) * width, width);
    const auto to = heights.begin() +
                    static_cast<std::ptrdiff_t>(
                        static_cast<std::size_t>(row - begin) * 2 * width);
    std::ranges::copy(from, to);
    std::ranges::reverse_copy(from, to + static_cast<std::ptrdiff_t>(width));
  }
  return heights;
}

} // namespace

std::string reason_for_whole_map(const SurfaceSpec& surface) {
  return reason_of(surface, reader_of(surface));
}

Grid measured_grid(const SurfaceSpec& surface) {
  const std::optional<WindowReader> reader = reader_of(surface);
  return grid_with_edges(reader ? reader->grid() : levelled_map(surface).grid,
                         surface.edges);
}

MeasuredMap described_map(const SurfaceSpec& surface) {
  const std::optional<WindowReader> reader = reader_of(surface);
  if (!reason_of(surface, reader).empty())
    return measured_map(surface);
  return {{reader->grid(), {}},
          reader->file().channel,
          reader->file().reader,
          reader->count_missing()};
}

std::vector<double> measured_rows(const SurfaceSpec& surface,
                                  const SharedRows& rows) {
  std::optional<WindowReader> reader = reader_of(surface);
  if (!reader)
    throw std::domain_error("the map cannot be read by rows");
  const SharedRows map_rows = rows_of_map(reader->grid(), rows);
  std::vector<double> heights =
      reader->complete(map_rows.first(), map_rows.count());
  if (rank_max(rows.ranks(), all_finite(heights) ? 0.0 : 1.0) > 0.0) {
    heights = {};
    reader->fill(surface);
    heights = reader->all_known(map_rows.first(), map_rows.count());
  }
  const double before = largest_of(map_rows, heights);
  const std::vector<TrendTerm> trend =
      remove_trend(map_rows, heights, surface.level);
  require_relief(surface, before, largest_of(map_rows, heights));
  if (rows.grid() != reader->grid()) {
    heights = {};
    heights = mirrored_rows(*reader, trend, rows);
  }
  remove_mean(rows, heights);
  return heights;
}

} // namespace asperity::surfaces
