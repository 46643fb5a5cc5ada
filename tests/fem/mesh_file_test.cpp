// Tests of fem/block/mesh_file.hpp: meshes of valid files in each format, and
// each mistake, with which a file is refused. The files in tests/fem/data were
// made by gmsh: a block of 4 x 2 x 2 mm with a coating (coated; graded with one
// fine corner) whose contact surface is up, and a cylinder of radius 1 and
// height 2 of tetrahedra (punch).
#include "fem/block/mesh_file.hpp"
#include "meshes/valid_mesh.hpp"
#include "tests/meshes/mesh_measures.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <string>

namespace asperity::fem::mesh_file_test {

using mechanics::BlockSides;
using meshes::BlockMesh;
using meshes::FaceGroup;
using meshes::Place;
namespace test = meshes::test;

constexpr double mm = 1e-3;
const std::string data = "tests/fem/data/";

BlockMesh block_of(const std::string& path, double unit, BlockSides sides) {
  BlockMesh mesh = read_mesh_file(path, unit).mesh;
  meshes::fit_sides(mesh, sides);
  return mesh;
}

// The mesh is scaled to metres, its contact surface is moved to the origin and
// turned down, and x and y are unchanged: counts, extents, volumes and areas
// are those of the geometry. Tolerance: gmsh integrates lengths to 1e-8.
TEST(ReadMeshFile, PlacesABlock) {
  const BlockMesh mesh =
      block_of(data + "coated.msh", mm, BlockSides::periodic);

  EXPECT_EQ(mesh.shape, meshes::CellShape::hexahedron);
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
}

// The mesh is mirrored along z only: the corner of smallest x and y stays that
// of the file (identified by a longer cell there). The graded edges differ by
// more than roundoff, so that they are aligned.
TEST(ReadMeshFile, KeepsTheFilesXAndY) {
  const BlockMesh mesh =
      block_of(data + "graded.msh", mm, BlockSides::periodic);

  std::set<double> places;
  for (const Place& vertex : mesh.vertices)
    if (vertex[1] == 0.0 && vertex[2] == 0.0)
      places.insert(vertex[0] / mm);
  // Cells of 8, 4, 2 and 1 fifteenths of 4 mm. gmsh integrates lengths to 1e-8.
  ASSERT_EQ(places.size(), 5u);
  EXPECT_NEAR(*std::next(places.begin()), 4.0 * 8.0 / 15.0, 1e-7);
}

// The curved side of a cylinder is `sides`; its ends have the area of the discs
// less the segments that a polygon misses: with edges of at most 0.5, at most
// 1/24 of it.
TEST(ReadMeshFile, ReadsABlockOtherThanABox) {
  const BlockMesh mesh = block_of(data + "punch.msh", 2e-9, BlockSides::free);

  std::set<FaceGroup> groups;
  for (const meshes::BoundaryFace& face : mesh.faces)
    groups.insert(face.group);
  EXPECT_EQ(groups, (std::set{FaceGroup::contact, FaceGroup::far_boundary,
                              FaceGroup::sides}));
  EXPECT_NEAR(mesh.depth, 4e-9, 1e-23);
  const double disc = std::numbers::pi * 4e-18;
  for (const auto end : {FaceGroup::contact, FaceGroup::far_boundary}) {
    EXPECT_LT(test::area_of(mesh, end), disc);
    EXPECT_GT(test::area_of(mesh, end), disc * (1.0 - 1.0 / 24.0));
  }
  EXPECT_GT(test::smallest_jacobian(mesh), 0.0);
  EXPECT_EQ(mesh.group_names, std::vector<std::string>{"punch"});
}

std::string file_with(const std::string& ending, const std::string& text) {
  const std::string path = testing::TempDir() + "asperity_mesh_file" + ending;
  std::ofstream(path) << text;
  return path;
}

const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                            "0 0 1\n1 0 1\n1 1 1\n0 1 1\n";

const std::string vtk =
    "# vtk DataFile Version 3.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\n"
    "POINTS 8 double\n" +
    corners +
    "CELLS 3 19\n8 0 1 2 3 4 5 6 7\n4 0 1 2 3\n4 4 5 6 7\nCELL_TYPES 3\n12\n9\n"
    "9\nCELL_DATA 3\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n7\n1\n2\n";

const std::string abaqus =
    "*HEADING\ncube\n*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n"
    "4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n7, 1., 1., 1.\n"
    "8, 0., 1., 1.\n*ELEMENT, TYPE=C3D8R, ELSET=EB7\n"
    "1, 1, 2, 3, 4, 5, 6, 7, 8\n*SURFACE, NAME=SS1\n1, S1\n"
    "*SURFACE, NAME=SS2\n1, S2\n";

std::string unv() {
  std::string text = "-1\n2411\n";
  std::istringstream lines(corners);
  std::string line;
  for (int i = 1; std::getline(lines, line); ++i)
    text += std::to_string(i) + " 1 1 11\n" + line + "\n";
  return text +
         "-1\n-1\n2412\n1 115 1 1 7 8\n1 2 3 4 5 6 7 8\n2 44 1 1 7 4\n"
         "1 2 3 4\n3 44 1 1 7 4\n5 6 7 8\n-1\n-1\n2467\n1 0 0 0 0 0 0 1\n7\n"
         "8 1 0 0\n2 0 0 0 0 0 0 1\n1\n8 2 0 0\n3 0 0 0 0 0 0 1\n2\n8 3 0 0\n"
         "-1\n";
}

// A cube with contact at z = 0 in the other formats, whose groups are numbers.
TEST(ReadMeshFile, ReadsOtherFormats) {
  for (const auto& [ending, text] :
       {std::pair{".vtk", vtk}, {".inp", abaqus}, {".unv", unv()}}) {
    const BlockMesh mesh =
        block_of(file_with(ending, text), 1.0, BlockSides::periodic);

    EXPECT_EQ(mesh.cells.size(), 1U) << ending;
    EXPECT_EQ(mesh.group_names, std::vector<std::string>{"volume 7"}) << ending;
    EXPECT_NEAR(test::area_of(mesh, FaceGroup::contact), 1.0, 1e-15) << ending;
    EXPECT_NEAR(test::area_of(mesh, FaceGroup::far_boundary), 1.0, 1e-15);
    EXPECT_NEAR(test::volume_of(mesh, 0), 1.0, 1e-15) << ending;
  }
}

TEST(ReadMeshFile, KnowsAMeshByItsHash) {
  const std::string hash = read_mesh_file(data + "coated.msh", mm).hash;

  EXPECT_EQ(read_mesh_file(data + "coated.msh", mm).hash, hash);
  EXPECT_NE(read_mesh_file(data + "coated.msh", 2.0 * mm).hash, hash);
}

std::string answer(const std::string& path,
                   BlockSides sides = BlockSides::free) {
  return tests::message_of<std::domain_error>(
      [&] { block_of(path, 1.0, sides); });
}

std::string answer_to_text(const std::string& ending, const std::string& text,
                           BlockSides sides = BlockSides::free) {
  const std::string path = file_with(ending, text);
  const std::string found = answer(path, sides);
  EXPECT_TRUE(found == "accepted" || found.starts_with(path + ": ") ||
              found.starts_with("mesh: "))
      << found;
  return found;
}

/// The parts of a .msh 2.2 file: two tetrahedra, 1 2 3 4 on the face 1 of the
/// contact surface
/// 2 3 and 2 5 3 4 behind it, clamped at 3 4 5.
struct Parts {
  std::string names = "2 1 \"contact\"\n2 2 \"fixed\"\n3 3 \"block\"\n";
  int n_names = 3;
  std::string nodes = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n";
  std::string elements = "1 2 2 1 1 1 2 3\n2 2 2 2 2 3 4 5\n"
                         "3 4 2 3 1 1 2 3 4\n4 4 2 3 1 2 5 3 4\n";
  int n_elements = 4;
};

std::string msh(const Parts& parts) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" +
         std::to_string(parts.n_names) + "\n" + parts.names +
         "$EndPhysicalNames\n$Nodes\n5\n" + parts.nodes +
         "$EndNodes\n$Elements\n" + std::to_string(parts.n_elements) + "\n" +
         parts.elements + "$EndElements\n";
}

void expect_answer(const Parts& parts, const std::string& words,
                   BlockSides sides = BlockSides::free) {
  const std::string found = answer_to_text(".msh", msh(parts), sides);
  EXPECT_NE(found.find(words), std::string::npos) << found;
}

TEST(ReadMeshFileRefuses, NothingOfAValidFile) {
  expect_answer({}, "accepted");
}

// A .geo file is never executed.
TEST(ReadMeshFileRefuses, FilesOfAnotherKind) {
  EXPECT_EQ(answer("none.msh"), "none.msh: there is no such file");
  EXPECT_NE(answer_to_text(".geo", "SystemCall \"touch made\";\n")
                .find("mesh it first: gmsh -3 asperity_mesh_file.geo"),
            std::string::npos);
  for (const char* ending : {".step", ".stl", ".pos", ".MSH", ""})
    EXPECT_NE(answer_to_text(ending, msh({}))
                  .find("from a .msh, .inp, .vtk or .unv file"),
              std::string::npos)
        << ending;
  EXPECT_NE(answer_to_text(".msh", "SystemCall \"touch made\";\n")
                .find("begins with \"SystemCall \"touch made\";\", but a .msh "
                      "file must begin with $MeshFormat"),
            std::string::npos);
  for (const char* text : {"", "\n", " $MeshFormat\n", "$MeshFormatted\n",
                           "$NOD\n1\n1 0 0 0\n$ENDNOD\n", "solid\n"})
    EXPECT_NE(answer_to_text(".msh", text).find("must begin with $MeshFormat"),
              std::string::npos)
        << text;
  EXPECT_NE(
      answer_to_text(".msh", "$MeshFormat\n4.1 1 8\n").find("as text: gmsh -3"),
      std::string::npos);
  EXPECT_NE(answer_to_text(".vtk", "solid").find("is refused by deal.II"),
            std::string::npos);
}

TEST(ReadMeshFileRefuses, AnInvalidUnit) {
  EXPECT_TRUE(tests::message_of<std::domain_error>([] {
                read_mesh_file(data + "coated.msh", 0.0);
              }).starts_with("unit = 0"));
}

TEST(ReadMeshFileRefuses, MissingGroups) {
  Parts no_contact;
  no_contact.names = "2 1 \"contcat\"\n2 2 \"fixed\"\n3 3 \"block\"\n";
  Parts no_fixed;
  no_fixed.elements = "1 2 2 1 1 1 2 3\n3 4 2 3 1 1 2 3 4\n4 4 2 3 1 2 5 3 4\n";
  no_fixed.n_elements = 3;

  expect_answer(no_contact, "no group of faces is named contact (or 1); there "
                            "are: contcat, fixed");
  expect_answer(no_fixed, "no group of faces is named fixed (or 2); there are: "
                          "contact");
}

TEST(ReadMeshFileRefuses, CellsOfOtherKinds) {
  Parts prism;
  prism.elements = "1 2 2 1 1 1 2 3\n2 6 2 3 1 1 2 3 4 5 5\n";
  prism.n_elements = 2;
  Parts mixed;
  mixed.elements += "5 5 2 3 1 1 2 3 4 5 1 2 3\n";
  mixed.n_elements = 5;

  expect_answer(prism, "is refused by deal.II");
  expect_answer(mixed, "cells must be all hexahedra of 8 or all tetrahedra");
}

TEST(ReadMeshFileRefuses, AContactSurfaceThatIsNotFlat) {
  Parts bent;
  bent.nodes = "1 0 0 0\n2 1 0 0.01\n3 0 1 0\n4 0 0 1\n5 1 1 1\n";

  expect_answer(bent, "not flat: its vertex 1 at (1, 0, 0.01) m is 0.01 m off");
}

TEST(ReadMeshFileRefuses, ContradictoryGroups) {
  Parts inside; // 2 3 4 is between the two cells
  inside.elements += "5 2 2 2 3 2 3 4\n";
  inside.n_elements = 5;
  Parts both;
  both.elements += "5 2 2 2 3 1 2 3\n";
  both.n_elements = 5;
  Parts nowhere;
  nowhere.elements = "1 2 2 1 1 1 2 3\n2 2 2 2 2 1 2 5\n3 4 2 3 1 1 2 3 4\n";
  nowhere.n_elements = 3;

  expect_answer(inside, "the group fixed has a face at (0.333333, 0.333333, "
                        "0.333333) m inside the block");
  expect_answer(both, "a face of the group fixed is also in the group contact");
  expect_answer(nowhere, "a face of the group fixed touches no cell");
}

// A block that is not a box cannot be periodic.
TEST(ReadMeshFileRefuses, PeriodicSidesOfOtherBlocks) {
  expect_answer({}, "a periodic block needs the face", BlockSides::periodic);
}

/// Replaces a random word of the text by an invalid one, or removes or repeats
/// a random line.
std::string damaged(std::string text, std::mt19937& random) {
  const auto up_to = [&random](std::size_t n) { return random() % n; };
  if (up_to(3) == 0) {
    const std::size_t begin = text.rfind('\n', up_to(text.size() - 1)) + 1;
    const std::size_t length = text.find('\n', begin) + 1 - begin;
    if (up_to(2) == 0)
      return text.erase(begin, length);
    return text.insert(begin, text.substr(begin, length));
  }
  const std::array<std::string, 9> awkward = {
      "",      "-1",  "0",    "2147483648", "18446744073709551615",
      "1e300", "nan", "1e-9", "x"};
  const std::size_t begin =
      text.find_last_of(" \n", up_to(text.size() - 1)) + 1;
  return text.replace(begin, text.find_first_of(" \n", begin) - begin,
                      awkward[up_to(awkward.size())]);
}

// However a file is damaged, it is read or refused by name (expected by
// answer_to_text), and nothing else happens: deal.II itself ends by a signal
// for some of these.
TEST(ReadMeshFileRefuses, AnyDamage) {
  std::mt19937 random(1);
  int accepted = 0;
  for (int i = 0; i < 60; ++i) {
    const std::array<std::pair<const char*, std::string>, 4> files{
        {{".msh", msh({})}, {".vtk", vtk}, {".inp", abaqus}, {".unv", unv()}}};
    auto [ending, text] = files[static_cast<std::size_t>(i) % 4];
    for (int damages = 1 + i % 3; damages > 0; --damages)
      text = damaged(text, random);
    SCOPED_TRACE(text);
    accepted += answer_to_text(ending, text) == "accepted" ? 1 : 0;
  }
  EXPECT_GT(accepted, 0); // damage to a comment, for example
  EXPECT_LT(accepted, 30);
}

} // namespace asperity::fem::mesh_file_test
