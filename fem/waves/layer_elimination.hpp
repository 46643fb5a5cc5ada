#pragma once

// Elimination of the layers of a laterally uniform block from the far boundary
// down to the contact surface, for four wavevectors at a time.

#include "fem/waves/block_symbol.hpp"
#include "fem/waves/simd_batch.hpp"
#include "mechanics/far_boundary.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace asperity::fem {

/// Whether the far boundary fixes component 0..2 of the displacement to 0.
inline bool holds(mechanics::FarBoundary far_boundary, std::size_t component) {
  return far_boundary == mechanics::FarBoundary::clamped ||
         (far_boundary == mechanics::FarBoundary::sliding && component == 2);
}

/// The elimination of one layer with cells of a degree. For layer l, b denotes
/// the plane below it and g all other planes up to its top:
///
///     G_l = S_gg + T_(l+1) on its top plane = L D L^T,                 (L.1)
///     R_l = L^-1 S_gb,   T_l = S_bb - R_l^T D^-1 R_l.
///
/// T is 0 above a free far boundary; components held on the far boundary have
/// rows of the identity.
template <std::size_t degree>
struct LayerElimination {
  static constexpr std::size_t n_classes = node_classes_of(degree);
  static constexpr std::size_t plane = plane_unknowns(degree);
  static constexpr std::size_t group = layer_unknowns(degree);

  /// The layout of a symbol: S_bb and S_gg as lower triangles by columns, then
  /// S_gb by rows.
  static constexpr std::size_t first_gg = triangle(plane);
  static constexpr std::size_t first_gb = first_gg + triangle(group);
  static constexpr std::size_t packs = first_gb + group * plane;

  static LayerSymbol::Target layout(std::size_t row, std::size_t column) {
    if (row < column)
      return {};
    if (row < plane)
      return {in_triangle(plane, row, column)};
    if (column >= plane)
      return {first_gg + in_triangle(group, row - plane, column - plane)};
    return {first_gb + (row - plane) * plane + column};
  }

  /// Applies (L.1): T_(l+1) in `stiffness` becomes T_l, and S_gg and S_gb
  /// become L with 1/D on its diagonal, and R_l.
  /// @param far_boundary  the boundary at the top of this layer, or null
  /// @param spring        on the uniform modes of its free components [N/m]
  static void take_layer(SimdBatch* symbol,
                         const mechanics::FarBoundary* far_boundary,
                         const SimdBatch& spring, SimdBatch* stiffness) {
    SimdBatch* const matrix = symbol + first_gg;
    SimdBatch* const to_lower = symbol + first_gb;
    constexpr std::size_t top_plane = group - plane;
    for (std::size_t j = 0; j < plane; ++j)
      for (std::size_t i = j; i < plane; ++i)
        matrix[in_triangle(group, top_plane + i, top_plane + j)] +=
            stiffness[in_triangle(plane, i, j)];
    if (far_boundary)
      hold_far_boundary(*far_boundary, spring, matrix, to_lower);
    factorise<group>(matrix);
    solve_lower<group, plane>(matrix, to_lower);
    std::copy_n(symbol, triangle(plane), stiffness);
    take_schur<group, plane>(matrix, to_lower, stiffness);
  }

  /// Computes (T_0^-1)_zz over the node classes from the factor of T_0.
  /// @param block  node_classes^2 packs, all entries [m/N]
  static void face_compliance(const SimdBatch* factor, SimdBatch* block) {
    std::array<SimdBatch, plane * n_classes> load{};
    for (std::size_t node_class = 0; node_class < n_classes; ++node_class)
      load[(3 * node_class + 2) * n_classes + node_class] += 1.0;
    solve_lower<plane, n_classes>(factor, load.data());
    for (std::size_t i = 0; i < n_classes; ++i)
      for (std::size_t j = 0; j < n_classes; ++j) {
        block[i * n_classes + j] = SimdBatch{};
        for (std::size_t k = 0; k < plane; ++k)
          block[i * n_classes + j] += load[k * n_classes + i] *
                                      load[k * n_classes + j] *
                                      factor[in_triangle(plane, k, k)];
      }
  }

private:
  static void hold_far_boundary(mechanics::FarBoundary far_boundary,
                                const SimdBatch& spring, SimdBatch* matrix,
                                SimdBatch* to_lower) {
    constexpr std::size_t top_plane = group - plane;
    for (std::size_t row = top_plane; row < group; ++row) {
      const std::size_t component = row % 3;
      if (holds(far_boundary, component)) {
        for (std::size_t j = 0; j < group; ++j)
          matrix[in_triangle(group, std::max(row, j), std::min(row, j))] =
              SimdBatch{};
        matrix[in_triangle(group, row, row)] += 1.0;
        std::fill_n(to_lower + row * plane, plane, SimdBatch{});
        continue;
      }
      for (std::size_t column = top_plane + component; column <= row;
           column += 3)
        matrix[in_triangle(group, row, column)] += spring;
    }
  }
};

} // namespace asperity::fem
