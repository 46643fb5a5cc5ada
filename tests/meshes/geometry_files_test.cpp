// Verifies that geometry_files() finds the files that a geometry includes,
// directly and through an included file, once each, and nothing else.
#include "meshes/geometry_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace asperity::meshes {
namespace {

namespace fs = std::filesystem;

class GeometryFiles : public testing::Test {
protected:
  GeometryFiles()
      : folder_(fs::temp_directory_path() /
                ("asperity_geometry_" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "parts");
  }

  ~GeometryFiles() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

private:
  fs::path folder_;
};

TEST_F(GeometryFiles, FollowsIncludes) {
  const fs::path size =
      write("parts/size.geo", "h = 0.1; // Include \"../block.geo\"\n");
  const fs::path shape = write("parts/shape.step", "Include \"size.geo\"");
  const fs::path block = write(
      "block.geo", "// a punch 5\" wide\nInclude \"parts/size.geo\";\n"
                   "Merge \"parts/shape.step\";\nInclude \"absent.geo\";\n"
                   "Physical Surface(\"contact\") = {1};");
  EXPECT_EQ(geometry_files(block), (std::vector{block, size, shape}));
}

TEST_F(GeometryFiles, IsTheMeshAlone) {
  const fs::path mesh = write("block.msh", "\"block.msh\"");
  EXPECT_EQ(geometry_files(mesh), std::vector{mesh});
}

} // namespace
} // namespace asperity::meshes
