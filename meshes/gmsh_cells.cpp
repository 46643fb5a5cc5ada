#include "meshes/gmsh_cells.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace asperity::meshes {
namespace {

constexpr int gmsh_tetrahedron = 4;
constexpr int gmsh_hexahedron = 5;
/// For each of deal.II's vertices 0, 1, 2, ..., the index of gmsh's vertex.
constexpr std::array<std::size_t, 8> hexahedron_order = {0, 1, 3, 2,
                                                         4, 5, 7, 6};

using Tags = std::vector<std::size_t>;

/// Cells that still refer to gmsh's numbers.
struct TaggedCells {
  CellShape shape = CellShape::hexahedron;
  std::vector<std::array<std::size_t, 8>> cells;
  std::vector<int> groups;
};

std::string kind_of(int type) {
  std::string name;
  int dimension = 0;
  int order = 0;
  int n_nodes = 0;
  int n_primary_nodes = 0;
  std::vector<double> places;
  gmsh::model::mesh::getElementProperties(type, name, dimension, order, n_nodes,
                                          places, n_primary_nodes);
  return name;
}

void add_cells(TaggedCells& all, int volume, int group) {
  std::vector<int> types;
  std::vector<Tags> numbers;
  std::vector<Tags> nodes;
  gmsh::model::mesh::getElements(types, numbers, nodes, 3, volume);
  for (std::size_t kind = 0; kind < types.size(); ++kind) {
    const int type = types[kind];
    if (type != gmsh_tetrahedron && type != gmsh_hexahedron)
      throw std::domain_error(fmt::format(
          "mesh: element {} is a {}, but cells must be hexahedra of 8 or "
          "tetrahedra of 4 vertices",
          numbers[kind].front(), kind_of(type)));
    const CellShape shape = type == gmsh_hexahedron ? CellShape::hexahedron
                                                    : CellShape::tetrahedron;
    if (all.cells.empty())
      all.shape = shape;
    if (shape != all.shape)
      throw std::domain_error(fmt::format(
          "mesh: element {} is a {}, but those before it are {}",
          numbers[kind].front(), kind_of(type),
          all.shape == CellShape::hexahedron ? "hexahedra" : "tetrahedra"));
    const std::size_t n_corners = shape == CellShape::hexahedron ? 8 : 4;
    for (std::size_t i = 0; i < numbers[kind].size(); ++i) {
      std::array<std::size_t, 8> cell{};
      for (std::size_t corner = 0; corner < n_corners; ++corner)
        cell[corner] =
            nodes[kind][i * n_corners +
                        (n_corners == 8 ? hexahedron_order[corner] : corner)];
      all.cells.push_back(cell);
      all.groups.push_back(group);
    }
  }
}

/// The group of each volume, and the names of the groups.
struct Groups {
  std::map<int, int> of_volume;
  std::vector<std::string> names;
};

Groups physical_volumes() {
  Groups groups;
  gmsh::vectorpair physical;
  gmsh::model::getPhysicalGroups(physical, 3);
  std::sort(physical.begin(), physical.end());
  for (const auto& [dimension, tag] : physical) {
    std::string name;
    gmsh::model::getPhysicalName(3, tag, name);
    const auto group = static_cast<int>(groups.names.size());
    groups.names.push_back(name.empty() ? fmt::format("volume {}", tag) : name);
    std::vector<int> volumes;
    gmsh::model::getEntitiesForPhysicalGroup(3, tag, volumes);
    for (const int volume : volumes)
      if (!groups.of_volume.emplace(volume, group).second)
        throw std::domain_error(fmt::format(
            "mesh: volume {} is in two physical groups, {} and {}", volume,
            groups.names[static_cast<std::size_t>(groups.of_volume[volume])],
            groups.names.back()));
  }
  if (groups.names.empty())
    groups.names = {"block"};
  return groups;
}

TaggedCells all_cells(const Groups& groups) {
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  // Volumes are sorted by group, then in gmsh's order.
  std::vector<std::pair<int, int>> by_group;
  for (const auto& [dimension, volume] : volumes) {
    const auto found = groups.of_volume.find(volume);
    if (found != groups.of_volume.end())
      by_group.emplace_back(found->second, volume);
    else if (groups.of_volume.empty())
      by_group.emplace_back(0, volume);
    else
      throw std::domain_error(fmt::format(
          "mesh: volume {} is in no physical volume, but others are", volume));
  }
  std::sort(by_group.begin(), by_group.end());
  TaggedCells all;
  for (const auto& [group, volume] : by_group)
    add_cells(all, volume, group);
  if (all.cells.empty())
    throw std::domain_error("mesh: there are no cells");
  return all;
}

std::map<std::size_t, Place> all_nodes() {
  Tags tags;
  std::vector<double> places;
  std::vector<double> parameters;
  gmsh::model::mesh::getNodes(tags, places, parameters);
  std::map<std::size_t, Place> nodes;
  for (std::size_t i = 0; i < tags.size(); ++i)
    nodes[tags[i]] = {places[3 * i], places[3 * i + 1], places[3 * i + 2]};
  return nodes;
}

} // namespace

GmshMesh cells_of_gmsh() {
  const Groups groups = physical_volumes();
  const TaggedCells read = all_cells(groups);
  const std::size_t n_corners = read.shape == CellShape::hexahedron ? 8 : 4;

  GmshMesh made;
  auto& [mesh, vertex_of_node] = made;
  for (const auto& cell : read.cells)
    for (std::size_t corner = 0; corner < n_corners; ++corner)
      vertex_of_node[cell[corner]] = 0;
  mesh.shape = read.shape;
  mesh.cell_group = read.groups;
  mesh.group_names = groups.names;
  const std::map<std::size_t, Place> nodes = all_nodes();
  for (auto& [node, vertex] : vertex_of_node) {
    vertex = static_cast<unsigned int>(mesh.vertices.size());
    mesh.vertices.push_back(nodes.at(node));
  }
  for (const auto& cell : read.cells) {
    std::array<unsigned int, 8> vertices{};
    for (std::size_t corner = 0; corner < n_corners; ++corner)
      vertices[corner] = vertex_of_node.at(cell[corner]);
    mesh.cells.push_back(vertices);
  }
  return made;
}

} // namespace asperity::meshes
