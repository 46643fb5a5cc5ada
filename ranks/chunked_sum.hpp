#pragma once

// Loops and sums over the nodes whose results are bitwise the same on any
// number of threads and ranks.

#include "base/maximum.hpp"
#include "base/parallel_rows.hpp"
#include "ranks/workers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
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

/// Calls do_chunk(chunk, begin, end) for each chunk of 0..nodes-1.
/// @param nodes  number of nodes of this process, or of its first rows
template <class DoChunk>
void each_chunk(std::size_t nodes, const Workers& workers,
                const DoChunk& do_chunk) {
  const NodeChunks& chunks = workers.chunks;
  parallel_rows(static_cast<int>(chunks.count(nodes)), workers.threads,
                [&](int number) {
                  const auto chunk = static_cast<std::size_t>(number);
                  do_chunk(chunk, chunks.begin(chunk),
                           std::min(nodes, chunks.begin(chunk + 1)));
                });
}

/// Calls do_chunk(begin, end) for chunks of 0..nodes-1.
/// @param threads  >= 1
template <class DoChunk>
void chunked(std::size_t nodes, int threads, const DoChunk& do_chunk) {
  each_chunk(nodes, threads,
             [&](std::size_t, std::size_t begin, std::size_t end) {
               do_chunk(begin, end);
             });
}

/// Adds the sums of the chunks of this process in their order, first those of
/// each group, then the groups of all ranks. Collective over the ranks.
/// @param nodes  number of nodes of this process
template <class Sums>
Sums sum_of_chunks(std::span<const Sums> partial, std::size_t nodes,
                   const Workers& workers) {
  const std::size_t length = workers.chunks.in_group(workers.all_nodes(nodes));
  std::vector<Sums> groups((partial.size() + length - 1) / length);
  for (std::size_t chunk = 0; chunk < partial.size(); ++chunk)
    groups[chunk / length] += partial[chunk];
  if (workers.rows != nullptr) {
    const std::vector<std::byte> all = gathered_sums(
        *workers.rows, std::as_bytes(std::span(groups)), sizeof(Sums));
    groups.resize(all.size() / sizeof(Sums));
    std::memcpy(groups.data(), all.data(), all.size());
  }
  Sums total{};
  for (const Sums& sums : groups)
    total += sums;
  return total;
}

/// Calls do_chunk(begin, end) -> Sums for each chunk of the nodes of this
/// process and adds the results in the order of the chunks, first those of each
/// group, then the groups of all ranks. The result is bitwise independent of
/// the numbers of threads and ranks and of their scheduling. Collective over
/// the ranks. Sums needs operator+=.
/// @param nodes  number of nodes of this process
template <class Sums, class DoChunk>
Sums chunked_sum(std::size_t nodes, const Workers& workers,
                 const DoChunk& do_chunk) {
  static_assert(std::is_trivially_copyable_v<Sums>);
  std::vector<Sums> partial(workers.chunks.count(nodes));
  each_chunk(nodes, workers,
             [&](std::size_t chunk, std::size_t begin, std::size_t end) {
               partial[chunk] = do_chunk(begin, end);
             });
  return sum_of_chunks<Sums>(partial, nodes, workers);
}

} // namespace asperity
