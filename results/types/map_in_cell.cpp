#include "results/types/map_in_cell.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::results {
namespace {

int points_on(int points, int all, int other) {
  const auto product = static_cast<std::int64_t>(points) * other;
  return static_cast<int>((product + all - 1) / all); // rounded up
}

} // namespace

MapInCell MapInCell::on(const Grid& cell, const Grid& other) const {
  if (is_whole(cell))
    return {};
  return {points_on(columns, cell.points_x, other.points_x),
          points_on(rows, cell.points_y, other.points_y)};
}

std::size_t MapInCell::node_on_map(std::size_t node, const Grid& cell) const {
  if (is_whole(cell))
    return node;
  const auto width = static_cast<std::size_t>(cell.points_x);
  const auto ix = static_cast<int>(node % width);
  const auto iy = static_cast<int>(node / width);
  return cell.index(std::min(ix, cell.points_x - 1 - ix),
                    std::min(iy, cell.points_y - 1 - iy));
}

StoredMap MapInCell::of(const MapView& values, const Grid& cell) const {
  if (values.size() != cell.size() || values.empty())
    return {};
  const Grid map = grid(cell);
  const auto width = static_cast<std::size_t>(cell.points_x);
  const auto own = static_cast<std::size_t>(map.points_x);
  return {static_cast<std::size_t>(map.points_y), own,
          [=](std::size_t first, std::size_t count) {
            std::vector<double> read, cut;
            const std::span<const double> all =
                values.values(first * width, count * width, read);
            cut.reserve(count * own);
            for (std::size_t row = 0; row < count; ++row) {
              const auto from = all.subspan(row * width, own);
              cut.insert(cut.end(), from.begin(), from.end());
            }
            return cut;
          }};
}

} // namespace asperity::results
