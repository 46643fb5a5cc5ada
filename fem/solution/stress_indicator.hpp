#pragma once

// The indicator of the error inside of the block.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"

#include <vector>

namespace asperity::fem {

/// The indicator of Zienkiewicz and Zhu (Int. J. Numer. Meth. Engng 24, 337
/// (1987)) by active cell index:
///
///     eta_K^2 = int_K |sigma - sigma^*|^2 / (2 mu) dV  [J],            (F.3)
///
/// with sigma^* interpolated from the averages at vertices of block_stress.hpp.
/// These averages extend over cells of similar materials only, so that a step
/// of the strain at an interface between materials is not taken for an error,
/// as it would be by the jumps of Kelly's indicator. Where the difference is
/// less than a thousandth of the stress, eta_K is zero.
///
/// @param displacement  u over the owned unknowns [m]
/// @param ratio         of the moduli up to which materials are similar
///                      [1] >= 1; see BlockStress::at_vertices
std::vector<double>
stress_indicator(const BlockSystem& system,
                 const dealii::TrilinosWrappers::MPI::Vector& displacement,
                 double ratio = 1.0);

} // namespace asperity::fem
