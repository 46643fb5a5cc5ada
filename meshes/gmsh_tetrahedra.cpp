#include "meshes/gmsh_geometries.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::meshes {
namespace {

namespace occ = gmsh::model::occ;
using BoundingBox = std::array<double, 6>;

constexpr double same = 1e-6; ///< tolerance of coordinates in OpenCASCADE's
                              ///< boxes

BoundingBox bounds_of(int surface) {
  BoundingBox box{};
  gmsh::model::getBoundingBox(2, surface, box[0], box[1], box[2], box[3],
                              box[4], box[5]);
  return box;
}

/// The surface whose bounds are those of the given one, shifted along x or y.
int partner_of(int surface, std::size_t direction, double period) {
  BoundingBox moved = bounds_of(surface);
  moved[direction] += period;
  moved[direction + 3] += period;
  gmsh::vectorpair found;
  gmsh::model::getEntitiesInBoundingBox(
      moved[0] - same, moved[1] - same, moved[2] - same, moved[3] + same,
      moved[4] + same, moved[5] + same, found, 2);
  if (found.size() != 1)
    throw std::domain_error(
        "gmsh: a periodic side has no matching opposite side");
  return found.front().second;
}

/// Makes gmsh mesh opposite sides identically.
void make_periodic(const GmshBlock& block) {
  for (const std::size_t direction : {0U, 1U}) {
    const double period = direction == 0 ? block.length_x : block.length_y;
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    std::vector<double> shift = {1, 0, 0, 0, 0, 1, 0, 0,
                                 0, 0, 1, 0, 0, 0, 0, 1};
    shift[4 * direction + 3] = period;
    for (const auto& [dimension, surface] : surfaces) {
      const BoundingBox box = bounds_of(surface);
      if (std::abs(box[direction]) < same &&
          std::abs(box[direction + 3]) < same)
        gmsh::model::mesh::setPeriodic(
            2, {partner_of(surface, direction, period)}, {surface}, shift);
    }
  }
}

/// Creates the volumes, one per group.
std::vector<int> make_volumes(const GmshBlock& block) {
  const std::vector<double> depths = depths_of(block);
  gmsh::vectorpair parts;
  for (std::size_t i = 0; i + 1 < depths.size(); ++i)
    parts.emplace_back(3,
                       occ::addBox(0.0, 0.0, depths[i], block.length_x,
                                   block.length_y, depths[i + 1] - depths[i]));
  if (block.geometry == mechanics::MeshGeometry::inclusion)
    parts.emplace_back(
        3, occ::addSphere(0.5 * block.length_x, 0.5 * block.length_y,
                          block.inclusion_depth, block.inclusion_radius));
  if (parts.size() == 1) {
    occ::synchronize();
    return {parts.front().second};
  }
  gmsh::vectorpair pieces;
  std::vector<gmsh::vectorpair> pieces_of;
  occ::fragment({parts.front()}, {parts.begin() + 1, parts.end()}, pieces,
                pieces_of);
  occ::synchronize();
  // After the fragmentation of a box by a ball, the pieces of the box include
  // the ball, which belongs to the last part only.
  std::vector<int> volumes;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const auto& [dimension, volume] : pieces_of[i])
      if (i + 1 == parts.size() || pieces_of[i].size() == 1 ||
          std::none_of(pieces_of.back().begin(), pieces_of.back().end(),
                       [volume = volume](const auto& of_ball) {
                         return of_ball.second == volume;
                       }))
        volumes.push_back(volume);
  return volumes;
}

/// Supplies the cell size to gmsh until meshing has finished or failed.
class SizeEverywhere {
public:
  explicit SizeEverywhere(const GmshBlock& block) {
    gmsh::model::mesh::setSizeCallback(
        [&block](int, int, double x, double y, double z) {
          return size_at(block, {x, y, z});
        });
  }

  SizeEverywhere(const SizeEverywhere&) = delete;
  SizeEverywhere& operator=(const SizeEverywhere&) = delete;

  ~SizeEverywhere() { gmsh::model::mesh::removeSizeCallback(); }
};

} // namespace

void make_tetrahedra(const GmshBlock& block) {
  const std::vector<int> volumes = make_volumes(block);
  const std::vector<std::string> names = group_names_of(block);
  for (std::size_t group = 0; group < names.size(); ++group) {
    const int tag = gmsh::model::addPhysicalGroup(3, {volumes.at(group)},
                                                  static_cast<int>(group) + 1);
    gmsh::model::setPhysicalName(3, tag, names[group]);
  }
  if (block.is_periodic)
    make_periodic(block);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  const SizeEverywhere size(block);
  gmsh::model::mesh::generate(3);
}

} // namespace asperity::meshes
