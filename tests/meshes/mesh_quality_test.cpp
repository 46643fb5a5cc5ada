// Tests of meshes/mesh_quality.hpp.
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/mesh_quality.hpp"
#include "tests/meshes/mesh_measures.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace asperity::meshes::mesh_quality_test {

BlockMesh one_tetrahedron(const std::array<Place, 4>& corners) {
  BlockMesh mesh;
  mesh.shape = CellShape::tetrahedron;
  mesh.vertices.assign(corners.begin(), corners.end());
  mesh.cells = {{0, 1, 2, 3, 0, 0, 0, 0}};
  mesh.cell_group = {0};
  mesh.faces = {{{0, 1, 2, 0}, FaceGroup::contact}};
  return mesh;
}

// (M.3) is 1 for any box and sin(angle) for a sheared one. Tolerance: roundoff
// of a determinant.
TEST(CellShapeOf, HexahedraIsTheSineOfTheirShear) {
  BlockMesh mesh = layered_mesh({1, 1, 3.0, 2.0}, {0.1});
  EXPECT_NEAR(cell_shape(mesh, 0), 1.0, 1e-15);

  const double angle = 40.0 * std::numbers::pi / 180.0;
  for (Place& vertex : mesh.vertices)
    vertex[0] += vertex[1] / std::tan(angle);
  EXPECT_NEAR(cell_shape(mesh, 0), std::sin(angle), 1e-15);
}

// The shape is that of the worst corner: one is moved half the way to its
// opposite along the space diagonal, where the edges are e_d - (1, 1, 1) / 2.
TEST(CellShapeOf, HexahedraIsTheWorstCorners) {
  BlockMesh mesh = layered_mesh({1, 1, 1.0, 1.0}, {1.0});
  mesh.vertices[7] = {0.5, 0.5, 0.5};

  // The determinant of the identity minus a matrix of rank one: 1 - 3/2.
  const double length = std::sqrt(0.75);
  EXPECT_NEAR(cell_shape(mesh, 0), -0.5 / (length * length * length), 1e-15);
}

// (M.4) is 1 for the regular tetrahedron, 0 for a flat one, and 12 (1/2)^(2/3)
// / 9 for the corner of a cube; for inverted cells all change sign.
TEST(CellShapeOf, TetrahedraIsTheirMeanRatio) {
  const Place a = {1, 1, 1}, b = {-1, -1, 1}, c = {-1, 1, -1}, d = {1, -1, -1};
  const Place o = {0, 0, 0}, x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};

  EXPECT_NEAR(cell_shape(one_tetrahedron({a, b, c, d}), 0), 1.0, 1e-15);
  EXPECT_NEAR(cell_shape(one_tetrahedron({a, c, b, d}), 0), -1.0, 1e-15);
  EXPECT_NEAR(cell_shape(one_tetrahedron({o, x, y, z}), 0),
              12.0 * std::cbrt(0.25) / 9.0, 1e-15);
  EXPECT_EQ(cell_shape(one_tetrahedron({o, x, y, {1, 1, 0}}), 0), 0.0);
}

// Counts are those after the cuts, and edges those of the finest cells at the
// contact surface and of the coarsest overall, by levels of (M.6): two layers
// of 16 x 16 cells, three of 8 x 8 and two of 4 x 4, with vertices of the finer
// cells between two levels.
TEST(MeshQualityOf, AHangingMeshCountsItsCuts) {
  const MeshQuality quality =
      mesh_quality(hanging_mesh({16, 16, 16e-9, 16e-9}, 16e-9, 2));

  EXPECT_EQ(quality.n_cells, 16u * 16 * 2 + 8 * 8 * 3 + 4 * 4 * 2);
  EXPECT_EQ(quality.n_vertices, 17u * 17 * 3 + 9 * 9 * 3 + 5 * 5 * 2);
  EXPECT_EQ(quality.n_contact_faces, 256u);
  EXPECT_NEAR(quality.contact_edges.smallest, 1e-9, 1e-22);
  EXPECT_NEAR(quality.contact_edges.largest, 1e-9, 1e-22);
  EXPECT_NEAR(quality.edges.largest, 4e-9, 1e-22);
  EXPECT_NEAR(quality.mean_shape, 1.0, 1e-12);
}

// The worst cell is found with its position; the mean is over all cells.
TEST(MeshQualityOf, ASkewedMeshNamesItsWorstCell) {
  BlockMesh mesh = layered_mesh({3, 1, 3.0, 1.0}, {1.0});
  mesh.vertices[7][0] += 0.75; // corner (3, 1, 0) of the last cell only
  mesh.group_names = {"soft", "hard"};
  mesh.cell_group = {0, 1, 1};

  const MeshQuality quality = mesh_quality(mesh);

  EXPECT_EQ(quality.worst_cell, 2u);
  EXPECT_NEAR(quality.worst_place[0], 2.5 + 0.75 / 8.0, 1e-15);
  // Two edges of 1.25 where there was 1 (3-4-5), with the determinant
  // unchanged.
  EXPECT_NEAR(quality.smallest_shape, 0.64, 1e-15);
  EXPECT_NEAR(quality.mean_shape, (1.0 + 1.0 + 0.64) / 3.0, 1e-15);
  EXPECT_EQ(quality.cells_per_group, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(quality_text(quality),
            "3 hexahedra (soft 1, hard 2), 16 vertices, 3 contact faces\n"
            "edges 1 to 1.75 m, at the contact surface 1 to 1.75 m\n"
            "scaled Jacobian: mean 0.880, smallest 0.640 (cell 2 at (2.59375, "
            "0.5, 0.5) m)");
}

TEST(MeshQualityOf, TetrahedraNamesTheirMeanRatio) {
  const MeshQuality quality = mesh_quality(one_tetrahedron(
      {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 5.0}}}));

  EXPECT_DOUBLE_EQ(quality.edges.largest, std::sqrt(29.0));
  EXPECT_DOUBLE_EQ(quality.contact_edges.largest, std::sqrt(5.0));
  EXPECT_NE(quality_text(quality).find("1 tetrahedra, 4 vertices"),
            std::string::npos);
  EXPECT_NE(quality_text(quality).find("mean ratio"), std::string::npos);
}

TEST(MeshQualityOf, AnEmptyMeshIsRefused) {
  EXPECT_THROW(mesh_quality(BlockMesh{}), std::domain_error);
}

} // namespace asperity::meshes::mesh_quality_test
