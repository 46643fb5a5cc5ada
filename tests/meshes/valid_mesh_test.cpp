// Tests of meshes/valid_mesh.hpp: each possible mistake of a mesh, in a small
// one, is named.
#include "meshes/facets.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/valid_mesh.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace asperity::meshes::valid_mesh_test {

using mechanics::BlockSides;

std::string answer(BlockMesh mesh, BlockSides sides = BlockSides::periodic) {
  return tests::message_of<std::domain_error>([&] { fit_sides(mesh, sides); });
}

/// 2 x 2 x 2 cells of 1 nm; vertex i + 3 (j + 3 k), cell i + 2 (j + 2 k).
BlockMesh cube() {
  return layered_mesh({2, 2, 2e-9, 2e-9}, {1e-9, 1e-9});
}

/// A cube of five tetrahedra whose opposite faces have crossing diagonals.
BlockMesh five_tetrahedra() {
  BlockMesh mesh = layered_mesh({1, 1, 1.0, 1.0}, {1.0});
  mesh.shape = CellShape::tetrahedron;
  mesh.cells = {
      {1, 0, 5, 3}, {2, 0, 3, 6}, {4, 0, 6, 5}, {7, 3, 5, 6}, {0, 5, 3, 6}};
  mesh.cell_group.assign(5, 0);
  mesh.faces.clear();
  using enum FaceGroup;
  mesh.faces = {{{0, 1, 3, 0}, contact},      {{0, 2, 3, 0}, contact},
                {{4, 5, 6, 0}, far_boundary}, {{5, 6, 7, 0}, far_boundary},
                {{0, 2, 6, 0}, left},         {{0, 4, 6, 0}, left},
                {{1, 3, 5, 0}, right},        {{3, 5, 7, 0}, right},
                {{0, 1, 5, 0}, front},        {{0, 4, 5, 0}, front},
                {{2, 3, 6, 0}, back},         {{3, 6, 7, 0}, back}};
  return mesh;
}

void expect_answer(const BlockMesh& mesh, const std::string& part,
                   BlockSides sides = BlockSides::periodic) {
  const std::string text = answer(mesh, sides);
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(RequireValid, AcceptsGeneratedMeshes) {
  EXPECT_EQ(answer(cube()), "accepted");
  EXPECT_EQ(answer(hanging_mesh({16, 16, 1e-6, 1e-6}, 2e-6, 2)), "accepted");
  EXPECT_EQ(answer(five_tetrahedra(), BlockSides::free), "accepted");
}

// Roundoff far above that of any file with 16 digits is not a mistake.
TEST(RequireValid, ToleratesRoundoff) {
  BlockMesh mesh = cube();
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices[i][i % 3] += i % 2 == 0 ? 5e-19 : -5e-19;

  EXPECT_EQ(answer(mesh), "accepted");
}

TEST(RequireValid, NamesInvertedAndFlatCells) {
  BlockMesh inverted = cube();
  inverted.vertices[13] = {-1e-9, 1e-9, 1e-9};
  BlockMesh turned = five_tetrahedra();
  std::swap(turned.cells[3][0], turned.cells[3][1]);
  BlockMesh flat = cube();
  for (std::size_t i = 9; i < 18; ++i)
    flat.vertices[i][2] = 0.0;

  expect_answer(inverted, "cell 0 at (2.5e-10, 5e-10, 5e-10) m is inverted: "
                          "its scaled Jacobian is -");
  expect_answer(turned, "cell 3 at (0.75, 0.75, 0.75) m is inverted: its mean "
                        "ratio is -");
  expect_answer(flat, "cell 0 at (5e-10, 5e-10, 0) m is flat");
}

TEST(RequireValid, NamesVerticesNotJoined) {
  // The upper cells get a separate vertex at the middle.
  BlockMesh cracked = cube();
  cracked.vertices.push_back(cracked.vertices[13]);
  for (std::size_t cell = 4; cell < 8; ++cell)
    for (unsigned int& vertex : cracked.cells[cell])
      vertex = vertex == 13 ? 27 : vertex;

  expect_answer(cracked,
                "vertices 13 and 27 are both at (1e-09, 1e-09, 1e-09)");
}

TEST(RequireValid, NamesAContactSurfaceThatIsNotFlat) {
  BlockMesh bent = cube();
  bent.vertices[4][2] = 1e-11;
  BlockMesh below = cube();
  for (BoundaryFace& face : below.faces)
    if (face.group == FaceGroup::contact)
      face.group = FaceGroup::sides;
  below.faces[1].group = FaceGroup::contact;
  for (Place& vertex : below.vertices)
    vertex[2] -= 2e-9;

  expect_answer(bent, "not flat: its vertex 4 at (1e-09, 1e-09, 1e-11) m is "
                      "1e-11 m off z = 0");
  expect_answer(below, "vertex 0 at (0, 0, -2e-09) m lies on the wrong side");
}

// A piece that is not connected to the fixed boundary is named: two blocks, one
// above the other, and the upper boundary of the lower one is no longer fixed.
TEST(RequireValid, NamesUnsupportedPieces) {
  BlockMesh loose = layered_mesh({1, 1, 1.0, 1.0}, {1.0});
  const BlockMesh other = loose;
  for (BoundaryFace& face : loose.faces)
    if (face.group == FaceGroup::far_boundary)
      face.group = FaceGroup::sides;
  for (const Place& vertex : other.vertices)
    loose.vertices.push_back({vertex[0], vertex[1], vertex[2] + 1.5});
  loose.cells.push_back({8, 9, 10, 11, 12, 13, 14, 15});
  loose.cell_group.push_back(0);
  for (BoundaryFace face : other.faces) {
    for (unsigned int& vertex : face.vertices)
      vertex += 8;
    if (face.group == FaceGroup::contact)
      face.group = FaceGroup::sides;
    loose.faces.push_back(face);
  }

  expect_answer(loose,
                "cell 0 at (0.5, 0.5, 0.5) m is not connected to the far",
                BlockSides::free);
}

TEST(RequireValid, NamesFacetsOfThreeCellsAndMissingSides) {
  BlockMesh three = cube();
  three.cells.push_back(three.cells.front());
  three.cells.push_back(three.cells.front());
  BlockMesh open = cube();
  for (BoundaryFace& face : open.faces)
    if (face.group == FaceGroup::back)
      face.group = FaceGroup::sides;

  EXPECT_NE(tests::message_of<std::domain_error>([&] {
              boundary_facets(three);
            }).find("cells 0, 8 and 9 share one facet"),
            std::string::npos);
  expect_answer(open, "needs the face back (y = length)");
  EXPECT_EQ(answer(open, BlockSides::free), "accepted");
}

TEST(RequireValid, NamesPeriodicSidesThatDoNotMatch) {
  BlockMesh moved = cube();
  moved.vertices[11][2] = 1.2e-9; // (2, 0, 1): of right and of front
  BlockMesh finer = cube();
  finer.vertices[10][0] = 1.1e-9; // (1, 0, 1): of front only
  BlockMesh longer = cube();
  longer.length_x = 2.1e-9;

  expect_answer(moved, "vertex 9 at (0, 0, 1e-09) m of the face left (x = 0) "
                       "has no partner on the face right");
  expect_answer(finer, "vertex 10 at (1.1e-09, 0, 1e-09) m of the face front "
                       "(y = 0) has no partner on the face back");
  expect_answer(longer, "has no partner on the face right");
  expect_answer(five_tetrahedra(), "of the face left (x = 0) has no partner on "
                                   "the face right (x = length), although its");
  EXPECT_EQ(answer(moved, BlockSides::free), "accepted");
}

// After alignment sides that differ by up to 1e-6 match, including the corners;
// larger differences are refused.
TEST(FitSides, MovesSidesOntoOneAnother) {
  BlockMesh mesh = cube();
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d)
      mesh.vertices[i][d] += 1e-16 * static_cast<double>((7 * i + 3 * d) % 5);
  for (Place& vertex : mesh.vertices)
    if (vertex[2] < 1e-15)
      vertex[2] = 0.0;

  fit_sides(mesh, BlockSides::periodic);

  for (std::size_t i = 0; i < 27; i += 3)
    for (const std::size_t d : {1U, 2U})
      EXPECT_EQ(mesh.vertices[i][d], mesh.vertices[i + 2][d]);
  mesh.vertices[11][2] += 1e-14;
  EXPECT_THROW(fit_sides(mesh, BlockSides::periodic), std::domain_error);
}

} // namespace asperity::meshes::valid_mesh_test
