#pragma once

// Completes the numbers that a rank owns by those that it needs from others,
// its ghosts, and returns contributions to ghosts to their owners.

#include "base/ranks/rank_group.hpp"
#include "base/ranks/value_exchange.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// Arrays over items of `width` numbers each: first the items that this rank
/// owns, which have consecutive global numbers, then its ghosts in the order of
/// their global numbers, then any that concern no other rank.
class GhostValues {
public:
  /// Collective, as the calls below.
  /// @param ranks   must outlive this object
  /// @param owned   the number of items of this rank; the global numbers of a
  ///                rank follow those of the ranks before it
  /// @param ghosts  global numbers of items of other ranks, increasing
  /// @throws std::domain_error  a ghost is an item of this rank or of none, or
  ///                            the numbers do not increase
  GhostValues(RankGroup& ranks, std::size_t owned,
              std::span<const std::size_t> ghosts, std::size_t width);

  RankGroup& ranks() const { return ranks_; }

  std::size_t owned() const { return owned_; } ///< items of this rank

  /// Copies the values of the owners to the ghosts.
  template <class Number>
  void fill_ghosts(Number* values) const;

  /// Adds the values of the ghosts to those of their owners, rank after rank,
  /// and sets the ghosts to zero.
  template <class Number>
  void add_to_owners(Number* values) const;

  std::size_t bytes() const;

private:
  RankGroup& ranks_;
  std::size_t owned_, ghosts_, width_;
  ValueExchange to_owners_;        ///< of the ghosts
  std::vector<std::size_t> items_; ///< own items that other ranks need
  mutable std::vector<std::byte> buffer_;
};

} // namespace asperity
