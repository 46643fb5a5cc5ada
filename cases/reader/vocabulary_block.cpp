// The rows of [material] and of heterogeneous blocks: layers, inclusion and
// variation.
#include "cases/reader/vocabulary.hpp"
#include "mechanics/limits.hpp"

namespace asperity::cases {
namespace {

Key youngs_modulus_key() {
  return {.name = "youngs_modulus",
          .dimension = Dimension::pressure,
          .range = positive(),
          .need = Need::always,
          .example = "\"2 GPa\"",
          .show = Show::no,
          .description = "Young's modulus E."};
}

Key poisson_ratio_key() {
  return {.name = "poisson_ratio",
          .range = between(mechanics::lowest_poisson_ratio,
                           mechanics::highest_poisson_ratio),
          .need = Need::always,
          .example = "0.3",
          .show = Show::no,
          .description = "Poisson's ratio nu."};
}

Table material_table() {
  Key modulus = youngs_modulus_key();
  modulus.need = Need::conditional;
  modulus.when = "this with poisson_ratio, or contact_modulus";
  modulus.show = Show::yes;
  Key ratio = poisson_ratio_key();
  ratio.need = Need::conditional;
  ratio.when = "with youngs_modulus, [fem] or a finite thickness";
  ratio.show = Show::yes;
  return {
      .name = "material",
      .when = "Always needed.",
      .description = "The elastic block.",
      .keys = {
          modulus,
          ratio,
          {.name = "contact_modulus",
           .dimension = Dimension::pressure,
           .range = positive(),
           .need = Need::conditional,
           .when = "this, or youngs_modulus with poisson_ratio",
           .example = "\"2 GPa\"",
           .show = Show::no,
           .description = "E* = E / (1 - nu^2), the unit \"E*\" of this file."},
          {.name = "layers",
           .type = ValueType::layers,
           .when = "default: none",
           .example = "[{ thickness = \"0.05 length\", youngs_modulus = "
                      "\"20 GPa\", poisson_ratio = 0.2 }]",
           .show = Show::no,
           .description =
               "Bonded layers of other moduli, listed from the contact surface "
               "down. The block below them has the moduli of this table, and "
               "these define E* in every case. The methods halfspace and fem "
               "take the layers into account."},
      }};
}

Table counter_table() {
  return {.name = "material.counter",
          .when = "Optional, with youngs_modulus in [material].",
          .description =
              "A second elastic body; without it the surface is rigid. 1/E* is "
              "the sum of (1 - nu^2)/E of both bodies. One block with this E* "
              "and the first body's nu represents both, which is exact for "
              "thick bodies; [fem] with bodies = 2 meshes both.",
          .keys = {youngs_modulus_key(), poisson_ratio_key()}};
}

Table layer_table() {
  return {.name = "material.layer",
          .when = "An entry of material.layers.",
          .is_part = true,
          .description = "One bonded layer.",
          .keys = {length_key("thickness", "\"0.05 length\"",
                              "Thickness of the layer."),
                   youngs_modulus_key(), poisson_ratio_key()}};
}

Table inclusion_table() {
  return {
      .name = "material.inclusion",
      .when = "Optional; only the full 3-D block ([fem] with solver = "
              "\"full\") takes it into account.",
      .description =
          "A sphere of other moduli below the centre of the contact surface.",
      .keys = {length_key("radius", "\"0.1 length\"", "Radius of the sphere."),
               length_key("depth", "\"0.2 length\"",
                          "Depth of its centre below the contact surface, "
                          "larger than the radius."),
               youngs_modulus_key(), poisson_ratio_key()}};
}

Key edge_key() {
  Key key = length_key("edge", "\"8 h\"",
                       "With random: edge of the cubes that share a factor. "
                       "Without it each cell has its own.");
  key.need = Need::never;
  key.show = Show::no;
  return key;
}

Table variation_table() {
  return {
      .name = "material.variation",
      .when = "Optional; only the full 3-D block ([fem] with solver = "
              "\"full\") takes it into account.",
      .description = "Young's modulus times a factor that varies from cell to "
                     "cell; nu is constant.",
      .keys = {
          {.name = "kind",
           .type = ValueType::word,
           .words = {"function", "random", "table"},
           .need = Need::always,
           .example = "\"random\"",
           .show = Show::no,
           .description = "Source of the factor."},
          {.name = "factor",
           .type = ValueType::text,
           .need = Need::conditional,
           .when = "with kind = \"function\"",
           .example = "\"1 + 0.5 * sin(2 * _pi * x) * exp(-z / 0.1)\"",
           .show = Show::no,
           .description = "An expression (muParser) of x, y and z, each "
                          "divided by length; z = 0 is the contact surface."},
          {.name = "spread",
           .range = {0.0, mechanics::largest_spread, false, true},
           .need = Need::conditional,
           .when = "with kind = \"random\"",
           .example = "0.5",
           .show = Show::no,
           .description = "The factors are uniform between 1 - spread and "
                          "1 + spread."},
          {.name = "seed",
           .type = ValueType::integer,
           .range = between(0, 2147483647),
           .need = Need::conditional,
           .when = "with kind = \"random\"",
           .example = "1",
           .show = Show::no,
           .description = "Seed of the factors, which depend on the positions "
                          "of the cells."},
          edge_key(),
          {.name = "file",
           .type = ValueType::path,
           .need = Need::conditional,
           .when = "with kind = \"table\"",
           .example = "\"factors.txt\"",
           .show = Show::no,
           .description = "Table of equal boxes that fill the block: a first "
                          "line `# boxes nx ny nz`, then ny nz rows of nx "
                          "factors, with y varying after x and z last; the "
                          "boxes at the contact surface come first."},
      }};
}

} // namespace

Key length_key(std::string name, std::string example, std::string description) {
  return {.name = std::move(name),
          .dimension = Dimension::length,
          .range = positive(),
          .references = {mechanics::ReferenceUnit::length,
                         mechanics::ReferenceUnit::spacing},
          .need = Need::always,
          .example = std::move(example),
          .show = Show::no,
          .description = std::move(description)};
}

std::vector<Table> block_tables() {
  std::vector<Table> tables{material_table(), counter_table(), layer_table(),
                            inclusion_table(), variation_table()};
  for (Table& table : mesh_tables())
    tables.push_back(std::move(table));
  return tables;
}

namespace {

std::vector<Key> full_block_mesh_keys() {
  return {
      {.name = "mesh",
       .type = ValueType::word,
       .words = {"layers", "case"},
       .when = "with solver = \"full\"; default: the case's [mesh] if it has "
               "one",
       .example = "\"layers\"",
       .show = Show::no,
       .description = "Mesh of the full 3-D block: its own graded layers, or "
                      "the case's [mesh]."},
      {.name = "sides",
       .type = ValueType::word,
       .words = {"periodic", "free"},
       .fallback = "\"periodic\"",
       .example = "\"free\"",
       .show = Show::no,
       .description = "Lateral boundary conditions of the block; free sides "
                      "need solver = \"full\"."},
      {.name = "linear_solver",
       .type = ValueType::word,
       .words = {"auto", "direct", "multigrid", "fourier"},
       .fallback = "\"auto\"",
       .example = "\"fourier\"",
       .show = Show::no,
       .description =
           "With solver = \"full\": direct factorisation, or conjugate "
           "gradients with multigrid or with the condensed block (fourier; "
           "periodic layers only) as preconditioner; auto selects the fastest "
           "that the mesh allows."},
      {.name = "contact_at",
       .type = ValueType::word,
       .words = {"nodes", "gauss"},
       .fallback = "\"nodes\"",
       .example = "\"gauss\"",
       .show = Show::no,
       .description = "With solver = \"full\": points at which the contact law "
                      "is evaluated; Gauss points are not available with hard "
                      "(unilateral) contact."},
      {.name = "height_interpolation",
       .type = ValueType::word,
       .words = {"bicubic", "band-limited", "bilinear"},
       .fallback = "\"bicubic\"",
       .example = "\"band-limited\"",
       .show = Show::no,
       .description =
           "With solver = \"full\": the surface at contact points between the "
           "points of the map, such as Gauss points; band-limited is exact for "
           "waves longer than two spacings, bilinear stays within the heights "
           "around the point."},
  };
}

std::vector<Key> full_block_contact_keys() {
  return {
      {.name = "bodies",
       .type = ValueType::integer,
       .range = between(1, 2),
       .fallback = "1",
       .example = "2",
       .show = Show::no,
       .description =
           "With solver = \"full\": 2 meshes [material.counter] against the "
           "block, with the heights between the two bodies."},
      {.name = "stiffness",
       .type = ValueType::boolean,
       .fallback = "false",
       .example = "true",
       .show = Show::no,
       .description =
           "With solver = \"full\": finds the normal and the tangential "
           "stiffness of the contact after each load step, by one linear "
           "solve per direction; needs top = \"clamped\", contact at nodes "
           "and one body."},
  };
}

} // namespace

std::vector<Key> full_block_keys() {
  std::vector<Key> keys = full_block_mesh_keys();
  append_keys(keys, full_block_contact_keys());
  return keys;
}

} // namespace asperity::cases
