#pragma once

// Thicknesses of the block's layers, finest at the contact face and growing
// away from it. Owns how a growth ratio is fitted to a given depth.

#include <vector>

namespace asperity::meshes {

/// Thicknesses of structured layers whose sum is the depth:
///
///     t_i = t_0 g^i,  i = 0..n-1,   t_0 (1 + g + ... + g^(n-1)) = depth  (M.1)
///
/// The surface layer t_0 is kept exactly, because the contact area depends on
/// it; n is the smallest number that reaches the depth with the growth asked
/// for, and g is then lowered until (M.1) holds: the mesh is never coarser
/// than asked. For a uniform mesh (growth 1) whose depth is no whole multiple
/// of t_0 this makes the deeper layers slightly thinner.
///
/// @param surface_thickness t_0, the layer at the contact face      [m]  > 0
/// @param growth            thickness ratio of successive layers    [1]  1..10
/// @param depth             of the block                            [m]  >= t_0
/// @return                  n thicknesses, the contact face's first [m]
/// @throws std::domain_error  an argument is outside its range; the depth lies
///                            between 1 and 1.5 surface layers (a sliver would
///                            be left); more than 100000 layers would be needed
/// @par Accuracy
///            The first is t_0 to the bit unless it is the only one, which is
///            depth; the sum is depth to the rounding of the sum.
std::vector<double> graded_layers(double surface_thickness, double growth,
                                  double depth);

} // namespace asperity::meshes
