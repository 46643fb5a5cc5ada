// The rows of [mesh].
#include "input/reader/bound_key.hpp"

namespace asperity::cases {
namespace {

using CounterMesh = mechanics::CounterMeshSpec;
using Mesh = mechanics::MeshSpec;

std::vector<Key> mesh_keys() {
  return {
      key<&Mesh::kind>(
          "kind", {"layers", "hanging", "adaptive", "gmsh"},
          "[fem]'s own graded layers, cubes halved towards the contact surface "
          "with hanging nodes, cubes halved where the solution of each load "
          "step requires it, or a mesh by gmsh.",
          needed("gmsh")),
      key<&Mesh::cells_a_level>(
          "cells_a_level", between(1, 64),
          "With hanging: layers of cells between two successive halvings."),
      key<&Mesh::halvings>(
          "halvings", between(1, 12),
          "With adaptive: how often the coarsest cells are halved at the "
          "contact; the nodes there are then those of the grid. The cells per "
          "side must be divisible by two so many times."),
      key<&Mesh::moduli_ratio>("moduli_ratio", between(1, 1000),
                               "With adaptive: largest ratio of the moduli "
                               "within a cell that need not be halved for it."),
      key<&Mesh::interface_halvings>(
          "interface_halvings", between(0, 12),
          "With adaptive: how often cells with a larger ratio, or at the "
          "surface of the inclusion, are halved. Without it their edge is at "
          "most a quarter of their depth and of the radius.",
          eg("2")),
      key<&Mesh::geometry>(
          "geometry", {"block", "indentation", "layered", "inclusion", "file"},
          "With gmsh: a block graded with depth, one refined around the centre "
          "of the contact surface, one with the layers or the inclusion of "
          "[material], or a file of your own.",
          eg("indentation")),
      key<&Mesh::size_at_contact>(
          "size_at_contact", by_the_grid(),
          "With gmsh: edge length of a cell in the contact region."),
      key<&Mesh::size_far>(
          "size_far", by_the_grid(),
          "With gmsh: edge length of a cell far from the contact region."),
      key<&Mesh::fine_radius>("fine_radius", by_the_grid(),
                              "With indentation: radius of the refined region "
                              "around the centre of the contact surface."),
  };
}

std::vector<Key> mesh_file_keys() {
  constexpr auto is_from_file = [](const Mesh& mesh) {
    return mesh.kind == mechanics::MeshKind::gmsh &&
           mesh.geometry == mechanics::MeshGeometry::file;
  };
  return {
      where<Mesh>(
          is_from_file,
          key<&Mesh::file>(
              "file", ValueType::path,
              "A .msh, .inp, .vtk or .unv file with the groups of faces "
              "contact, fixed and, if it has any, sides (without names: 1, 2 "
              "and 3). The contact surface is a plane rectangle with its edges "
              "along x and y, as large as the surface.",
              needed("block.msh", "with geometry = \"file\""))),
      key<&Mesh::file_unit>(
          "file_unit", Dimension::length,
          "Length that corresponds to the number 1 in the file.", eg("1 mm")),
  };
}

/// Returns a key that is a length along x or y, of either sign.
template <auto member>
Key offset_key(std::string name, const std::string& axis) {
  Values values = by_the_grid();
  values.range = any_number();
  Key offset = key<member>(
      std::move(name), values,
      "Distance of the body's axis from the centre of the block along " + axis +
          "; cylinder and cuboid only. The heights of [surface] stay where "
          "they are.",
      eg("0.1 length"));
  offset.fallback = "\"0 length\""; // the member's 0 m
  return offset;
}

Table mesh_counter_table() {
  constexpr auto is_column = [](const CounterMesh& counter) {
    return counter.shape != mechanics::CounterShape::sphere;
  };
  return {.name = "mesh.counter",
          .when = "Optional; for [fem] with solver = \"full\" and bodies = 2.",
          .description = "A counter-body of finite size with free sides and a "
                         "mesh of hexahedra of its own. Without this table the "
                         "counter-body is the mirror image of the block.",
          .keys = {
              key<&CounterMesh::shape>(
                  "shape", {"sphere", "cylinder", "cuboid"},
                  "Outline of the body: a half ball or a cap, with the radius "
                  "of [surface] (radius of kind = \"sphere\", or form_radius); "
                  "or an upright column, whose end is meshed flat.",
                  needed("sphere")),
              where<CounterMesh>(
                  is_column,
                  key<&CounterMesh::radius>(
                      "radius", by_the_grid(),
                      "Radius of the cylinder, half the side of the cuboid. A "
                      "sphere has the radius of [surface].",
                      needed("0.15 length",
                             "with shape = \"cylinder\" or \"cuboid\""))),
              key<&CounterMesh::height>(
                  "height", by_the_grid(),
                  "Distance of its base, which is held like the far boundary "
                  "of the block (top), from its end; for a sphere 0.25 to 1 "
                  "times the radius.",
                  eg("0.5 length", "default: the radius")),
              key<&CounterMesh::size_at_contact>(
                  "size_at_contact", by_the_grid(),
                  "Edge length of its cells at the contact, not less than that "
                  "of the block's cells.",
                  eg("2 h", "default: that of the block's cells")),
              key<&CounterMesh::size_far>(
                  "size_far", by_the_grid(),
                  "Largest length of its cells along the way from the contact "
                  "to its base and its sides."),
              key<&CounterMesh::fine_radius>(
                  "fine_radius", by_the_grid(),
                  "Half the width of the region at the centre of its end that "
                  "has the fine cells.",
                  eg("0.1 length", "default: a quarter of the radius of a "
                                   "sphere, the whole end of a column")),
              offset_key<&CounterMesh::offset_x>("offset_x", "x"),
              offset_key<&CounterMesh::offset_y>("offset_y", "y")}};
}

} // namespace

std::vector<Table> mesh_tables() {
  Table table{.name = "mesh",
              .when = "Optional; for [fem] with solver = \"full\", whose "
                      "layers (growth, surface_cell_depth) it replaces.",
              .description = "The mesh of the full 3-D block.",
              .keys = mesh_keys()};
  append_keys(table.keys, mesh_file_keys());
  return {table, mesh_counter_table()};
}

} // namespace asperity::cases
