#pragma once

// Problems that several tests of the full model solve, and meshes that no
// generator of meshes/ makes.

#include "fem/block/block_problem.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace asperity::fem {

/// A cosine along x with `waves` periods per side, on all of the grid [m].
inline std::vector<double> wave_heights(const Grid& grid, double amplitude,
                                        int waves = 1) {
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      heights[grid.index(ix, iy)] =
          amplitude *
          std::cos(2.0 * std::numbers::pi * waves * ix / grid.points_x);
  return heights;
}

/// A homogeneous block of boxes on the nodes of the grid; each layer is 1.4
/// times as thick as the one above.
inline BlockProblem boxes_problem(const Grid& grid, int degree,
                                  const mechanics::BodyModuli& body,
                                  double depth) {
  Grid columns = grid;
  columns.points_x /= degree;
  columns.points_y /= degree;
  return {.grid = grid,
          .mesh = meshes::layered_mesh(
              columns,
              meshes::graded_layers(degree * grid.spacing_x(), 1.4, depth)),
          .degree = degree,
          .moduli = ModuliField(moduli(body))};
}

/// Each box divided into six tetrahedra around its diagonal (Kuhn,
/// Freudenthal): opposite sides of the block still match.
inline meshes::BlockMesh tetrahedra_of(const meshes::BlockMesh& boxes) {
  constexpr std::array<std::array<unsigned int, 4>, 6> corners{{{0, 1, 3, 7},
                                                                {0, 3, 2, 7},
                                                                {0, 2, 6, 7},
                                                                {0, 6, 4, 7},
                                                                {0, 4, 5, 7},
                                                                {0, 5, 1, 7}}};
  meshes::BlockMesh mesh = boxes;
  mesh.shape = meshes::CellShape::tetrahedron;
  mesh.cells.clear();
  mesh.cell_group.clear();
  mesh.faces.clear();
  for (const auto& box : boxes.cells)
    for (const auto& four : corners) {
      mesh.cells.push_back(
          {box[four[0]], box[four[1]], box[four[2]], box[four[3]]});
      mesh.cell_group.push_back(0);
    }
  for (const meshes::BoundaryFace& face : boxes.faces) {
    const auto& v = face.vertices;
    mesh.faces.push_back({{v[0], v[1], v[3], 0}, face.group});
    mesh.faces.push_back({{v[0], v[2], v[3], 0}, face.group});
  }
  return mesh;
}

/// Moves the vertices inside the block by up to a fraction of the shortest
/// edge, and those of its contact surface within the surface.
inline void shake(meshes::BlockMesh& mesh, double distance) {
  unsigned int turn = 1;
  for (meshes::Place& place : mesh.vertices) {
    const std::array<double, 3> lengths{mesh.length_x, mesh.length_y,
                                        mesh.depth};
    for (std::size_t i = 0; i < 3; ++i) {
      turn = turn * 1664525U + 1013904223U;
      if (place[i] > 1e-9 * lengths[i] && place[i] < (1.0 - 1e-9) * lengths[i])
        place[i] += distance * (turn / 4294967296.0 - 0.5);
    }
  }
}

} // namespace asperity::fem
