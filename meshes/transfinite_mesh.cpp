// Meshes the blocks of transfinite_blocks.hpp in gmsh's built-in geometry
// kernel, whose numbers of points, edges and faces are those of the
// description.
#include "meshes/transfinite_blocks.hpp"

#include <gmsh.h>

#include <map>

namespace asperity::meshes {
namespace {

namespace geo = gmsh::model::geo;
namespace constrain = gmsh::model::mesh;

void add_outlines(const TransfiniteBlocks& blocks) {
  for (const Place& place : blocks.points())
    geo::addPoint(place[0], place[1], place[2]);
  for (const TransfiniteBlocks::Edge& edge : blocks.edges())
    edge.centre != 0 ? geo::addCircleArc(edge.from, edge.centre, edge.to)
                     : geo::addLine(edge.from, edge.to);
  for (const TransfiniteBlocks::Face& face : blocks.faces()) {
    const int loop = geo::addCurveLoop({face.edges.begin(), face.edges.end()});
    face.centre != 0 ? geo::addSurfaceFilling({loop}, -1, face.centre)
                     : geo::addPlaneSurface({loop});
  }
  for (const TransfiniteBlocks::Block& block : blocks.blocks())
    geo::addVolume(
        {geo::addSurfaceLoop({block.faces.begin(), block.faces.end()})});
  geo::synchronize();
}

/// Adds the hexahedra of a volume, by gmsh's numbers of their nodes.
void add_cells(int volume, std::vector<std::array<std::size_t, 8>>& cells) {
  constexpr int hexahedron = 5;
  /// For each of deal.II's vertices 0, 1, 2, ..., the index of gmsh's vertex.
  constexpr std::array<std::size_t, 8> order = {0, 1, 3, 2, 4, 5, 7, 6};
  std::vector<std::size_t> numbers, nodes;
  constrain::getElementsByType(hexahedron, numbers, nodes, volume);
  for (std::size_t first = 0; first < nodes.size(); first += 8) {
    auto& cell = cells.emplace_back();
    for (std::size_t corner = 0; corner < 8; ++corner)
      cell[corner] = nodes[first + order[corner]];
  }
}

/// Gives the nodes of the cells their places and the cells their vertices.
void take_vertices(const std::vector<std::array<std::size_t, 8>>& cells,
                   BlockMesh& mesh) {
  std::vector<std::size_t> tags;
  std::vector<double> places, parameters;
  constrain::getNodes(tags, places, parameters);
  std::map<std::size_t, Place> place_of;
  for (std::size_t i = 0; i < tags.size(); ++i)
    place_of[tags[i]] = {places[3 * i], places[3 * i + 1], places[3 * i + 2]};
  std::map<std::size_t, unsigned int> vertex_of;
  for (const auto& cell : cells)
    for (const std::size_t node : cell)
      vertex_of[node] = 0;
  for (auto& [node, vertex] : vertex_of) {
    vertex = static_cast<unsigned int>(mesh.vertices.size());
    mesh.vertices.push_back(place_of.at(node));
  }
  for (const auto& cell : cells) {
    auto& vertices = mesh.cells.emplace_back();
    for (std::size_t corner = 0; corner < 8; ++corner)
      vertices[corner] = vertex_of.at(cell[corner]);
  }
}

} // namespace

BlockMesh mesh_by_gmsh(const TransfiniteBlocks& blocks,
                       const std::vector<std::string>& group_names) {
  add_outlines(blocks);
  int tag = 0;
  for (const TransfiniteBlocks::Edge& edge : blocks.edges())
    constrain::setTransfiniteCurve(++tag, edge.law.n + 1, "Progression",
                                   edge.law.ratio);
  tag = 0;
  for (const TransfiniteBlocks::Face& face : blocks.faces()) {
    constrain::setTransfiniteSurface(
        ++tag, "Left", {face.corners.begin(), face.corners.end()});
    constrain::setRecombine(2, tag);
  }
  tag = 0;
  std::vector<std::vector<int>> volumes(group_names.size());
  for (const TransfiniteBlocks::Block& block : blocks.blocks()) {
    const auto& at = block.corners; // in gmsh's order:
    constrain::setTransfiniteVolume(
        ++tag, {at[0], at[1], at[3], at[2], at[4], at[5], at[7], at[6]});
    volumes.at(static_cast<std::size_t>(block.group)).push_back(tag);
  }
  constrain::generate(3);
  BlockMesh mesh;
  mesh.group_names = group_names;
  std::vector<std::array<std::size_t, 8>> cells;
  for (std::size_t group = 0; group < volumes.size(); ++group) {
    for (const int volume : volumes[group])
      add_cells(volume, cells);
    mesh.cell_group.resize(cells.size(), static_cast<int>(group));
  }
  take_vertices(cells, mesh);
  return mesh;
}

} // namespace asperity::meshes
