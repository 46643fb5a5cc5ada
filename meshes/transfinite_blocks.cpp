#include "meshes/transfinite_blocks.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>

namespace asperity::meshes {
namespace {

namespace geo = gmsh::model::geo;

/// The faces of a hexahedron by its corners, in cyclic order.
constexpr std::array<std::array<std::size_t, 4>, 6> faces_of_block = {
    {{0, 2, 6, 4},
     {1, 3, 7, 5},
     {0, 1, 5, 4},
     {2, 3, 7, 6},
     {0, 1, 3, 2},
     {4, 5, 7, 6}}};

} // namespace

EdgeLaw graded_edge(double length, double first, double last) {
  const double cells = std::abs(last - first) < 1e-9 * first
                           ? length / first
                           : length / (last - first) * std::log(last / first);
  const int n = std::max(1, static_cast<int>(std::ceil(cells - 1e-9)));
  return {n, std::pow(last / first, 1.0 / n)}; // (M.5)
}

int TransfiniteBlocks::point(const Place& place) {
  return geo::addPoint(place[0], place[1], place[2]);
}

void TransfiniteBlocks::arc(int from, int to, int centre) {
  const int tag = geo::addCircleArc(from, centre, to);
  edges_[std::minmax(from, to)] = {tag, from, centre, {0, 1.0}};
}

TransfiniteBlocks::Edge& TransfiniteBlocks::edge(int from, int to) {
  const auto [found, is_new] = edges_.try_emplace(std::minmax(from, to));
  if (is_new)
    found->second = {geo::addLine(from, to), from, 0, {0, 1.0}};
  return found->second;
}

int TransfiniteBlocks::face(const std::array<int, 4>& corners) {
  std::array<int, 4> key = corners;
  std::sort(key.begin(), key.end());
  const auto found = faces_.find(key);
  if (found != faces_.end())
    return found->second;

  std::vector<int> around;
  bool is_spherical = true;
  const int centre = edge(corners[0], corners[1]).centre;
  for (std::size_t i = 0; i < 4; ++i) {
    const Edge& side = edge(corners[i], corners[(i + 1) % 4]);
    around.push_back(side.from == corners[i] ? side.tag : -side.tag);
    is_spherical = is_spherical && side.centre != 0 && side.centre == centre;
  }
  const int loop = geo::addCurveLoop(around);
  const int tag = is_spherical ? geo::addSurfaceFilling({loop}, -1, centre)
                               : geo::addPlaneSurface({loop});
  corners_of_face_[tag] = corners;
  return faces_[key] = tag;
}

void TransfiniteBlocks::add(const std::array<int, 8>& corners,
                            const std::array<EdgeLaw, 3>& laws, int group) {
  for (std::size_t corner = 0; corner < 8; ++corner)
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t bit = std::size_t{1} << d;
      if ((corner & bit) != 0)
        continue;
      Edge& along = edge(corners[corner], corners[corner | bit]);
      if (along.law.n == 0)
        along.law = {laws[d].n, along.from == corners[corner]
                                    ? laws[d].ratio
                                    : 1.0 / laws[d].ratio};
    }
  std::vector<int> shell;
  shell.reserve(faces_of_block.size());
  for (const auto& around : faces_of_block)
    shell.push_back(face({corners[around[0]], corners[around[1]],
                          corners[around[2]], corners[around[3]]}));
  const int volume = geo::addVolume({geo::addSurfaceLoop(shell)});
  corners_of_volume_[volume] = {corners[0], corners[1], corners[3], corners[2],
                                corners[4], corners[5], corners[7], corners[6]};
  group_of_volume_.emplace_back(group, volume);
}

void TransfiniteBlocks::mesh(const std::vector<std::string>& group_names) {
  geo::synchronize();
  namespace constrain = gmsh::model::mesh;
  for (const auto& [ends, edge] : edges_)
    constrain::setTransfiniteCurve(edge.tag, edge.law.n + 1, "Progression",
                                   edge.law.ratio);
  for (const auto& [tag, corners] : corners_of_face_) {
    constrain::setTransfiniteSurface(tag, "Left",
                                     {corners.begin(), corners.end()});
    constrain::setRecombine(2, tag);
  }
  for (const auto& [tag, corners] : corners_of_volume_)
    constrain::setTransfiniteVolume(tag, {corners.begin(), corners.end()});
  for (std::size_t group = 0; group < group_names.size(); ++group) {
    std::vector<int> volumes;
    for (const auto& [of_group, volume] : group_of_volume_)
      if (of_group == static_cast<int>(group))
        volumes.push_back(volume);
    const int tag =
        gmsh::model::addPhysicalGroup(3, volumes, static_cast<int>(group) + 1);
    gmsh::model::setPhysicalName(3, tag, group_names[group]);
  }
  gmsh::model::mesh::generate(3);
}

} // namespace asperity::meshes
