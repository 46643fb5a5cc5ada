// Tests of meshes/mesh_file.hpp with valid files. Those with invalid ones are
// in mesh_file_refusals.
#include "meshes/gmsh_session.hpp"
#include "meshes/mesh_file.hpp"

#include <gmsh.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/meshes/block_of_file.hpp"
#include "tests/meshes/mesh_measures.hpp"

namespace asperity::meshes::mesh_file_test {

using mechanics::BlockSides;

constexpr double mm = 1e-3;
const std::string coated = "tests/meshes/data/coated.geo";
const std::string punch = "tests/meshes/data/punch.geo";

std::set<FaceGroup> groups_of(const BlockMesh& mesh) {
  std::set<FaceGroup> groups;
  for (const BoundaryFace& face : mesh.faces)
    groups.insert(face.group);
  return groups;
}

// A .geo is meshed and scaled to metres, its contact surface is moved to the
// origin and turned down, and x and y are unchanged: counts, extents, volumes
// and areas are those of the text of the file. Tolerance: roundoff of sums.
TEST(ReadMeshFile, MeshesAGeometry) {
  const BlockMesh mesh = test::block_of_file(coated, mm, BlockSides::periodic);

  EXPECT_EQ(mesh.shape, CellShape::hexahedron);
  EXPECT_EQ(mesh.cells.size(), 4u * 2 * 5);
  EXPECT_EQ(mesh.group_names, (std::vector<std::string>{"coating", "bulk"}));
  EXPECT_NEAR(mesh.length_x, 4 * mm, 1e-15);
  EXPECT_NEAR(mesh.length_y, 2 * mm, 1e-15);
  EXPECT_NEAR(mesh.depth, 2 * mm, 1e-15);
  EXPECT_GT(test::smallest_jacobian(mesh), 0.0);
  EXPECT_NEAR(test::volume_of(mesh, 0), 4e-9, 1e-20);
  EXPECT_NEAR(test::volume_of(mesh, 1), 12e-9, 1e-20);
  EXPECT_NEAR(test::area_of(mesh, FaceGroup::contact), 8e-6, 1e-17);
  EXPECT_NEAR(test::area_of(mesh, FaceGroup::left), 4e-6, 1e-17);
  EXPECT_NEAR(test::area_of(mesh, FaceGroup::back), 8e-6, 1e-17);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (const unsigned int vertex : mesh.cells[cell])
      if (mesh.cell_group[cell] == 0)
        EXPECT_LE(mesh.vertices[vertex][2], 0.5 * mm + 1e-15);
      else
        EXPECT_GE(mesh.vertices[vertex][2], 0.5 * mm - 1e-15);
}

// The mesh is mirrored along z only: the corner of smallest x and y stays that
// of the file (identified by a longer cell there). The graded edges differ by
// more than valid sides may, so that they are aligned.
TEST(ReadMeshFile, KeepsTheFilesXAndY) {
  const std::string path = testing::TempDir() + "asperity_mesh_file_xy.msh";
  in_gmsh([&] {
    gmsh::open(coated);
    gmsh::model::mesh::setTransfiniteCurve(1, 5, "Progression", 0.5);
    gmsh::model::mesh::setTransfiniteCurve(3, 5, "Progression", 2.0);
    gmsh::model::mesh::generate(3);
    gmsh::write(path);
  });

  const BlockMesh mesh = test::block_of_file(path, mm, BlockSides::periodic);

  std::set<double> places;
  for (const Place& vertex : mesh.vertices)
    if (vertex[1] == 0.0 && vertex[2] == 0.0)
      places.insert(vertex[0] / mm);
  // Cells of 8, 4, 2 and 1 fifteenths of 4 mm. gmsh integrates lengths to 1e-8.
  ASSERT_EQ(places.size(), 5u);
  EXPECT_NEAR(*std::next(places.begin()), 4.0 * 8.0 / 15.0, 1e-7);
}

// The four formats in which gmsh writes a mesh are read as one mesh. Tolerance:
// 16 digits may be wrong by one ulp.
TEST(ReadMeshFile, ReadsEveryVersion) {
  const BlockMesh expected = test::block_of_file(punch, 1.0, BlockSides::free);
  for (const double version : {2.2, 4.1})
    for (const int is_binary : {0, 1}) {
      const std::string path = testing::TempDir() + "asperity_mesh_file.msh";
      in_gmsh([&] {
        gmsh::open(punch);
        gmsh::model::mesh::generate(3);
        gmsh::option::setNumber("Mesh.MshFileVersion", version);
        gmsh::option::setNumber("Mesh.Binary", is_binary);
        gmsh::write(path);
      });

      const BlockMesh mesh = test::block_of_file(path, 1.0, BlockSides::free);

      ASSERT_EQ(mesh.vertices.size(), expected.vertices.size());
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (std::size_t d = 0; d < 3; ++d)
          EXPECT_NEAR(mesh.vertices[i][d], expected.vertices[i][d], 5e-16);
      EXPECT_EQ(mesh.cells, expected.cells);
      EXPECT_EQ(mesh.group_names, std::vector<std::string>{"punch"});
      EXPECT_EQ(mesh.faces.size(), expected.faces.size());
    }
}

// The curved side of a cylinder is `sides`; its ends have the area of the discs
// less the segments that a polygon misses: with edges of at most 0.5, at most
// 1/24 of it.
TEST(ReadMeshFile, ReadsABlockOtherThanABox) {
  const BlockMesh mesh = test::block_of_file(punch, 2e-9, BlockSides::free);

  EXPECT_EQ(groups_of(mesh),
            (std::set{FaceGroup::contact, FaceGroup::far_boundary,
                      FaceGroup::sides}));
  EXPECT_NEAR(mesh.depth, 4e-9, 1e-23);
  const double disc = std::numbers::pi * 4e-18;
  for (const auto end : {FaceGroup::contact, FaceGroup::far_boundary}) {
    EXPECT_LT(test::area_of(mesh, end), disc);
    EXPECT_GT(test::area_of(mesh, end), disc * (1.0 - 1.0 / 24.0));
  }
  EXPECT_GT(test::smallest_jacobian(mesh), 0.0);
}

// So are the sides of a wedge, although two of its three sides are planes of
// the box.
TEST(ReadMeshFile, CallsNoSideOfAWedgeLeftOrFront) {
  const std::string path = testing::TempDir() + "asperity_mesh_file_wedge.geo";
  std::ofstream(path) << R"(
SetFactory("OpenCASCADE");
Wedge(1) = {0, 0, 0, 1, 1, 1, 0};
Physical Surface("contact") = {5};
Physical Surface("fixed") = {4};
)";

  const BlockMesh mesh = test::block_of_file(path, 1.0, BlockSides::free);

  EXPECT_EQ(mesh.group_names, std::vector<std::string>{"block"});
  EXPECT_EQ(groups_of(mesh),
            (std::set{FaceGroup::contact, FaceGroup::far_boundary,
                      FaceGroup::sides}));
}

} // namespace asperity::meshes::mesh_file_test
