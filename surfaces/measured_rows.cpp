#include "surfaces/measured_rows.hpp"

#include "surfaces/formats/row_file.hpp"
#include "surfaces/maps/edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

namespace asperity::surfaces {
namespace {

using mechanics::SurfaceSpec;

/// Heights in memory while the missing points are found.
constexpr std::size_t counted_at_a_time = std::size_t{1} << 19;

/// Reads rows of the part of a map that a case uses.
class WindowReader {
public:
  WindowReader(RowFile file, const SurfaceSpec& surface)
      : file_(std::move(file)), window_(window_of_map(surface, file_.grid)) {}

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

  std::size_t count_missing() const {
    if (file_.missing && grid() == file_.grid)
      return *file_.missing;
    if (file_.missing_in)
      return file_.missing_in(window_);
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
  PixelWindow window_;
};

std::optional<WindowReader> reader_of(const SurfaceSpec& surface) {
  std::optional<RowFile> file = row_file(surface.file, request_of_map(surface));
  if (!file)
    return std::nullopt;
  return WindowReader(std::move(*file), surface);
}

std::string reason_of(const SurfaceSpec& surface,
                      const std::optional<WindowReader>& reader) {
  if (!reader)
    return "the format of the map cannot be read by rows";
  const std::size_t missing = reader->count_missing();
  if (missing == reader->grid().size())
    return "all points are missing";
  require_few_missing(surface, missing, reader->grid().size());
  return "";
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
  if (!reason_of(surface, reader).empty() || surface.spikes)
    return measured_map(surface);
  return {{reader->grid(), {}},
          reader->file().channel,
          reader->file().reader,
          reader->count_missing()};
}

std::vector<double> measured_rows(const SurfaceSpec& surface,
                                  const SharedRows& rows, MapFacts* facts) {
  const std::optional<WindowReader> reader = reader_of(surface);
  if (!reader)
    throw std::domain_error("the map cannot be read by rows");
  const SharedRows map_rows = rows_of_map(reader->grid(), rows);
  std::vector<double> heights =
      reader->measured(map_rows.first(), map_rows.count());
  MapFacts found =
      prepare_rows(surface, map_rows, heights, reader->file().numbers);
  const bool has_effect =
      facts != nullptr && surface.edges == mechanics::Edges::window;
  if (has_effect)
    found.effect = {roughness_of(map_rows, heights), {}};
  heights = with_edges(map_rows, std::move(heights), surface.edges, rows);
  if (has_effect)
    found.effect->pressed = roughness_of(rows, heights);
  if (facts != nullptr)
    *facts = found;
  return heights;
}

} // namespace asperity::surfaces
