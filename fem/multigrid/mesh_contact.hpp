#pragma once

// Contact of a block with its counter-surface as the linear solver sees it, and
// how it is transferred to coarser functions.

#include "base/ranks/ghost_values.hpp"
#include "fem/multigrid/sparse_rows.hpp"
#include "fem/multigrid/unknown_constraints.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
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

/// Springs and held nodes of the contact surface, in the numbers of one mesh
/// (UnknownLayout). If ranks share the mesh, each has springs of its own, which
/// may act on unknowns of others, and its own held nodes.
struct MeshContact {
  std::vector<std::size_t> unknowns; ///< u_z that `springs` join
  SparseRows springs; ///< symmetric matrix on these, or no rows; [N/m] or in
                      ///< the unit of a level's stiffness
  bool has_springs = false;      ///< on any rank
  ContactPairs pairs;            ///< whose springs are not among `springs`
  std::vector<std::size_t> held; ///< u_z of held nodes
  bool is_sticking = false;      ///< u_x and u_y of held nodes are held, too
  /// Further unknowns that are held. Coarser functions ignore them, so they
  /// should be few.
  std::vector<std::size_t> pinned;

  /// Whether this rank has neither springs nor held nodes.
  bool is_free() const { return springs.is_empty() && held.empty(); }

  /// All unknowns that are held.
  /// @param step  of UnknownLayout
  std::vector<std::size_t> held_unknowns(std::size_t step) const;

  /// The same with springs in another unit [N/m].
  MeshContact in_units_of(double stiffness) const;

  /// Adds `factor` times the forces of the springs, but those of pairs.
  template <class Number>
  void add_spring_force(const Number* displacement, Number* force,
                        double factor = 1.0) const;

  std::size_t bytes() const {
    return springs.bytes() + pairs.bytes() +
           (unknowns.size() + held.size()) * sizeof(std::size_t);
  }
};

/// Contact points: the values of shape functions at each, by unknown.
/// @param springs  of the points [N/m]
/// @param held     whether the only unknown of a point is held
/// @param is_pair  whether a point is a contact pair, of which the first
///                 unknown is that of the node; or empty
/// @param ranks    that share the unknowns, or null. Collective.
/// @param size     of a vector of the unknowns
struct PointContact {
  std::span<const double> springs;
  const std::vector<bool>& held;
  bool is_sticking = false;
  const std::vector<bool>* is_pair = nullptr;
};

MeshContact contact_of_points(const SparseRows& points,
                              const PointContact& contact, std::size_t size,
                              RankGroup* ranks);

/// The contact of all ranks, each of which has the whole mesh: the sum of their
/// springs, and all held nodes. Collective.
MeshContact of_all_ranks(RankGroup& ranks, const MeshContact& own);

/// Contact of coarser functions: springs by the Galerkin product P^T S P with
/// the interpolation P of the surface; a coarse node is held if a certain fine
/// one is.
class ContactTransfer {
public:
  /// Adds the row of P of a fine node, whose masters must not be constrained.
  /// @param fine  u_z of the node
  void add_node(std::size_t fine);
  void add_master(std::size_t coarse, double weight);

  /// The coarse node is held if the fine one is; both by u_z.
  void add_held(std::size_t fine, std::size_t coarse) {
    held_.emplace_back(fine, coarse);
  }

  /// To be called once after all have been added.
  void finish();

  MeshContact coarse(const MeshContact& fine) const;

  std::size_t bytes() const {
    return rows_.bytes() +
           (fine_.size() + held_.size()) * 2 * sizeof(std::size_t);
  }

private:
  using Pair = std::pair<std::size_t, std::size_t>;

  std::vector<Pair> fine_;          ///< u_z of each fine node, and its row
  SparseRows rows_;                 ///< P; columns are numbers in coarse_
  std::vector<std::size_t> coarse_; ///< u_z of coarse nodes
  std::vector<Pair> held_;          ///< fine and coarse u_z
};

} // namespace asperity::fem
