// The rows of [material] and of heterogeneous blocks: layers, inclusion and
// variation.
#include "input/reader/bound_key.hpp"
#include "mechanics/limits.hpp"

namespace asperity::cases {
namespace {

using mechanics::BodyModuli;
using mechanics::MaterialLayer;
using mechanics::VariationKind;
using Inclusion = mechanics::MaterialInclusion;
using Variation = mechanics::MaterialVariation;
using Material = mechanics::MaterialSpec;

Key youngs_modulus_key(Given given = needed("2 GPa")) {
  return key<&BodyModuli::youngs_modulus>("youngs_modulus", Dimension::pressure,
                                          "Young's modulus E.",
                                          std::move(given));
}

template <auto member = &BodyModuli::poisson_ratio>
Key poisson_ratio_key(Given given = needed("0.3")) {
  return key<member>("poisson_ratio",
                     between(mechanics::lowest_poisson_ratio,
                             mechanics::highest_poisson_ratio),
                     "Poisson's ratio nu.", std::move(given));
}

Table material_table() {
  return {
      .name = "material",
      .when = "Always needed.",
      .description = "The elastic block.",
      .keys = hidden({
          youngs_modulus_key(
              needed("2 GPa", "this with poisson_ratio, or contact_modulus"))
              .shown(),
          poisson_ratio_key<&Material::poisson_ratio>(
              needed("0.3", "with youngs_modulus, [fem] or a finite thickness"))
              .shown(),
          key<&Material::contact_modulus>(
              "contact_modulus", Dimension::pressure,
              "E* = E / (1 - nu^2), the unit \"E*\" of this file.",
              needed("2 GPa", "this, or youngs_modulus with poisson_ratio")),
          key("layers", ValueType::layers,
              "Bonded layers of other moduli, listed from the contact surface "
              "down. The block below them has the moduli of this table, and "
              "these define E* in every case. The methods halfspace and fem "
              "take the layers into account.",
              eg("[{ thickness = \"0.05 length\", youngs_modulus = \"20 GPa\", "
                 "poisson_ratio = 0.2 }]",
                 "default: none")),
      })};
}

Table counter_table() {
  return {.name = "material.counter",
          .when = "Optional, with youngs_modulus in [material].",
          .description =
              "A second elastic body; without it the surface is rigid. 1/E* is "
              "the sum of (1 - nu^2)/E of both bodies. One block with this E* "
              "and the first body's nu represents both, which is exact for "
              "thick bodies; [fem] with bodies = 2 meshes both.",
          .keys = {youngs_modulus_key(), poisson_ratio_key<>()}};
}

Table layer_table() {
  return {.name = "material.layer",
          .when = "An entry of material.layers.",
          .is_part = true,
          .description = "One bonded layer.",
          .keys = {key<&MaterialLayer::thickness>("thickness", by_the_grid(),
                                                  "Thickness of the layer.",
                                                  needed("0.05 length")),
                   youngs_modulus_key(), poisson_ratio_key<>()}};
}

Table inclusion_table() {
  return {
      .name = "material.inclusion",
      .when = "Optional; only the full 3-D block ([fem] with solver = "
              "\"full\") takes it into account.",
      .description =
          "A sphere of other moduli below the centre of the contact surface.",
      .keys = {key<&Inclusion::radius>("radius", by_the_grid(),
                                       "Radius of the sphere.",
                                       needed("0.1 length")),
               key<&Inclusion::depth>("depth", by_the_grid(),
                                      "Depth of its centre below the contact "
                                      "surface, larger than the radius.",
                                      needed("0.2 length")),
               youngs_modulus_key(), poisson_ratio_key<>()}};
}

template <VariationKind kind>
Key if_kind(Key key) {
  return where<Variation>(
      [](const Variation& variation) { return variation.kind == kind; },
      std::move(key));
}

Table variation_table() {
  return {
      .name = "material.variation",
      .when = "Optional; only the full 3-D block ([fem] with solver = "
              "\"full\") takes it into account.",
      .description = "Young's modulus times a factor that varies from cell to "
                     "cell; nu is constant.",
      .keys = {
          key<&Variation::kind>("kind", {"function", "random", "table"},
                                "Source of the factor.", needed("random")),
          if_kind<VariationKind::function>(key<&Variation::factor>(
              "factor", ValueType::text,
              "An expression (muParser) of x, y and z, each divided by length; "
              "z = 0 is the contact surface.",
              needed("1 + 0.5 * sin(2 * _pi * x) * exp(-z / 0.1)",
                     "with kind = \"function\""))),
          if_kind<VariationKind::random>(key<&Variation::spread>(
              "spread", Range{0.0, mechanics::largest_spread, false, true},
              "The factors are uniform between 1 - spread and 1 + spread.",
              needed("0.5", "with kind = \"random\""))),
          if_kind<VariationKind::random>(
              key<&Variation::seed>("seed", between(0, 2147483647),
                                    "Seed of the factors, which depend on the "
                                    "positions of the cells.",
                                    needed("1", "with kind = \"random\""))),
          if_kind<VariationKind::random>(key<&Variation::edge>(
              "edge", by_the_grid(),
              "With random: edge of the cubes that share a factor. Without it "
              "each cell has its own.",
              eg("8 h"))),
          if_kind<VariationKind::table>(key<&Variation::file>(
              "file", ValueType::path,
              "Table of equal boxes that fill the block: a first line `# boxes "
              "nx ny nz`, then ny nz rows of nx factors, with y varying after "
              "x and z last; the boxes at the contact surface come first.",
              needed("factors.txt", "with kind = \"table\""))),
      }};
}

} // namespace

std::vector<Table> block_tables() {
  std::vector<Table> tables{material_table(), counter_table(), layer_table(),
                            inclusion_table(), variation_table()};
  for (Table& table : mesh_tables())
    tables.push_back(std::move(table));
  return tables;
}

} // namespace asperity::cases
