#pragma once

// Full 3-D blocks that all ranks of an mpirun solve together although only rank
// 0 runs the program. This file maps each broadcast command to its block.

#include "fem/full_request.hpp"

#include <functional>
#include <memory>
#include <string>

namespace asperity::fem {

/// Builds the part of a block that one rank owns. It is make_full_block, except
/// in tests of failures.
using BlockMaker =
    std::function<std::unique_ptr<FullBlock>(const BlockProblem&)>;

/// To be called on rank 0. Generates the mesh on rank 0 alone, then builds the
/// block on every rank. The block returned is a proxy: it broadcasts each call
/// to the other ranks before it executes the call here. Only one call may be
/// active at a time, from any thread. On a single rank the block itself is
/// returned. A failure on every rank is thrown as an exception; a failure on
/// some ranks terminates all of them (ranks.hpp).
/// @throws std::domain_error, input::InputError  as problem_of and
///                                               make_full_block
std::unique_ptr<FullBlock> make_distributed_block(const FullRequest& request,
                                                  const BlockMaker& make_block);

/// What a rank does with a command of the program that is about no block.
using RankCommand = std::function<void(const std::string& text, int rank)>;

/// To be called on rank 0. Executes a command on every rank and waits for all
/// of them. Failures are handled as those of a block.
void execute_on_all_ranks(const std::string& text, const RankCommand& command);

/// To be called on the other ranks. Executes the commands that rank 0
/// broadcasts until rank 0 ends.
void serve_rank_0(const BlockMaker& make_block,
                  const RankCommand& command = {});

/// To be called on rank 0. Lets the other ranks end when the program exits.
void end_followers_at_exit();

} // namespace asperity::fem
