#pragma once

// Nodal areas inside loops: a loop is compiled twice, for equal nodes and for
// those of a quadratic face.

#include <cstddef>
#include <span>

namespace asperity::contact {

struct EqualWeights {
  double operator[](std::size_t) const { return 1.0; }
};

/// Calls loop(weights), weights[i] the area of node i relative to the mean.
template <class Loop>
auto with_weights(std::span<const double> weights, const Loop& loop) {
  return weights.empty() ? loop(EqualWeights{}) : loop(weights.data());
}

} // namespace asperity::contact
