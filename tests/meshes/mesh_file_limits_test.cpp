// Tests of the resources that a mesh file may use (meshes/mesh_file.hpp), and
// of meshes that are passed from one process to another
// (meshes/mesh_bytes.hpp).
#include "meshes/gmsh_file.hpp"
#include "meshes/mesh_bytes.hpp"
#include "meshes/mesh_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/message_of.hpp"

namespace asperity::meshes::mesh_file_limits_test {

constexpr const char* coated = "tests/meshes/data/coated.geo";

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

} // namespace asperity::meshes::mesh_file_limits_test
