#pragma once

// The lattice of boxes that a mesh may be.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_problem.hpp"
#include "fem/multigrid/box_lattice.hpp"

#include <optional>

namespace asperity::fem {

/// The lattice of a problem if its mesh consists of equal columns of boxes
/// numbered as by layered_mesh; none for other meshes, two bodies and several
/// ranks.
std::optional<BoxLattice> box_lattice(const BlockProblem& problem);

} // namespace asperity::fem
