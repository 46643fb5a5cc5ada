#pragma once

// Conduction of heat or current from the nodes in contact through the block.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/block/full_block.hpp"

#include <vector>

namespace asperity::fem {

/// Solves Laplace's equation of the temperature T with the mesh, the shape
/// functions and the periodic or insulated sides of a block of uniform
/// conductivity k,
///
///     div grad T = 0,   T = 1 at the nodes in contact, 0 at the far boundary,
///
/// and no flux through the rest of the contact surface. The conductance is
/// int |grad T|^2 dV, whose error is of second order in that of T. The matrix
/// is the one of u_z in a material of lambda = -mu whose u_x and u_y are held,
/// (F.3). Collective.
/// @param touching  which contact points of this rank are in contact
/// @param depth     of the block [m] > 0
/// @throws std::domain_error  there are two bodies
BlockConduction conduction(const BlockSystem& system,
                           const std::vector<bool>& touching, double depth);

} // namespace asperity::fem
