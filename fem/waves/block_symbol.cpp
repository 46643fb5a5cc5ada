#include "fem/waves/block_symbol.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

/// Splits the entries of a cell matrix by their dependence on the thickness t:
/// those between u_z and lateral components are constant, the others
/// C t + A/t.
struct ThicknessParts {
  CellStiffness growing, falling, constant; ///< at the thickness of `layer`

  ThicknessParts(const Grid& grid, int degree, ElasticLayer layer) {
    const double dx = degree * grid.spacing_x(), dy = degree * grid.spacing_y();
    growing = falling = constant = cell_stiffness(degree, dx, dy, layer);
    layer.thickness *= 2.0;
    const CellStiffness doubled = cell_stiffness(degree, dx, dy, layer);
    const std::size_t size = growing.size();
    for (std::size_t i = 0; i < size * size; ++i) {
      const double single = constant.entries[i];
      if ((i / size % 3 == 2) != (i % size % 3 == 2)) {
        growing.entries[i] = falling.entries[i] = 0.0;
        continue;
      }
      growing.entries[i] = (2.0 * doubled.entries[i] - single) / 3.0;
      falling.entries[i] = single - growing.entries[i];
      constant.entries[i] = 0.0;
    }
  }
};

bool is_same_material(const ElasticLayer& a, const ElasticLayer& b) {
  return a.lame_modulus == b.lame_modulus && a.shear_modulus == b.shear_modulus;
}

} // namespace

BlockSymbol::BlockSymbol(const Grid& grid, int degree,
                         const LayeredBlock& block, std::size_t packs,
                         LayerSymbol::Layout layout)
    : packs_(packs) {
  const double thickness = degree * grid.spacing_x();
  std::vector<ElasticLayer> materials;
  for (const ElasticLayer& layer : block.layers) {
    const auto same = std::find_if(materials.begin(), materials.end(),
                                   [&](const ElasticLayer& material) {
                                     return is_same_material(material, layer);
                                   });
    layers_.push_back({static_cast<std::size_t>(same - materials.begin()),
                       layer.thickness / thickness});
    if (same != materials.end())
      continue;
    materials.push_back({thickness, layer.lame_modulus, layer.shear_modulus});
    const ThicknessParts parts(grid, degree, materials.back());
    for (const CellStiffness* part :
         {&parts.growing, &parts.falling, &parts.constant})
      symbols_.emplace_back(*part, packs, layout);
  }
}

std::vector<SimdBatch> BlockSymbol::at(const SimdBatch& theta_x,
                                       const SimdBatch& theta_y) const {
  const WaveProducts products(theta_x, theta_y);
  std::vector<SimdBatch> materials(symbols_.size() * packs_);
  for (std::size_t i = 0; i < symbols_.size(); ++i)
    symbols_[i].evaluate(products, &materials[i * packs_]);
  return materials;
}

} // namespace asperity::fem
