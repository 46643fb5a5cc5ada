#pragma once

// Loops over the blocks of nodes in which something happens, so that the nodes
// far from the contact cost nothing. Their sums are bitwise the same on any
// number of threads and ranks.

#include "base/ranks/chunked_sum.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::contact {

/// Number of consecutive nodes in one block. Chunks consist of whole blocks.
inline constexpr std::size_t block_nodes = 64;
static_assert(chunk_nodes % block_nodes == 0);

/// One flag per block, 0 or 1.
using BlockFlags = std::vector<std::uint8_t>;

inline std::size_t blocks_of(std::size_t nodes) {
  return (nodes + block_nodes - 1) / block_nodes;
}

/// Calls do_block(block, begin, end) for each block of the nodes begin..end-1;
/// `begin` is the first node of a block.
template <class DoBlock>
void each_block(std::size_t begin, std::size_t end, const DoBlock& do_block) {
  for (std::size_t first = begin; first < end; first += block_nodes)
    do_block(first / block_nodes, first, std::min(end, first + block_nodes));
}

/// Nodes begin..end-1, the first of which begins a block.
struct NodeRange {
  std::size_t begin, end;
};

/// As chunked_sum, over the flagged blocks: calls do_run(range) -> Sums for
/// each run of adjacent flagged blocks of a chunk.
template <class Sums, class DoRun>
Sums flagged_sum(const BlockFlags& flags, std::size_t nodes,
                 const Workers& workers, const DoRun& do_run) {
  const std::uint8_t* const flag = flags.data();
  return chunked_sum<Sums>(
      nodes, workers, [&, flag](std::size_t begin, std::size_t end) {
        Sums total{};
        const std::size_t last = blocks_of(end);
        for (std::size_t block = begin / block_nodes; block < last; ++block) {
          if (flag[block] == 0)
            continue;
          const std::size_t first = block * block_nodes;
          while (block < last && flag[block] != 0)
            ++block;
          total += do_run(NodeRange{first, std::min(end, block * block_nodes)});
        }
        return total;
      });
}

/// Sets a field to 0 in the blocks that were written and are not active, and
/// notes the active ones as written.
template <class Real>
void clear_inactive(const BlockFlags& active, BlockFlags& written,
                    std::span<Real> field) {
  int any = 0;
  for (std::size_t block = 0; block < active.size(); ++block)
    any |= written[block] & ~active[block];
  for (std::size_t block = 0; any != 0 && block < active.size(); ++block)
    if (written[block] != 0 && active[block] == 0) {
      const std::size_t first = block * block_nodes;
      const std::size_t nodes = std::min(block_nodes, field.size() - first);
      std::ranges::fill(field.subspan(first, nodes), Real{0});
    }
  written = active;
}

} // namespace asperity::contact
