#pragma once

// Divides a field that rank 0 has in pieces among the ranks, so that no rank
// holds the whole one.

#include "ranks/shared_rows.hpp"

#include <functional>
#include <span>
#include <vector>

namespace asperity {

/// Returns the rows of this process. Collective.
/// @param next  fills a span with the next values of the field, from the first
///              row to the last; called on rank 0 only, for pieces of at most
///              4 MB or one row
/// @throws      what next() throws on rank 0, std::runtime_error on the others
std::vector<double>
rows_from_rank_0(const SharedRows& rows,
                 const std::function<void(std::span<double>)>& next);

} // namespace asperity
