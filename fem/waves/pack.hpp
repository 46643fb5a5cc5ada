#pragma once

// Four wavevectors computed together: small dense algebra on packs of numbers,
// in which the compiler finds the processor's vectors. Owns no loop over waves.

#include <array>
#include <cstddef>

namespace asperity::fem {

/// Wavevectors in a pack, one a lane.
constexpr std::size_t lanes = 4;

/// The same number of each of them: + - * / act on every lane.
using Pack = double __attribute__((vector_size(lanes * sizeof(double))));

/// Numbers in the lower triangle of a symmetric n x n matrix.
constexpr std::size_t triangle(std::size_t n) {
  return n * (n + 1) / 2;
}

/// Where entry (row, column) of the lower triangle lies: column by column.
constexpr std::size_t in_triangle(std::size_t n, std::size_t row,
                                  std::size_t column) {
  return column * n - column * (column + 1) / 2 + row;
}

// Always inlined: compiled for the processor that their caller is compiled for.

/// In place: A = L D L^T becomes L below the diagonal and 1/D on it. Without
/// roots: powers of two pass through to the last bit.
template <std::size_t n>
[[gnu::always_inline]] inline void factorise(Pack* a) {
  for (std::size_t k = 0; k < n; ++k) {
    Pack* const from = a + in_triangle(n, 0, k);
    const Pack inverse = 1.0 / from[k];
    for (std::size_t j = k + 1; j < n; ++j) {
      Pack* const to = a + in_triangle(n, 0, j);
      const Pack factor = from[j] * inverse;
      for (std::size_t i = j; i < n; ++i)
        to[i] -= from[i] * factor;
    }
    from[k] = inverse;
    for (std::size_t i = k + 1; i < n; ++i)
      from[i] *= inverse;
  }
}

/// values = L^-1 values, n rows of m columns, row by row.
template <std::size_t n, std::size_t m>
[[gnu::always_inline]] inline void solve_lower(const Pack* factor,
                                               Pack* values) {
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const Pack* const column = factor + in_triangle(n, 0, k);
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j)
        values[i * m + j] -= column[i] * values[k * m + j];
  }
}

/// values = D^-1 values.
template <std::size_t n, std::size_t m>
[[gnu::always_inline]] inline void solve_diagonal(const Pack* factor,
                                                  Pack* values) {
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < m; ++j)
      values[k * m + j] *= factor[in_triangle(n, k, k)];
}

/// values = L^-T values.
template <std::size_t n, std::size_t m>
[[gnu::always_inline]] inline void solve_upper(const Pack* factor,
                                               Pack* values) {
  for (std::size_t k = n - 1; k-- > 0;) {
    const Pack* const column = factor + in_triangle(n, 0, k);
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j)
        values[k * m + j] -= column[i] * values[i * m + j];
  }
}

/// a -= R^T D^-1 R on the lower triangle of the m x m matrix a, R of n rows
/// and m columns and D the factor's.
template <std::size_t n, std::size_t m>
[[gnu::always_inline]] inline void take_schur(const Pack* factor,
                                              const Pack* rows, Pack* a) {
  for (std::size_t k = 0; k < n; ++k) {
    const Pack* const row = rows + k * m;
    const Pack inverse = factor[in_triangle(n, k, k)];
    for (std::size_t j = 0; j < m; ++j) {
      const Pack scaled = row[j] * inverse;
      Pack* const to = a + in_triangle(m, 0, j);
      for (std::size_t i = j; i < m; ++i)
        to[i] -= row[i] * scaled;
    }
  }
}

} // namespace asperity::fem
