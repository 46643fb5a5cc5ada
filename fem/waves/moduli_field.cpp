#include "fem/waves/moduli_field.hpp"

#include "base/refused_argument.hpp"
#include "base/require.hpp"
#include "meshes/facets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace asperity::fem {

Moduli moduli(const mechanics::BodyModuli& body) {
  const ElasticLayer layer =
      elastic_layer(1.0, body.youngs_modulus, body.poisson_ratio);
  return {layer.lame_modulus, layer.shear_modulus};
}

ModuliField::ModuliField(const LayeredBlock& block) {
  require_block(block);
  for (const ElasticLayer& layer : block.layers)
    add_layer(layer.thickness, {layer.lame_modulus, layer.shear_modulus});
  rest_ = layers_.back().moduli;
}

void ModuliField::add_layer(double thickness, const Moduli& layer) {
  require_positive("thickness", thickness, "m");
  const double below = layers_.empty() ? 0.0 : layers_.back().upper_side;
  layers_.push_back({below + thickness, layer});
}

void ModuliField::set_sphere(const meshes::Place& centre, double radius,
                             const Moduli& sphere) {
  require_positive("radius", radius, "m");
  sphere_ = Sphere{centre, radius, sphere};
}

Moduli ModuliField::without_factor(const meshes::Place& place) const {
  if (sphere_ &&
      std::hypot(place[0] - sphere_->centre[0], place[1] - sphere_->centre[1],
                 place[2] - sphere_->centre[2]) < sphere_->radius)
    return sphere_->moduli;
  for (const Layer& layer : layers_)
    if (place[2] < layer.upper_side)
      return layer.moduli;
  return rest_;
}

std::vector<double> ModuliField::interfaces() const {
  std::vector<double> depths;
  for (const Layer& layer : layers_)
    depths.push_back(layer.upper_side);
  return depths;
}

double ModuliField::factor(const meshes::Place& place) const {
  if (!factor_)
    return 1.0;
  const double factor = factor_(place);
  if (!std::isfinite(factor) || factor <= 0.0)
    throw RefusedArgument("material.variation: factor of the modulus at " +
                              meshes::place_text(place),
                          factor, "finite and > 0 [1]",
                          "material.variation.factor");
  return factor;
}

Moduli ModuliField::at(const meshes::Place& place) const {
  Moduli found = without_factor(place);
  const double factor = this->factor(place);
  found.lame_modulus *= factor;
  found.shear_modulus *= factor;
  return found;
}

namespace {

/// Adds the sphere below the centre of the contact surface. A sphere outside of
/// the block would leave it uniform.
void add_inclusion(const mechanics::MaterialInclusion& inclusion,
                   const mechanics::Scales& scales, const Grid& grid,
                   double depth, ModuliField& field) {
  const double centre = inclusion.depth.in_si(scales);
  const double radius = inclusion.radius.in_si(scales);
  if (!(centre > radius && centre - radius < depth))
    refuse_argument("material.inclusion.depth", centre,
                    fmt::format("larger than the radius, {} m, and less than "
                                "{} m, where it lies below the block",
                                number_text(radius),
                                number_text(depth + radius, centre, 6)));
  field.set_sphere({grid.length_x / 2.0, grid.length_y / 2.0, centre}, radius,
                   moduli(inclusion.moduli));
}

} // namespace

ModuliField moduli_field(const mechanics::MaterialSpec& material,
                         const mechanics::Scales& scales,
                         const mechanics::BodyModuli& block, const Grid& grid,
                         double depth) {
  ModuliField field(moduli(block));
  for (const mechanics::MaterialLayer& layer : material.layers)
    field.add_layer(layer.thickness.in_si(scales), moduli(layer.moduli));
  if (material.inclusion)
    add_inclusion(*material.inclusion, scales, grid, depth, field);
  if (!material.variation)
    return field;
  const mechanics::MaterialVariation& variation = *material.variation;
  switch (variation.kind) {
  case mechanics::VariationKind::function:
    field.set_factor(expression_factor(variation.factor, grid.length_x));
    break;
  case mechanics::VariationKind::random:
    if (variation.edge) {
      const double edge = variation.edge->in_si(scales);
      field.set_factor(random_cubes(variation.spread, variation.seed, edge),
                       edge);
    } else {
      field.set_factor(
          random_factor(variation.spread, variation.seed, grid.spacing_x()));
    }
    break;
  case mechanics::VariationKind::table: {
    FactorTable table = read_factor_table(
        variation.file, {grid.length_x, grid.length_y, depth});
    const double least = std::min({table.lengths[0] / table.boxes[0],
                                   table.lengths[1] / table.boxes[1],
                                   table.lengths[2] / table.boxes[2]});
    field.set_factor(table_factor(std::move(table)), least);
    break;
  }
  }
  return field;
}

} // namespace asperity::fem
