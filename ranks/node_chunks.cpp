#include "ranks/node_chunks.hpp"

#include <algorithm>
#include <bit>

namespace asperity {
namespace {

bool are_enough_for_a_chunk(std::size_t nodes) {
  return 3 * nodes >= 2 * chunk_nodes;
}

std::size_t rows_in_unit(std::size_t width) {
  std::size_t rows = rows_in_cell;
  while (rows * width % chunk_alignment != 0 ||
         !are_enough_for_a_chunk(rows * width))
    rows *= 2;
  return rows;
}

} // namespace

NodeChunks::NodeChunks(const Grid& grid) {
  const auto width = static_cast<std::size_t>(grid.points_x);
  unit_nodes_ = rows_in_unit(width) * width;
  while (are_enough_for_a_chunk(unit_nodes_ / (2 * in_unit_)))
    in_unit_ *= 2;
}

std::size_t NodeChunks::rows_to_share(const Grid& grid) const {
  return std::max<std::size_t>(1, in_group(grid.size()) / in_unit_) *
         (unit_nodes_ / static_cast<std::size_t>(grid.points_x));
}

std::size_t NodeChunks::count(std::size_t nodes) const {
  std::size_t chunks = nodes / unit_nodes_ * in_unit_;
  while (begin(chunks) < nodes)
    ++chunks;
  return chunks;
}

std::size_t NodeChunks::in_group(std::size_t all_nodes) const {
  return std::bit_ceil((count(all_nodes) + most_groups - 1) / most_groups);
}

} // namespace asperity
