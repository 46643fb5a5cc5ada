#pragma once

// The group of one rank, with which one process calls what is written for
// several.

#include "ranks/rank_group.hpp"
#include "ranks/shared_rows.hpp"

#include <algorithm>

namespace asperity {

/// This process alone. It has no state, so that threads may share it.
class OneRank final : public RankGroup {
public:
  int rank() const override { return 0; }

  int size() const override { return 1; }

  void gather_to_all(std::span<const std::byte> own,
                     std::span<const std::size_t> /*counts*/,
                     std::span<std::byte> all) override {
    std::ranges::copy(own, all.begin());
  }

  void exchange(std::span<const std::byte> sent,
                std::span<const std::size_t> sent_counts,
                std::span<std::byte> received,
                std::span<const std::size_t> /*received_counts*/) override {
    std::ranges::copy(sent.first(sent_counts.front()), received.begin());
  }

  void pass(Direction /*direction*/, std::span<const std::byte> sent,
            std::span<std::byte> received) override {
    std::ranges::copy(sent, received.begin());
  }
};

/// The group that shares the rows, or this process alone.
inline RankGroup& group_of(const SharedRows& rows) {
  static OneRank alone;
  return rows.ranks() != nullptr ? *rows.ranks() : alone;
}

/// All rows of a grid as those of a group of one rank.
inline SharedRows rows_of_one(const Grid& grid) {
  return {grid, group_of(SharedRows(grid)), {0, grid.points_y}};
}

} // namespace asperity
