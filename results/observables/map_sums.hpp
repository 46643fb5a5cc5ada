#pragma once

// This internal header of results/ adds over the nodes of a map that may be in
// a file.

#include "base/ranks/chunked_sum.hpp"
#include "results/types/map_view.hpp"

#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace asperity::results {

/// Calls do_nodes(first, values) -> Sums for chunks of adjacent nodes and adds
/// the results as chunked_sum() does, with the same bits wherever the map is.
template <class Sums, class DoNodes>
Sums sum_over(const MapView& map, int threads, const DoNodes& do_nodes) {
  if (!map.is_stored()) {
    std::vector<double> none;
    const std::span<const double> all = map.values(0, map.size(), none);
    return chunked_sum<Sums>(
        all.size(), threads, [&](std::size_t begin, std::size_t end) {
          return do_nodes(begin, all.subspan(begin, end - begin));
        });
  }
  static_assert(values_at_a_time % chunk_nodes == 0);
  Sums total{};
  each_piece(std::array{map}, values_at_a_time,
             [&](std::size_t first, const auto& values) {
               const std::span<const double> piece = values[0];
               add_chunks(total, piece.size(), threads,
                          [&](std::size_t begin, std::size_t end) {
                            return do_nodes(first + begin,
                                            piece.subspan(begin, end - begin));
                          });
             });
  return total;
}

/// The mean of a map, with the bits of weighted_mean().
inline double mean_of(const MapView& map, int threads = 1) {
  const Sum sum = sum_over<Sum>(
      map, threads, [](std::size_t, std::span<const double> values) {
        return Sum{std::accumulate(values.begin(), values.end(), 0.0)};
      });
  return sum.value / static_cast<double>(map.size());
}

} // namespace asperity::results
