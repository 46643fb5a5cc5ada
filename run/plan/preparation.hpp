#pragma once

// Refuses a case that cannot be computed before anything of it is, with the
// file, the line and the key.

#include "base/grid.hpp"
#include "input/types/case.hpp"

#include <vector>

namespace asperity::run {

/// Requires that each method can build its block on the grid of the surface:
/// that meshes, layers, inclusions, slabs, counter-bodies and atoms fit. The
/// reader of cases refuses what does not depend on the grid. The solvers' own
/// checks are asked; none of them builds a mesh or a matrix here, but the mesh
/// of a file is read.
///
/// @param grid  of the surface; without points if no method needs a surface
/// @throws input::InputError  all mistakes, each with its place
void require_computable(const cases::Case& contact_case,
                        const std::vector<cases::MethodSpec>& methods,
                        const Grid& grid);

/// Requires that the surfaces of a case can be built, by building the first
/// realisation if it is small enough that this takes less than about a second.
///
/// @param grid  as for require_computable
/// @throws input::InputError, std::domain_error  the surface is refused
void require_surface(const cases::Case& contact_case,
                     const std::vector<cases::MethodSpec>& methods,
                     const Grid& grid);

} // namespace asperity::run
