#pragma once

// Loops over independent rows on several threads.

#include "base/thread_team.hpp"

#include <algorithm>
#include <atomic>
#include <functional>

namespace asperity {

/// Calls do_turn(turn, worker) once for each turn in 0..n_turns-1, on `threads`
/// threads that each take the next free turn. `worker` in 0..threads-1
/// identifies the thread, for its scratch memory. Every turn must write only
/// its own results, so that the result is bitwise independent of the number of
/// threads; the caller computes sums over turns afterwards, in order. do_turn
/// may contain another parallel loop. If it throws, no further turn is started
/// and the exception is passed to the caller.
/// @param threads  >= 1; with 1 no other thread is used
template <class DoTurn>
void parallel_turns(int n_turns, int threads, const DoTurn& do_turn) {
  std::atomic<int> next_turn = 0;
  const auto work = [&](int worker) {
    try {
      for (int turn = next_turn++; turn < n_turns; turn = next_turn++)
        do_turn(turn, worker);
    } catch (...) {
      next_turn = n_turns;
      throw;
    }
  };
  work_together(std::min(threads, n_turns), std::ref(work));
}

/// The same loop for rows that need no scratch memory; it calls do_row(row).
template <class DoRow>
void parallel_rows(int n_rows, int threads, const DoRow& do_row) {
  parallel_turns(n_rows, threads, [&](int row, int) { do_row(row); });
}

} // namespace asperity
