#pragma once

// This file computes weighted sums over all nodes of a field, bitwise the same
// on any number of threads and ranks.

#include <cstddef>
#include <span>

#include "ranks/chunked_sum.hpp"
#include "ranks/node_weights.hpp"

namespace asperity {

/// sum_i weight_i term(i) over the nodes 0..nodes-1 of each rank.
/// @param weights  nodal areas relative to their mean; empty if all are equal
template <class Term>
double weighted_sum(std::span<const double> weights, std::size_t nodes,
                    const Workers& workers, const Term& term) {
  return with_weights(weights, [&](const auto weight) {
    return chunked_sum<Sum>(nodes, workers,
                            [=](std::size_t begin, std::size_t end) {
                              double total = 0.0;
                              for (std::size_t i = begin; i < end; ++i)
                                total += weight[i] * term(i);
                              return Sum{total};
                            })
        .value;
  });
}

/// sum_i weight_i field_i
inline double weighted_sum(std::span<const double> weights,
                           std::span<const double> field,
                           const Workers& workers = 1) {
  return weighted_sum(weights, field.size(), workers,
                      [f = field.data()](std::size_t i) { return f[i]; });
}

/// sum_i weight_i left_i right_i; the two fields have the same size.
inline double weighted_dot(std::span<const double> weights,
                           std::span<const double> left,
                           std::span<const double> right,
                           const Workers& workers = 1) {
  return weighted_sum(weights, left.size(), workers,
                      [a = left.data(), b = right.data()](std::size_t i) {
                        return a[i] * b[i];
                      });
}

} // namespace asperity
