#include "meshes/hanging_mesh.hpp"

#include "base/refused_argument.hpp"
#include "base/require.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/halvable_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity::meshes {
namespace {

/// Computes d_l of (M.6) in edges of the cells at the contact surface,
/// l = 0..n_levels-1.
std::vector<long> level_bottoms(int n_levels, int cells_a_level) {
  std::vector<long> bottoms;
  long above = 0;
  for (int level = 0; level < n_levels; ++level) {
    const long edge = 1L << level;
    const long parent = 2 * edge;
    const long least = above + cells_a_level * edge;
    above = (least + parent - 1) / parent * parent;
    bottoms.push_back(above);
  }
  return bottoms;
}

/// Number of layers of cells that are nearly cubes.
int n_layers_of(const Grid& face, double depth) {
  const double mean_edge = 0.5 * (face.spacing_x() + face.spacing_y());
  const double n_layers = std::round(depth / mean_edge);
  require_between(Argument{"ratio of depth to cell edge", "method.depth"},
                  n_layers, 0.0, 1e6, "1");
  return std::max(1, static_cast<int>(n_layers));
}

/// The coarse mesh that is refined n_levels times.
struct Coarse {
  Grid face;
  int n_layers = 1;
  int edge = 1; ///< in edges of the contact surface's cells
};

Coarse coarse_mesh(const Grid& face, double depth, int n_levels) {
  const int edge = 1 << n_levels;
  const Grid coarse{face.points_x / edge, face.points_y / edge, face.length_x,
                    face.length_y};
  return {coarse, n_layers_of(coarse, depth), edge};
}

bool is_possible(const Grid& face, double depth, int n_levels,
                 int cells_a_level) {
  const int edge = 1 << n_levels;
  if (face.points_x % edge != 0 || face.points_y % edge != 0 ||
      face.points_x / edge < 2 || face.points_y / edge < 2)
    return false;
  const Coarse coarse = coarse_mesh(face, depth, n_levels);
  const long bottom = level_bottoms(n_levels, cells_a_level).back();
  return coarse.n_layers - bottom / edge >= cells_a_level;
}

void check(const Grid& face, double depth, int cells_a_level) {
  require_positive("length_x", face.length_x, "m");
  require_positive("length_y", face.length_y, "m");
  require_positive("depth", depth, "m");
  require_between("cells_a_level", cells_a_level, 1, 64, "1");
  for (const int points : {face.points_x, face.points_y})
    if (points < 2 || points % 2 != 0)
      refuse_argument(Argument{"cells per side of a mesh with hanging nodes",
                               "surface.points"},
                      points,
                      "even, preferably a power of two times a small number");
}

/// The largest number of levels of a mesh.
int n_levels_of(const Grid& face, double depth, int cells_a_level) {
  check(face, depth, cells_a_level);
  int n_levels = 0;
  while (n_levels < 20 && is_possible(face, depth, n_levels + 1, cells_a_level))
    ++n_levels;
  return n_levels;
}

} // namespace

BlockMesh equal_boxes(const Grid& face, double depth) {
  require_positive("depth", depth, "m");
  const int n_layers = n_layers_of(face, depth);
  const double layer = depth / n_layers;
  std::vector<double> thickness(static_cast<std::size_t>(n_layers), layer);
  thickness.back() =
      depth - std::accumulate(thickness.begin(), thickness.end() - 1, 0.0);
  return layered_mesh(face, thickness);
}

BlockMesh hanging_mesh(const Grid& face, double depth, int cells_a_level) {
  const int n_levels = n_levels_of(face, depth, cells_a_level);
  const Coarse coarse = coarse_mesh(face, depth, n_levels);
  const double layer = depth / coarse.n_layers;
  BlockMesh mesh = equal_boxes(coarse.face, depth);
  for (const long bottom : level_bottoms(n_levels, cells_a_level))
    mesh.refine_below.push_back(layer * static_cast<double>(bottom) /
                                coarse.edge);
  std::reverse(mesh.refine_below.begin(), mesh.refine_below.end());
  return mesh;
}

double hanging_nodes(const Grid& face, double depth, int cells_a_level,
                     int degree) {
  const int n_levels = n_levels_of(face, depth, cells_a_level);
  const Coarse coarse = coarse_mesh(face, depth, n_levels);
  std::vector<long> bottoms = level_bottoms(n_levels, cells_a_level);
  bottoms.push_back(long{coarse.n_layers} * coarse.edge);
  double nodes = 0.0;
  long top = 0;
  for (std::size_t level = 0; level < bottoms.size(); ++level) {
    const double edge = std::ldexp(1.0, static_cast<int>(level));
    const double n_x = face.points_x / edge, n_y = face.points_y / edge;
    const double n_z = static_cast<double>(bottoms[level] - top) / edge;
    nodes += (degree * n_x + 1.0) * (degree * n_y + 1.0) * (degree * n_z + 1.0);
    if (level > 0) // vertices of these cells are nodes of the finer ones
      nodes -= (n_x + 1.0) * (n_y + 1.0);
    top = bottoms[level];
  }
  return nodes;
}

Grid halvable_columns(const Grid& nodes, int degree, int halvings) {
  require_between("halvings", halvings, 1, 12, "1");
  const int step = degree << halvings;
  for (const int points : {nodes.points_x, nodes.points_y})
    if (points % step != 0 || points / step < 2)
      refuse_argument(
          Argument{"points per side of an adaptive mesh", "mesh.halvings"},
          points,
          "a multiple of " + std::to_string(step) +
              ", the node spacings of a cell that is halved " +
              std::to_string(halvings) + " times, and at least twice as many");
  return {nodes.points_x / step, nodes.points_y / step, nodes.length_x,
          nodes.length_y};
}

BlockMesh halvable_boxes(const Grid& nodes, int degree, int halvings,
                         const std::vector<double>& interfaces, double depth) {
  const Grid columns = halvable_columns(nodes, degree, halvings);
  if (interfaces.empty())
    return equal_boxes(columns, depth);
  return layered_mesh(columns, halvable_layers(0.5 * (columns.spacing_x() +
                                                      columns.spacing_y()),
                                               halvings, interfaces, depth));
}

} // namespace asperity::meshes
