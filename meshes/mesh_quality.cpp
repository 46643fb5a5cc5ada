#include "meshes/mesh_quality.hpp"

#include "meshes/facets.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace asperity::meshes {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;

constexpr std::array<Edge, 12> hexahedron_edges = {{{0, 1},
                                                    {2, 3},
                                                    {4, 5},
                                                    {6, 7},
                                                    {0, 2},
                                                    {1, 3},
                                                    {4, 6},
                                                    {5, 7},
                                                    {0, 4},
                                                    {1, 5},
                                                    {2, 6},
                                                    {3, 7}}};
constexpr std::array<Edge, 6> tetrahedron_edges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
constexpr std::array<Edge, 4> quadrilateral_edges = {
    {{0, 1}, {2, 3}, {0, 2}, {1, 3}}};
constexpr std::array<Edge, 3> triangle_edges = {{{0, 1}, {0, 2}, {1, 2}}};

Eigen::Vector3d between(const BlockMesh& mesh, unsigned int from,
                        unsigned int to) {
  const Place& a = mesh.vertices[from];
  const Place& b = mesh.vertices[to];
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

double scaled_jacobian(const BlockMesh& mesh,
                       const std::array<unsigned int, 8>& cell) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Eigen::Matrix3d tangents;
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t bit = std::size_t{1} << d;
      tangents.col(static_cast<Eigen::Index>(d)) =
          between(mesh, cell[corner & ~bit], cell[corner | bit]);
    }
    const double lengths = tangents.colwise().norm().prod();
    smallest = std::min(smallest,
                        lengths > 0.0 ? tangents.determinant() / lengths : 0.0);
  }
  return smallest; // (M.3)
}

double mean_ratio(const BlockMesh& mesh,
                  const std::array<unsigned int, 8>& cell) {
  Eigen::Matrix3d tangents;
  for (std::size_t d = 0; d < 3; ++d)
    tangents.col(static_cast<Eigen::Index>(d)) =
        between(mesh, cell[0], cell[d + 1]);
  const double volume = tangents.determinant() / 6.0;
  double sum = 0.0;
  for (const auto& [from, to] : tetrahedron_edges)
    sum += between(mesh, cell[from], cell[to]).squaredNorm();
  if (sum == 0.0)
    return 0.0;
  return std::copysign(12.0 * std::cbrt(9.0 * volume * volume) / sum,
                       volume); // (M.4)
}

template <class Vertices, class Edges>
void widen(EdgeRange& range, const BlockMesh& mesh, const Vertices& vertices,
           const Edges& edges) {
  for (const auto& [from, to] : edges) {
    const double length = between(mesh, vertices[from], vertices[to]).norm();
    range.smallest = std::min(range.smallest, length);
    range.largest = std::max(range.largest, length);
  }
}

void measure_cells(MeshQuality& quality, const BlockMesh& mesh) {
  quality.smallest_shape = std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const double shape = cell_shape(mesh, cell);
    quality.mean_shape += shape / static_cast<double>(mesh.cells.size());
    if (shape < quality.smallest_shape) {
      quality.smallest_shape = shape;
      quality.worst_cell = cell;
    }
    if (mesh.shape == CellShape::hexahedron)
      widen(quality.edges, mesh, mesh.cells[cell], hexahedron_edges);
    else
      widen(quality.edges, mesh, mesh.cells[cell], tetrahedron_edges);
    ++quality.cells_per_group[static_cast<std::size_t>(mesh.cell_group[cell])];
  }
  quality.worst_place = centre_of_cell(mesh, quality.worst_cell);
}

void measure_contact_faces(MeshQuality& quality, const BlockMesh& mesh) {
  for (const BoundaryFace& face : mesh.faces) {
    if (face.group != FaceGroup::contact)
      continue;
    ++quality.n_contact_faces;
    if (mesh.shape == CellShape::hexahedron)
      widen(quality.contact_edges, mesh, face.vertices, quadrilateral_edges);
    else
      widen(quality.contact_edges, mesh, face.vertices, triangle_edges);
  }
}

/// Appends how often the layers of cells between two depths are halved.
void append_levels(const std::vector<double>& refine_below, std::size_t next,
                   double top, double bottom, std::vector<int>& levels,
                   int level = 0) {
  const double middle = 0.5 * (top + bottom);
  if (next == refine_below.size()) {
    levels.push_back(level);
  } else if (middle < refine_below[next]) {
    append_levels(refine_below, next + 1, top, middle, levels, level + 1);
    append_levels(refine_below, next + 1, middle, bottom, levels, level + 1);
  } else {
    append_levels(refine_below, next + 1, top, bottom, levels, level);
  }
}

/// Replaces the numbers of equal boxes by those after they have been halved.
void halve_boxes(MeshQuality& quality, const BlockMesh& mesh) {
  const auto n_layers = mesh.cells.size() / quality.n_contact_faces;
  const double edge = std::abs(mesh.vertices[mesh.cells[0][1]][0] -
                               mesh.vertices[mesh.cells[0][0]][0]);
  const auto n_x = static_cast<std::size_t>(std::lround(mesh.length_x / edge));
  const std::size_t n_y = quality.n_contact_faces / n_x;
  std::vector<int> levels; // of the layers, from the contact surface
  for (std::size_t layer = 0; layer < n_layers; ++layer) {
    const double height = mesh.depth / static_cast<double>(n_layers);
    append_levels(mesh.refine_below, 0, height * static_cast<double>(layer),
                  height * static_cast<double>(layer + 1), levels);
  }
  quality.n_cells = quality.n_vertices = 0;
  int above = levels.front();
  levels.push_back(levels.back());
  for (std::size_t layer = 0; layer < levels.size(); ++layer) {
    const std::size_t fine = std::size_t{1} << std::max(above, levels[layer]);
    quality.n_vertices += (fine * n_x + 1) * (fine * n_y + 1);
    above = levels[layer];
    if (layer + 1 < levels.size())
      quality.n_cells += (n_x << above) * (n_y << above);
  }
  quality.cells_per_group = {quality.n_cells};
  const int finest = levels.front();
  quality.n_contact_faces <<= 2 * finest;
  const double halved = std::ldexp(1.0, -finest);
  quality.worst_cell = 0; // all are equally good
  quality.worst_place = {
      0.5 * halved * edge,
      0.5 * halved * mesh.length_y / static_cast<double>(n_y),
      0.5 * halved * mesh.depth / static_cast<double>(n_layers)};
  quality.edges.smallest *= halved;
  quality.contact_edges.smallest *= halved;
  quality.contact_edges.largest *= halved;
}

} // namespace

double cell_shape(const BlockMesh& mesh, std::size_t cell) {
  return mesh.shape == CellShape::hexahedron
             ? scaled_jacobian(mesh, mesh.cells[cell])
             : mean_ratio(mesh, mesh.cells[cell]);
}

MeshQuality mesh_quality(const BlockMesh& mesh) {
  if (mesh.cells.empty())
    throw std::domain_error("mesh: there are no cells");
  const EdgeRange nothing{std::numeric_limits<double>::infinity(), 0.0};
  MeshQuality quality{.shape = mesh.shape,
                      .n_cells = mesh.cells.size(),
                      .n_vertices = mesh.vertices.size(),
                      .edges = nothing,
                      .contact_edges = nothing,
                      .group_names = mesh.group_names,
                      .cells_per_group =
                          std::vector<std::size_t>(mesh.group_names.size())};
  measure_cells(quality, mesh);
  measure_contact_faces(quality, mesh);
  if (!mesh.refine_below.empty())
    halve_boxes(quality, mesh);
  return quality;
}

std::string quality_text(const MeshQuality& quality) {
  const bool is_hexahedron = quality.shape == CellShape::hexahedron;
  std::string groups;
  if (quality.group_names.size() > 1)
    for (std::size_t i = 0; i < quality.group_names.size(); ++i)
      groups +=
          fmt::format("{}{} {}", i == 0 ? " (" : ", ", quality.group_names[i],
                      quality.cells_per_group[i]) +
          (i + 1 == quality.group_names.size() ? ")" : "");
  return fmt::format(
      "{} {}{}, {} vertices, {} contact faces\n"
      "edges {:.4g} to {:.4g} m, at the contact surface {:.4g} to {:.4g} m\n"
      "{}: mean {:.3f}, smallest {:.3f} (cell {} at {})",
      quality.n_cells, is_hexahedron ? "hexahedra" : "tetrahedra", groups,
      quality.n_vertices, quality.n_contact_faces, quality.edges.smallest,
      quality.edges.largest, quality.contact_edges.smallest,
      quality.contact_edges.largest,
      is_hexahedron ? "scaled Jacobian" : "mean ratio", quality.mean_shape,
      quality.smallest_shape, quality.worst_cell,
      place_text(quality.worst_place));
}

} // namespace asperity::meshes
