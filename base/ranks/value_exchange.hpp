#pragma once

// Values that go from the ranks that hold them to those that need them, and
// back, always in the same way.

#include "base/ranks/rank_group.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// A fixed pattern of messages. All calls are collective.
class ValueExchange {
public:
  /// Each value goes to one rank.
  /// @param ranks    must outlive this object
  /// @param targets  of each value that this rank holds, not decreasing
  /// @throws std::domain_error  the targets decrease
  ValueExchange(RankGroup& ranks, std::span<const int> targets);

  /// Every rank receives all values.
  /// @param n_values  that this rank holds
  ValueExchange(RankGroup& ranks, std::size_t n_values);

  /// The number of values that this rank receives.
  std::size_t n_received() const { return n_received_; }

  /// The values that this rank receives: those of rank 0 first, and those of
  /// one rank in its order.
  /// @param own  as many values as this rank holds
  template <class Value>
  std::vector<Value> sent(std::span<const Value> own) const {
    std::vector<Value> all(n_received_);
    send(std::as_bytes(own), sizeof(Value),
         std::as_writable_bytes(std::span(all)));
    return all;
  }

  /// The values that this rank holds, from one each that every rank returns for
  /// a value that it received.
  template <class Value>
  std::vector<Value> returned(std::span<const Value> values) const {
    std::vector<Value> own(n_own_);
    give_back(std::as_bytes(values), sizeof(Value),
              std::as_writable_bytes(std::span(own)));
    return own;
  }

  /// The same for values of `size` bytes each.
  void send(std::span<const std::byte> own, std::size_t size,
            std::span<std::byte> received) const;
  void give_back(std::span<const std::byte> values, std::size_t size,
                 std::span<std::byte> own) const;

  std::size_t bytes() const {
    return (sent_.size() + received_.size()) * sizeof(std::size_t);
  }

private:
  RankGroup* ranks_;
  std::size_t n_own_;
  /// Numbers of values for and from each rank; the first is empty if every rank
  /// receives all.
  std::vector<std::size_t> sent_, received_;
  std::size_t n_received_ = 0;
  std::size_t first_ = 0; ///< place of the own values if all receive them
};

} // namespace asperity
