#pragma once

// Contact of a lattice with its counter-surface as the linear solver sees it:
// springs on u_z of the contact surface and nodes whose u_z is held.

#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_lattice.hpp"
#include "fem/multigrid/lattice_slab.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace asperity::fem {

/// Contact on the nodes of the contact surface without images, x fastest.
///
/// If ranks share the rows of cells (LatticeSlab), each has the nodes of its
/// own rows and of the image row (NodeLayout::face_rows). A spring belongs to
/// the rank of its cell, so that the forces on the image row are those of this
/// rank's cells only; nodes of the image row are held if they are at the next
/// rank.
struct FaceContact {
  SparseRows springs;       ///< symmetric matrix on u_z, or no rows
  std::vector<bool> held;   ///< or empty, on all ranks
  bool is_sticking = false; ///< all components of held nodes are held, not only
                            ///< u_z

  bool is_free() const;
};

/// The springs of a contact and the places of its nodes' u_z in a vector.
struct FaceSprings {
  const SparseRows* matrix = nullptr; ///< null or without rows if there are no
                                      ///< springs
  const std::vector<std::size_t>* places = nullptr;
  double factor = 1.0; ///< of the forces

  std::size_t nodes() const { return matrix == nullptr ? 0 : matrix->rows(); }

  /// Adds the forces of the springs on the nodes first..end-1, as far as there
  /// are so many.
  template <class Number>
  void add_force(std::size_t first, std::size_t end, const Number* displacement,
                 Number* force) const;
};

/// Adds `factor` times the forces of the springs to `force`.
template <class Number>
void add_spring_force(const SparseRows& springs,
                      const std::vector<std::size_t>& places,
                      const Number* displacement, Number* force,
                      double factor = 1.0) {
  FaceSprings{&springs, &places, factor}.add_force(0, springs.rows(),
                                                   displacement, force);
}

/// How contact is transferred to the next coarser lattice: springs by the
/// Galerkin product P^T S P with the interpolation P of the surface; a coarse
/// node is held if the fine node nearest to it is.
class FaceTransfer {
public:
  FaceTransfer(const BoxLattice& fine, const LatticeSlab& fine_slab,
               const BoxLattice& coarse, const LatticeSlab& coarse_slab);

  /// Collective if the fine rows are shared and the coarse ones are not.
  FaceContact coarse(const FaceContact& fine) const;

  std::size_t bytes() const {
    return interpolation_.bytes() + transposed_.bytes();
  }

private:
  void gather(FaceContact& contact) const;

  SparseRows interpolation_, transposed_;
  /// Of each coarse node along x and y the nearest fine one of this rank.
  std::array<std::vector<std::optional<std::size_t>>, 2> nearest_;
  std::size_t fine_nodes_x_ = 0, coarse_size_ = 0;
  RankGroup* ranks_ = nullptr; ///< set if the coarse nodes are gathered
};

/// Adds the values of the image row, one per node of the contact surface, to
/// those of the next rank's first row. Collective if the rows are shared.
void fold_face_row(const NodeLayout& layout, const LatticeSlab& slab,
                   std::vector<double>& nodes);

/// Holds the nodes of the image row that the next rank holds. Collective if the
/// rows are shared.
void share_held(const NodeLayout& layout, const LatticeSlab& slab,
                FaceContact& contact);

/// The places of a component of the surface's nodes in a vector.
std::vector<std::size_t> face_places(const NodeLayout& layout,
                                     int component = 2);

/// The places of all unknowns that contact holds, those of u_z last.
std::vector<std::size_t> held_places(const NodeLayout& layout,
                                     const FaceContact& contact);

/// Sets the supported unknowns of the far boundary to zero.
template <class Number>
void clear_far_boundary(const BoxLattice& lattice, const NodeLayout& layout,
                        Number* vector);

} // namespace asperity::fem
