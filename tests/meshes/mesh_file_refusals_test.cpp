// Tests of meshes/mesh_file.hpp: each invalid file is refused with its mistake.
#include "meshes/mesh_file.hpp"
#include "tests/meshes/block_of_file.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

namespace asperity::meshes::mesh_file_refusals_test {

using mechanics::BlockSides;

std::string answer(const std::string& path,
                   BlockSides sides = BlockSides::free) {
  return tests::message_of<std::domain_error>(
      [&] { test::block_of_file(path, 1.0, sides); });
}

std::string answer_to_text(const std::string& ending, const std::string& text,
                           BlockSides sides = BlockSides::free) {
  const std::string path =
      testing::TempDir() + "asperity_mesh_file_refusals" + ending;
  std::ofstream(path) << text;
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

TEST(ReadMeshFileRefuses, FilesThatAreNoMesh) {
  EXPECT_EQ(answer("none.msh"), "none.msh: there is no such file");
  EXPECT_NE(answer_to_text(".stl", "solid").find("from a .msh or a .geo"),
            std::string::npos);
  EXPECT_NE(answer_to_text(".geo", "Point(1) = {").find("gmsh: '"),
            std::string::npos);
  EXPECT_NE(answer_to_text(".geo", "Point(1) = {0, 0, 0};")
                .find("there are no cells; gmsh writes"),
            std::string::npos);
}

// A .msh file is what it says in its first line, and a .geo file is a script.
TEST(ReadMeshFileRefuses, FilesOfAnotherKindThanTheirName) {
  EXPECT_NE(answer_to_text(".msh", "Point(1) = {0, 0, 0};\n")
                .find("begins with \"Point(1) = {0, 0, 0};\", but a .msh file "
                      "must begin with $MeshFormat"),
            std::string::npos);
  for (const char* text :
       {"", "\n", " $MeshFormat\n", "$MeshFormatted\n",
        "$NOD\n1\n1 0 0 0\n$ENDNOD\n", "solid\n", "View \"x\" {\n",
        "ISO-10303-21;\n", "$PostFormat\n1.4 0 8\n$EndPostFormat\n"})
    EXPECT_NE(answer_to_text(".msh", text).find("must begin with $MeshFormat"),
              std::string::npos)
        << text;
  EXPECT_NE(answer_to_text(".geo", msh({})).find("is no script of gmsh"),
            std::string::npos);
  for (const char* ending : {".step", ".stl", ".brep", ".pos", ".geo.opt",
                             ".geo_unrolled", ".MSH", ""})
    EXPECT_NE(answer_to_text(ending, msh({})).find("a .msh or a .geo file"),
              std::string::npos)
        << ending;
}

TEST(ReadMeshFileRefuses, AnInvalidUnit) {
  try {
    read_mesh_file({"tests/meshes/data/coated.geo", 0.0});
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("unit = 0"));
  }
}

TEST(ReadMeshFileRefuses, MissingGroups) {
  Parts no_contact;
  no_contact.names = "2 1 \"contcat\"\n2 2 \"fixed\"\n3 3 \"block\"\n";
  Parts no_fixed;
  no_fixed.names = "2 1 \"contact\"\n3 3 \"block\"\n";
  no_fixed.n_names = 2;

  expect_answer(no_contact, "no physical surface is named contact; there are: "
                            "contcat, fixed");
  expect_answer(no_fixed, "no physical surface is named fixed; there are: "
                          "contact, 2");
}

TEST(ReadMeshFileRefuses, CellsOfOtherKinds) {
  Parts prism;
  prism.elements = "1 2 2 1 1 1 2 3\n2 6 2 3 1 1 2 3 4 5 5\n";
  prism.n_elements = 2;
  Parts second_order;
  second_order.elements = "1 2 2 1 1 1 2 3\n7 11 2 3 1 1 2 3 4 5 5 5 5 5 5\n";
  second_order.n_elements = 2;
  Parts mixed;
  mixed.elements += "5 5 2 3 1 1 2 3 4 5 1 2 3\n";
  mixed.n_elements = 5;

  expect_answer(prism, "element 2 is a Prism 6, but cells must be hexahedra");
  expect_answer(second_order, "element 7 is a Tetrahedron 10, but");
  expect_answer(mixed, "element 5 is a Hexahedron 8, but those before it are "
                       "tetrahedra");
}

TEST(ReadMeshFileRefuses, InvertedCells) {
  Parts inverted;
  inverted.elements = "1 2 2 1 1 1 2 3\n2 2 2 2 2 3 4 5\n"
                      "3 4 2 3 1 1 2 3 4\n4 4 2 3 1 5 2 3 4\n";

  expect_answer(inverted, "cell 1 at (0.5, 0.5, 0.5) m is inverted");
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
  Parts half_named;
  half_named.elements = "1 2 2 1 1 1 2 3\n2 2 2 2 2 3 4 5\n"
                        "3 4 2 3 1 1 2 3 4\n4 4 2 0 2 2 5 3 4\n";

  expect_answer(inside, "the physical surface fixed has a face at (0.333333, "
                        "0.333333, 0.333333) m inside the block");
  expect_answer(both,
                "element 5 of the physical surface fixed is also in another");
  expect_answer(nowhere, "element 2 of the physical surface fixed touches no");
  expect_answer(half_named, "volume 2 is in no physical volume, but others");
}

TEST(ReadMeshFileRefuses, AVolumeOfTwoGroups) {
  EXPECT_NE(answer_to_text(".geo", R"(
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Physical Volume("soft") = {1};
Physical Volume("hard") = {1};
)")
                .find("volume 1 is in two physical groups, soft and hard"),
            std::string::npos);
}

// A block that is not a box cannot be periodic, nor can a box whose sides
// differ.
TEST(ReadMeshFileRefuses, PeriodicSidesThatDoNotMatch) {
  expect_answer({}, "a periodic block needs the face", BlockSides::periodic);
  EXPECT_NE(answer_to_text(".geo", R"(
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
MeshSize {:} = 0.5;
MeshSize {1} = 0.1;
Physical Surface("contact") = {5};
Physical Surface("fixed") = {6};
Physical Volume("box") = {1};
)",
                           BlockSides::periodic)
                .find("periodic faces do not match: vertex"),
            std::string::npos);
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

// However the file is damaged, it is read or refused by name (expected by
// answer_to_text), and nothing else happens: gmsh itself ends by a signal for
// some of these.
TEST(ReadMeshFileRefuses, AnyDamage) {
  std::mt19937 random(1);
  int accepted = 0;
  for (int i = 0; i < 40; ++i) {
    std::string text = msh({});
    for (int damages = 1 + i % 3; damages > 0; --damages)
      text = damaged(text, random);
    SCOPED_TRACE(text);
    accepted += answer_to_text(".msh", text) == "accepted" ? 1 : 0;
  }
  EXPECT_GT(accepted, 1); // damage to the tag of the clamped face, for example
  EXPECT_LT(accepted, 20);
}

} // namespace asperity::meshes::mesh_file_refusals_test
