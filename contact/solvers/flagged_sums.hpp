#pragma once

// This file computes weighted sums over the blocks of nodes in which something
// happens. It is for sources that are compiled with -fopenmp-simd.

#include "contact/solvers/node_blocks.hpp"

#include <cstddef>
#include <span>

#include "ranks/node_weights.hpp"

namespace asperity::contact {

/// sum_i weight_i term(i) over the nodes i of the flagged blocks.
template <class Term>
double flagged_weighted_sum(std::span<const double> weights,
                            const BlockFlags& flags, std::size_t nodes,
                            const Workers& workers, const Term& term) {
  return with_weights(weights, [&](const auto weight) {
    return flagged_sum<Sum>(flags, nodes, workers,
                            [=](std::size_t begin, std::size_t end) {
                              double total = 0.0;
#pragma omp simd reduction(+ : total)
                              for (std::size_t i = begin; i < end; ++i)
                                total += weight[i] * term(i);
                              return Sum{total};
                            })
        .value;
  });
}

} // namespace asperity::contact
