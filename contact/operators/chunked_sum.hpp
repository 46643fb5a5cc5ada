#pragma once

// This file contains loops and sums over the nodes whose results are bitwise
// the same on any number of threads.

#include "base/parallel_rows.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace asperity::contact {

/// Number of nodes in one chunk, which one thread sums.
inline constexpr std::size_t chunk_nodes = std::size_t{1} << 13;

/// The value of one sum over a loop.
struct Sum {
  double value = 0.0;

  Sum& operator+=(const Sum& other) {
    value += other.value;
    return *this;
  }
};

/// The values of several sums over one loop.
template <std::size_t n>
struct SeveralSums {
  std::array<double, n> values{};

  SeveralSums& operator+=(const SeveralSums& other) {
    for (std::size_t k = 0; k < n; ++k)
      values[k] += other.values[k];
    return *this;
  }
};

/// Calls do_chunk(begin, end) -> Sums for each chunk of 0..nodes-1 and adds the
/// results in the order of the chunks, so that the result is bitwise
/// independent of the number of threads and of their scheduling. Sums needs
/// operator+=.
template <class Sums, class DoChunk>
Sums chunked_sum(std::size_t nodes, int threads, const DoChunk& do_chunk) {
  const std::size_t chunks = (nodes + chunk_nodes - 1) / chunk_nodes;
  std::vector<Sums> partial(chunks);
  parallel_rows(static_cast<int>(chunks), threads, [&](int chunk) {
    const std::size_t begin = static_cast<std::size_t>(chunk) * chunk_nodes;
    partial[static_cast<std::size_t>(chunk)] =
        do_chunk(begin, std::min(nodes, begin + chunk_nodes));
  });
  Sums total{};
  for (const Sums& sums : partial)
    total += sums;
  return total;
}

/// The same loop without a sum; it calls do_chunk(begin, end).
template <class DoChunk>
void chunked(std::size_t nodes, int threads, const DoChunk& do_chunk) {
  chunked_sum<Sum>(nodes, threads, [&](std::size_t begin, std::size_t end) {
    do_chunk(begin, end);
    return Sum{};
  });
}

} // namespace asperity::contact
