#pragma once

// Adds up the rows of a field in their order, while all ranks work at the same
// time.

#include "ranks/rank_sums.hpp"
#include "ranks/shared_rows.hpp"

#include <type_traits>
#include <vector>

namespace asperity {

/// Calls of_row(row) -> Sums for each row of this process, 0..rows.count()-1,
/// and adds the results of all rows of the grid in their order: the bits do not
/// depend on the number of ranks. Each rank receives the sums of all rows.
/// Collective. Sums needs operator+=.
template <class Sums, class OfRow>
Sums sum_over_rows(const SharedRows& rows, const OfRow& of_row) {
  static_assert(std::is_trivially_copyable_v<Sums>);
  std::vector<Sums> own;
  own.reserve(static_cast<std::size_t>(rows.count()));
  for (int row = 0; row < rows.count(); ++row)
    own.push_back(of_row(row));
  Sums total{};
  for (const Sums& sums :
       values_of_ranks<Sums>(rows.ranks(), std::span<const Sums>(own)))
    total += sums;
  return total;
}

} // namespace asperity
