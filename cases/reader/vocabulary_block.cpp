// The rows of [material] and of heterogeneous blocks: layers, inclusion,
// variation and mesh.
#include "cases/reader/vocabulary.hpp"

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
          .range = inside(-1.0, 0.5),
          .need = Need::always,
          .example = "0.3",
          .show = Show::no,
          .description = "Poisson's ratio nu."};
}

/// Returns a key for a length in SI, in multiples of the side length or in node
/// spacings.
Key length_key(std::string name, std::string example, std::string description) {
  return {.name = std::move(name),
          .dimension = Dimension::length,
          .range = positive(),
          .yardsticks = {Yardstick::length, Yardstick::spacing},
          .need = Need::always,
          .example = std::move(example),
          .show = Show::no,
          .description = std::move(description)};
}

/// Returns the same key with a default.
Key length_key_or(std::string fallback, std::string name,
                  std::string description) {
  Key key = length_key(std::move(name), fallback, std::move(description));
  key.need = Need::never;
  key.fallback = std::move(fallback);
  return key;
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
               "Bonded layers of other moduli, the contact face's first; "
               "below them the block is this table's own, and E* is always "
               "its. Half-space and finite elements see them."},
      }};
}

Table counter_table() {
  return {.name = "material.counter",
          .when = "Optional, with youngs_modulus in [material].",
          .description = "A second elastic body; the surface is rigid "
                         "without it. 1/E* is the sum of (1 - nu^2)/E; one "
                         "block with this E* and the first body's nu "
                         "stands for both, exact for thick bodies; [fem] with "
                         "bodies = 2 meshes both.",
          .keys = {youngs_modulus_key(), poisson_ratio_key()}};
}

Table layer_table() {
  return {.name = "material.layer",
          .when = "An entry of material.layers.",
          .is_part = true,
          .description = "One bonded layer.",
          .keys = {length_key("thickness", "\"0.05 length\"", "Of the layer."),
                   youngs_modulus_key(), poisson_ratio_key()}};
}

Table inclusion_table() {
  return {.name = "material.inclusion",
          .when = "Optional; only the whole block ([fem] with solver = "
                  "\"full\") sees it.",
          .description = "A sphere of other moduli under the middle of the "
                         "contact face.",
          .keys = {length_key("radius", "\"0.1 length\"", "Of the sphere."),
                   length_key("depth", "\"0.2 length\"",
                              "Of its centre below the contact face, more than "
                              "the radius."),
                   youngs_modulus_key(), poisson_ratio_key()}};
}

Table variation_table() {
  return {.name = "material.variation",
          .when = "Optional; only the whole block ([fem] with solver = "
                  "\"full\") sees it.",
          .description = "Young's modulus times a factor that varies from "
                         "cell to cell; nu stays.",
          .keys = {
              {.name = "kind",
               .type = ValueType::word,
               .words = {"function", "random", "table"},
               .need = Need::always,
               .example = "\"random\"",
               .show = Show::no,
               .description = "Where the factor comes from."},
              {.name = "factor",
               .type = ValueType::text,
               .need = Need::conditional,
               .when = "with kind = \"function\"",
               .example = "\"1 + 0.5 * sin(2 * _pi * x) * exp(-z / 0.1)\"",
               .show = Show::no,
               .description = "An expression (muParser) of x, y and z, each "
                              "over length; z = 0 is the contact face."},
              {.name = "spread",
               .range = inside(0.0, 1.0),
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
               .description = "Of the factors, which belong to the cells' "
                              "places."},
              {.name = "file",
               .type = ValueType::path,
               .need = Need::conditional,
               .when = "with kind = \"table\"",
               .example = "\"factors.txt\"",
               .show = Show::no,
               .description = "A first line `# boxes nx ny nz`, then ny nz "
                              "rows of nx factors, y after x and z last, those "
                              "of the contact face first: equal boxes of the "
                              "block."},
          }};
}

Table mesh_table() {
  return {
      .name = "mesh",
      .when = "Optional; for [fem] with solver = \"full\", whose layers "
              "(growth, surface_cell_depth) it replaces.",
      .description = "The mesh of the whole block.",
      .keys = {
          {.name = "kind",
           .type = ValueType::word,
           .words = {"layers", "hanging", "gmsh"},
           .need = Need::always,
           .example = "\"gmsh\"",
           .show = Show::no,
           .description = "[fem]'s own graded layers, cubes halved towards "
                          "the face with hanging nodes, or gmsh."},
          {.name = "cells_a_level",
           .type = ValueType::integer,
           .range = between(1, 64),
           .fallback = "4",
           .example = "4",
           .show = Show::no,
           .description = "With hanging: layers of cells between one "
                          "halving and the next."},
          {.name = "geometry",
           .type = ValueType::word,
           .words = {"block", "indentation", "layered", "inclusion", "file"},
           .fallback = "\"block\"",
           .example = "\"indentation\"",
           .show = Show::no,
           .description = "With gmsh: a block graded with depth, one fine "
                          "around the middle of the face, one with "
                          "[material]'s layers or inclusion, or your own."},
          {.name = "cells",
           .type = ValueType::word,
           .words = {"hexahedra", "tetrahedra"},
           .fallback = "\"hexahedra\"",
           .example = "\"tetrahedra\"",
           .show = Show::no,
           .description = "With gmsh."},
          length_key_or("\"1 h\"", "size_at_contact",
                        "With gmsh: edge of a cell where contact is."),
          length_key_or("\"0.1 length\"", "size_far",
                        "With gmsh: edge of a cell far from it."),
          length_key_or("\"0.1 length\"", "fine_radius",
                        "With indentation: of the fine part around the "
                        "middle of the face."),
          {.name = "file",
           .type = ValueType::path,
           .need = Need::conditional,
           .when = "with geometry = \"file\"",
           .example = "\"block.msh\"",
           .show = Show::no,
           .description = "A .msh or .geo that names the physical groups "
                          "contact, fixed and, if it has any, sides."},
          {.name = "file_unit",
           .dimension = Dimension::length,
           .range = positive(),
           .fallback = "1.0",
           .example = "\"1 mm\"",
           .show = Show::no,
           .description = "Length that the number 1 of the file means."},
      }};
}

} // namespace

std::vector<Table> block_tables() {
  return {material_table(),  counter_table(),   layer_table(),
          inclusion_table(), variation_table(), mesh_table()};
}

std::vector<Key> whole_block_keys() {
  return {
      {.name = "mesh",
       .type = ValueType::word,
       .words = {"layers", "case"},
       .when = "with solver = \"full\"; default: the case's [mesh] if it has "
               "one",
       .example = "\"layers\"",
       .show = Show::no,
       .description = "Mesh of the whole block: its own graded layers, or the "
                      "case's [mesh]."},
      {.name = "sides",
       .type = ValueType::word,
       .words = {"periodic", "free"},
       .fallback = "\"periodic\"",
       .example = "\"free\"",
       .show = Show::no,
       .description = "Of the block; free ones only with solver = \"full\"."},
      {.name = "linear_solver",
       .type = ValueType::word,
       .words = {"auto", "direct", "multigrid", "fourier"},
       .fallback = "\"auto\"",
       .example = "\"fourier\"",
       .show = Show::no,
       .description = "With solver = \"full\": factors, conjugate gradients "
                      "with algebraic multigrid, or with the condensed block "
                      "as preconditioner (periodic layers only); auto takes "
                      "the fastest that the mesh allows."},
      {.name = "contact_at",
       .type = ValueType::word,
       .words = {"nodes", "gauss"},
       .fallback = "\"nodes\"",
       .example = "\"gauss\"",
       .show = Show::no,
       .description = "With solver = \"full\": where the law of the interface "
                      "is asked; Gauss points not with a hard wall."},
      {.name = "bodies",
       .type = ValueType::integer,
       .range = between(1, 2),
       .fallback = "1",
       .example = "2",
       .show = Show::no,
       .description = "With solver = \"full\": 2 meshes [material.counter] "
                      "against the block, the heights between them."},
  };
}

} // namespace asperity::cases
