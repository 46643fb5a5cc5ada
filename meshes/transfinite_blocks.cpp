#include "meshes/transfinite_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace asperity::meshes {
namespace {

/// The faces of a hexahedron by its corners, in cyclic order.
constexpr std::array<std::array<std::size_t, 4>, 6> faces_of_block = {
    {{0, 2, 6, 4},
     {1, 3, 7, 5},
     {0, 1, 5, 4},
     {2, 3, 7, 6},
     {0, 1, 3, 2},
     {4, 5, 7, 6}}};

int number_of_last(std::size_t size) {
  return static_cast<int>(size);
}

} // namespace

EdgeLaw graded_edge(double length, double first, double last) {
  constexpr double most_cells = 1e9;
  const double cells = std::abs(last - first) < 1e-9 * first
                           ? length / first
                           : length / (last - first) * std::log(last / first);
  const int n =
      static_cast<int>(std::clamp(std::ceil(cells - 1e-9), 1.0, most_cells));
  return {n, std::pow(last / first, 1.0 / n)}; // (M.5)
}

int TransfiniteBlocks::point(const Place& place) {
  points_.push_back(place);
  return number_of_last(points_.size());
}

void TransfiniteBlocks::arc(int from, int to, int centre) {
  edges_.push_back({from, to, centre, {0, 1.0}});
  edge_between_[std::minmax(from, to)] = number_of_last(edges_.size());
}

/// The number of the edge between two points, which is new if there is none.
int TransfiniteBlocks::edge(int from, int to) {
  const auto [found, is_new] = edge_between_.try_emplace(std::minmax(from, to));
  if (is_new) {
    edges_.push_back({from, to, 0, {0, 1.0}});
    found->second = number_of_last(edges_.size());
  }
  return found->second;
}

int TransfiniteBlocks::face(const std::array<int, 4>& corners) {
  std::array<int, 4> key = corners;
  std::sort(key.begin(), key.end());
  const auto [found, is_new] = face_between_.try_emplace(key);
  if (!is_new)
    return found->second;
  Face made{corners, {}, 0};
  bool is_spherical = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const int number = edge(corners[i], corners[(i + 1) % 4]);
    const Edge& side = edges_[static_cast<std::size_t>(number) - 1];
    made.edges[i] = side.from == corners[i] ? number : -number;
    if (i == 0)
      made.centre = side.centre;
    is_spherical =
        is_spherical && side.centre != 0 && side.centre == made.centre;
  }
  if (!is_spherical)
    made.centre = 0;
  faces_.push_back(made);
  return found->second = number_of_last(faces_.size());
}

void TransfiniteBlocks::add(const std::array<int, 8>& corners,
                            const std::array<EdgeLaw, 3>& laws, int group) {
  for (std::size_t corner = 0; corner < 8; ++corner)
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t bit = std::size_t{1} << d;
      if ((corner & bit) != 0)
        continue;
      Edge& along = edges_[static_cast<std::size_t>(
                               edge(corners[corner], corners[corner | bit])) -
                           1];
      if (along.law.n == 0)
        along.law = {laws[d].n, along.from == corners[corner]
                                    ? laws[d].ratio
                                    : 1.0 / laws[d].ratio};
    }
  Block block{corners, {}, {laws[0].n, laws[1].n, laws[2].n}, group};
  for (std::size_t i = 0; i < faces_of_block.size(); ++i) {
    const auto& around = faces_of_block[i];
    block.faces[i] = face({corners[around[0]], corners[around[1]],
                           corners[around[2]], corners[around[3]]});
  }
  blocks_.push_back(block);
}

double TransfiniteBlocks::nodes(int degree) const {
  const auto inside = [degree](int cells) {
    return degree * 1.0 * cells - 1.0;
  };
  std::set<int> corners; // without the centres of arcs
  double count = 0.0;
  for (const Edge& edge : edges_) {
    corners.insert({edge.from, edge.to});
    count += inside(edge.law.n);
  }
  for (const Face& face : faces_) {
    double across = 1.0;
    for (const int number : {face.edges[0], face.edges[1]})
      across *=
          inside(edges_[static_cast<std::size_t>(std::abs(number)) - 1].law.n);
    count += across;
  }
  for (const Block& block : blocks_)
    count += inside(block.cells[0]) * inside(block.cells[1]) *
             inside(block.cells[2]);
  return count + static_cast<double>(corners.size());
}

} // namespace asperity::meshes
