#include "meshes/valid_mesh.hpp"

#include "meshes/facets.hpp"
#include "meshes/mesh_quality.hpp"

#include <boost/pending/disjoint_sets.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>

namespace asperity::meshes {
namespace {

constexpr double accuracy_of_files = 1e-6; ///< of the places, over the largest
                                           ///< extent
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

/// Requires each vertex to have a place of its own.
void require_joined_vertices(const BlockMesh& mesh) {
  std::vector<std::size_t> all(mesh.vertices.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  refuse_coincident(mesh, all, 0);
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

struct Side {
  FaceGroup group;
  const char* name;
};

/// Two opposite sides and the translation from the first to the second.
struct Pair {
  Side from, to;
  std::size_t direction; ///< 0: x, 1: y
  double period;         ///< [m]
};

using VertexByPlace = std::multimap<double, unsigned int>;

/// The vertices of a side, sorted by the in-plane coordinate other than z.
VertexByPlace vertices_of(const BlockMesh& mesh, const Pair& pair,
                          const Side& side) {
  std::set<unsigned int> vertices;
  for (const BoundaryFace& face : mesh.faces)
    if (face.group == side.group)
      for (std::size_t i = 0; i < vertices_per_facet(mesh.shape); ++i)
        vertices.insert(face.vertices[i]);
  if (vertices.empty())
    throw std::domain_error(fmt::format(
        "mesh: a periodic block needs the face {}, but has none: its sides "
        "must "
        "be planes through the edges of the contact surface; with sides = "
        "\"free\" in [fem] they may have any shape",
        side.name));
  VertexByPlace sorted;
  for (const unsigned int vertex : vertices)
    sorted.emplace(mesh.vertices[vertex][1 - pair.direction], vertex);
  return sorted;
}

std::optional<unsigned int> vertex_at(const BlockMesh& mesh,
                                      const VertexByPlace& vertices,
                                      std::size_t along, const Place& place,
                                      double tolerance) {
  const auto end = vertices.upper_bound(place[along] + tolerance);
  for (auto next = vertices.lower_bound(place[along] - tolerance); next != end;
       ++next) {
    const Place& found = mesh.vertices[next->second];
    if (std::abs(found[0] - place[0]) <= tolerance &&
        std::abs(found[1] - place[1]) <= tolerance &&
        std::abs(found[2] - place[2]) <= tolerance)
      return next->second;
  }
  return std::nullopt;
}

/// The partner of each vertex of the first side. Every vertex of both sides
/// must have a partner.
std::map<unsigned int, unsigned int> partners(const BlockMesh& mesh,
                                              const Pair& pair) {
  const std::size_t along = 1 - pair.direction;
  const double tolerance =
      accuracy_of_files * std::max({mesh.length_x, mesh.length_y, mesh.depth});
  const VertexByPlace from = vertices_of(mesh, pair, pair.from);
  const VertexByPlace to = vertices_of(mesh, pair, pair.to);
  const auto search = [&](const VertexByPlace& side, unsigned int vertex,
                          double period, const char* name,
                          const char* opposite) {
    Place expected = mesh.vertices[vertex];
    expected[pair.direction] += period;
    const auto found = vertex_at(mesh, side, along, expected, tolerance);
    if (!found)
      throw std::domain_error(fmt::format(
          "mesh: periodic faces do not match: vertex {} at {} of the face {} "
          "has no partner on the face {}",
          vertex, place_text(mesh.vertices[vertex]), name, opposite));
    return *found;
  };
  std::map<unsigned int, unsigned int> matched;
  for (const auto& [place, vertex] : from)
    matched[vertex] =
        search(to, vertex, pair.period, pair.from.name, pair.to.name);
  for (const auto& [place, vertex] : to)
    search(from, vertex, -pair.period, pair.to.name, pair.from.name);
  return matched;
}

/// Moves the vertices of the second side to the places of their partners
/// shifted by one period, and requires the partners of the vertices of each
/// face to form a face.
void align(BlockMesh& mesh, const Pair& pair) {
  const auto partner_of = partners(mesh, pair);
  std::set<std::array<unsigned int, 4>> faces;
  for (const BoundaryFace& face : mesh.faces)
    if (face.group == pair.to.group)
      faces.insert(facet_key(mesh.shape, face.vertices));
  for (const BoundaryFace& face : mesh.faces) {
    if (face.group != pair.from.group)
      continue;
    auto moved = face.vertices;
    for (std::size_t i = 0; i < vertices_per_facet(mesh.shape); ++i)
      moved[i] = partner_of.at(face.vertices[i]);
    if (!faces.contains(facet_key(mesh.shape, moved)))
      refuse(
          "periodic faces do not match: the face at {} of the face {} has no "
          "partner on the face {}, although its vertices have partners",
          place_text(centre_of_facet(mesh, face.vertices)), pair.from.name,
          pair.to.name);
  }
  for (const auto& [vertex, partner] : partner_of) {
    mesh.vertices[partner] = mesh.vertices[vertex];
    mesh.vertices[partner][pair.direction] += pair.period;
  }
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
  const double tolerance =
      accuracy_of_files * std::max({mesh.length_x, mesh.length_y, mesh.depth});
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

void fit_sides(BlockMesh& mesh, mechanics::BlockSides sides) {
  require_positive_cells(mesh);
  require_joined_vertices(mesh);
  require_flat_contact(mesh);
  require_held_cells(mesh);
  if (sides != mechanics::BlockSides::periodic)
    return;
  align(mesh, {{FaceGroup::left, "left (x = 0)"},
               {FaceGroup::right, "right (x = length)"},
               0,
               mesh.length_x});
  align(mesh, {{FaceGroup::front, "front (y = 0)"},
               {FaceGroup::back, "back (y = length)"},
               1,
               mesh.length_y});
}

} // namespace asperity::meshes
