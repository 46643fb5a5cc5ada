#pragma once

// Whole blocks that all ranks of an mpirun solve together though only rank 0
// runs the program. Owns which block an order is for.

#include "fem/case_problem.hpp"

#include <functional>
#include <memory>

namespace asperity::fem {

/// Builds a rank's own part of a block: make_full_block, but in tests of
/// failures.
using BlockMaker =
    std::function<std::unique_ptr<FullBlock>(const BlockProblem&)>;

/// Rank 0: reads the case and makes the mesh, alone; then builds the block on
/// every rank, and passes each call of it on before it is done here. One call
/// at a time, from any thread. On one rank alone it is the block itself. What
/// fails on every rank is thrown; what fails on some ends all (ranks.hpp).
/// @throws std::domain_error, cases::CaseError  as problem_of_case and
///                                              make_full_block
std::unique_ptr<FullBlock> lead_full_block(const FullRequest& request,
                                           const BlockMaker& make_block);

/// The other ranks: does what rank 0 passes on until it ends.
void follow_rank_0(const BlockMaker& make_block);

/// Rank 0: lets the others end when the program does.
void end_followers_at_exit();

} // namespace asperity::fem
