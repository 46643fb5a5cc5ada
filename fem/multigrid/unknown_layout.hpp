#pragma once

// How the unknowns of a mesh lie in the vectors of a rank, and what determines
// those that are no unknowns of a linear system.

#include "base/ranks/ghost_values.hpp"
#include "fem/multigrid/unknown_constraints.hpp"

#include <cstddef>
#include <memory>

namespace asperity::fem {

/// The unknowns of this rank, then copies of those of other ranks (ghosts), and
/// anywhere those that constraints determine.
struct UnknownLayout {
  std::size_t size = 0; ///< of a vector

  /// The number of u_z less that of u_y of the same node, and that of u_y less
  /// that of u_x.
  std::size_t step = 1;

  SharedConstraints constraints;
  std::shared_ptr<const GhostValues> ghosts; ///< null on one process

  RankGroup* ranks() const {
    return ghosts == nullptr ? nullptr : &ghosts->ranks();
  }

  /// Writes the displacements of other ranks and those that are constrained.
  template <class Number>
  void complete(Number* displacement) const {
    if (ghosts != nullptr)
      ghosts->fill_ghosts(displacement);
    constraints->distribute(displacement);
  }

  /// Moves forces on unknowns of other ranks to these.
  template <class Number>
  void collect(Number* force) const {
    if (ghosts != nullptr)
      ghosts->add_to_owners(force);
  }
};

} // namespace asperity::fem
