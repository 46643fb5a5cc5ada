// The rows of [mesh].
#include "cases/reader/vocabulary.hpp"

namespace asperity::cases {
namespace {

/// Returns the same key with a default.
Key length_key_or(std::string fallback, std::string name,
                  std::string description) {
  Key key = length_key(std::move(name), fallback, std::move(description));
  key.need = Need::never;
  key.fallback = std::move(fallback);
  return key;
}

std::vector<Key> mesh_kind_keys() {
  return {
      {.name = "kind",
       .type = ValueType::word,
       .words = {"layers", "hanging", "adaptive", "gmsh"},
       .need = Need::always,
       .example = "\"gmsh\"",
       .show = Show::no,
       .description =
           "[fem]'s own graded layers, cubes halved towards the contact "
           "surface with hanging nodes, cubes halved where the solution of "
           "each load step requires it, or a mesh by gmsh."},
      {.name = "cells_a_level",
       .type = ValueType::integer,
       .range = between(1, 64),
       .fallback = "4",
       .example = "4",
       .show = Show::no,
       .description = "With hanging: layers of cells between two "
                      "successive halvings."},
      {.name = "halvings",
       .type = ValueType::integer,
       .range = between(1, 12),
       .fallback = "3",
       .example = "3",
       .show = Show::no,
       .description =
           "With adaptive: how often the coarsest cells are halved at the "
           "contact; the nodes there are then those of the grid. The cells "
           "per side must be divisible by two so many times."},
      {.name = "moduli_ratio",
       .range = between(1, 1000),
       .fallback = "1.25",
       .example = "1.25",
       .show = Show::no,
       .description = "With adaptive: largest ratio of the moduli within a "
                      "cell that need not be halved for it."},
      {.name = "interface_halvings",
       .type = ValueType::integer,
       .range = between(0, 12),
       .example = "2",
       .show = Show::no,
       .description =
           "With adaptive: how often cells with a larger ratio, or at the "
           "surface of the inclusion, are halved. Without it their edge is at "
           "most a quarter of their depth and of the radius."},
  };
}

std::vector<Key> mesh_geometry_keys() {
  return {
      {.name = "geometry",
       .type = ValueType::word,
       .words = {"block", "indentation", "layered", "inclusion", "file"},
       .fallback = "\"block\"",
       .example = "\"indentation\"",
       .show = Show::no,
       .description =
           "With gmsh: a block graded with depth, one refined around the "
           "centre of the contact surface, one with the layers or the "
           "inclusion of [material], or a file of your own."},
      {.name = "cells",
       .type = ValueType::word,
       .words = {"hexahedra", "tetrahedra"},
       .fallback = "\"hexahedra\"",
       .example = "\"tetrahedra\"",
       .show = Show::no,
       .description = "With gmsh: shape of the cells."},
  };
}

std::vector<Key> mesh_size_keys() {
  return {
      length_key_or("\"1 h\"", "size_at_contact",
                    "With gmsh: edge length of a cell in the contact region."),
      length_key_or(
          "\"0.1 length\"", "size_far",
          "With gmsh: edge length of a cell far from the contact region."),
      length_key_or("\"0.1 length\"", "fine_radius",
                    "With indentation: radius of the refined region around "
                    "the centre of the contact surface."),
  };
}

std::vector<Key> mesh_file_keys() {
  return {
      {.name = "file",
       .type = ValueType::path,
       .need = Need::conditional,
       .when = "with geometry = \"file\"",
       .example = "\"block.msh\"",
       .show = Show::no,
       .description =
           "A .msh file ($MeshFormat) or a .geo script of gmsh, with the "
           "physical groups contact, fixed and, if it has any, sides. The "
           "contact surface is a plane rectangle with its edges along x and "
           "y, as large as the surface. A .geo is a program, which runs "
           "confined: see allow_commands."},
      {.name = "file_unit",
       .dimension = Dimension::length,
       .range = positive(),
       .fallback = "1.0",
       .example = "\"1 mm\"",
       .show = Show::no,
       .description = "Length that corresponds to the number 1 in the file."},
      {.name = "allow_commands",
       .type = ValueType::boolean,
       .fallback = "false",
       .example = "true",
       .show = Show::no,
       .description =
           "With a .geo file: allow it to start programs (SystemCall and "
           "others), to write files and to use the network, which is refused "
           "otherwise. Only for files that you trust."},
  };
}

/// Returns a key that is a length along x or y, of either sign.
Key offset_key(std::string name, const std::string& axis) {
  Key key = length_key_or("\"0 length\"", std::move(name),
                          "Distance of the body's axis from the centre of the "
                          "block along " +
                              axis +
                              "; cylinder and cuboid only. The heights of "
                              "[surface] stay where they are.");
  key.range = any_number();
  key.example = "\"0.1 length\"";
  return key;
}

/// Returns a length that has a default in words.
Key optional_length(std::string name, std::string example, std::string when,
                    std::string description) {
  Key key =
      length_key(std::move(name), std::move(example), std::move(description));
  key.need = Need::never;
  key.when = std::move(when);
  return key;
}

Table mesh_counter_table() {
  Key radius = length_key("radius", "\"0.15 length\"",
                          "Radius of the cylinder, half the side of the "
                          "cuboid. A sphere has the radius of [surface].");
  radius.need = Need::conditional;
  radius.when = "with shape = \"cylinder\" or \"cuboid\"";
  return {
      .name = "mesh.counter",
      .when = "Optional; for [fem] with solver = \"full\" and bodies = 2.",
      .description =
          "A counter-body of finite size with free sides and a mesh of "
          "hexahedra of its own. Without this table the counter-body is the "
          "mirror image of the block.",
      .keys = {
          {.name = "shape",
           .type = ValueType::word,
           .words = {"sphere", "cylinder", "cuboid"},
           .need = Need::always,
           .example = "\"sphere\"",
           .show = Show::no,
           .description =
               "Outline of the body: a half ball or a cap, with the radius of "
               "[surface] (radius of kind = \"sphere\", or form_radius); or "
               "an upright column, whose end is meshed flat."},
          radius,
          optional_length("height", "\"0.5 length\"", "default: the radius",
                          "Distance of its base, which is held like the far "
                          "boundary of the block (top), from its end; for a "
                          "sphere 0.25 to 1 times the radius."),
          optional_length("size_at_contact", "\"2 h\"",
                          "default: that of the block's cells",
                          "Edge length of its cells at the contact, not less "
                          "than that of the block's cells."),
          length_key_or("\"0.1 length\"", "size_far",
                        "Largest length of its cells along the way from the "
                        "contact to its base and its sides."),
          optional_length("fine_radius", "\"0.1 length\"",
                          "default: a quarter of the radius of a sphere, the "
                          "whole end of a column",
                          "Half the width of the region at the centre of its "
                          "end that has the fine cells."),
          offset_key("offset_x", "x"),
          offset_key("offset_y", "y")}};
}

} // namespace

std::vector<Table> mesh_tables() {
  Table table{.name = "mesh",
              .when =
                  "Optional; for [fem] with solver = \"full\", whose layers "
                  "(growth, surface_cell_depth) it replaces.",
              .description = "The mesh of the full 3-D block.",
              .keys = mesh_kind_keys()};
  append_keys(table.keys, mesh_geometry_keys());
  append_keys(table.keys, mesh_size_keys());
  append_keys(table.keys, mesh_file_keys());
  return {table, mesh_counter_table()};
}

} // namespace asperity::cases
