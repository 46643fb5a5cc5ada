#pragma once

// The product of the cell matrices of one layer with a vector, many cells at a
// time.

#include <cstddef>

namespace asperity::fem {

/// Cells of one layer and the planes of nodes around them.
template <class Number>
struct LayerProduct {
  const Number* from = nullptr; ///< the layer's first plane, with images
  Number* to = nullptr;         ///< the same plane; sums are added here
  std::size_t stride = 0, row_size = 0, plane_size = 0; ///< of NodeLayout
  std::size_t cells_x = 0, cells_y = 0;
  /// Blocks of ParitySlots: of the layer's cells up to a factor; or, if
  /// `shear` is set, of lambda = 1 and then of mu = 1.
  const Number* blocks = nullptr;
  /// Factor of each cell, or its lambda, in rows that end with zeros up to a
  /// multiple of most_lanes.
  const Number* factor = nullptr;
  const Number* shear = nullptr; ///< mu of each cell; null if not needed
  std::size_t factor_row = 0;    ///< from row to row; 0 if all are equal
};

/// The largest number of cells that are treated at a time.
inline constexpr std::size_t most_lanes = 16;

/// Adds K `from` to `to` for the cells of a layer. The fastest instructions of
/// this processor are used; the result depends on them only by rounding.
void multiply_layer(int degree, const LayerProduct<float>& layer);
void multiply_layer(int degree, const LayerProduct<double>& layer);

} // namespace asperity::fem
