#pragma once

// The processes of one mpirun: rank 0 leads, the others do as it does. Owns
// how an order is passed on and how a failure of any rank ends all of them;
// what an order means is led_blocks' business.

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
  strongest_stress,
  section, ///< numbers: the plane
  write,   ///< text: folder and stem of the files
  drop,    ///< a block is not needed any more
  quit,    ///< rank 0 has ended
};

/// What every rank is to do with one block.
struct Order {
  OrderKind kind = OrderKind::quit;
  int block = 0; ///< which, counted from 0 in the order they were built
  std::string text = {};
  std::vector<double> numbers = {};
};

/// Of MPI_COMM_WORLD, started if need be; 1 without mpirun.
int n_ranks();
int own_rank();

/// Rank 0: to all others. Nothing happens on one rank alone.
void pass_on(const Order& order);

/// The other ranks: waits for it, asleep rather than turning.
Order next_order();

/// Every rank: does its share of an order and waits for the others. Where all
/// failed, the ranks are still in step: rank 0 throws its own failure, and the
/// others return. Where some failed, or the others do not come within
/// seconds because a collective call of theirs waits for this rank, each failed
/// rank ends all of them as below.
void do_share(const std::function<void()>& share);

/// Prints the failure with this rank's number and ends all ranks: exit code 2
/// for a refused argument or case, 4 for anything else, as the program's main.
[[noreturn]] void end_all_ranks(const std::exception_ptr& failure);

/// A count as MPI takes it.
/// @param what  is counted, for the message
/// @throws std::domain_error  more than 2^31 - 1; names what and how many
int mpi_count(std::size_t count, const char* what);

} // namespace asperity::fem
