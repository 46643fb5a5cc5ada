#pragma once

// The processes of one mpirun: rank 0 broadcasts commands and the other ranks
// execute them. This file defines how a command is broadcast and how a failure
// on any rank terminates all of them; block_proxy defines what a command means.

#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace asperity::fem {

enum class OrderKind : int {
  build,        ///< text: a FullRequest and its mesh
  displacement, ///< numbers: the pressure
  solve,        ///< numbers: the heights, then load and contact
  stiffness,
  strongest_stress,
  section, ///< numbers: the plane
  write,   ///< text: folder and stem of the files
  drop,    ///< the block is no longer needed
  command, ///< text: a command of the program that is about no block
  quit,    ///< rank 0 has ended
};

/// A command that every rank executes for one block.
struct Order {
  OrderKind kind = OrderKind::quit;
  int block = 0; ///< number of the block, from 0 in the order of construction
  std::string text = {};
  std::vector<double> numbers = {};
};

/// Size of MPI_COMM_WORLD, which is initialised if necessary; 1 without mpirun.
int n_ranks();
int own_rank();

/// To be called on rank 0. Broadcasts a command to all other ranks; does
/// nothing on a single rank.
void pass_on(const Order& order);

/// To be called on the other ranks. Waits for the next command, sleeping
/// instead of polling continuously.
Order next_order();

/// To be called on every rank. Executes this rank's share of a command and
/// waits for the other ranks. If the share failed on all ranks, the ranks are
/// still synchronised: rank 0 throws its own failure and the others return. If
/// it failed on some ranks only, or if the others do not arrive within seconds
/// because one of their collective calls waits for this rank, each failed rank
/// terminates all ranks as end_all_ranks does.
void do_share(const std::function<void()>& share);

/// Prints the failure with the number of this rank and terminates all ranks.
/// The exit code is 2 for a refused argument or case and 4 for anything else,
/// as in the program's main function.
[[noreturn]] void end_all_ranks(const std::exception_ptr& failure);

/// Converts a count to the integer type of MPI.
/// @param what  what is counted, for the message
/// @throws std::domain_error  the count exceeds 2^31 - 1; the message names
///                            what is counted and the count
int mpi_count(std::size_t count, const char* what);

} // namespace asperity::fem
