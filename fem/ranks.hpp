#pragma once

// The processes of one mpirun: rank 0 leads, the others do as it does. Owns
// how an order is passed on; what it means is whole_blocks' business.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

enum class OrderKind : int {
  build,        ///< text: a FullRequest
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

} // namespace asperity::fem
