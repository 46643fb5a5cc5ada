#include "fem/waves/elastic_layers.hpp"

#include "base/refused_argument.hpp"
#include "base/require.hpp"
#include "mechanics/limits.hpp"

namespace asperity::fem {

ElasticLayer elastic_layer(double thickness, double youngs_modulus,
                           double poisson_ratio) {
  require_positive("thickness", thickness, "m");
  require_positive("youngs_modulus", youngs_modulus, "Pa");
  require_between("poisson_ratio", poisson_ratio,
                  mechanics::lowest_poisson_ratio,
                  mechanics::highest_poisson_ratio, "1");
  const double shear = youngs_modulus / (2.0 * (1.0 + poisson_ratio));
  return {thickness, 2.0 * shear * poisson_ratio / (1.0 - 2.0 * poisson_ratio),
          shear};
}

LayeredBlock homogeneous_block(std::span<const double> thickness,
                               double youngs_modulus, double poisson_ratio,
                               mechanics::FarBoundary far_boundary) {
  LayeredBlock block;
  block.far_boundary = far_boundary;
  for (const double layer : thickness)
    block.layers.push_back(elastic_layer(layer, youngs_modulus, poisson_ratio));
  require_block(block);
  return block;
}

LayeredBlock bonded_block(std::span<const double> thickness,
                          std::span<const double> interfaces,
                          std::span<const mechanics::BodyModuli> moduli,
                          mechanics::FarBoundary far_boundary) {
  if (moduli.size() != interfaces.size() + 1)
    refuse_argument("moduli.size()", static_cast<double>(moduli.size()),
                    "one more than the number of interfaces");
  LayeredBlock block;
  block.far_boundary = far_boundary;
  double depth = 0.0;
  std::size_t material = 0;
  for (const double layer : thickness) {
    while (material < interfaces.size() &&
           depth + 0.5 * layer > interfaces[material])
      ++material;
    block.layers.push_back(elastic_layer(layer, moduli[material].youngs_modulus,
                                         moduli[material].poisson_ratio));
    depth += layer;
  }
  require_block(block);
  return block;
}

void require_block(const LayeredBlock& block) {
  if (block.layers.empty())
    refuse_argument("layers", 0.0, "at least one");
  for (const ElasticLayer& layer : block.layers) {
    require_positive("thickness", layer.thickness, "m");
    require_positive("shear_modulus", layer.shear_modulus, "Pa");
    require_positive("bulk modulus, lame_modulus + 2/3 shear_modulus",
                     layer.lame_modulus + 2.0 / 3.0 * layer.shear_modulus,
                     "Pa");
  }
}

void require_cells(const Grid& grid, int nodes_per_cell) {
  require_positive("length_x", grid.length_x, "m");
  require_positive("length_y", grid.length_y, "m");
  const int fewest = 2 * nodes_per_cell;
  for (const int points : {grid.points_x, grid.points_y})
    if (points < fewest || points % nodes_per_cell != 0)
      refuse_argument(Argument{"points", "surface.points"}, points,
                      "a multiple of " + std::to_string(nodes_per_cell) +
                          " and at least " + std::to_string(fewest));
}

} // namespace asperity::fem
