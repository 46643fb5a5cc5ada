#pragma once

// The full 3-D block on a mesh that follows the contact along the loading path.

#include "fem/block/block_problem.hpp"

#include <memory>

namespace asperity::fem {

/// Builds a block whose mesh is refined where the contact requires it, in each
/// load step:
///
/// 1. solve on the present mesh, which in the first step is the coarsest one;
/// 2. mark the contact surface (contact_marks.hpp) and compute the indicator of
///    the stress (stress_indicator.hpp). Cells at a mark and their neighbours
///    are halved until they are of the finest size, and so are cells with an
///    indicator above twice the rms of those in contact. In the first pass,
///    cells far from any contact with a small indicator are merged;
/// 3. interpolate the solution and repeat, until no cell is refined.
///
/// The last solution has the tolerance of the caller, the others a looser one.
/// Fields are samples on the grid. The mean gap is that of the displacement,
/// integrated over the contact surface, minus the mean height of the grid: the
/// nodes of coarse cells would sample the heights badly. Numbers of iterations
/// and set-ups are those of all passes; unknowns() are those of the last mesh.
///
/// @param problem  with `adaptive` set and a coarsest mesh of equal boxes,
///                 which halved adaptive.halvings times has the nodes of the
///                 grid on its contact surface
/// On several ranks the cells are distributed anew after each change.
///
/// @throws std::domain_error  under the conditions of make_full_block, and for
///                            two bodies
std::unique_ptr<FullBlock> make_adaptive_block(const BlockProblem& problem);

} // namespace asperity::fem
