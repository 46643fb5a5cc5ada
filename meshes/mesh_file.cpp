#include "meshes/mesh_file.hpp"

#include "base/child_process.hpp"
#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "base/require.hpp"
#include "base/temporary_folder.hpp"
#include "meshes/matching_sides.hpp"
#include "meshes/mesh_bytes.hpp"
#include "meshes/valid_mesh.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

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

/// The first line of a file, without its end; no more than a mesh begins with.
std::string first_line(const fs::path& path) {
  constexpr std::size_t longest = 64;
  std::ifstream file(path, std::ios::binary);
  std::string line(longest, '\0');
  file.read(line.data(), static_cast<std::streamsize>(longest));
  line.resize(static_cast<std::size_t>(file.gcount()));
  return line.substr(0, line.find_first_of("\r\n"));
}

/// Requires what the extension promises, because gmsh decides by the content.
void require_kind(const fs::path& path) {
  std::error_code none;
  if (!fs::exists(path, none))
    throw std::domain_error("there is no such file");
  if (!fs::is_regular_file(path, none))
    throw std::domain_error("is no regular file");
  if (path.extension() != ".msh" && path.extension() != ".geo")
    throw std::domain_error("a mesh must be read from a .msh or a .geo file");
  const std::string line = first_line(path);
  if (path.extension() == ".msh" && line != "$MeshFormat")
    throw std::domain_error(fmt::format(
        "begins with \"{}\", but a .msh file must begin with $MeshFormat "
        "(format 2 or 4 of gmsh; gmsh -3 -o NEW.msh OLD converts others)",
        printable(line)));
  if (path.extension() == ".geo" && line.starts_with('$'))
    throw std::domain_error(fmt::format(
        "begins with \"{}\" and is no script of gmsh; a mesh must be named "
        ".msh",
        printable(line)));
}

/// The folder that serves gmsh as home, so that it finds no files there.
std::vector<std::string> environment_with_home(const fs::path& home) {
  std::vector<std::string> environment = own_environment();
  std::erase_if(environment, [](const std::string& entry) {
    return entry.starts_with("HOME=") || entry.starts_with("GMSH");
  });
  environment.push_back("HOME=" + home.string());
  return environment;
}

/// What is wrong, of a child that made no mesh.
std::string reason(const ChildAnswer& answer, const MeshFileLimits& limits) {
  if (answer.end.exit_code == 2)
    return answer.output;
  constexpr int ended_by_signal = 128;
  if (answer.end.exit_code == ended_by_signal + SIGSYS)
    return "starts a program or does something else that the file of a mesh "
           "may do only with allow_commands = true in [mesh]";
  return fmt::format("gmsh ended without a mesh: {}{}{}. It may take {:.6g} s "
                     "and {:.6g} GiB of memory; generate a larger mesh "
                     "beforehand (gmsh -3) and give its .msh file",
                     answer.end.failure, answer.output.empty() ? "" : ", ",
                     answer.output, limits.wall_time,
                     static_cast<double>(limits.memory) / 1073741824.0);
}

std::string bytes_by_gmsh(const MeshFile& file, const MeshFileLimits& limits) {
  const TemporaryFolder scratch("asperity-mesh");
  const fs::path output = scratch.path() / "mesh";
  const fs::path home = scratch.path() / "home";
  fs::create_directory(home);
  fs::path opened = fs::absolute(file.path);
  const bool is_script = opened.extension() == ".geo";
  if (!is_script) {
    opened = home / "mesh.msh";
    fs::copy_file(file.path, opened);
  }
  const ChildAnswer answer = run_child(
      {.words = {mesh_program().string(), opened.string(),
                 fmt::format("{}", file.unit),
                 is_script && file.allow_commands ? "unconfined" : "confined",
                 output.string()},
       .folder = is_script ? opened.parent_path() : home,
       .environment = environment_with_home(home),
       .limits = {.wall_time = limits.wall_time, .memory = limits.memory}});
  if (!answer.end.failure.empty()) {
    std::string words = reason(answer, limits);
    boost::replace_all(words, opened.string(), file.path);
    throw std::domain_error(words);
  }
  std::ifstream stream(output, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty())
    throw std::domain_error("the file ends gmsh (Exit or Abort) before there "
                            "is a mesh");
  return bytes;
}

} // namespace

FileMesh read_mesh_file(const MeshFile& file, const MeshFileLimits& limits) {
  require_positive("unit", file.unit, "m");
  try {
    require_kind(file.path);
    const std::string bytes = bytes_by_gmsh(file, limits);
    return {mesh_of_bytes(bytes), content_hash(bytes)};
  } catch (const std::domain_error& error) {
    throw std::domain_error(file.path + ": " + error.what());
  }
}

void fit_sides(BlockMesh& mesh, mechanics::BlockSides sides) {
  require_valid_mesh(mesh, mechanics::BlockSides::free);
  if (sides == mechanics::BlockSides::periodic) {
    align_sides(mesh);
    require_valid_mesh(mesh, sides);
  }
}

} // namespace asperity::meshes
