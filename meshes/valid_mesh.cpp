#include "meshes/valid_mesh.hpp"

#include "meshes/facets.hpp"
#include "meshes/matching_sides.hpp"
#include "meshes/mesh_quality.hpp"

#include <boost/pending/disjoint_sets.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <stdexcept>

namespace asperity::meshes {
namespace {

constexpr double least_shape = 1e-6; ///< smaller values mark an inverted or
                                     ///< flat cell

template <class... Parts>
[[noreturn]] void refuse(fmt::format_string<Parts...> format,
                         Parts&&... parts) {
  throw std::domain_error("mesh: " +
                          fmt::format(format, std::forward<Parts>(parts)...));
}

double tolerance_of(const BlockMesh& mesh) {
  return 1e-9 * std::max({mesh.length_x, mesh.length_y, mesh.depth});
}

void require_consistent_lists(const BlockMesh& mesh) {
  if (mesh.cells.empty())
    refuse("there are no cells");
  if (mesh.cell_group.size() != mesh.cells.size())
    refuse("{} cells, but {} cell groups", mesh.cells.size(),
           mesh.cell_group.size());
  for (const double length : {mesh.length_x, mesh.length_y, mesh.depth})
    if (!std::isfinite(length) || length <= 0.0)
      refuse("its extent is {} x {} x {} m, but must be > 0", mesh.length_x,
             mesh.length_y, mesh.depth);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    for (const double coordinate : mesh.vertices[i])
      if (!std::isfinite(coordinate))
        refuse("vertex {} is at {}", i, place_text(mesh.vertices[i]));
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (std::size_t i = 0; i < vertices_per_cell(mesh.shape); ++i)
      if (mesh.cells[cell][i] >= mesh.vertices.size())
        refuse("cell {} has vertex {}, but there are {} vertices", cell,
               mesh.cells[cell][i], mesh.vertices.size());
    const int group = mesh.cell_group[cell];
    if (group < 0 || static_cast<std::size_t>(group) >= mesh.group_names.size())
      refuse("cell {} is of group {}, but there are {} groups", cell, group,
             mesh.group_names.size());
  }
  if (!mesh.refine_below.empty() && mesh.shape != CellShape::hexahedron)
    refuse("hanging nodes (refine_below) are supported for hexahedra only, but "
           "the cells are tetrahedra");
}

/// Refuses coincident vertices. Vertices whose coordinates before `direction`
/// coincide are grouped into runs along it; vertices that share a run in all
/// three directions coincide.
void refuse_coincident(const BlockMesh& mesh, std::span<std::size_t> vertices,
                       std::size_t direction) {
  const double tolerance = tolerance_of(mesh);
  const auto coordinate = [&](std::size_t i, std::size_t d) {
    return mesh.vertices[vertices[i]][d];
  };
  std::sort(vertices.begin(), vertices.end(),
            [&](std::size_t a, std::size_t b) {
              return mesh.vertices[a][direction] < mesh.vertices[b][direction];
            });
  for (std::size_t first = 0, next = 0; first < vertices.size(); first = next) {
    next = first + 1;
    while (next < vertices.size() &&
           coordinate(next, direction) - coordinate(next - 1, direction) <=
               tolerance)
      ++next;
    if (next - first < 2)
      continue;
    if (direction < 2) {
      refuse_coincident(mesh, vertices.subspan(first, next - first),
                        direction + 1);
      continue;
    }
    for (std::size_t i = first + 1; i < next; ++i)
      if (std::abs(coordinate(i, 0) - coordinate(i - 1, 0)) <= tolerance &&
          std::abs(coordinate(i, 1) - coordinate(i - 1, 1)) <= tolerance)
        refuse("vertices {} and {} are both at {}: the parts of the mesh are "
               "not connected",
               std::min(vertices[i - 1], vertices[i]),
               std::max(vertices[i - 1], vertices[i]),
               place_text(mesh.vertices[vertices[i]]));
  }
}

/// Requires each vertex to belong to a cell and to have a place of its own.
void require_joined_vertices(const BlockMesh& mesh) {
  std::vector<bool> has_cell(mesh.vertices.size(), false);
  for (const auto& cell : mesh.cells)
    for (std::size_t i = 0; i < vertices_per_cell(mesh.shape); ++i)
      has_cell[cell[i]] = true;
  for (std::size_t i = 0; i < has_cell.size(); ++i)
    if (!has_cell[i])
      refuse("vertex {} at {} belongs to no cell", i,
             place_text(mesh.vertices[i]));

  std::vector<std::size_t> all(mesh.vertices.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  refuse_coincident(mesh, all, 0);
}

/// Requires every boundary facet to be in exactly one group, and no other facet
/// to be in any.
void require_closed(const BlockMesh& mesh) {
  std::map<std::array<unsigned int, 4>, bool> is_listed;
  for (const Facet& facet : boundary_facets(mesh))
    is_listed[facet_key(mesh.shape, facet.vertices)] = false;
  for (const BoundaryFace& face : mesh.faces) {
    for (std::size_t i = 0; i < vertices_per_facet(mesh.shape); ++i)
      if (face.vertices[i] >= mesh.vertices.size())
        refuse("a face has vertex {}, but there are {} vertices",
               face.vertices[i], mesh.vertices.size());
    const auto found = is_listed.find(facet_key(mesh.shape, face.vertices));
    const auto place = [&] {
      return place_text(centre_of_facet(mesh, face.vertices));
    };
    if (found == is_listed.end())
      refuse("the face at {} is not a facet of the boundary", place());
    if (found->second)
      refuse("the face at {} is listed twice", place());
    found->second = true;
  }
  for (const auto& [key, listed] : is_listed)
    if (!listed)
      refuse("the boundary facet at {} is in no group of faces",
             place_text(centre_of_facet(mesh, key)));
}

void require_group(const BlockMesh& mesh, FaceGroup group, const char* name) {
  if (std::none_of(
          mesh.faces.begin(), mesh.faces.end(),
          [&](const BoundaryFace& face) { return face.group == group; }))
    refuse("no face is in the group {}", name);
}

void require_flat_contact(const BlockMesh& mesh) {
  const double tolerance = tolerance_of(mesh);
  for (const BoundaryFace& face : mesh.faces)
    if (face.group == FaceGroup::contact)
      for (std::size_t i = 0; i < vertices_per_facet(mesh.shape); ++i) {
        const Place& place = mesh.vertices[face.vertices[i]];
        if (std::abs(place[2]) > tolerance)
          refuse("the contact surface is not flat: its vertex {} at {} is "
                 "{:.3g} m off z = 0",
                 face.vertices[i], place_text(place), place[2]);
      }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (mesh.vertices[i][2] < -tolerance)
      refuse("vertex {} at {} lies on the wrong side of the contact surface", i,
             place_text(mesh.vertices[i]));
}

void require_held_cells(const BlockMesh& mesh) {
  boost::disjoint_sets_with_storage<> pieces(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    pieces.make_set(i);
  for (const auto& cell : mesh.cells)
    for (std::size_t i = 1; i < vertices_per_cell(mesh.shape); ++i)
      pieces.union_set(std::size_t{cell[0]}, std::size_t{cell[i]});
  std::set<std::size_t> held;
  for (const BoundaryFace& face : mesh.faces)
    if (face.group == FaceGroup::far_boundary)
      held.insert(pieces.find_set(std::size_t{face.vertices[0]}));
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (!held.contains(pieces.find_set(std::size_t{mesh.cells[cell][0]})))
      refuse("cell {} at {} is not connected to the far boundary (group fixed)",
             cell, place_text(centre_of_cell(mesh, cell)));
}

} // namespace

void require_positive_cells(const BlockMesh& mesh) {
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const double shape = cell_shape(mesh, cell);
    if (!(shape >= least_shape))
      refuse("cell {} at {} is {}: its {} is {:.3g}", cell,
             place_text(centre_of_cell(mesh, cell)),
             shape < -least_shape ? "inverted" : "flat",
             mesh.shape == CellShape::hexahedron ? "scaled Jacobian"
                                                 : "mean ratio",
             shape);
  }
}

void require_flat_support(const BlockMesh& mesh) {
  constexpr double accuracy = 1e-6; // of the places in files
  const double tolerance =
      accuracy * std::max({mesh.length_x, mesh.length_y, mesh.depth});
  for (const BoundaryFace& face : mesh.faces)
    if (face.group == FaceGroup::far_boundary)
      for (std::size_t i = 0; i < vertices_per_facet(mesh.shape); ++i) {
        const Place& place = mesh.vertices[face.vertices[i]];
        if (std::abs(place[2] - mesh.depth) > tolerance)
          refuse(
              "the far boundary (group fixed) must be a plane of constant z "
              "unless top = \"clamped\", but its vertex {} at {} is {:.3g} m "
              "off the largest z",
              face.vertices[i], place_text(place), mesh.depth - place[2]);
      }
}

void require_valid_mesh(const BlockMesh& mesh, mechanics::BlockSides sides) {
  require_consistent_lists(mesh);
  require_positive_cells(mesh);
  require_joined_vertices(mesh);
  require_closed(mesh);
  require_group(mesh, FaceGroup::contact, "contact");
  require_group(mesh, FaceGroup::far_boundary, "fixed");
  require_flat_contact(mesh);
  require_held_cells(mesh);
  if (sides == mechanics::BlockSides::periodic)
    require_matching_sides(mesh);
}

} // namespace asperity::meshes
