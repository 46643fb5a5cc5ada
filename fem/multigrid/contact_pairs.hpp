#pragma once

// Nodes of one body that stiff springs join to faces of another, and the change
// of variables in which such springs are a diagonal.

#include "fem/multigrid/sparse_rows.hpp"
#include "ranks/ghost_values.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace asperity::fem {

/// Springs k [N/m, or in the unit of a level's stiffness] between a node and
/// the place on the other body's face that it touches:
///
///     force on the node = -k r,    r = u_z - (N m),
///
/// where m is u_z of the face's nodes and N their shape functions. A stiff
/// spring leaves r small and does not resist a common motion of both sides,
/// which no smoother that treats one unknown at a time can reduce. With r in
/// place of the node's u_z, u = T (r, m), the springs are a diagonal, and a
/// change of m moves both sides. Nor does the force k r suffer from the
/// roundoff of u.
struct ContactPairs {
  std::vector<std::size_t> nodes; ///< u_z of each pair's node, of this rank
  std::vector<double> springs;    ///< k > 0
  SparseRows faces;               ///< N, a row per pair; columns are unknowns
  bool exist = false;             ///< on any rank
  std::shared_ptr<const GhostValues> ghosts; ///< of the vectors below; null
                                             ///< on one process

  /// Computes u = T (r, m) in place. Collective.
  template <class Number>
  void add_common(Number* displacement) const;

  /// Computes T^T f in place: a force on the node acts on the face as well. The
  /// forces of other ranks become zero. Collective.
  template <class Number>
  void add_to_faces(Number* force) const;

  /// Adds the forces of the springs, also those on unknowns of other ranks.
  /// @param displacement  u, with those of other ranks
  void add_spring_force(const double* displacement, double* force) const;

  std::size_t bytes() const {
    return nodes.size() * sizeof(std::size_t) +
           springs.size() * sizeof(double) + faces.bytes();
  }

private:
  template <class Number>
  double on_face(std::size_t pair, const Number* displacement) const;
};

} // namespace asperity::fem
