// Meshes the blocks of transfinite_blocks.hpp in gmsh's built-in geometry
// kernel, whose numbers of points, edges and faces are those of the
// description.
#include "meshes/transfinite_blocks.hpp"

#include <gmsh.h>

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

} // namespace

void mesh_by_gmsh(const TransfiniteBlocks& blocks,
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
  for (std::size_t group = 0; group < group_names.size(); ++group) {
    const int physical = gmsh::model::addPhysicalGroup(
        3, volumes[group], static_cast<int>(group) + 1);
    gmsh::model::setPhysicalName(3, physical, group_names[group]);
  }
  constrain::generate(3);
}

} // namespace asperity::meshes
