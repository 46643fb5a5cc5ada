#pragma once

// Small dense linear algebra for four wavevectors at a time, on packs of
// numbers that the compiler maps to SIMD vectors. Loops over wavevectors are
// elsewhere.

#include "base/simd_pack.hpp"

#include <boost/align/aligned_allocator.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace asperity::fem {

/// Number of wavevectors in a pack, one per lane.
constexpr std::size_t lanes = 4;

/// A SIMD batch that holds one number for each wavevector; + - * / act on every
/// lane.
using SimdBatch = SimdPack<double, lanes * sizeof(double)>::Type;

/// Many of them. The alignment of the type, as std::allocator knows it, is that
/// of the processor for which the program is compiled, and may be smaller than
/// that of the processor for which a loop is.
using SimdBatches = std::vector<SimdBatch, boost::alignment::aligned_allocator<
                                               SimdBatch, sizeof(SimdBatch)>>;

/// Number of entries in the lower triangle of a symmetric n x n matrix.
constexpr std::size_t triangle(std::size_t n) {
  return n * (n + 1) / 2;
}

/// Index of the entry (row, column) of the lower triangle, stored by columns.
constexpr std::size_t in_triangle(std::size_t n, std::size_t row,
                                  std::size_t column) {
  return column * n - column * (column + 1) / 2 + row;
}

// The functions below are always inlined so that they are compiled for the same
// processor as their caller.

/// Factorises A = L D L^T in place: the result is L below the diagonal and 1/D
/// on it. No square roots are taken, so scaling by powers of two is exact to
/// the last bit.
template <std::size_t n>
[[gnu::always_inline]] inline void factorise(SimdBatch* a) {
  for (std::size_t k = 0; k < n; ++k) {
    SimdBatch* const from = a + in_triangle(n, 0, k);
    const SimdBatch inverse = 1.0 / from[k];
    for (std::size_t j = k + 1; j < n; ++j) {
      SimdBatch* const to = a + in_triangle(n, 0, j);
      const SimdBatch factor = from[j] * inverse;
      for (std::size_t i = j; i < n; ++i)
        to[i] -= from[i] * factor;
    }
    from[k] = inverse;
    for (std::size_t i = k + 1; i < n; ++i)
      from[i] *= inverse;
  }
}

/// Computes values = L^-1 values, n rows of m columns, stored by rows.
template <std::size_t n, std::size_t m>
[[gnu::always_inline]] inline void solve_lower(const SimdBatch* factor,
                                               SimdBatch* values) {
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const SimdBatch* const column = factor + in_triangle(n, 0, k);
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j)
        values[i * m + j] -= column[i] * values[k * m + j];
  }
}

/// Computes a -= R^T D^-1 R on the lower triangle of the m x m matrix a, where
/// R has n rows and m columns and D is that of the factor.
template <std::size_t n, std::size_t m>
[[gnu::always_inline]] inline void
take_schur(const SimdBatch* factor, const SimdBatch* rows, SimdBatch* a) {
  for (std::size_t k = 0; k < n; ++k) {
    const SimdBatch* const row = rows + k * m;
    const SimdBatch inverse = factor[in_triangle(n, k, k)];
    for (std::size_t j = 0; j < m; ++j) {
      const SimdBatch scaled = row[j] * inverse;
      SimdBatch* const to = a + in_triangle(m, 0, j);
      for (std::size_t i = j; i < m; ++i)
        to[i] -= row[i] * scaled;
    }
  }
}

} // namespace asperity::fem
