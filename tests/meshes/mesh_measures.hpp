#pragma once

// Volumes and areas of a mesh, for the tests of meshes: computed from the
// vertices alone by algorithms that the sources do not use.

#include "meshes/block_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity::meshes::test {

inline Place minus(const Place& a, const Place& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

inline double dot(const Place& a, const Place& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double triple(const Place& a, const Place& b, const Place& c) {
  return dot(a, cross(b, c));
}

/// det dx/dxi of the trilinear map at xi in the unit cube, from its three
/// tangents.
inline double hexahedron_jacobian(const BlockMesh& mesh, std::size_t cell,
                                  const Place& xi) {
  std::array<Place, 3> tangent{};
  for (std::size_t corner = 0; corner < 8; ++corner)
    for (std::size_t d = 0; d < 3; ++d) {
      double weight = 1.0;
      for (std::size_t e = 0; e < 3; ++e) {
        const bool is_far = (corner >> e & 1U) != 0;
        if (e == d)
          weight *= is_far ? 1.0 : -1.0;
        else
          weight *= is_far ? xi[e] : 1.0 - xi[e];
      }
      for (std::size_t c = 0; c < 3; ++c)
        tangent[d][c] += weight * mesh.vertices[mesh.cells[cell][corner]][c];
    }
  return triple(tangent[0], tangent[1], tangent[2]);
}

/// The volume of a cell; that of a hexahedron by two Gauss points per
/// direction, which is exact because the Jacobian is quadratic in each.
inline double cell_volume(const BlockMesh& mesh, std::size_t cell) {
  if (mesh.shape == CellShape::tetrahedron) {
    const auto& v = mesh.cells[cell];
    const Place& origin = mesh.vertices[v[0]];
    return triple(minus(mesh.vertices[v[1]], origin),
                  minus(mesh.vertices[v[2]], origin),
                  minus(mesh.vertices[v[3]], origin)) /
           6.0;
  }
  const double g = 0.5 / std::sqrt(3.0);
  double volume = 0.0;
  for (const double x : {0.5 - g, 0.5 + g})
    for (const double y : {0.5 - g, 0.5 + g})
      for (const double z : {0.5 - g, 0.5 + g})
        volume += hexahedron_jacobian(mesh, cell, {x, y, z}) / 8.0;
  return volume;
}

inline double volume_of(const BlockMesh& mesh, int group = -1) {
  double sum = 0.0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (group < 0 || mesh.cell_group[cell] == group)
      sum += cell_volume(mesh, cell);
  return sum;
}

/// The area of flat faces, by the triangles of each.
inline double area_of(const BlockMesh& mesh, FaceGroup group) {
  double sum = 0.0;
  for (const BoundaryFace& face : mesh.faces) {
    if (face.group != group)
      continue;
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
      const Place& origin = mesh.vertices[face.vertices[a]];
      const Place normal =
          cross(minus(mesh.vertices[face.vertices[b]], origin),
                minus(mesh.vertices[face.vertices[c]], origin));
      return 0.5 * std::sqrt(dot(normal, normal));
    };
    sum += triangle(0, 1, 2);
    if (mesh.shape == CellShape::hexahedron)
      sum += triangle(3, 1, 2);
  }
  return sum;
}

/// The Jacobian at the corners of all cells: negative where a cell is inverted.
inline double smallest_jacobian(const BlockMesh& mesh) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    if (mesh.shape == CellShape::tetrahedron)
      smallest = std::min(smallest, 6.0 * cell_volume(mesh, cell));
    else
      for (const double x : {0.0, 1.0})
        for (const double y : {0.0, 1.0})
          for (const double z : {0.0, 1.0})
            smallest =
                std::min(smallest, hexahedron_jacobian(mesh, cell, {x, y, z}));
  }
  return smallest;
}

} // namespace asperity::meshes::test
