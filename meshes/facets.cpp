#include "meshes/facets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

namespace asperity::meshes {
namespace {

using Corners = std::array<unsigned int, 4>;

constexpr std::array<Corners, 6> hexahedron_facets = {{{0, 2, 4, 6},
                                                       {1, 3, 5, 7},
                                                       {0, 1, 4, 5},
                                                       {2, 3, 6, 7},
                                                       {0, 1, 2, 3},
                                                       {4, 5, 6, 7}}};
constexpr std::array<Corners, 4> tetrahedron_facets = {
    {{0, 1, 2, 0}, {0, 1, 3, 0}, {0, 2, 3, 0}, {1, 2, 3, 0}}};

struct KeyedFacet {
  Corners key{};
  Facet facet;
};

std::vector<KeyedFacet> all_facets(const BlockMesh& mesh) {
  const bool is_hexahedron = mesh.shape == CellShape::hexahedron;
  const std::span<const Corners> of_a_cell =
      is_hexahedron ? std::span<const Corners>(hexahedron_facets)
                    : std::span<const Corners>(tetrahedron_facets);
  std::vector<KeyedFacet> facets;
  facets.reserve(mesh.cells.size() * of_a_cell.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (const Corners& corners : of_a_cell) {
      Facet facet{{}, cell};
      for (std::size_t i = 0; i < vertices_per_facet(mesh.shape); ++i)
        facet.vertices[i] = mesh.cells[cell][corners[i]];
      facets.push_back({facet_key(mesh.shape, facet.vertices), facet});
    }
  return facets;
}

template <class Vertices>
Place mean_place(const BlockMesh& mesh, const Vertices& vertices,
                 std::size_t count) {
  Place mean{};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t d = 0; d < 3; ++d)
      mean[d] += mesh.vertices[vertices[i]][d] / static_cast<double>(count);
  return mean;
}

} // namespace

std::size_t vertices_per_facet(CellShape shape) {
  return shape == CellShape::hexahedron ? 4 : 3;
}

std::size_t vertices_per_cell(CellShape shape) {
  return shape == CellShape::hexahedron ? 8 : 4;
}

std::array<unsigned int, 4> facet_key(CellShape shape,
                                      std::array<unsigned int, 4> vertices) {
  // The unused fourth entry of a triangle is sorted to the end and then set to
  // zero.
  const bool is_triangle = vertices_per_facet(shape) == 3;
  if (is_triangle)
    vertices.back() = std::numeric_limits<unsigned int>::max();
  std::sort(vertices.begin(), vertices.end());
  if (is_triangle)
    vertices.back() = 0U;
  return vertices;
}

std::vector<Facet> boundary_facets(const BlockMesh& mesh) {
  std::vector<KeyedFacet> facets = all_facets(mesh);
  // The sort is stable, so facets with equal keys stay in the order of their
  // cells.
  std::stable_sort(
      facets.begin(), facets.end(),
      [](const KeyedFacet& a, const KeyedFacet& b) { return a.key < b.key; });

  std::vector<Facet> boundary;
  for (std::size_t first = 0, next = 0; first < facets.size(); first = next) {
    while (next < facets.size() && facets[next].key == facets[first].key)
      ++next;
    if (next - first > 2)
      throw std::domain_error(fmt::format(
          "mesh: cells {}, {} and {} share one facet, at {}",
          facets[first].facet.cell, facets[first + 1].facet.cell,
          facets[first + 2].facet.cell,
          place_text(centre_of_facet(mesh, facets[first].facet.vertices))));
    if (next - first == 1)
      boundary.push_back(facets[first].facet);
  }
  std::stable_sort(
      boundary.begin(), boundary.end(),
      [](const Facet& a, const Facet& b) { return a.cell < b.cell; });
  return boundary;
}

Place centre_of_cell(const BlockMesh& mesh, std::size_t cell) {
  return mean_place(mesh, mesh.cells[cell], vertices_per_cell(mesh.shape));
}

Place centre_of_facet(const BlockMesh& mesh,
                      const std::array<unsigned int, 4>& vertices) {
  return mean_place(mesh, vertices, vertices_per_facet(mesh.shape));
}

bool lies_on_plane(const BlockMesh& mesh, const Facet& facet,
                   std::size_t direction, double coordinate, double tolerance) {
  for (std::size_t i = 0; i < vertices_per_facet(mesh.shape); ++i)
    if (!(std::abs(mesh.vertices[facet.vertices[i]][direction] - coordinate) <=
          tolerance))
      return false;
  return true;
}

std::optional<FaceGroup> lateral_side_of(const BlockMesh& mesh,
                                         const Facet& facet, double tolerance) {
  if (lies_on_plane(mesh, facet, 0, 0.0, tolerance))
    return FaceGroup::left;
  if (lies_on_plane(mesh, facet, 0, mesh.length_x, tolerance))
    return FaceGroup::right;
  if (lies_on_plane(mesh, facet, 1, 0.0, tolerance))
    return FaceGroup::front;
  if (lies_on_plane(mesh, facet, 1, mesh.length_y, tolerance))
    return FaceGroup::back;
  return std::nullopt;
}

double contact_area(const BlockMesh& mesh) {
  const std::size_t n = vertices_per_facet(mesh.shape);
  // Around a quadrilateral, whose vertices are numbered as those of a grid of
  // boxes.
  constexpr std::array<std::size_t, 4> around{0, 1, 3, 2};
  double area = 0.0;
  for (const BoundaryFace& face : mesh.faces) {
    if (face.group != FaceGroup::contact)
      continue;
    double twice = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      const Place& a = mesh.vertices[face.vertices[n == 4 ? around[i] : i]];
      const Place& b =
          mesh.vertices[face.vertices[n == 4 ? around[next] : next]];
      twice += a[0] * b[1] - a[1] * b[0];
    }
    area += 0.5 * std::abs(twice);
  }
  return area;
}

std::string place_text(const Place& place) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", place[0], place[1],
                     place[2]);
}

} // namespace asperity::meshes
