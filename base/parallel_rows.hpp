#pragma once

// A loop over independent rows on a few threads.

#include "base/thread_team.hpp"

#include <algorithm>
#include <atomic>
#include <functional>

namespace asperity {

/// Calls do_turn(turn, worker) once for each turn in 0..n_turns-1, on `threads`
/// threads that each take the next free turn; `worker` in 0..threads-1 names
/// the thread, for its scratch. Every turn writes its own results only, so the
/// number of threads changes no bit; what is to be summed over turns is summed
/// by the caller afterwards, in their order. do_turn may hold a loop of its
/// own. Where it throws, no further turn is begun and the caller gets the
/// exception.
/// @param threads  >= 1; with 1 no other thread is asked
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

/// The same for rows that need no scratch: do_row(row).
template <class DoRow>
void parallel_rows(int n_rows, int threads, const DoRow& do_row) {
  parallel_turns(n_rows, threads, [&](int row, int) { do_row(row); });
}

} // namespace asperity
