#pragma once

// Nodal areas inside loops. A loop is compiled twice: for equal nodal areas and
// for those of quadratic elements.

#include <cstddef>
#include <span>

namespace asperity {

struct EqualWeights {
  double operator[](std::size_t) const { return 1.0; }
};

/// The area of a node relative to the mean; `weights` is empty if all are
/// equal.
inline double weight_of(std::span<const double> weights, std::size_t node) {
  return weights.empty() ? 1.0 : weights[node];
}

/// Calls loop(weights), where weights[i] is the area of node i relative to the
/// mean.
template <class Loop>
auto with_weights(std::span<const double> weights, const Loop& loop) {
  return weights.empty() ? loop(EqualWeights{}) : loop(weights.data());
}

} // namespace asperity
