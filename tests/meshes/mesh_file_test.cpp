// Tests of meshes/mesh_file.hpp: meshes of valid files (invalid ones are in
// mesh_file_refusals), what a file may do besides describing a mesh, and the
// resources that it may use; also of meshes/mesh_bytes.hpp, which passes a mesh
// from one process to another.
#include "meshes/gmsh_file.hpp"
#include "meshes/gmsh_session.hpp"
#include "meshes/mesh_bytes.hpp"
#include "meshes/mesh_file.hpp"
#include "tests/meshes/block_of_file.hpp"
#include "tests/meshes/mesh_measures.hpp"
#include "tests/message_of.hpp"

#include <gmsh.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

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

namespace fs = std::filesystem;

constexpr const char* box = R"(
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Transfinite Curve {:} = 3;
Transfinite Surface {:};
Transfinite Volume {1};
Recombine Surface {:};
Physical Surface("contact") = {5};
Physical Surface("fixed") = {6};
)";

constexpr const char* tetrahedra = R"(
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Physical Surface("contact") = {5};
Physical Surface("fixed") = {6};
)";

/// A folder with the files of a geometry. A command that is executed leaves the
/// file "made" in it.
class MeshFileCommands : public testing::Test {
protected:
  MeshFileCommands()
      : folder_(fs::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  ~MeshFileCommands() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  std::string path(const std::string& name) const { return folder_ / name; }

  std::string answer(const std::string& name, bool allow_commands) const {
    return tests::message_of<std::domain_error>([&] {
      read_mesh_file({path(name), 1.0, allow_commands});
    });
  }

  bool is_made() const { return fs::exists(folder_ / "made"); }

  /// Expects the text, in front of a valid geometry, to be refused with these
  /// words and to have done nothing.
  void expect_refused(const std::string& text, const std::string& words,
                      const std::string& geometry = box) const {
    write("block.geo", text + geometry);
    write("kept", "kept");

    const std::string found = answer("block.geo", false);

    EXPECT_NE(found.find(words), std::string::npos) << text << found;
    EXPECT_NE(found.find("allow_commands = true"), std::string::npos) << found;
    EXPECT_TRUE(found.starts_with(path("block.geo") + ": ")) << found;
    EXPECT_FALSE(is_made()) << text;
    EXPECT_EQ(fs::file_size(folder_ / "kept"), 4U) << text;
  }

  fs::path folder_;
};

TEST_F(MeshFileCommands, StartNoProgram) {
  const std::string touch = "touch " + path("made");
  expect_refused("x = 1;\nSystemCall \"" + touch + "\";\n",
                 "block.geo', line 2: starts a program (" + touch + ")");
  for (const std::string& command :
       {"System \"" + touch + "\";", "NonBlockingSystemCall \"" + touch + "\";",
        "SystemCall StrCat(\"tou\", \"ch " + path("made") + "\");",
        "OnelabRun(\"x\", \"" + touch + "\");",
        "Macro Run\n SystemCall \"" + touch + "\";\nReturn\nCall Run;"})
    expect_refused(command + "\n", "block.geo', line ");
  // The size of cells may come from a program, which starts when they are made.
  expect_refused("Field[1] = ExternalProcess;\nField[1].CommandLine = \"" +
                     touch + "\";\nBackground Field = 1;\n",
                 "block.geo: starts a program", tetrahedra);
}

TEST_F(MeshFileCommands, WriteNoFile) {
  const std::string made = path("made");
  const std::string kept = path("kept");
  expect_refused("Printf(\"text\") > \"made\";\n",
                 "line 1: writes a file (" + made + ")");
  for (const std::string& command :
       {"Printf(\"text\") >> \"" + made + "\";", "Save \"" + made + ".msh\";",
        "Print \"" + made + ".geo_unrolled\";", "CreateDir \"" + made + "\";",
        "Printf(\"\") > \"" + kept + "\";"})
    expect_refused(command + "\n", "block.geo', line 1: ");
  // gmsh removes its temporary file when it ends.
  std::string up;
  for (int i = 0; i < 20; ++i)
    up += "../";
  expect_refused("General.TmpFileName = \"" + up + kept + "\";\n",
                 "block.geo: creates, changes or removes a file (");
}

TEST_F(MeshFileCommands, AreRefusedInFilesThatAreIncluded) {
  const std::string command = "SystemCall \"touch " + path("made") + "\";\n";
  write("run.geo", "\n" + command);
  write("r1n.geo", "\n" + command);
  write("run.msh", command);
  for (const char* include :
       {"Include \"run.geo\";\n", "Merge \"run.geo\";\n",
        "Include Sprintf(\"r%gn.geo\", 1);\n", "Merge \"run.msh\";\n"})
    expect_refused(include, "starts a program");
  expect_refused("Include \"run.geo\";\n",
                 "run.geo', line 2: starts a program");
}

TEST_F(MeshFileCommands, AreAllowedByTheKey) {
  write("block.geo", "SystemCall \"echo > made\";\n" + std::string(box));

  EXPECT_EQ(answer("block.geo", true), "accepted");

  EXPECT_TRUE(is_made());
}

TEST_F(MeshFileCommands, AreNoPartOfAMshFile) {
  write("block.msh", "SystemCall \"touch " + path("made") + "\";\n");
  for (const bool allow : {false, true})
    EXPECT_NE(answer("block.msh", allow).find("must begin with $MeshFormat"),
              std::string::npos);
  write("block.msh", "$MeshFormat\nSystemCall \"touch " + path("made") +
                         "\";\n$EndMeshFormat\n");
  EXPECT_NE(answer("block.msh", true), "accepted");

  EXPECT_FALSE(is_made());
}

// Option files would change the mesh and may contain any command: neither those
// beside a file nor those of the user or the working folder are read.
TEST_F(MeshFileCommands, OptionFilesAreNotRead) {
  write("block.geo", "Merge \"part.geo\";\n" + std::string(box));
  write("part.geo", "x = 1;\n");
  const std::string hash = read_mesh_file({path("block.geo")}).hash;
  const std::string options =
      "SystemCall \"touch " + path("made") + "\"; Geometry.Tolerance = 0.5;\n";
  for (const char* name : {"block.geo.opt", "part.geo.opt", ".gmshrc",
                           ".gmsh-options", "block.msh.opt"})
    write(name, options);
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  setenv("GMSH_HOME", folder_.c_str(), 1);

  for (const bool allow : {false, true})
    EXPECT_EQ(read_mesh_file({path("block.geo"), 1.0, allow}).hash, hash);

  fs::current_path(before);
  unsetenv("GMSH_HOME");
  EXPECT_FALSE(is_made());
}

std::string answer_to(const std::string& ending, const std::string& text,
                      const MeshFileLimits& limits) {
  const std::string path = testing::TempDir() + "asperity_limits" + ending;
  std::ofstream(path) << text;
  return tests::message_of<std::domain_error>(
      [&] { read_mesh_file({path}, limits); });
}

// The mesh from the other process is the same to the last bit.
TEST(ReadMeshFile, EqualsTheMeshOfTheOtherProcess) {
  const std::string here = bytes_of(gmsh_file(coated, 1e-3));
  const std::string there = bytes_of(read_mesh_file({coated, 1e-3}).mesh);

  EXPECT_EQ(here, there);
  EXPECT_GT(here.size(), 1000U);
}

// A file that would keep gmsh busy without end is refused, and the limit is
// named.
TEST(ReadMeshFile, StopsAnEndlessFile) {
  const std::string words =
      answer_to(".geo", "For i In {1:1e15}\n  x = i;\nEndFor\n",
                {.wall_time = 1.0, .memory = std::uintmax_t{8} << 30});

  EXPECT_NE(words.find("asperity_limits.geo: gmsh ended without a mesh"),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("It may take 1 s and 8 GiB"), std::string::npos)
      << words;
}

// So is a file with more cells than fit into the memory.
TEST(ReadMeshFile, StopsAFileThatNeedsAllMemory) {
  const std::string words =
      answer_to(".geo",
                "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n"
                "Transfinite Curve {:} = 400;\nTransfinite Surface {:};\n"
                "Transfinite Volume {1};\n",
                {.wall_time = 300.0, .memory = std::uintmax_t{5} << 27});

  EXPECT_NE(words.find("gmsh ended without a mesh"), std::string::npos)
      << words;
  EXPECT_NE(words.find("out of memory"), std::string::npos) << words;
  EXPECT_NE(words.find("0.625 GiB"), std::string::npos) << words;
}

TEST(MeshBytes, AreRefusedIfTruncatedOrTooLong) {
  const std::string bytes = bytes_of(gmsh_file(coated, 1.0));

  EXPECT_EQ(bytes_of(mesh_of_bytes(bytes)), bytes);
  EXPECT_THROW(mesh_of_bytes(bytes + "x"), std::runtime_error);
  EXPECT_THROW(mesh_of_bytes(bytes.substr(0, bytes.size() - 1)),
               std::runtime_error);
  EXPECT_THROW(mesh_of_bytes(""), std::runtime_error);
}

} // namespace asperity::meshes::mesh_file_test
