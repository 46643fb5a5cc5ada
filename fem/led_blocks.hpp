#pragma once

// Whole blocks that all ranks of an mpirun solve together though only rank 0
// runs the program. Owns which block an order is for.

#include "fem/case_problem.hpp"

#include <memory>

namespace asperity::fem {

/// Rank 0: builds the block on every rank; each call of it is passed on before
/// it is done here. One call at a time, from any thread. On one rank alone it
/// is the block itself.
/// @throws std::domain_error, cases::CaseError  as problem_of_case and
///                                              make_full_block
std::unique_ptr<FullBlock> lead_full_block(const FullRequest& request);

/// The other ranks: does what rank 0 passes on until it ends.
void follow_rank_0();

/// Rank 0: lets the others end when the program does.
void end_followers_at_exit();

} // namespace asperity::fem
