#include "fem/ranks.hpp"

#include "fem/mpi_session.hpp"

#include <mpi.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <thread>

namespace asperity::fem {
namespace {

constexpr int leader = 0;

/// Kind, block, letters of the text, numbers.
using Head = std::array<std::int64_t, 4>;

/// A rank that waits for rank 0 leaves its core to others.
void broadcast_asleep(Head& head) {
  MPI_Request request;
  MPI_Ibcast(head.data(), static_cast<int>(head.size()), MPI_INT64_T, leader,
             MPI_COMM_WORLD, &request);
  int is_done = 0;
  MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
  while (!is_done) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
  }
}

void broadcast_body(Order& order) {
  MPI_Bcast(order.text.data(), static_cast<int>(order.text.size()), MPI_CHAR,
            leader, MPI_COMM_WORLD);
  MPI_Bcast(order.numbers.data(), static_cast<int>(order.numbers.size()),
            MPI_DOUBLE, leader, MPI_COMM_WORLD);
}

} // namespace

int n_ranks() {
  start_mpi();
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

int own_rank() {
  start_mpi();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

void pass_on(const Order& order) {
  if (n_ranks() == 1)
    return;
  Head head{static_cast<std::int64_t>(order.kind), order.block,
            static_cast<std::int64_t>(order.text.size()),
            static_cast<std::int64_t>(order.numbers.size())};
  broadcast_asleep(head);
  Order sent = order; // MPI takes no constant
  broadcast_body(sent);
}

Order next_order() {
  Head head{};
  broadcast_asleep(head);
  Order order{static_cast<OrderKind>(head[0]), static_cast<int>(head[1])};
  order.text.resize(static_cast<std::size_t>(head[2]));
  order.numbers.resize(static_cast<std::size_t>(head[3]));
  broadcast_body(order);
  return order;
}

} // namespace asperity::fem
