#pragma once

// The product of the cell matrices of a row with a vector, many cells at a
// time.

#include <cstddef>

namespace asperity::fem {

/// A row of cells along x and the nodes around them.
template <class Number>
struct RowProduct {
  const Number* from = nullptr; ///< the row's first node, with images
  Number* to = nullptr;         ///< the same node; sums are added here
  std::size_t stride = 0, row_size = 0, slice_size = 0; ///< of NodeLayout
  std::size_t cells = 0;
  /// Blocks of ParitySlots: of the layer's cells up to a factor; or, if
  /// `shear` is set, of lambda = 1 and then of mu = 1.
  const Number* blocks = nullptr;
  /// Factor of each cell, or its lambda; zeros follow up to a multiple of
  /// most_lanes.
  const Number* factor = nullptr;
  const Number* shear = nullptr; ///< mu of each cell; null if not needed
  Number scale = Number(1);      ///< of the product
};

/// The largest number of cells that are treated at a time.
inline constexpr std::size_t most_lanes = 16;

/// Adds `scale` K `from` to `to` for the cells of a row. The fastest
/// instructions of this processor are used; the result depends on them only by
/// rounding.
void multiply_row(int degree, const RowProduct<float>& row);
void multiply_row(int degree, const RowProduct<double>& row);

} // namespace asperity::fem
