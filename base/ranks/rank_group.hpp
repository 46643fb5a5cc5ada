#pragma once

// The communication between processes that share the rows of a field. It knows
// no library of message passing: the program implements it by MPI, the tests by
// threads.

#include "base/grid.hpp"
#include "base/ranks/slab_transforms.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace asperity {

/// Several processes, the ranks 0..size()-1. Each call is collective: every
/// rank makes the same calls in the same order, from one thread at a time. A
/// rank whose call fails throws; whoever made the group ends the other ranks.
class RankGroup {
public:
  virtual ~RankGroup() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;

  /// Gives the bytes of all ranks to every rank, in the order of the ranks.
  /// @param own     counts[rank()] bytes
  /// @param counts  number of bytes of each rank
  /// @param all     receives the sum of the counts
  virtual void gather_to_all(std::span<const std::byte> own,
                             std::span<const std::size_t> counts,
                             std::span<std::byte> all) = 0;

  /// Sends a part of `sent` to each rank, and receives a part from each. Parts
  /// are adjacent and in the order of the ranks.
  /// @param sent_counts      number of bytes for each rank
  /// @param received_counts  number of bytes from each rank
  virtual void exchange(std::span<const std::byte> sent,
                        std::span<const std::size_t> sent_counts,
                        std::span<std::byte> received,
                        std::span<const std::size_t> received_counts) = 0;

  enum class Direction { backwards, forwards };

  /// Sends to the rank before this one and receives from the rank after it, or
  /// with `forwards` the other way round. The last rank precedes the first.
  /// @param received  of the size that the other rank sends, which may be 0
  virtual void pass(Direction direction, std::span<const std::byte> sent,
                    std::span<std::byte> received) = 0;

  /// The rows at the two ends of what one rank holds, all of one size.
  struct Edges {
    std::span<const std::byte> first, last; ///< sent to the rank before, after
    std::span<std::byte> before, after;     ///< received from these ranks
  };

  /// Makes transforms of a field of which each rank holds the same number of
  /// rows, and the last ones fewer.
  virtual void
  make_transforms(const Grid& grid, int rows,
                  std::shared_ptr<SlabTransforms<float>>& made) = 0;
  virtual void
  make_transforms(const Grid& grid, int rows,
                  std::shared_ptr<SlabTransforms<double>>& made) = 0;

  /// Exchanges rows with the ranks before and after this one.
  void swap_edges(const Edges& edges) {
    pass(Direction::backwards, edges.first, edges.after);
    pass(Direction::forwards, edges.last, edges.before);
  }
};

} // namespace asperity
