#include "meshes/gmsh_file.hpp"

#include "base/require.hpp"
#include "base/special_numbers.hpp"
#include "meshes/facets.hpp"
#include "meshes/gmsh_cells.hpp"
#include "meshes/gmsh_session.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace asperity::meshes {
namespace {

using FacetKey = std::array<unsigned int, 4>;

struct GroupName {
  FaceGroup group;
  const char* name;
};

constexpr std::array<GroupName, 3> group_names = {
    {{FaceGroup::contact, "contact"},
     {FaceGroup::far_boundary, "fixed"},
     {FaceGroup::sides, "sides"}}};

struct Bounds {
  Place low{}, high{};
};

/// The contents of the file: its cells and the groups of facets that it names.
struct FileMesh {
  GmshMesh cells;
  std::map<FacetKey, FaceGroup> groups;
  std::vector<std::string> surface_names;
};

bool has_cells() {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> numbers;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, numbers, nodes, 3);
  return !types.empty();
}

void open_file(const std::string& path) {
  gmsh::open(path);
  if (path.ends_with(".geo") && !has_cells())
    gmsh::model::mesh::generate(3);
  if (!has_cells())
    throw std::domain_error(
        "mesh: there are no cells; gmsh writes cells of physical volumes only, "
        "and only when it meshes in three dimensions (gmsh -3)");
}

/// Adds the elements of one surface to the group.
void add_surface(FileMesh& file, int surface, const GroupName& of) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> numbers;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, numbers, nodes, 2, surface);
  const CellShape shape = file.cells.mesh.shape;
  const std::size_t n_corners = vertices_per_facet(shape);
  for (std::size_t kind = 0; kind < types.size(); ++kind)
    for (std::size_t i = 0; i < numbers[kind].size(); ++i) {
      FacetKey facet{};
      for (std::size_t corner = 0; corner < n_corners; ++corner) {
        const auto vertex = file.cells.vertex_of_node.find(
            nodes[kind].at(i * n_corners + corner));
        if (vertex == file.cells.vertex_of_node.end())
          throw std::domain_error(fmt::format(
              "mesh: element {} of the physical surface {} touches no cell",
              numbers[kind][i], of.name));
        facet[corner] = vertex->second;
      }
      const auto [found, is_new] =
          file.groups.emplace(facet_key(shape, facet), of.group);
      if (!is_new && found->second != of.group)
        throw std::domain_error(
            fmt::format("mesh: element {} of the physical surface {} is also "
                        "in another of the groups contact, fixed and sides",
                        numbers[kind][i], of.name));
    }
}

void add_groups(FileMesh& file) {
  gmsh::vectorpair physical;
  gmsh::model::getPhysicalGroups(physical, 2);
  for (const auto& [dimension, tag] : physical) {
    std::string name;
    gmsh::model::getPhysicalName(2, tag, name);
    file.surface_names.push_back(name.empty() ? std::to_string(tag) : name);
    const auto found = std::find_if(
        group_names.begin(), group_names.end(),
        [&](const GroupName& group) { return group.name == name; });
    if (found == group_names.end())
      continue;
    std::vector<int> surfaces;
    gmsh::model::getEntitiesForPhysicalGroup(2, tag, surfaces);
    for (const int surface : surfaces)
      add_surface(file, surface, *found);
  }
  for (const GroupName& group : {group_names[0], group_names[1]})
    if (std::none_of(
            file.groups.begin(), file.groups.end(),
            [&](const auto& entry) { return entry.second == group.group; }))
      throw std::domain_error(fmt::format(
          "mesh: no physical surface is named {}; there are: {}", group.name,
          file.surface_names.empty()
              ? "none"
              : fmt::format("{}", fmt::join(file.surface_names, ", "))));
}

FileMesh file_mesh(const std::string& path,
                   const std::function<void()>& begin) {
  FileMesh file;
  in_gmsh([&] {
    begin();
    open_file(path);
    file.cells = cells_of_gmsh();
    add_groups(file);
  });
  return file;
}

void widen(Bounds& bounds, const Place& place) {
  for (std::size_t d = 0; d < 3; ++d) {
    bounds.low[d] = std::min(bounds.low[d], place[d]);
    bounds.high[d] = std::max(bounds.high[d], place[d]);
  }
}

Bounds nothing() {
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

Bounds bounds_of_contact(const FileMesh& file) {
  Bounds bounds = nothing();
  const BlockMesh& mesh = file.cells.mesh;
  for (const auto& [key, group] : file.groups)
    if (group == FaceGroup::contact)
      for (std::size_t i = 0; i < vertices_per_facet(mesh.shape); ++i)
        widen(bounds, mesh.vertices[key[i]]);
  return bounds;
}

/// Renumbers mirrored cells so that they are right-handed again.
void turn_cells(BlockMesh& mesh) {
  for (auto& cell : mesh.cells)
    if (mesh.shape == CellShape::tetrahedron)
      std::swap(cell[0], cell[1]);
    else
      for (std::size_t i = 0; i < 4; ++i)
        std::swap(cell[i], cell[i + 4]);
}

/// Moves the contact surface to z = 0 and its bounds to x = y = 0. If the
/// surface is not flat, its lowest vertex is at z = 0 and the others keep their
/// heights above it.
void place(BlockMesh& mesh, const Bounds& contact, double unit) {
  Bounds all = nothing();
  for (const Place& vertex : mesh.vertices)
    widen(all, vertex);
  const bool is_above =
      contact.high[2] - all.low[2] <= all.high[2] - contact.low[2];
  const double tolerance = 1e-9 * (all.high[2] - all.low[2]);
  for (Place& vertex : mesh.vertices) {
    double z =
        is_above ? vertex[2] - contact.low[2] : contact.high[2] - vertex[2];
    if (std::abs(z) <= tolerance)
      z = 0.0;
    vertex = {(vertex[0] - contact.low[0]) * unit,
              (vertex[1] - contact.low[1]) * unit, z * unit};
    mesh.depth = std::max(mesh.depth, vertex[2]);
  }
  if (!is_above)
    turn_cells(mesh);
  mesh.length_x = (contact.high[0] - contact.low[0]) * unit;
  mesh.length_y = (contact.high[1] - contact.low[1]) * unit;
}

/// The side of the box on which a facet lies within 1e-9 of the size of the
/// box, otherwise FaceGroup::sides.
FaceGroup nearest_side_of(const BlockMesh& mesh, const Facet& facet) {
  const double tolerance =
      1e-9 * std::max({mesh.length_x, mesh.length_y, mesh.depth});
  return lateral_side_of(mesh, facet, tolerance).value_or(FaceGroup::sides);
}

void add_faces(BlockMesh& mesh, const std::map<FacetKey, FaceGroup>& groups) {
  bool is_box = true;
  for (const Facet& facet : boundary_facets(mesh)) {
    const auto named = groups.find(facet_key(mesh.shape, facet.vertices));
    const bool is_side =
        named == groups.end() || named->second == FaceGroup::sides;
    mesh.faces.push_back({facet.vertices, is_side ? nearest_side_of(mesh, facet)
                                                  : named->second});
    is_box = is_box && mesh.faces.back().group != FaceGroup::sides;
  }
  if (is_box)
    return;
  for (BoundaryFace& face : mesh.faces)
    if (face.group != FaceGroup::contact &&
        face.group != FaceGroup::far_boundary)
      face.group = FaceGroup::sides;
}

/// Requires every named facet to be on the boundary, because facets inside the
/// block can be neither loaded nor held.
void require_named_on_boundary(const BlockMesh& mesh,
                               std::map<FacetKey, FaceGroup> groups) {
  for (const BoundaryFace& face : mesh.faces)
    groups.erase(facet_key(mesh.shape, face.vertices));
  if (groups.empty())
    return;
  const auto& [key, inside] = *groups.begin();
  const FaceGroup group = inside;
  const auto named =
      std::find_if(group_names.begin(), group_names.end(),
                   [&](const GroupName& name) { return name.group == group; });
  throw std::domain_error(fmt::format(
      "mesh: the physical surface {} has a face at {} inside the block",
      named->name, place_text(centre_of_facet(mesh, key))));
}

} // namespace

BlockMesh gmsh_file(const std::string& path, double unit,
                    const std::function<void()>& begin) {
  require_positive("unit", unit, "m");
  const FileMesh file = file_mesh(path, begin);
  BlockMesh mesh = file.cells.mesh;
  place(mesh, bounds_of_contact(file), unit);
  add_faces(mesh, file.groups);
  require_named_on_boundary(mesh, file.groups);
  return mesh;
}

} // namespace asperity::meshes
