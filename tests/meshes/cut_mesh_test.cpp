// Tests of meshes/cut_mesh.hpp.
#include "meshes/cut_mesh.hpp"
#include "meshes/facets.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"
#include "tests/meshes/mesh_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace asperity::meshes::cut_mesh_test {

constexpr double eps = std::numeric_limits<double>::epsilon();

std::vector<Place> sorted_places(BlockMesh mesh) {
  std::sort(mesh.vertices.begin(), mesh.vertices.end());
  return mesh.vertices;
}

std::size_t count_of(const BlockMesh& mesh, FaceGroup group) {
  return static_cast<std::size_t>(
      std::count_if(mesh.faces.begin(), mesh.faces.end(),
                    [&](const auto& face) { return face.group == group; }));
}

// A mesh in which every cell is cut is the one with twice the cells along x, y
// and z: same positions (powers of two, so to the bit), same groups of faces.
TEST(CutMesh, CutEverywhereIsTheFinerMesh) {
  BlockMesh coarse = layered_mesh({4, 2, 4.0, 2.0}, {1.0, 2.0});
  coarse.refine_below = {3.0};

  const BlockMesh cut = cut_mesh(coarse);
  const BlockMesh fine = layered_mesh({8, 4, 4.0, 2.0}, {0.5, 0.5, 1.0, 1.0});

  EXPECT_EQ(sorted_places(cut), sorted_places(fine));
  EXPECT_EQ(cut.cells.size(), fine.cells.size());
  EXPECT_TRUE(cut.refine_below.empty());
  for (const auto group : {FaceGroup::contact, FaceGroup::far_boundary,
                           FaceGroup::left, FaceGroup::back}) {
    EXPECT_EQ(count_of(cut, group), count_of(fine, group));
    EXPECT_DOUBLE_EQ(test::area_of(cut, group), test::area_of(fine, group));
  }
  EXPECT_GT(test::smallest_jacobian(cut), 0.0);
}

// Verifies the counts of a hanging mesh of 16 cells per side, m = 2, against
// (M.2): levels of edge 1 to depth 2 and 2 to depth 8, then 4 to 16. A level of
// n cells per side and k layers has n^2 k cells and, since its last layer of
// vertices is that of the next level with hanging ones between, (n + 1)^2 k
// vertices. No vertex exists twice.
TEST(CutMesh, CountsTheLevelsOfAHangingMesh) {
  const BlockMesh cut = cut_mesh(hanging_mesh({16, 16, 16.0, 16.0}, 16.0, 2));

  EXPECT_EQ(cut.cells.size(), 16u * 16 * 2 + 8 * 8 * 3 + 4 * 4 * 2);
  EXPECT_EQ(cut.vertices.size(), 17u * 17 * 3 + 9 * 9 * 3 + 5 * 5 * 2);
  const std::vector<Place> places = sorted_places(cut);
  EXPECT_EQ(std::adjacent_find(places.begin(), places.end()), places.end());
  EXPECT_EQ(count_of(cut, FaceGroup::contact), 16u * 16);
  EXPECT_EQ(count_of(cut, FaceGroup::far_boundary), 4u * 4);
  EXPECT_EQ(count_of(cut, FaceGroup::left), 16u * 2 + 8 * 3 + 4 * 2);
  EXPECT_NEAR(test::volume_of(cut), 4096.0, 4096.0 * 1e3 * eps);
}

// Every listed face still belongs to one cell, and children keep the group of
// their parent.
TEST(CutMesh, KeepsFacesAndGroups) {
  BlockMesh coarse = layered_mesh({2, 2, 2.0, 2.0}, {1.0, 1.0});
  coarse.group_names = {"near", "far"};
  coarse.cell_group = {0, 1, 1, 1, 0, 0, 0, 1};
  coarse.refine_below = {1.0};

  const BlockMesh cut = cut_mesh(coarse);

  EXPECT_DOUBLE_EQ(test::volume_of(cut, 0), 4.0);
  EXPECT_DOUBLE_EQ(test::volume_of(cut, 1), 4.0);
  ASSERT_EQ(cut.cells.size(), 8u * 4 + 4);
  std::set<std::array<unsigned int, 4>> boundary;
  for (const Facet& facet : boundary_facets(cut))
    boundary.insert(facet_key(cut.shape, facet.vertices));
  for (const BoundaryFace& face : cut.faces)
    EXPECT_TRUE(boundary.contains(facet_key(cut.shape, face.vertices)));
}

// A skewed cell is cut at the means of its corners; the expected values are
// computed separately.
TEST(CutMesh, CutsAtTheMeans) {
  BlockMesh one = layered_mesh({1, 1, 1.0, 1.0}, {1.0});
  one.vertices[7] = {3.0, 5.0, 9.0};
  one.refine_below = {10.0};

  const BlockMesh cut = cut_mesh(one);

  const auto& last = cut.cells.back();
  EXPECT_EQ(cut.vertices[last[0]], (Place{0.75, 1.0, 1.5})); // of 8 corners
  EXPECT_EQ(cut.vertices[last[1]], (Place{1.5, 1.5, 2.5}));  // of x = 1
  EXPECT_EQ(cut.vertices[last[3]], (Place{2.0, 3.0, 4.5}));  // of an edge
  EXPECT_EQ(cut.vertices[last[7]], (Place{3.0, 5.0, 9.0}));
  EXPECT_NEAR(test::volume_of(cut), test::volume_of(one), 1e-14);
}

TEST(CutMesh, RefusesTetrahedra) {
  BlockMesh mesh = layered_mesh({1, 1, 1.0, 1.0}, {1.0});
  mesh.shape = CellShape::tetrahedron;
  mesh.refine_below = {0.5};

  EXPECT_THROW(cut_mesh(mesh), std::domain_error);
}

} // namespace asperity::meshes::cut_mesh_test
