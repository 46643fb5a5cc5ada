#include "suite/exchange/problem_mesh.hpp"

#include "base/json.hpp"
#include "input/input_error.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>

namespace asperity::exchange {
namespace {

using Json = nlohmann::ordered_json;
using meshes::FaceGroup;

constexpr double most_nodes = 2e6;
constexpr double usual_poisson_ratio = 0.3;

struct NamedFaces {
  FaceGroup group;
  const char* name;
  int axis; ///< to which the faces are normal
  bool is_end;
  const char* meaning;
};

constexpr std::array named_faces{
    NamedFaces{FaceGroup::contact, "contact", 2, false, "z = 0, pressed"},
    NamedFaces{FaceGroup::far_boundary, "fixed", 2, true, "z = depth"},
    NamedFaces{FaceGroup::left, "left", 0, false, "x = 0"},
    NamedFaces{FaceGroup::right, "right", 0, true, "x = length_x"},
    NamedFaces{FaceGroup::front, "front", 1, false, "y = 0"},
    NamedFaces{FaceGroup::back, "back", 1, true, "y = length_y"}};

constexpr std::array far_conditions{
    "fixed: no displacement", "fixed: no displacement along z, free in x and y",
    "fixed: uniform normal traction in balance with the contact, free in x and "
    "y"};

/// From deal.II's order of the vertices to that of gmsh and Abaqus, as numbers
/// from 1.
std::array<unsigned int, 8> around(const std::array<unsigned int, 8>& cell) {
  return {cell[0] + 1, cell[1] + 1, cell[3] + 1, cell[2] + 1,
          cell[4] + 1, cell[5] + 1, cell[7] + 1, cell[6] + 1};
}

std::vector<double> interfaces_of(const mechanics::ElasticBlock& body) {
  std::vector<double> depths;
  depths.reserve(body.layers.size());
  for (const mechanics::BondedLayer& layer : body.layers)
    depths.push_back((depths.empty() ? 0.0 : depths.back()) + layer.thickness);
  return depths;
}

/// Sorts the cells into the bonded layers and the body below them.
void set_materials(const Problem& problem, double poisson_ratio,
                   ProblemMesh& block) {
  const std::vector<double> interfaces = interfaces_of(problem.body);
  block.mesh.group_names.clear();
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    block.mesh.group_names.push_back(fmt::format("layer_{}", i + 1));
    block.moduli.push_back({problem.body.layers[i].youngs_modulus,
                            problem.body.layers[i].poisson_ratio});
  }
  block.mesh.group_names.emplace_back("block");
  block.moduli.push_back(
      {problem.body.contact_modulus * (1.0 - poisson_ratio * poisson_ratio),
       poisson_ratio});
  const std::size_t a_layer =
      static_cast<std::size_t>(block.cells_x) * block.cells_y;
  double top = 0.0;
  for (std::size_t k = 0; k < block.layers.size(); ++k) {
    const double middle = top + 0.5 * block.layers[k];
    const auto group =
        std::ranges::lower_bound(interfaces, middle) - interfaces.begin();
    std::fill_n(block.mesh.cell_group.begin() +
                    static_cast<std::ptrdiff_t>(k * a_layer),
                a_layer, static_cast<int>(group));
    top += block.layers[k];
  }
}

std::string numbers_in_lines(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += fmt::format("{}{}", numbers[i],
                        i % 10 == 9 || i + 1 == numbers.size() ? "\n" : ",");
  return text;
}

/// The nodes at the first or last place along an axis, in ascending order.
std::vector<std::size_t> nodes_on(const ProblemMesh& block, int axis,
                                  bool is_end) {
  const std::array<std::size_t, 3> counts{
      static_cast<std::size_t>(block.cells_x) + 1,
      static_cast<std::size_t>(block.cells_y) + 1, block.layers.size() + 1};
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < block.mesh.vertices.size(); ++i) {
    const std::array<std::size_t, 3> at{
        i % counts[0], i / counts[0] % counts[1], i / (counts[0] * counts[1])};
    const auto a = static_cast<std::size_t>(axis);
    if (at[a] == (is_end ? counts[a] - 1 : 0))
      nodes.push_back(i + 1);
  }
  return nodes;
}

/// A bounding box of the whole mesh, which is what an entity may state.
std::string entity(std::size_t tag, const ProblemMesh& block) {
  return fmt::format("{} 0 0 0 {:.12e} {:.12e} {:.12e} 1 {} 0\n", tag,
                     block.mesh.length_x, block.mesh.length_y, block.mesh.depth,
                     tag);
}

std::string gmsh_elements(const ProblemMesh& block) {
  const meshes::BlockMesh& mesh = block.mesh;
  const std::size_t n = mesh.faces.size() + mesh.cells.size();
  std::string text =
      fmt::format("$Elements\n{} {} 1 {}\n",
                  named_faces.size() + mesh.group_names.size(), n, n);
  auto out = std::back_inserter(text);
  std::size_t number = 0;
  for (std::size_t i = 0; i < named_faces.size(); ++i) {
    const FaceGroup group = named_faces[i].group;
    fmt::format_to(
        out, "2 {} 3 {}\n", i + 1,
        std::ranges::count(mesh.faces, group, &meshes::BoundaryFace::group));
    for (const meshes::BoundaryFace& face : mesh.faces)
      if (face.group == group)
        fmt::format_to(out, "{} {} {} {} {}\n", ++number, face.vertices[0] + 1,
                       face.vertices[1] + 1, face.vertices[3] + 1,
                       face.vertices[2] + 1);
  }
  for (std::size_t i = 0; i < mesh.group_names.size(); ++i) {
    const int group = static_cast<int>(i);
    fmt::format_to(out, "3 {} 5 {}\n", i + 1,
                   std::ranges::count(mesh.cell_group, group));
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      if (mesh.cell_group[c] == group)
        fmt::format_to(out, "{} {}\n", ++number,
                       fmt::join(around(mesh.cells[c]), " "));
  }
  return text + "$EndElements\n";
}

} // namespace

ProblemMesh problem_mesh(const Problem& problem,
                         const mechanics::BlockSettings& settings) {
  const Grid& grid = problem.grid;
  const mechanics::ElasticBlock& body = problem.body;
  const int degree = mechanics::degree_of(settings.element);
  if (grid.points_x % degree != 0 || grid.points_y % degree != 0)
    throw input::InputError(
        fmt::format("{}: has {} by {} points, but cells of Q2 need an even "
                    "number: change surface.points, or take element = \"Q1\"",
                    problem.name, grid.points_x, grid.points_y));
  const bool is_deep = std::isinf(body.thickness);
  ProblemMesh block;
  block.element = settings.element;
  block.cells_x = grid.points_x / degree;
  block.cells_y = grid.points_y / degree;
  block.far_boundary =
      is_deep ? mechanics::FarBoundary::clamped : body.far_boundary;
  block.layers = meshes::layers_of_block(
      settings, interfaces_of(body), grid.spacing_x(),
      is_deep ? std::max(grid.length_x, grid.length_y) : body.thickness);
  const double nodes = (block.cells_x + 1.0) * (block.cells_y + 1.0) *
                       (static_cast<double>(block.layers.size()) + 1.0);
  if (nodes > most_nodes)
    throw input::InputError(fmt::format(
        "{}: its mesh would have {:.2g} nodes, but at most {:.2g} are written: "
        "lower surface.points",
        problem.name, nodes, most_nodes));
  block.mesh = meshes::layered_mesh(
      {block.cells_x, block.cells_y, grid.length_x, grid.length_y},
      block.layers);
  const bool has_ratio =
      !is_deep || !body.layers.empty() || body.poisson_ratio != 0.0;
  set_materials(problem, has_ratio ? body.poisson_ratio : usual_poisson_ratio,
                block);
  return block;
}

std::string gmsh_text(const ProblemMesh& block) {
  const meshes::BlockMesh& mesh = block.mesh;
  const std::size_t groups = mesh.group_names.size();
  std::string text =
      fmt::format("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n",
                  named_faces.size() + groups);
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < named_faces.size(); ++i)
    fmt::format_to(out, "2 {} \"{}\"\n", i + 1, named_faces[i].name);
  for (std::size_t i = 0; i < groups; ++i)
    fmt::format_to(out, "3 {} \"{}\"\n", i + 1, mesh.group_names[i]);
  fmt::format_to(out, "$EndPhysicalNames\n$Entities\n0 0 {} {}\n",
                 named_faces.size(), groups);
  for (std::size_t i = 0; i < named_faces.size(); ++i)
    text += entity(i + 1, block);
  for (std::size_t i = 0; i < groups; ++i)
    text += entity(i + 1, block);
  const std::size_t n = mesh.vertices.size();
  fmt::format_to(out, "$EndEntities\n$Nodes\n1 {} 1 {}\n3 1 0 {}\n", n, n, n);
  for (std::size_t i = 1; i <= n; ++i)
    fmt::format_to(out, "{}\n", i);
  for (const meshes::Place& place : mesh.vertices)
    fmt::format_to(out, "{:.12e} {:.12e} {:.12e}\n", place[0], place[1],
                   place[2]);
  return text + "$EndNodes\n" + gmsh_elements(block);
}

std::string abaqus_text(const ProblemMesh& block) {
  const meshes::BlockMesh& mesh = block.mesh;
  std::string text = "** The block of an Asperity problem [m]; see "
                     "problem.json\n*NODE,NSET=all\n";
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    fmt::format_to(out, "{},{:.12e},{:.12e},{:.12e}\n", i + 1,
                   mesh.vertices[i][0], mesh.vertices[i][1],
                   mesh.vertices[i][2]);
  for (std::size_t group = 0; group < mesh.group_names.size(); ++group) {
    fmt::format_to(out, "*ELEMENT,TYPE=C3D8,ELSET={}\n",
                   mesh.group_names[group]);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      if (mesh.cell_group[c] == static_cast<int>(group))
        fmt::format_to(out, "{},{}\n", c + 1,
                       fmt::join(around(mesh.cells[c]), ","));
  }
  for (const NamedFaces& faces : named_faces)
    text += fmt::format("*NSET,NSET={}\n", faces.name) +
            numbers_in_lines(nodes_on(block, faces.axis, faces.is_end));
  const std::size_t a_layer =
      static_cast<std::size_t>(block.cells_x) * block.cells_y;
  const std::size_t last = mesh.cells.size() - a_layer;
  for (const auto& [name, side, first] :
       {std::tuple{"contact", 1, std::size_t{0}},
        std::tuple{"fixed", 2, last}}) {
    fmt::format_to(out, "*SURFACE,NAME={},TYPE=ELEMENT\n", name);
    for (std::size_t c = first + 1; c <= first + a_layer; ++c)
      fmt::format_to(out, "{},S{}\n", c, side);
  }
  return text;
}

std::string mesh_readme(const ProblemMesh& block, const Problem& problem) {
  const Grid& grid = problem.grid;
  const bool is_linear = block.element == mechanics::Element::q1;
  std::string text = fmt::format(
      R"(- `mesh.msh`: the block as {} by {} by {} hexahedra for gmsh (4.1, text), in metres, z into the block; its named
  surfaces and groups of cells are listed under `mesh` in `problem.json`, with moduli and boundary conditions
- `mesh.inp`: the same for Abaqus and CalculiX: nodes, elements, the sets of nodes and the surfaces of these names. It has
  no materials, steps and contact: these are yours

## From forces of nodes to pressures

Solve for a rigid surface whose height over the node of column j and row i of the contact surface is `heights[i, j]`; nodes at
x = length_x and y = length_y are those at 0. )",
      block.cells_x, block.cells_y, block.layers.size());
  text +=
      is_linear
          ? fmt::format(
                R"(Contact forces of nodes F [N] become pressures by the area of a node:

    p[i, j] = F[i, j] / (dx dy),    dx dy = {:.6e} m x {:.6e} m

where F of a node on the border is the sum over its periodic images. Write p as `pressure`, or F itself as `nodal_force` in
`submission.toml`, which does this division. It is exact for linear hexahedra, since the area of a node is the row sum of
the mass matrix of the contact surface; the sum of all F over length_x length_y is then p_0.
)",
                grid.spacing_x(), grid.spacing_y())
          : std::string(
                R"(These are second-order elements: the other nodes of the grid are the
middles of edges and faces of the cells of `mesh.msh`. Forces of their nodes have different weights at corners, edges and
faces, so that `nodal_force` does not apply: solve M p = F with the mass matrix M of the contact surface, or integrate
the contact pressure of your code, and write p at the nodes of the grid as `pressure`.
)");
  return text;
}

Json mesh_json(const ProblemMesh& block) {
  Json surfaces = Json::object();
  for (const NamedFaces& faces : named_faces)
    surfaces[faces.name] = faces.meaning;
  Json materials = Json::array();
  for (std::size_t i = 0; i < block.moduli.size(); ++i)
    materials.push_back(
        {{"group", block.mesh.group_names[i]},
         {"youngs_modulus [Pa]", block.moduli[i].youngs_modulus},
         {"poisson_ratio [1]", block.moduli[i].poisson_ratio}});
  return {
      {"files", {"mesh.msh", "mesh.inp"}},
      {"element", block.element == mechanics::Element::q1 ? "Q1" : "Q2"},
      {"cells_x", block.cells_x},
      {"cells_y", block.cells_y},
      {"layers [m]", block.layers},
      {"materials", materials},
      {"surfaces", surfaces},
      {"boundary_conditions",
       {far_conditions.at(static_cast<std::size_t>(block.far_boundary)),
        "left and right, front and back: equal displacements (periodic)",
        "contact: z displacement w, no shear traction; with the rigid surface "
        "g = u + w - h >= 0, p >= 0, p g = 0 at every node of the grid"}},
      {"numbering",
       "node 1 + i + (cells_x + 1) (j + (cells_y + 1) k) is at column i, row "
       "j, layer k from the contact surface; z points into the block"},
      {"nodal_forces",
       "an answer may be the nodal forces of the contact surface [N]; with Q1 "
       "a force over the area of a node, which is the row sum of the mass of "
       "the surface, is its pressure. Nodes at x = length_x and y = length_y "
       "are those at 0"}};
}

} // namespace asperity::exchange
