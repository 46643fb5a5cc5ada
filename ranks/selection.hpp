#pragma once

// Selects numbers by their order from those of all ranks.

#include "ranks/rank_group.hpp"

#include <cstddef>
#include <span>

namespace asperity {

/// The number that would be at place k if the numbers of all ranks were sorted,
/// k = 0 for the smallest. The bits of the numbers are counted from the highest
/// to the lowest byte, so that no number is moved and the result is exact,
/// whatever their order. Collective.
///
/// Negative NaN are before all other numbers, positive NaN behind them, and -0
/// before 0.
/// @param ranks  null for this process alone
/// @param own    numbers of this rank; may be empty
/// @param k      below the number of all numbers
/// @throws std::domain_error  k is not
double kth_smallest(RankGroup* ranks, std::span<const double> own,
                    std::size_t k);

/// The median of the numbers of all ranks: the mean of the middle two for an
/// even number, and NaN for none. Collective.
double median(RankGroup* ranks, std::span<const double> own);

} // namespace asperity
