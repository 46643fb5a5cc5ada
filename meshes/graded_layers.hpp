#pragma once

// Thicknesses of the block's layers, finest at the contact face and growing
// away from it. Owns how a growth ratio is fitted to a given depth.

#include <span>
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

/// As graded_layers, with a layer's face on each interface of a block of
/// several materials: between interfaces the thicknesses t_i = s g^i start
/// from the largest s that is at most g times the layer above and fits,
///
///     s (1 + g + ... + g^(n-1)) = distance of the interfaces,            (M.2)
///
/// n the smallest number that lets it. No layer is thicker than the growth
/// allows; none is thinner than half the layer above it, but where two
/// interfaces are themselves so near. The face's first layer is t_0 if the
/// first interface is t_0 deep, or 1.5 t_0 or deeper; else that distance, or
/// half of it.
///
/// @param interfaces  depths [m], rising, each > 0 and < depth; none: (M.1)
/// @return            thicknesses, the contact face's first [m]
/// @throws std::domain_error  as graded_layers; interfaces do not rise
/// @par Accuracy  the sum down to each interface is its depth to the rounding
///            of the sum
std::vector<double>
graded_layers_with_interfaces(double surface_thickness, double growth,
                              std::span<const double> interfaces, double depth);

} // namespace asperity::meshes
