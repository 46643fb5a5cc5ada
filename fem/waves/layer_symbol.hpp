#pragma once

// The symbol of the stiffness of a cell layer: deal.II's cell matrix summed
// with the phases of four lateral wavevectors at a time.

#include "fem/waves/cell_stiffness.hpp"
#include "fem/waves/simd_batch.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace asperity::fem {

/// Number of node classes of a surface, by the parity (a, b) of their place;
/// the index is a + 2 b.
constexpr std::size_t node_classes_of(std::size_t degree) {
  return degree * degree;
}

/// Unknowns of a node plane at one wavevector, in the order (node class,
/// component) with index 3 node_class + c.
constexpr std::size_t plane_unknowns(std::size_t degree) {
  return 3 * node_classes_of(degree);
}

/// Unknowns of a layer without those of its lower plane: `degree` planes.
constexpr std::size_t layer_unknowns(std::size_t degree) {
  return degree * plane_unknowns(degree);
}

/// Products f(theta_x) g(theta_y) of 1, cos, cos 2, sin and sin 2, with f the
/// slower index; theta is q times the node spacing.
struct WaveProducts {
  std::array<SimdBatch, 25> values;

  /// Each lane holds one wavevector.
  WaveProducts(const SimdBatch& theta_x, const SimdBatch& theta_y);
};

/// Entries of S(q), made real by multiplying u_x and u_y by i, in a layout that
/// the caller defines. By the mirror symmetries of the cell each entry needs
/// few products.
class LayerSymbol {
public:
  /// The place and sign with which an entry is stored; it is not stored if
  /// `place` is none.
  struct Target {
    std::size_t place = none;
    double sign = 1.0;
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
  };

  /// Maps an entry (row, column) to its target; row and column are
  /// plane_unknowns * plane + 3 node_class + c, with plane 0..degree from
  /// below.
  using Layout = Target (*)(std::size_t row, std::size_t column);

  /// @param size  size of the layout, in packs
  LayerSymbol(const CellStiffness& cell, std::size_t size, Layout layout);

  /// @param blocks  size() packs, overwritten [N/m]
  void evaluate(const WaveProducts& products, SimdBatch* blocks) const;

private:
  struct Term {
    double amount;
    std::uint16_t target;
    std::uint16_t product;
  };

  std::size_t size_;
  std::vector<Term> terms_; ///< ordered by target
};

} // namespace asperity::fem
