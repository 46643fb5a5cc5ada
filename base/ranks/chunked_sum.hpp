#pragma once

// Loops and sums over the nodes. The sums of a process are bitwise the same on
// any number of threads.

#include "base/maximum.hpp"
#include "base/parallel_rows.hpp"
#include "base/ranks/workers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace asperity {

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

/// The larger of several values over one loop; NaN if any is NaN.
struct Largest {
  double value = -std::numeric_limits<double>::infinity();

  Largest& operator+=(const Largest& other) {
    value = maximum(value, other.value);
    return *this;
  }
};

/// Number of nodes in one chunk, which one thread sums.
inline constexpr std::size_t chunk_nodes = std::size_t{1} << 13;

/// Calls do_chunk(begin, end) for chunks of 0..nodes-1.
/// @param threads  >= 1
template <class DoChunk>
void chunked(std::size_t nodes, int threads, const DoChunk& do_chunk) {
  const std::size_t count = (nodes + chunk_nodes - 1) / chunk_nodes;
  parallel_rows(static_cast<int>(count), threads, [&](int number) {
    const std::size_t begin = static_cast<std::size_t>(number) * chunk_nodes;
    do_chunk(begin, std::min(nodes, begin + chunk_nodes));
  });
}

/// Adds do_chunk(begin, end) -> Sums of each chunk to the total, in the order
/// of the chunks. Sums needs operator+=.
template <class Sums, class DoChunk>
void add_chunks(Sums& total, std::size_t nodes, int threads,
                const DoChunk& do_chunk) {
  std::vector<Sums> partial((nodes + chunk_nodes - 1) / chunk_nodes);
  chunked(nodes, threads, [&](std::size_t begin, std::size_t end) {
    partial[begin / chunk_nodes] = do_chunk(begin, end);
  });
  for (const Sums& sums : partial)
    total += sums;
}

/// The sums of do_chunk(begin, end) -> Sums over all nodes of this process and
/// of the ranks that share the rows. Collective.
/// @param nodes  number of nodes of this process
template <class Sums, class DoChunk>
Sums chunked_sum(std::size_t nodes, const Workers& workers,
                 const DoChunk& do_chunk) {
  static_assert(std::is_trivially_copyable_v<Sums>);
  Sums own{};
  add_chunks(own, nodes, workers.threads, do_chunk);
  if (workers.ranks() == nullptr)
    return own;
  Sums total{};
  for (const Sums& sums :
       values_of_ranks<Sums>(workers.ranks(), std::span<const Sums>(&own, 1)))
    total += sums;
  return total;
}

} // namespace asperity
