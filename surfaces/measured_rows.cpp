#include "surfaces/measured_rows.hpp"

#include "surfaces/formats/scan.hpp"
#include "surfaces/maps/edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace asperity::surfaces {
namespace {

using mechanics::SurfaceSpec;

/// The part of a map that a case uses.
class MapWindow {
public:
  explicit MapWindow(const SurfaceSpec& surface)
      : map_(open_map(surface.file, request_of_map(surface))),
        window_(window_of_map(surface, map_.grid)) {}

  const Grid& grid() const { return window_.grid; }

  const OpenMap& map() const { return map_; }

  /// Heights as in the file [m].
  std::vector<double> rows(int first, int count) const {
    HeightMap read{map_.grid, map_.rows(window_.first_y + first, count)};
    PixelWindow kept{window_.first_x, 0, window_.grid};
    kept.grid.points_y = count;
    if (kept.grid.points_x != map_.grid.points_x)
      crop(read, kept);
    return std::move(read.heights);
  }

  /// Counts the points without a height, by pieces of a few MB.
  std::size_t count_missing() const {
    const int at_a_time = std::max(1, (1 << 19) / map_.grid.points_x);
    std::ptrdiff_t missing = 0;
    for (int row = 0; row < grid().points_y; row += at_a_time)
      missing += std::ranges::count_if(
          rows(row, std::min(at_a_time, grid().points_y - row)),
          [](double height) { return !std::isfinite(height); });
    return static_cast<std::size_t>(missing);
  }

private:
  OpenMap map_;
  PixelWindow window_;
};

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
  if (surface.cut_off)
    return "short wavelengths are removed from it";
  constexpr const char* reason = "the format of the map cannot be read by rows";
  if (!may_read_rows(surface.file, surface.format))
    return reason;
  const MapWindow window(surface);
  if (!window.map().reads_rows)
    return reason;
  const std::size_t missing = window.count_missing();
  if (missing == window.grid().size())
    return "all points are missing";
  require_few_missing(surface, missing, window.grid().size());
  return "";
}

Grid measured_grid(const SurfaceSpec& surface) {
  return grid_with_edges(MapWindow(surface).grid(), continuation_of(surface));
}

MeasuredMap described_map(const SurfaceSpec& surface) {
  if (surface.spikes || surface.cut_off == 0.0)
    return measured_map(surface);
  const MapWindow window(surface);
  const std::size_t missing = window.count_missing();
  require_few_missing(surface, missing, window.grid().size());
  return {
      {window.grid(), {}}, window.map().channel, window.map().reader, missing};
}

std::vector<double> measured_rows(const SurfaceSpec& surface,
                                  const SharedRows& rows, MapFacts* facts) {
  const MapWindow window(surface);
  if (!window.map().reads_rows)
    throw std::domain_error("the map cannot be read by rows");
  const SharedRows map_rows = rows_of_map(window.grid(), rows);
  std::vector<double> heights = window.rows(map_rows.first(), map_rows.count());
  MapFacts found =
      prepare_rows(surface, map_rows, heights, window.map().numbers);
  const bool has_effect =
      facts != nullptr && surface.edges == mechanics::Edges::window;
  if (has_effect)
    found.effect = {roughness_of(map_rows, heights), {}};
  heights =
      with_edges(map_rows, std::move(heights), continuation_of(surface), rows);
  if (has_effect)
    found.effect->pressed = roughness_of(rows, heights);
  if (facts != nullptr)
    *facts = found;
  return heights;
}

} // namespace asperity::surfaces
