// Tests of what a mesh file may do besides describing a mesh
// (meshes/mesh_file.hpp): nothing, unless it is allowed.
#include "meshes/mesh_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/message_of.hpp"

namespace asperity::meshes::mesh_file_commands_test {

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

} // namespace asperity::meshes::mesh_file_commands_test
