#include "meshes/matching_sides.hpp"

#include "meshes/facets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

namespace asperity::meshes {
namespace {

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
/// must have a partner within `accuracy` times the largest extent.
std::map<unsigned int, unsigned int>
partners(const BlockMesh& mesh, const Pair& pair, double accuracy) {
  const std::size_t along = 1 - pair.direction;
  const double tolerance =
      accuracy * std::max({mesh.length_x, mesh.length_y, mesh.depth});
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

void require_match(const BlockMesh& mesh, const Pair& pair) {
  const auto partner_of = partners(mesh, pair, 1e-9);
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
      throw std::domain_error(fmt::format(
          "mesh: periodic faces do not match: the face at {} of the face {} "
          "has no partner on the face {}, although its vertices have partners",
          place_text(centre_of_facet(mesh, face.vertices)), pair.from.name,
          pair.to.name));
  }
}

std::array<Pair, 2> pairs_of(const BlockMesh& mesh) {
  return {{{{FaceGroup::left, "left (x = 0)"},
            {FaceGroup::right, "right (x = length)"},
            0,
            mesh.length_x},
           {{FaceGroup::front, "front (y = 0)"},
            {FaceGroup::back, "back (y = length)"},
            1,
            mesh.length_y}}};
}

} // namespace

void require_matching_sides(const BlockMesh& mesh) {
  for (const Pair& pair : pairs_of(mesh))
    require_match(mesh, pair);
}

void align_sides(BlockMesh& mesh) {
  for (const Pair& pair : pairs_of(mesh))
    for (const auto& [vertex, partner] : partners(mesh, pair, 1e-6)) {
      mesh.vertices[partner] = mesh.vertices[vertex];
      mesh.vertices[partner][pair.direction] += pair.period;
    }
}

} // namespace asperity::meshes
