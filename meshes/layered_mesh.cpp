#include "meshes/layered_mesh.hpp"

#include "base/refused_argument.hpp"
#include "base/require.hpp"

#include <numeric>

namespace asperity::meshes {
namespace {

/// Numbers the vertices of a block of n_x * n_y * n_z cells.
struct VertexGrid {
  unsigned int n_x = 1, n_y = 1, n_z = 1;

  unsigned int operator()(unsigned int i, unsigned int j,
                          unsigned int k) const {
    return i + (n_x + 1) * (j + (n_y + 1) * k);
  }
};

void check(const Grid& face, const std::vector<double>& thickness) {
  require_positive("points_x", face.points_x, "1");
  require_positive("points_y", face.points_y, "1");
  require_positive("length_x", face.length_x, "m");
  require_positive("length_y", face.length_y, "m");
  const auto n_layers = static_cast<double>(thickness.size());
  require_positive("number of layers", n_layers, "1");
  for (const double layer : thickness)
    require_positive("thickness", layer, "m");
  const double n_vertices =
      (face.points_x + 1.0) * (face.points_y + 1.0) * (n_layers + 1.0);
  require_between(Argument{"number of vertices", "surface.points"}, n_vertices,
                  8.0, 2147483648.0, "1");
}

/// Coordinate i of n equal steps from 0 to length; both ends are exact.
double step(unsigned int i, unsigned int n, double length) {
  return length * (static_cast<double>(i) / static_cast<double>(n));
}

void add_vertices(BlockMesh& mesh, const VertexGrid& at,
                  const std::vector<double>& thickness) {
  mesh.vertices.reserve(at(at.n_x, at.n_y, at.n_z) + std::size_t{1});
  double z = 0.0;
  for (unsigned int k = 0; k <= at.n_z; ++k) {
    for (unsigned int j = 0; j <= at.n_y; ++j)
      for (unsigned int i = 0; i <= at.n_x; ++i)
        mesh.vertices.push_back({step(i, at.n_x, mesh.length_x),
                                 step(j, at.n_y, mesh.length_y), z});
    if (k < at.n_z)
      z += thickness[k];
  }
}

void add_cells(BlockMesh& mesh, const VertexGrid& at) {
  mesh.cells.reserve(std::size_t{at.n_x} * at.n_y * at.n_z);
  for (unsigned int k = 0; k < at.n_z; ++k)
    for (unsigned int j = 0; j < at.n_y; ++j)
      for (unsigned int i = 0; i < at.n_x; ++i)
        mesh.cells.push_back({at(i, j, k), at(i + 1, j, k), at(i, j + 1, k),
                              at(i + 1, j + 1, k), at(i, j, k + 1),
                              at(i + 1, j, k + 1), at(i, j + 1, k + 1),
                              at(i + 1, j + 1, k + 1)});
  mesh.cell_group.assign(mesh.cells.size(), 0);
}

void add_faces(BlockMesh& mesh, const VertexGrid& at) {
  for (unsigned int j = 0; j < at.n_y; ++j)
    for (unsigned int i = 0; i < at.n_x; ++i)
      for (const unsigned int k : {0U, at.n_z})
        mesh.faces.push_back(
            {{at(i, j, k), at(i + 1, j, k), at(i, j + 1, k),
              at(i + 1, j + 1, k)},
             k == 0 ? FaceGroup::contact : FaceGroup::far_boundary});
  for (unsigned int k = 0; k < at.n_z; ++k)
    for (unsigned int j = 0; j < at.n_y; ++j)
      for (const unsigned int i : {0U, at.n_x})
        mesh.faces.push_back({{at(i, j, k), at(i, j + 1, k), at(i, j, k + 1),
                               at(i, j + 1, k + 1)},
                              i == 0 ? FaceGroup::left : FaceGroup::right});
  for (unsigned int k = 0; k < at.n_z; ++k)
    for (unsigned int i = 0; i < at.n_x; ++i)
      for (const unsigned int j : {0U, at.n_y})
        mesh.faces.push_back({{at(i, j, k), at(i + 1, j, k), at(i, j, k + 1),
                               at(i + 1, j, k + 1)},
                              j == 0 ? FaceGroup::front : FaceGroup::back});
}

} // namespace

BlockMesh layered_mesh(const Grid& face, const std::vector<double>& thickness) {
  check(face, thickness);
  BlockMesh mesh;
  mesh.length_x = face.length_x;
  mesh.length_y = face.length_y;
  mesh.depth = std::accumulate(thickness.begin(), thickness.end(), 0.0);
  const VertexGrid at{static_cast<unsigned int>(face.points_x),
                      static_cast<unsigned int>(face.points_y),
                      static_cast<unsigned int>(thickness.size())};

  add_vertices(mesh, at, thickness);
  add_cells(mesh, at);
  add_faces(mesh, at);
  return mesh;
}

} // namespace asperity::meshes
