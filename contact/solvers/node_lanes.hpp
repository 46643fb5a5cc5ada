#pragma once

// This file contains what the loops of node_kernels.hpp consist of: blocks of
// nodes, and sums that round in the same way for every SIMD width.
//
// The terms of the sums over a block go to arrays on the stack, which are added
// in `n_lanes` lanes and then the lanes in a fixed order. The compiler turns
// the loops over a block into vectors: they have no branches, a condition is a
// mask of bits, and the number of nodes is known. Nodes that are missing in the
// last block have terms of 0.

#include "base/simd_pack.hpp"
#include "contact/solvers/node_blocks.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace asperity::contact {

inline constexpr std::size_t n_lanes = 16;

/// The terms of a sum over a block.
struct Terms {
  /// @param n       number of nodes, whose terms are to be set
  /// @param beyond  the other terms
  template <class Count>
  [[gnu::always_inline]] explicit Terms(Count n, double beyond = 0.0) {
    if (n < block_nodes)
      values.fill(beyond);
  }

  double& operator[](std::size_t i) { return values[i]; }

  /// Multiplies the terms by the weights of n nodes from `first` on, if there
  /// are any.
  template <class Count>
  [[gnu::always_inline]] void scale(const double* weights, std::size_t first,
                                    Count n) {
    if (weights != nullptr)
      for (std::size_t i = 0; i < n; ++i)
        values[i] *= weights[first + i];
  }

  /// Aligned, because clang forgets that a reference to SimdPack::Unaligned may
  /// stand at any place.
  alignas(64) std::array<double, block_nodes> values;
};

/// One accumulator per lane.
template <std::size_t bytes>
struct Lanes {
  using Vector = typename SimdPack<double, bytes>::Type;
  using Unaligned = typename SimdPack<double, bytes>::Unaligned;
  static constexpr std::size_t width = SimdPack<double, bytes>::lanes;

  [[gnu::always_inline]] void add(const Terms& terms) {
    for (std::size_t k = 0; k < block_nodes; k += n_lanes)
      for (std::size_t part = 0; part < n_lanes / width; ++part)
        parts[part] += at(terms, k + part * width);
  }

  [[gnu::always_inline]] void keep_smallest(const Terms& terms) {
    for (std::size_t k = 0; k < block_nodes; k += n_lanes)
      for (std::size_t part = 0; part < n_lanes / width; ++part) {
        const Vector own = at(terms, k + part * width);
        parts[part] = own < parts[part] ? own : parts[part];
      }
  }

  [[gnu::always_inline]] double total() const {
    return folded([](double a, double b) { return a + b; });
  }

  [[gnu::always_inline]] double smallest() const {
    return folded([](double a, double b) { return b < a ? b : a; });
  }

  template <class Join>
  [[gnu::always_inline]] double folded(const Join& join) const {
    std::array<double, n_lanes> lanes;
    std::memcpy(lanes.data(), parts.data(), sizeof(lanes));
#pragma GCC unroll 4
    for (std::size_t half = n_lanes / 2; half > 0; half /= 2)
#pragma GCC unroll 8
      for (std::size_t i = 0; i < half; ++i)
        lanes[i] = join(lanes[i], lanes[i + half]);
    return lanes[0];
  }

  [[gnu::always_inline]] static const Unaligned& at(const Terms& terms,
                                                    std::size_t i) {
    return *reinterpret_cast<const Unaligned*>(terms.values.data() + i);
  }

  std::array<Vector, n_lanes / width> parts{};
};

/// Calls do_block(first node, number of nodes); the number is a constant in all
/// calls but the last, which has fewer nodes.
template <class DoBlock>
[[gnu::always_inline]] inline void each_node_block(std::size_t nodes,
                                                   const DoBlock& do_block) {
  std::size_t first = 0;
  for (; first + block_nodes <= nodes; first += block_nodes)
    do_block(first, std::integral_constant<std::size_t, block_nodes>());
  if (first < nodes)
    do_block(first, nodes - first);
}

[[gnu::always_inline]] inline double masked(double value, std::int64_t mask) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(value) & mask);
}

[[gnu::always_inline]] inline float masked(float value, std::int32_t mask) {
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(value) & mask);
}

} // namespace asperity::contact
