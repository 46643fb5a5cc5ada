#pragma once

// What the loops of node_kernels.hpp consist of: blocks of nodes, vectors of
// adjacent nodes, and sums that round in the same way for every SIMD width.
// Conditions are masks of bits and sums stay in registers; loops over arrays,
// which the compiler would turn into vectors, write their terms to memory.

#include "base/simd_pack.hpp"
#include "contact/solvers/node_blocks.hpp"
#include "contact/solvers/node_kernels.hpp"
#include "contact/solvers/padded_block.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace asperity::contact {

inline constexpr std::size_t n_lanes = 16;

/// Stands for weights of 1.
struct EqualWeights {};

/// The values of as many adjacent nodes as a vector has numbers of type Real.
template <std::size_t bytes, class Real>
struct NodePack {
  static constexpr std::size_t width = bytes / sizeof(Real);

  template <class Number>
  using Of = typename SimdPack<Number, width * sizeof(Number)>::Type;
  template <class Number>
  using Mask =
      Of<std::conditional_t<sizeof(Number) == 8, std::int64_t, std::int32_t>>;
  using Reals = Of<Real>;

  // Results are arguments: a vector returned has another place without AVX.

  template <class Number>
  [[gnu::always_inline]] static void take(const Number* from,
                                          Of<Number>& values) {
    std::memcpy(&values, from, sizeof(values));
  }

  template <class Number>
  [[gnu::always_inline]] static void put(const Of<Number>& values, Number* to) {
    std::memcpy(to, &values, sizeof(values));
  }

  /// The numbers as those of another type: a vector of them, or an array.
  template <class Result, class Numbers>
  [[gnu::always_inline]] static void convert(const Numbers& from,
                                             Of<Result>& values) {
    convert_each<Result>(from, values, std::make_index_sequence<width>());
  }

  /// The bits of the negative numbers, and no bits of the others. GCC 12 makes
  /// single comparisons of one of vectors, except in a selection.
  template <class Number>
  [[gnu::always_inline]] static void negative(const Of<Number>& values,
                                              Mask<Number>& mask) {
    std::memcpy(&mask, &values, sizeof(mask));
    mask >>= 8 * static_cast<int>(sizeof(Number)) - 1;
  }

  /// Sets the numbers to 0 where a mask has no bits.
  template <class Number>
  [[gnu::always_inline]] static void restrict_to(const Mask<Number>& mask,
                                                 Of<Number>& values) {
    Mask<Number> bits;
    std::memcpy(&bits, &values, sizeof(bits));
    bits &= mask;
    std::memcpy(&values, &bits, sizeof(bits));
  }

  [[gnu::always_inline]] static void scale(EqualWeights, std::size_t, Reals&) {}

  [[gnu::always_inline]] static void scale(const double* weights, std::size_t i,
                                           Reals& values) {
    Reals factors;
    convert<Real>(weights + i, factors);
    values *= factors;
  }

private:
  /// __builtin_convertvector of GCC 12 converts in two halves.
  template <class Result, class Numbers, std::size_t... i>
  [[gnu::always_inline]] static void convert_each(const Numbers& from,
                                                  Of<Result>& values,
                                                  std::index_sequence<i...>) {
    values = Of<Result>{static_cast<Result>(from[i])...};
  }
};

/// One accumulator per lane.
template <std::size_t bytes, class Real = double>
struct Lanes {
  using Pack = NodePack<bytes, Real>;

  [[gnu::always_inline]] double total() const {
    return folded([](double a, double b) { return a + b; });
  }

  [[gnu::always_inline]] double smallest() const {
    return folded([](double a, double b) { return b < a ? b : a; });
  }

  [[gnu::always_inline]] double largest() const {
    return folded([](double a, double b) { return b > a ? b : a; });
  }

  template <class Join>
  [[gnu::always_inline]] double folded(const Join& join) const {
    std::array<Real, n_lanes> lanes;
    std::memcpy(lanes.data(), parts.data(), sizeof(lanes));
#pragma GCC unroll 4
    for (std::size_t half = n_lanes / 2; half > 0; half /= 2)
#pragma GCC unroll 8
      for (std::size_t i = 0; i < half; ++i)
        lanes[i] = join(lanes[i], lanes[i + half]);
    return lanes[0];
  }

  /// Adds sums in single precision.
  [[gnu::always_inline]] void add(const Lanes<bytes, float>& sums) {
    std::array<float, n_lanes> narrow;
    std::memcpy(narrow.data(), sums.parts.data(), sizeof(narrow));
    for (std::size_t part = 0; part < parts.size(); ++part) {
      typename Pack::Reals wide;
      Pack::template convert<Real>(narrow.data() + part * Pack::width, wide);
      parts[part] += wide;
    }
  }

  std::array<typename Pack::Reals, n_lanes / Pack::width> parts{};
};

/// Calls do_pack(node, part) for each vector of the nodes of a block, with the
/// part of the lanes that they belong to.
template <class Pack, class DoPack>
[[gnu::always_inline]] inline void each_pack(const DoPack& do_pack) {
  for (std::size_t k = 0; k < block_nodes; k += n_lanes)
#pragma GCC unroll 8
    for (std::size_t part = 0; part < n_lanes / Pack::width; ++part)
      do_pack(k + part * Pack::width, part);
}

/// Calls do_block(fields, first node of the block in them, block, weights from
/// this node on).
template <class DoBlock>
[[gnu::always_inline]] inline void each_node_block(const NodeFields& fields,
                                                   const DoBlock& do_block) {
  const std::size_t whole = fields.nodes / block_nodes;
  if (fields.weight == nullptr)
    for (std::size_t block = 0; block < whole; ++block)
      do_block(fields, block * block_nodes, block, EqualWeights());
  else
    for (std::size_t block = 0; block < whole; ++block)
      do_block(fields, block * block_nodes, block,
               fields.weight + block * block_nodes);
  if (fields.nodes % block_nodes == 0)
    return;
  const NodeFields part = fields.at(whole * block_nodes, fields.nodes);
  PaddedBlock last(part);
  do_block(last.fields(), 0, whole, last.fields().weight);
  last.copy_back(part);
}

} // namespace asperity::contact
