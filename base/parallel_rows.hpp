#pragma once

// A loop over independent rows on a few threads.

#include <atomic>
#include <thread>
#include <vector>

namespace asperity {

/// Calls do_row(row) once for each row in 0..n_rows-1, on `threads` threads
/// that each take the next free row. Every row writes its own results only, so
/// the number of threads changes no bit; what is to be summed over rows is
/// summed by the caller afterwards, in their order. do_row does not throw.
/// @param threads  >= 1; with 1 no thread is started
template <class DoRow>
void parallel_rows(int n_rows, int threads, const DoRow& do_row) {
  std::atomic<int> next_row = 0;
  const auto work = [&] {
    for (int row = next_row++; row < n_rows; row = next_row++)
      do_row(row);
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < threads && i < n_rows; ++i)
    helpers.emplace_back(work);
  work();
}

} // namespace asperity
