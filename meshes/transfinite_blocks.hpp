#pragma once

// Adjacent blocks of hexahedra, each meshed by transfinite interpolation from
// its twelve edges. gmsh is needed for the mesh, not for its description.

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

/// Describes a mesh of such blocks; mesh_by_gmsh() makes it. A point, edge or
/// face that several blocks share exists once, so that the blocks are
/// connected. Points, edges and faces are numbered from 1, each in order of
/// creation.
class TransfiniteBlocks {
public:
  struct Edge {
    int from = 0;
    int to = 0;
    int centre = 0; ///< of an arc, else 0
    EdgeLaw law{0, 1.0};
  };

  /// A face by its corners, in cyclic order.
  struct Face {
    std::array<int, 4> corners{};
    std::array<int, 4> edges{}; ///< negative if traversed backwards
    int centre = 0;             ///< of the sphere it is a part of, else 0
  };

  struct Block {
    std::array<int, 8> corners{}; ///< x fastest in its own directions
    std::array<int, 6> faces{};
    std::array<int, 3> cells{}; ///< along each direction
    int group = 0;
  };

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

  /// Number of nodes of elements of this degree in the whole mesh [1].
  double nodes(int degree) const;

  const std::vector<Place>& points() const { return points_; }

  const std::vector<Edge>& edges() const { return edges_; }

  const std::vector<Face>& faces() const { return faces_; }

  const std::vector<Block>& blocks() const { return blocks_; }

private:
  int edge(int from, int to);
  int face(const std::array<int, 4>& corners);

  std::vector<Place> points_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<Block> blocks_;
  std::map<std::pair<int, int>, int> edge_between_;
  std::map<std::array<int, 4>, int> face_between_; ///< by sorted corners
};

/// Generates the mesh by gmsh, to be used inside in_gmsh: its vertices, its
/// cells group by group, and the groups.
BlockMesh mesh_by_gmsh(const TransfiniteBlocks& blocks,
                       const std::vector<std::string>& group_names);

} // namespace asperity::meshes
