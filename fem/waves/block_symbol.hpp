#pragma once

// The symbols of all layers of a laterally uniform block at four wavevectors:
// three for each material, whatever the number of its layers.

#include "fem/waves/cell_stiffness.hpp"
#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/simd_batch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity::fem {

/// Unknowns of a node plane at one wavevector, in the order (node class,
/// component) with index 3 node_class + c. The node classes of a surface are
/// those of the parity (a, b) of their place, with index a + 2 b.
constexpr std::size_t plane_unknowns(std::size_t degree) {
  return 3 * degree * degree;
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

/// The entries of a symbol depend on the thickness t of the layer as
/// A/t + B + C t, because lateral derivatives are independent of t and vertical
/// ones proportional to 1/t.
class BlockSymbol {
public:
  /// @param grid    grid of the nodes of the contact surface
  /// @param degree  1 or 2
  /// @param packs   size of the layout
  BlockSymbol(const Grid& grid, int degree, const LayeredBlock& block,
              std::size_t packs, LayerSymbol::Layout layout);

  std::size_t layers() const { return layers_.size(); }

  /// Whether the layer is the one at the far boundary.
  bool is_last(std::size_t layer) const { return layer + 1 == layers_.size(); }

  /// The symbols of the materials at four wavevectors.
  /// @param theta_x, theta_y  q times the node spacing, one wavevector per lane
  SimdBatches at(const SimdBatch& theta_x, const SimdBatch& theta_y) const;

  /// Evaluates a layer. Inlined so that it is compiled for the same processor
  /// as its caller.
  /// @param materials  the result of at()
  /// @param symbol     as many packs as the layout has, overwritten [N/m]
  [[gnu::always_inline]] void evaluate(std::size_t layer,
                                       const SimdBatch* materials,
                                       SimdBatch* symbol) const {
    const double stretch = layers_[layer].stretch;
    const double inverse = 1.0 / stretch;
    const SimdBatch* const growing =
        materials + layers_[layer].material * 3 * packs_;
    const SimdBatch* const falling = growing + packs_;
    const SimdBatch* const constant = falling + packs_;
    for (std::size_t i = 0; i < packs_; ++i)
      symbol[i] = growing[i] * stretch + falling[i] * inverse + constant[i];
  }

private:
  struct Layer {
    std::size_t material;
    double stretch; ///< thickness relative to that of the material's symbols
  };

  std::size_t packs_;
  std::vector<Layer> layers_;
  /// Of each material the symbols proportional to t, to 1/t and constant.
  std::vector<LayerSymbol> symbols_;
};

} // namespace asperity::fem
