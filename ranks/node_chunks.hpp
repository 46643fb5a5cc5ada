#pragma once

// Divides the nodes of a grid into chunks, whose sums are added in their order,
// so that sums have the same bits on any number of threads and ranks.

#include "base/grid.hpp"

#include <cstddef>

namespace asperity {

/// Wanted number of nodes in one chunk, which one thread sums.
inline constexpr std::size_t chunk_nodes = std::size_t{1} << 13;

/// Chunks begin at multiples of so many nodes of the grid.
inline constexpr std::size_t chunk_alignment = 64;

/// Largest number of groups of chunks. Each rank holds whole groups; their sums
/// are gathered and added in order.
inline constexpr std::size_t most_groups = 1024;

/// The least number of rows that ranks hold together: the side of the largest
/// cells of BoundaryExtension whose rows are shared on any grid.
inline constexpr std::size_t rows_in_cell = 8;

/// Units of whole rows, each of which is divided into chunks of nearly equal
/// size. All numbers are powers of two: those of the rows in a unit, at least
/// rows_in_cell; of the chunks in a unit, which have 2/3 to 4/3 chunk_nodes on
/// the average, or more if a unit cannot be smaller; and of the chunks in a
/// group. If points_x is a power of two, a chunk has chunk_nodes nodes. The
/// last unit of a grid may have fewer rows.
///
/// Nodes are counted from the first of a unit, and ranks hold whole units, so
/// that the chunks of all ranks are those of one process.
class NodeChunks {
public:
  /// Chunks of chunk_nodes nodes, for nodes that belong to no grid.
  NodeChunks() = default;

  /// @param grid  of the nodes of all ranks together
  explicit NodeChunks(const Grid& grid);

  /// Rows after which a rank may end: whole units and whole groups. Not for
  /// nodes that belong to no grid.
  std::size_t rows_to_share(const Grid& grid) const;

  std::size_t unit_nodes() const { return unit_nodes_; }

  std::size_t in_unit() const { return in_unit_; }

  /// Number of chunks of so many nodes.
  std::size_t count(std::size_t nodes) const;

  /// First node of a chunk.
  std::size_t begin(std::size_t chunk) const {
    const std::size_t blocks = unit_nodes_ / chunk_alignment;
    return chunk / in_unit_ * unit_nodes_ +
           chunk % in_unit_ * blocks / in_unit_ * chunk_alignment;
  }

  /// Number of chunks in a group.
  /// @param all_nodes  of all ranks together
  std::size_t in_group(std::size_t all_nodes) const;

  /// Number of groups of the nodes of one rank.
  std::size_t groups(std::size_t nodes, std::size_t all_nodes) const {
    const std::size_t length = in_group(all_nodes);
    return (count(nodes) + length - 1) / length;
  }

private:
  std::size_t unit_nodes_ = chunk_nodes;
  std::size_t in_unit_ = 1;
};

} // namespace asperity
