#pragma once

// Moves rows between ranks that hold them in two divisions.

#include "ranks/shared_rows.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// Sends the rows of a field to the ranks that hold them in another division:
/// row i of one grid is row i of the other. The rows that only one grid has are
/// neither sent nor received. Collective.
/// @param width  values in a row of the fields
/// @param field  of the rows of `from`, of which the first are read
/// @param moved  of the rows of `to`, of which the first are overwritten
template <class Value>
void move_rows(const SharedRows& from, const SharedRows& to, std::size_t width,
               std::span<const Value> field, std::span<Value> moved) {
  std::size_t n_sent = 0, n_received = 0;
  std::vector<std::size_t> sent = from.rows_on(to);
  std::vector<std::size_t> received = to.rows_on(from);
  for (std::size_t& rows : sent) {
    n_sent += rows * width;
    rows *= width * sizeof(Value);
  }
  for (std::size_t& rows : received) {
    n_received += rows * width;
    rows *= width * sizeof(Value);
  }
  from.ranks()->exchange(std::as_bytes(field.first(n_sent)), sent,
                         std::as_writable_bytes(moved.first(n_received)),
                         received);
}

} // namespace asperity
