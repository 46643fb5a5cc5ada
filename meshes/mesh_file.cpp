#include "meshes/mesh_file.hpp"

#include "base/child_process.hpp"
#include "base/require.hpp"
#include "base/temporary_folder.hpp"
#include "meshes/mesh_bytes.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace asperity::meshes {
namespace {

namespace fs = std::filesystem;

/// Path of asperity_mesh: in the folder of the running program, in ../meshes
/// or ../../meshes relative to it (the build tree), or in ../lib/asperity
/// relative to it (an installation).
fs::path mesh_program() {
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char* folder :
       {".", "../meshes", "../../meshes", "../lib/asperity"}) {
    fs::path program = (here / folder / "asperity_mesh").lexically_normal();
    if (fs::exists(program))
      return program;
  }
  throw std::runtime_error(
      "The program asperity_mesh, which runs gmsh, was not found near " +
      here.string());
}

[[noreturn]] void refuse(const std::string& path, const ChildAnswer& answer,
                         const MeshFileLimits& limits) {
  if (answer.end.exit_code == 2) // the output is a message that begins with the
                                 // path
    throw std::domain_error(answer.output);
  throw std::domain_error(
      fmt::format("{}: gmsh ended without a mesh: {}{}{}. It may take {:.6g} s "
                  "and {:.6g} GiB of memory; generate a larger mesh beforehand "
                  "(gmsh -3) and give its .msh file",
                  path, answer.end.failure, answer.output.empty() ? "" : ", ",
                  answer.output, limits.wall_time,
                  static_cast<double>(limits.memory) / 1073741824.0));
}

} // namespace

BlockMesh read_mesh_file(const std::string& path, double unit,
                         mechanics::BlockSides sides,
                         const MeshFileLimits& limits) {
  require_positive("unit", unit, "m");
  const TemporaryFolder scratch("asperity-mesh");
  const fs::path output = scratch.path() / "mesh";
  const ChildAnswer answer = run_child(
      {.words = {mesh_program().string(), path, fmt::format("{}", unit),
                 sides == mechanics::BlockSides::periodic ? "periodic" : "free",
                 output.string()},
       .limits = {.wall_time = limits.wall_time, .memory = limits.memory}});
  if (!answer.end.failure.empty())
    refuse(path, answer, limits);
  std::ifstream file(output, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  return mesh_of_bytes(bytes);
}

} // namespace asperity::meshes
