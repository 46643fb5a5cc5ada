#pragma once

// Continues a computation from the nodes of one rank to those of the next, so
// that sums over all nodes have the bits of one process.

#include "ranks/shared_rows.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>

namespace asperity {

/// Calls go_on() on each rank, one after another; it continues the state of the
/// ranks before. All ranks receive the state after the last one. Collective.
/// The ranks do not work at the same time, so that this is for sums that are
/// needed once for a surface.
/// @param rows   whose ranks are called; one call without ranks, or if null
/// @param state  bytes that go_on() changes
/// @throws std::domain_error  on every rank, if go_on() threw an exception on
///                            one, with its message
void bytes_in_order(const SharedRows* rows, std::span<std::byte> state,
                    const std::function<void()>& go_on);

/// The same for go_on(state); returns the state after the last rank.
template <class State, class GoOn>
State in_order(const SharedRows* rows, State state, const GoOn& go_on) {
  static_assert(std::is_trivially_copyable_v<State>);
  if (rows == nullptr)
    go_on(state);
  else
    bytes_in_order(rows, std::as_writable_bytes(std::span(&state, 1)),
                   [&] { go_on(state); });
  return state;
}

} // namespace asperity
