#pragma once

// This internal header of results/ adds over the nodes of a map that may be in
// a file.

#include "ranks/chunked_sum.hpp"
#include "results/types/map_view.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace asperity::results {

/// Calls do_nodes(first, values) -> Sums for chunks of adjacent nodes and adds
/// the results as chunked_sum() does, with the same bits wherever the map is.
/// @param workers  without ranks if the map is in a file
template <class Sums, class DoNodes>
Sums sum_over(const MapView& map, const Workers& workers,
              const DoNodes& do_nodes) {
  if (!map.is_stored()) {
    std::vector<double> none;
    const std::span<const double> all = map.values(0, map.size(), none);
    return chunked_sum<Sums>(
        all.size(), workers, [&](std::size_t begin, std::size_t end) {
          return do_nodes(begin, all.subspan(begin, end - begin));
        });
  }
  const NodeChunks& chunks = workers.chunks;
  const std::size_t units =
      std::max<std::size_t>(1, MapView::values_at_a_time / chunks.unit_nodes());
  std::vector<Sums> partial(chunks.count(map.size()));
  each_piece(std::array{map}, units * chunks.unit_nodes(),
             [&](std::size_t first, const auto& values) {
               const std::span<const double> piece = values[0];
               Sums* const of_piece = &partial[chunks.count(first)];
               each_chunk(
                   piece.size(), workers,
                   [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                     of_piece[chunk] = do_nodes(
                         first + begin, piece.subspan(begin, end - begin));
                   });
             });
  return sum_of_chunks<Sums>(partial, map.size(), workers);
}

/// The mean of a map, with the bits of weighted_mean().
inline double mean_of(const MapView& map, const Workers& workers = 1) {
  const Sum sum = sum_over<Sum>(
      map, workers, [](std::size_t, std::span<const double> values) {
        return Sum{std::accumulate(values.begin(), values.end(), 0.0)};
      });
  return sum.value / static_cast<double>(map.size());
}

} // namespace asperity::results
