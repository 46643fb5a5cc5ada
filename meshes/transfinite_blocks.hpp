#pragma once

// Blocks of hexahedra laid side by side in gmsh's own geometry, each cut by
// transfinite interpolation from its twelve edges.

#include "meshes/block_mesh.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::meshes {

/// How an edge is cut: `n` cells, each `ratio` times as long as the one before.
struct EdgeLaw {
  int n = 1;
  double ratio = 1.0;
};

/// Cells whose size grows linearly along an edge:
///
///     s(t) = s_a + (s_b - s_a) t / l,  n = ceil of the integral of dt / s,
///     ratio = (s_b / s_a)^(1/n)                                        (M.5)
///
/// @param length of the edge, l          > 0
/// @param first, last  s_a, s_b          > 0, in the unit of the length
EdgeLaw graded_edge(double length, double first, double last);

/// Builds the current model of gmsh, inside in_gmsh. A point, edge or face that
/// blocks share is made once, so that they join.
class TransfiniteBlocks {
public:
  int point(const Place& place);

  /// A circular edge, shorter than half a turn, for blocks added later. Four
  /// arcs about one centre around a face make it a piece of the sphere.
  void arc(int from, int to, int centre);

  /// A block of 2 x 2 x 2 corners, x fastest of its own right-handed
  /// directions, and how its edges along each are cut, from low to high. Edges
  /// already there keep their law, which must cut into as many cells.
  void add(const std::array<int, 8>& corners,
           const std::array<EdgeLaw, 3>& laws, int group);

  /// Makes the mesh and one physical volume a group, the first of tag 1.
  void mesh(const std::vector<std::string>& group_names);

private:
  struct Edge {
    int tag = 0; ///< of gmsh, positive from `from`
    int from = 0;
    int centre = 0; ///< of an arc, else 0
    EdgeLaw law{0, 1.0};
  };

  Edge& edge(int from, int to);
  int face(const std::array<int, 4>& corners);

  std::map<std::pair<int, int>, Edge> edges_;
  std::map<std::array<int, 4>, int> faces_;             ///< by sorted corners
  std::map<int, std::array<int, 4>> corners_of_face_;   ///< in turn around it
  std::map<int, std::array<int, 8>> corners_of_volume_; ///< in gmsh's order
  std::vector<std::pair<int, int>> group_of_volume_;
};

} // namespace asperity::meshes
