#include "meshes/gmsh_geometries.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::meshes {
namespace {

/// One interval of a tensor product of intervals.
struct Interval {
  double low = 0.0;
  double high = 0.0;
  EdgeLaw law;
};

/// Adjacent intervals between n + 1 ends.
using Intervals = std::vector<Interval>;

/// Corners of the boxes between the ends of three lists of intervals.
class BoxGrid {
public:
  BoxGrid(TransfiniteBlocks& blocks, Intervals x, Intervals y, Intervals z)
      : blocks_(blocks), along_{std::move(x), std::move(y), std::move(z)} {
    const auto ends = [&](std::size_t d) {
      std::vector<double> places = {along_[d].front().low};
      for (const Interval& interval : along_[d])
        places.push_back(interval.high);
      return places;
    };
    for (const double at_z : ends(2))
      for (const double at_y : ends(1))
        for (const double at_x : ends(0))
          points_.push_back(blocks.point({at_x, at_y, at_z}));
  }

  std::array<int, 8> corners(std::size_t i, std::size_t j,
                             std::size_t k) const {
    std::array<int, 8> found{};
    for (std::size_t corner = 0; corner < 8; ++corner)
      found[corner] =
          points_[i + (corner & 1U) +
                  (along_[0].size() + 1) *
                      (j + (corner >> 1 & 1U) +
                       (along_[1].size() + 1) * (k + (corner >> 2)))];
    return found;
  }

  void add(std::size_t i, std::size_t j, std::size_t k, int group) {
    blocks_.add(corners(i, j, k),
                {along_[0][i].law, along_[1][j].law, along_[2][k].law}, group);
  }

private:
  TransfiniteBlocks& blocks_;
  std::array<Intervals, 3> along_;
  std::vector<int> points_;
};

EdgeLaw equal_cells(double length, double size) {
  return graded_edge(length, size, size);
}

/// Builds columns over the complete contact surface; the geometry block has one
/// layer, layered several.
void layers(TransfiniteBlocks& blocks, const GmshBlock& block) {
  const std::vector<double> depths = depths_of(block);
  Intervals down;
  for (std::size_t i = 0; i + 1 < depths.size(); ++i)
    down.push_back(
        {depths[i], depths[i + 1],
         graded_edge(depths[i + 1] - depths[i], size_at_depth(block, depths[i]),
                     size_at_depth(block, depths[i + 1]))});
  const double size = block.size_at_contact;
  BoxGrid grid(
      blocks, {{0.0, block.length_x, equal_cells(block.length_x, size)}},
      {{0.0, block.length_y, equal_cells(block.length_y, size)}}, down);
  for (std::size_t k = 0; k < down.size(); ++k)
    grid.add(0, 0, k, static_cast<int>(k));
}

/// A box inside a larger one with corresponding corners, and the six blocks
/// between them.
struct Shell {
  std::array<int, 8> inner{};
  std::array<int, 8> outer{};
  std::array<EdgeLaw, 3> across; ///< of the edges of both boxes
  EdgeLaw outwards;
  int group = 0;
};

/// Adds the block of the shell on one side of the inner box.
void add_side(TransfiniteBlocks& blocks, const Shell& shell,
              std::size_t direction, bool is_high) {
  const std::size_t bit = std::size_t{1} << direction;
  std::array<int, 8> corners{};
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const bool is_far = ((corner & bit) != 0) == is_high;
    const std::size_t on_side = is_high ? corner | bit : corner & ~bit;
    corners[corner] = (is_far ? shell.outer : shell.inner)[on_side];
  }
  std::array<EdgeLaw, 3> laws = shell.across;
  laws[direction] = shell.outwards;
  if (!is_high)
    laws[direction].ratio = 1.0 / shell.outwards.ratio;
  blocks.add(corners, laws, shell.group);
}

void add_all_sides(TransfiniteBlocks& blocks, const Shell& shell) {
  for (const std::size_t direction : {0U, 1U, 2U})
    for (const bool is_high : {false, true})
      add_side(blocks, shell, direction, is_high);
}

void indentation(TransfiniteBlocks& blocks, const GmshBlock& block) {
  const double fine = block.fine_radius;
  const double half = 0.5 * std::min(block.length_x, block.length_y);
  // The fan ends at the bottom of a cube; below it a deeper block continues in
  // layers.
  const double fan_depth = block.depth <= 1.5 * half ? block.depth : half;
  const double x = 0.5 * block.length_x;
  const double y = 0.5 * block.length_y;
  const EdgeLaw across = equal_cells(2.0 * fine, block.size_at_contact);
  const EdgeLaw down = equal_cells(fine, block.size_at_contact);
  const double far = std::min(half, fan_depth);
  const EdgeLaw outwards =
      graded_edge(far - fine, block.size_at_contact, block.size_far);

  BoxGrid core(blocks, {{x - fine, x + fine, across}},
               {{y - fine, y + fine, across}}, {{0.0, fine, down}});
  Intervals below = {{0.0, fan_depth, down}};
  if (fan_depth < block.depth)
    below.push_back({fan_depth, block.depth,
                     equal_cells(block.depth - fan_depth, block.size_far)});
  BoxGrid around(blocks, {{0.0, block.length_x, across}},
                 {{0.0, block.length_y, across}}, below);

  core.add(0, 0, 0, 0);
  const Shell shell{core.corners(0, 0, 0),
                    around.corners(0, 0, 0),
                    {across, across, down},
                    outwards};
  for (const std::size_t direction : {0U, 1U})
    for (const bool is_high : {false, true})
      add_side(blocks, shell, direction, is_high);
  add_side(blocks, shell, 2, true);
  if (below.size() > 1)
    around.add(0, 0, 1, 0);
}

/// The corners of a cube around the centre.
std::array<int, 8> cube_corners(TransfiniteBlocks& blocks, const Place& centre,
                                double half) {
  std::array<int, 8> corners{};
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Place place = centre;
    for (std::size_t d = 0; d < 3; ++d)
      place[d] += (corner >> d & 1U) != 0 ? half : -half;
    corners[corner] = blocks.point(place);
  }
  return corners;
}

/// Builds the ball inside the box with the given corners: a cube, six blocks
/// from the cube to the sphere, and six from the sphere to the box.
void ball(TransfiniteBlocks& blocks, const GmshBlock& block,
          const Place& centre, const std::array<int, 8>& box, double box_half) {
  const double radius = block.inclusion_radius;
  const double core_half = 0.45 * radius;
  const double size = block.size_at_contact;
  const EdgeLaw across = equal_cells(2.0 * box_half, size);
  const auto core = cube_corners(blocks, centre, core_half);
  const auto sphere = cube_corners(blocks, centre, radius / std::sqrt(3.0));
  const int middle = blocks.point(centre);
  for (std::size_t corner = 0; corner < 8; ++corner)
    for (std::size_t d = 0; d < 3; ++d)
      if ((corner >> d & 1U) == 0)
        blocks.arc(sphere[corner], sphere[corner | std::size_t{1} << d],
                   middle);
  blocks.add(core, {across, across, across}, 1);
  add_all_sides(blocks, {core,
                         sphere,
                         {across, across, across},
                         equal_cells(radius - core_half, size),
                         1});
  add_all_sides(blocks, {sphere,
                         box,
                         {across, across, across},
                         equal_cells(box_half - radius, size),
                         0});
}

Intervals split(double length, double from, double to, double size,
                const EdgeLaw& between) {
  return {{0.0, from, equal_cells(from, size)},
          {from, to, between},
          {to, length, equal_cells(length - to, size)}};
}

void inclusion(TransfiniteBlocks& blocks, const GmshBlock& block) {
  const double radius = block.inclusion_radius;
  const Place centre = {0.5 * block.length_x, 0.5 * block.length_y,
                        block.inclusion_depth};
  const double room =
      std::min({centre[0], centre[1], centre[2], block.depth - centre[2]});
  const double half = std::min(1.5 * radius, 0.5 * (radius + room));
  const double size = block.size_at_contact;
  const EdgeLaw across = equal_cells(2.0 * half, size);
  const double top = centre[2] - half;
  const double bottom = centre[2] + half;

  const Intervals down = {
      {0.0, top, equal_cells(top, size)},
      {top, bottom, across},
      {bottom, block.depth,
       graded_edge(block.depth - bottom, size, block.size_far)}};
  BoxGrid grid(
      blocks,
      split(block.length_x, centre[0] - half, centre[0] + half, size, across),
      split(block.length_y, centre[1] - half, centre[1] + half, size, across),
      down);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        if (i != 1 || j != 1 || k != 1)
          grid.add(i, j, k, 0);
  ball(blocks, block, centre, grid.corners(1, 1, 1), half);
}

} // namespace

TransfiniteBlocks hexahedra_of(const GmshBlock& block) {
  TransfiniteBlocks blocks;
  switch (block.geometry) {
  case mechanics::MeshGeometry::indentation:
    indentation(blocks, block);
    break;
  case mechanics::MeshGeometry::inclusion:
    inclusion(blocks, block);
    break;
  default:
    layers(blocks, block);
  }
  return blocks;
}

} // namespace asperity::meshes
