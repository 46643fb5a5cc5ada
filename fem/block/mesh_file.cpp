#include "fem/block/mesh_file.hpp"

#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "base/require.hpp"
#include "base/special_numbers.hpp"
#include "meshes/facets.hpp"
#include "meshes/mesh_bytes.hpp"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <new>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace asperity::fem {
namespace {

namespace fs = std::filesystem;

using meshes::BlockMesh;
using meshes::BoundaryFace;
using meshes::CellShape;
using meshes::FaceGroup;
using meshes::Facet;
using FacetKey = std::array<unsigned int, 4>;

struct GroupName {
  FaceGroup group;
  const char* name;
  const char* number;
};

constexpr std::array<GroupName, 3> group_names = {
    {{FaceGroup::contact, "contact", "1"},
     {FaceGroup::far_boundary, "fixed", "2"},
     {FaceGroup::sides, "sides", "3"}}};

/// What a reader of deal.II would make a triangulation of.
class RawMesh final : public dealii::Triangulation<3> {
public:
  using dealii::Triangulation<3>::create_triangulation;

  void create_triangulation(const std::vector<dealii::Point<3>>& places,
                            const std::vector<dealii::CellData<3>>& volumes,
                            const dealii::SubCellData& others) override {
    vertices = places;
    cells = volumes;
    faces = others;
  }

  std::vector<dealii::Point<3>> vertices;
  std::vector<dealii::CellData<3>> cells;
  dealii::SubCellData faces;
  std::array<std::map<unsigned int, std::string>, 4> names; ///< by dimension
};

/// Reads the names of groups in the text of a .msh file, which deal.II skips.
void take_names(const std::string& text, RawMesh& raw) {
  for (const char* section : {"PhysicalNames", "PartitionedEntities"})
    if (text.find(fmt::format("${}", section)) != std::string::npos &&
        text.find(fmt::format("$End{}", section)) == std::string::npos)
      throw std::domain_error(fmt::format("${} has no end", section));
  std::istringstream lines(
      text.substr(std::min(text.find("$PhysicalNames"), text.size())));
  std::string line;
  std::getline(lines, line);
  int count = 0;
  lines >> count;
  unsigned int dimension = 0, number = 0;
  for (int i = 0; i < count && lines >> dimension >> number; ++i) {
    std::getline(lines, line);
    const std::size_t begin = line.find('"') + 1;
    if (dimension < raw.names.size())
      raw.names[dimension][number] =
          line.substr(begin, line.rfind('"') - begin);
  }
}

void read_msh(const std::string& text, RawMesh& raw) {
  const std::string first = text.substr(0, text.find_first_of("\r\n"));
  if (first != "$MeshFormat")
    throw std::domain_error(fmt::format(
        "begins with \"{}\", but a .msh file must begin with $MeshFormat "
        "(format 2 or 4 of gmsh; gmsh -3 -o NEW.msh OLD converts others)",
        printable(first.substr(0, 64))));
  std::istringstream format(text.substr(first.size()));
  double version = 0.0;
  int is_binary = 0;
  format >> version >> is_binary;
  if (is_binary != 0 || !(version >= 2.0 && version < 4.15))
    throw std::domain_error(
        "must have the format 2 or 4 of gmsh as text: gmsh -3 -format msh41 "
        "-o NEW.msh OLD");
  take_names(text, raw);
  std::istringstream stream(text);
  dealii::GridIn<3>(raw).read_msh(stream);
}

void read_raw(const std::string& path, RawMesh& raw) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  const std::string extension = fs::path(path).extension();
  dealii::GridIn<3> reader(raw);
  if (extension == ".msh")
    read_msh(text.str(), raw);
  else if (extension == ".inp")
    reader.read_abaqus(text);
  else if (extension == ".vtk")
    reader.read_vtk(text);
  else
    reader.read_unv(text);
}

/// Requires the cells to be of one kind and to have vertices that exist.
void require_cells_of_one_kind(const RawMesh& raw) {
  const std::size_t n_corners = raw.cells.front().vertices.size();
  for (std::size_t i = 0; i < raw.cells.size(); ++i) {
    const std::vector<unsigned int>& own = raw.cells[i].vertices;
    if (own.size() != n_corners || (n_corners != 8 && n_corners != 4))
      throw std::domain_error(fmt::format(
          "mesh: cell {} has {} vertices, but cells must be all hexahedra of 8 "
          "or all tetrahedra of 4 vertices",
          i, own.size()));
    for (const unsigned int vertex : own)
      if (vertex >= raw.vertices.size())
        throw std::domain_error(
            fmt::format("mesh: cell {} has a vertex that does not exist", i));
  }
}

/// The cells and their groups, in the order of the numbers of the groups.
BlockMesh cells_of(const RawMesh& raw) {
  BlockMesh mesh;
  mesh.shape = raw.cells.front().vertices.size() == 8 ? CellShape::hexahedron
                                                      : CellShape::tetrahedron;
  for (const dealii::Point<3>& place : raw.vertices) {
    mesh.vertices.push_back({place[0], place[1], place[2]});
    for (const double coordinate : mesh.vertices.back())
      if (!std::isfinite(coordinate))
        throw std::domain_error("mesh: a vertex has no finite place");
  }
  std::map<unsigned int, std::vector<std::size_t>> by_group;
  for (std::size_t i = 0; i < raw.cells.size(); ++i)
    by_group[raw.cells[i].material_id].push_back(i);
  mesh.group_names.clear();
  for (const auto& [number, cells] : by_group) {
    const auto named = raw.names[3].find(number);
    const bool is_only = by_group.size() == 1 && number == 0;
    for (const std::size_t i : cells) {
      auto& cell = mesh.cells.emplace_back();
      std::ranges::copy(raw.cells[i].vertices, cell.begin());
      mesh.cell_group.push_back(static_cast<int>(mesh.group_names.size()));
    }
    mesh.group_names.push_back(named != raw.names[3].end() ? named->second
                               : is_only                   ? "block"
                                         : fmt::format("volume {}", number));
  }
  return mesh;
}

using NamedFacets = std::map<FacetKey, const GroupName*>;

/// The facets that the file names.
NamedFacets named_facets(const RawMesh& raw, CellShape shape) {
  NamedFacets named;
  std::vector<std::string> found;
  for (const auto& face : raw.faces.boundary_quads) {
    const auto known = raw.names[2].find(face.boundary_id);
    const std::string name = known != raw.names[2].end()
                                 ? known->second
                                 : std::to_string(face.boundary_id);
    if (std::ranges::find(found, name) == found.end())
      found.push_back(name);
    const auto group =
        std::ranges::find_if(group_names, [&](const GroupName& one) {
          return name == one.name || name == one.number;
        });
    if (group == group_names.end())
      continue;
    FacetKey facet{};
    if (face.vertices.size() != meshes::vertices_per_facet(shape) ||
        std::ranges::any_of(face.vertices, [&](unsigned int vertex) {
          return vertex >= raw.vertices.size();
        }))
      throw std::domain_error(fmt::format(
          "mesh: a face of the group {} touches no cell", group->name));
    std::ranges::copy(face.vertices, facet.begin());
    const auto entry =
        named.emplace(meshes::facet_key(shape, facet), &*group).first;
    if (entry->second != &*group)
      throw std::domain_error(
          fmt::format("mesh: a face of the group {} is also in the group {}",
                      group->name, entry->second->name));
  }
  for (const GroupName& group : {group_names[0], group_names[1]})
    if (std::ranges::none_of(named, [&](const auto& entry) {
          return entry.second->group == group.group;
        }))
      throw std::domain_error(fmt::format(
          "mesh: no group of faces is named {} (or {}); there are: {}",
          group.name, group.number,
          found.empty() ? "none" : fmt::format("{}", fmt::join(found, ", "))));
  return named;
}

struct Bounds {
  meshes::Place low{infinity, infinity, infinity};
  meshes::Place high{-infinity, -infinity, -infinity};

  void widen(const meshes::Place& place) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], place[d]);
      high[d] = std::max(high[d], place[d]);
    }
  }
};

/// Renumbers mirrored cells so that they are right-handed again.
void turn_cells(BlockMesh& mesh) {
  for (auto& cell : mesh.cells)
    if (mesh.shape == CellShape::tetrahedron)
      std::swap(cell[0], cell[1]);
    else
      std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4);
}

/// Moves the contact surface to z = 0 and its bounds to x = y = 0. If the
/// surface is not flat, its lowest vertex is at z = 0 and the others keep their
/// heights above it.
void place(BlockMesh& mesh, const NamedFacets& named, double unit) {
  Bounds contact, all;
  for (const auto& [key, group] : named)
    if (group->group == FaceGroup::contact)
      for (std::size_t i = 0; i < meshes::vertices_per_facet(mesh.shape); ++i)
        contact.widen(mesh.vertices[key[i]]);
  for (const meshes::Place& vertex : mesh.vertices)
    all.widen(vertex);
  const bool is_above =
      contact.high[2] - all.low[2] <= all.high[2] - contact.low[2];
  const double tolerance = 1e-9 * (all.high[2] - all.low[2]);
  for (meshes::Place& vertex : mesh.vertices) {
    double z =
        is_above ? vertex[2] - contact.low[2] : contact.high[2] - vertex[2];
    if (std::abs(z) <= tolerance)
      z = 0.0;
    vertex = {(vertex[0] - contact.low[0]) * unit,
              (vertex[1] - contact.low[1]) * unit, z * unit};
    mesh.depth = std::max(mesh.depth, vertex[2]);
  }
  if (!is_above)
    turn_cells(mesh);
  mesh.length_x = (contact.high[0] - contact.low[0]) * unit;
  mesh.length_y = (contact.high[1] - contact.low[1]) * unit;
  for (const double length : {mesh.length_x, mesh.length_y, mesh.depth})
    if (!(length > 0.0) || !std::isfinite(length))
      throw std::domain_error(
          fmt::format("mesh: its extent is {} x {} x {} m, but must be > 0",
                      mesh.length_x, mesh.length_y, mesh.depth));
}

/// Adds the facets of the boundary, and requires every named one to be among
/// them, because facets inside the block can be neither loaded nor held.
void add_faces(BlockMesh& mesh, NamedFacets named) {
  const double tolerance =
      1e-9 * std::max({mesh.length_x, mesh.length_y, mesh.depth});
  bool is_box = true;
  for (const Facet& facet : meshes::boundary_facets(mesh)) {
    const auto entry =
        named.find(meshes::facet_key(mesh.shape, facet.vertices));
    FaceGroup group = FaceGroup::sides;
    if (entry != named.end()) {
      group = entry->second->group;
      named.erase(entry);
    }
    if (group == FaceGroup::sides)
      group = meshes::lateral_side_of(mesh, facet, tolerance).value_or(group);
    is_box = is_box && group != FaceGroup::sides;
    mesh.faces.push_back({facet.vertices, group});
  }
  if (!named.empty())
    throw std::domain_error(
        fmt::format("mesh: the group {} has a face at {} inside the block",
                    named.begin()->second->name,
                    meshes::place_text(
                        meshes::centre_of_facet(mesh, named.begin()->first))));
  for (BoundaryFace& face : mesh.faces)
    if (!is_box && face.group != FaceGroup::contact &&
        face.group != FaceGroup::far_boundary)
      face.group = FaceGroup::sides;
}

BlockMesh mesh_of(const std::string& path, double unit) {
  RawMesh raw;
  read_raw(path, raw);
  if (raw.cells.empty())
    throw std::domain_error("mesh: there are no cells");
  require_cells_of_one_kind(raw);
  for (const auto& face : raw.faces.boundary_quads)
    for (const unsigned int vertex : face.vertices)
      if (vertex >= raw.vertices.size())
        throw std::domain_error("mesh: a face of a group touches no cell");
  raw.faces.boundary_lines.clear();
  dealii::GridTools::delete_unused_vertices(raw.vertices, raw.cells, raw.faces);
  BlockMesh mesh = cells_of(raw);
  const NamedFacets named = named_facets(raw, mesh.shape);
  place(mesh, named, unit);
  add_faces(mesh, named);
  return mesh;
}

/// Limits what the child may use beyond what the program has: memory, and a
/// time in which ten times as many bytes would be read.
void limit_child(const std::string& path) {
  constexpr rlim_t memory = rlim_t{8} << 30;
  constexpr std::uintmax_t bytes_a_second = 100000;
  constexpr std::uintmax_t longest = 3600;
  const std::uintmax_t seconds =
      10 + std::min(longest, fs::file_size(path) / bytes_a_second);
  std::ifstream statm("/proc/self/statm");
  rlim_t pages = 0;
  statm >> pages;
  const rlim_t bytes =
      pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + memory;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
  std::signal(SIGALRM, SIG_DFL);
  alarm(static_cast<unsigned int>(seconds));
}

constexpr int exit_refused = 2;

/// Writes the bytes of the mesh, or what is wrong. Returns the exit code.
int answer_in_child(int output, const std::string& path, double unit) {
  std::string answer;
  int code = exit_refused;
  try {
    limit_child(path);
    std::cerr.setstate(std::ios::failbit); // deal.II repeats itself there
    answer = meshes::bytes_of(mesh_of(path, unit));
    code = 0;
  } catch (const dealii::ExceptionBase& error) {
    std::stringstream text;
    error.print_info(text);
    answer = "is refused by deal.II:";
    for (std::string word; text >> word;)
      answer += ' ' + word;
    answer = printable(answer, longest_line);
  } catch (const std::bad_alloc&) {
    answer = "takes more than 8 GiB of memory";
  } catch (const std::exception& error) {
    answer = error.what();
  }
  for (std::size_t done = 0; done < answer.size();) {
    const ssize_t count =
        write(output, answer.data() + done, answer.size() - done);
    if (count <= 0)
      return EXIT_FAILURE;
    done += static_cast<std::size_t>(count);
  }
  return code;
}

std::string all_of(int input) {
  std::string text;
  std::array<char, 65536> part{};
  for (;;) {
    const ssize_t count = read(input, part.data(), part.size());
    if (count < 0 && errno == EINTR)
      continue;
    if (count <= 0)
      return text;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

/// The bytes of the mesh, read in a child process.
std::string bytes_by_child(const std::string& path, double unit) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
    throw std::runtime_error("cannot make a pipe");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    _exit(answer_in_child(ends[1], path, unit));
  }
  close(ends[1]);
  std::string answer = child > 0 ? all_of(ends[0]) : "";
  close(ends[0]);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
    continue;
  if (child < 0)
    throw std::runtime_error("cannot start a process");
  if (WIFEXITED(status) && WEXITSTATUS(status) == exit_refused)
    throw std::domain_error(answer);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::domain_error("is damaged: deal.II crashed, or did not end, when "
                            "it read the file");
  return answer;
}

void require_kind(const fs::path& path) {
  std::error_code none;
  if (!fs::exists(path, none))
    throw std::domain_error("there is no such file");
  if (!fs::is_regular_file(path, none))
    throw std::domain_error("is no regular file");
  const std::string extension = path.extension();
  if (extension == ".geo")
    throw std::domain_error(
        "a .geo file is a script of gmsh; mesh it first: gmsh -3 " +
        path.filename().string() + ", and give the .msh file");
  if (extension != ".msh" && extension != ".inp" && extension != ".vtk" &&
      extension != ".unv")
    throw std::domain_error(
        "a mesh must be read from a .msh, .inp, .vtk or .unv file");
}

} // namespace

FileMesh read_mesh_file(const std::string& path, double unit) {
  require_positive("unit", unit, "m");
  try {
    require_kind(path);
    const std::string bytes = bytes_by_child(path, unit);
    return {meshes::mesh_of_bytes(bytes), content_hash(bytes)};
  } catch (const std::domain_error& error) {
    throw std::domain_error(path + ": " + error.what());
  }
}

} // namespace asperity::fem
