#pragma once

// Adds and compares one number of each rank.

#include "base/ranks/rank_group.hpp"
#include "base/ranks/value_exchange.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

namespace asperity {

/// The number of each rank, in their order. Collective.
/// @param ranks  null for this process alone
inline std::vector<double> of_ranks(RankGroup* ranks, double own) {
  if (ranks == nullptr)
    return {own};
  const auto n = static_cast<std::size_t>(ranks->size());
  const std::vector<std::size_t> bytes(n, sizeof(double));
  std::vector<double> all(n);
  ranks->gather_to_all(std::as_bytes(std::span(&own, 1)), bytes,
                       std::as_writable_bytes(std::span(all)));
  return all;
}

/// The values of all ranks on each of them, those of rank 0 first. Collective.
/// @param ranks  null for this process alone
template <class Value>
std::vector<Value> values_of_ranks(RankGroup* ranks,
                                   std::span<const Value> own) {
  return ranks == nullptr ? std::vector<Value>(own.begin(), own.end())
                          : ValueExchange(*ranks, own.size()).sent(own);
}

/// The sum over the ranks, with the same bits on each of them. Collective.
inline double rank_sum(RankGroup* ranks, double own) {
  const std::vector<double> all = of_ranks(ranks, own);
  return std::accumulate(all.begin() + 1, all.end(), all.front());
}

/// The largest number of the ranks. Collective.
inline double rank_max(RankGroup* ranks, double own) {
  return std::ranges::max(of_ranks(ranks, own));
}

} // namespace asperity
