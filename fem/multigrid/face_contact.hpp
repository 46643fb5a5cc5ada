#pragma once

// Contact of a lattice with its counter-surface as the linear solver sees it:
// springs on u_z of the contact surface and nodes whose u_z is held.

#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_lattice.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace asperity::fem {

/// Contact on the nodes of the contact surface without images, x fastest.
struct FaceContact {
  SparseRows springs;       ///< symmetric matrix on u_z, or no rows
  std::vector<bool> held;   ///< or empty
  bool is_sticking = false; ///< all components of held nodes are held, not only
                            ///< u_z

  bool is_free() const;
};

/// How contact is transferred to the next coarser lattice: springs by the
/// Galerkin product P^T S P with the interpolation P of the surface; a coarse
/// node is held if the fine node nearest to it is.
class FaceTransfer {
public:
  FaceTransfer(const BoxLattice& fine, const BoxLattice& coarse);

  FaceContact coarse(const FaceContact& fine) const;

  std::size_t bytes() const {
    return interpolation_.bytes() + transposed_.bytes();
  }

private:
  SparseRows interpolation_, transposed_;
  std::array<std::vector<std::size_t>, 2> nearest_;
  std::size_t fine_nodes_x_ = 0, coarse_size_ = 0;
};

/// The places of a component of the surface's nodes in a vector.
std::vector<std::size_t> face_places(const NodeLayout& layout,
                                     int component = 2);

/// The places of all unknowns that contact holds, those of u_z last.
std::vector<std::size_t> held_places(const NodeLayout& layout,
                                     const FaceContact& contact);

/// Adds the forces of the springs to `force`.
template <class Number>
void add_spring_force(const SparseRows& springs,
                      const std::vector<std::size_t>& places,
                      const Number* displacement, Number* force);

/// Sets the supported unknowns of the far boundary to zero.
template <class Number>
void clear_far_boundary(const BoxLattice& lattice, const NodeLayout& layout,
                        Number* vector);

} // namespace asperity::fem
