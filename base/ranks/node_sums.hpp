#pragma once

// Computes weighted sums, and maxima, over all nodes of a field.

#include "base/ranks/chunked_sum.hpp"
#include "base/ranks/node_weights.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace asperity {

/// Sum of term(i) over begin..end-1, in 16 partial sums, which processors add
/// at the same time, and then these in a fixed order.
template <class Term>
double sum_in_lanes(std::size_t begin, std::size_t end, const Term& term) {
  constexpr std::size_t n_lanes = 16;
  std::array<double, n_lanes> lanes{};
  std::size_t i = begin;
  for (; i + n_lanes <= end; i += n_lanes)
    for (std::size_t k = 0; k < n_lanes; ++k)
      lanes[k] += term(i + k);
  for (std::size_t k = 0; i < end; ++i, ++k)
    lanes[k] += term(i);
  for (std::size_t half = n_lanes / 2; half > 0; half /= 2)
    for (std::size_t k = 0; k < half; ++k)
      lanes[k] += lanes[k + half];
  return lanes[0];
}

/// sum_i weight_i term(i) over the nodes 0..nodes-1 of each rank.
/// @param weights  nodal areas relative to their mean; empty if all are equal
template <class Term>
double weighted_sum(std::span<const double> weights, std::size_t nodes,
                    const Workers& workers, const Term& term) {
  return with_weights(weights, [&](const auto weight) {
    return chunked_sum<Sum>(nodes, workers,
                            [=](std::size_t begin, std::size_t end) {
                              return Sum{
                                  sum_in_lanes(begin, end, [=](std::size_t i) {
                                    return weight[i] * term(i);
                                  })};
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

/// Sums over the nodes 0..nodes-1 of each rank: add(i, values) adds the terms
/// of one node.
template <std::size_t n, class Add>
std::array<double, n> several_sums(std::size_t nodes, const Workers& workers,
                                   const Add& add) {
  return chunked_sum<SeveralSums<n>>(nodes, workers,
                                     [&](std::size_t begin, std::size_t end) {
                                       SeveralSums<n> own;
                                       for (std::size_t i = begin; i < end; ++i)
                                         add(i, own.values);
                                       return own;
                                     })
      .values;
}

/// The largest term(i) over the nodes 0..nodes-1 of each rank; NaN if one is.
template <class Term>
double largest_term(std::size_t nodes, const Workers& workers,
                    const Term& term) {
  return chunked_sum<Largest>(nodes, workers,
                              [&](std::size_t begin, std::size_t end) {
                                Largest own;
                                for (std::size_t i = begin; i < end; ++i)
                                  own += Largest{term(i)};
                                return own;
                              })
      .value;
}

/// max_i field_i, and max_i |field_i|.
inline double largest_of(std::span<const double> field,
                         const Workers& workers) {
  return largest_term(field.size(), workers,
                      [=](std::size_t i) { return field[i]; });
}

inline double largest_size(std::span<const double> field,
                           const Workers& workers) {
  return largest_term(field.size(), workers,
                      [=](std::size_t i) { return std::abs(field[i]); });
}

} // namespace asperity
