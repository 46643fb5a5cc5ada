#pragma once

// Adjacent blocks of hexahedra in gmsh's built-in geometry kernel, each meshed
// by transfinite interpolation from its twelve edges.

#include "meshes/block_mesh.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::meshes {

/// Subdivision of an edge: `n` cells, each `ratio` times as long as the
/// previous one.
struct EdgeLaw {
  int n = 1;
  double ratio = 1.0;
};

/// Subdivides an edge into cells whose size grows linearly along it:
///
///     s(t) = s_a + (s_b - s_a) t / l,  n = ceil of the integral of dt / s,
///     ratio = (s_b / s_a)^(1/n)                                        (M.5)
///
/// @param length       l, the length of the edge, > 0
/// @param first, last  s_a and s_b, > 0, in the unit of the length
EdgeLaw graded_edge(double length, double first, double last);

/// Builds the current model of gmsh; to be used inside in_gmsh. A point, edge
/// or face that several blocks share is created once, so that the blocks are
/// connected.
class TransfiniteBlocks {
public:
  int point(const Place& place);

  /// Adds a circular edge, shorter than half a turn, for blocks that are added
  /// later. Four arcs with a common centre around a face make the face a part
  /// of the sphere.
  void arc(int from, int to, int centre);

  /// Adds a block with 2 x 2 x 2 corners, x fastest in its own right-handed
  /// directions. The laws subdivide its edges along each direction, from low to
  /// high. Existing edges keep their law, which must have the same number of
  /// cells.
  void add(const std::array<int, 8>& corners,
           const std::array<EdgeLaw, 3>& laws, int group);

  /// Generates the mesh and one physical volume per group, starting with tag 1.
  void mesh(const std::vector<std::string>& group_names);

private:
  struct Edge {
    int tag = 0; ///< gmsh's tag, positive from `from`
    int from = 0;
    int centre = 0; ///< of an arc, else 0
    EdgeLaw law{0, 1.0};
  };

  Edge& edge(int from, int to);
  int face(const std::array<int, 4>& corners);

  std::map<std::pair<int, int>, Edge> edges_;
  std::map<std::array<int, 4>, int> faces_;             ///< by sorted corners
  std::map<int, std::array<int, 4>> corners_of_face_;   ///< in cyclic order
  std::map<int, std::array<int, 8>> corners_of_volume_; ///< in gmsh's order
  std::vector<std::pair<int, int>> group_of_volume_;
};

} // namespace asperity::meshes
