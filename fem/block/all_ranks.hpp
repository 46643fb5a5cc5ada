#pragma once

// Values that every rank needs of all ranks.

#include "base/ranks/rank_sums.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/ranks.hpp"

#include <span>
#include <vector>

namespace asperity::fem {

/// The values of all ranks, those of rank 0 first, of each as many as it has.
/// Collective. (deal.II's all_gather packs and compresses values of any type,
/// for which the compiler takes seconds.)
/// @throws std::domain_error  they are 2^31 bytes or more
template <class Value>
std::vector<Value> of_all_ranks(const std::vector<Value>& own) {
  return values_of_ranks(n_ranks() > 1 ? &mpi_group() : nullptr,
                         std::span<const Value>(own));
}

} // namespace asperity::fem
