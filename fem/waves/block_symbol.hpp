#pragma once

// The symbols of all layers of a laterally uniform block at four wavevectors:
// three for each material, whatever the number of its layers.

#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/layer_symbol.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

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
  std::vector<SimdBatch> at(const SimdBatch& theta_x,
                            const SimdBatch& theta_y) const;

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
