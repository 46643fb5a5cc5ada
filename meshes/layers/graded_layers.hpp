#pragma once

// Thicknesses of the block's layers, finest at the contact surface and growing
// away from it. This file defines how the grading ratio is fitted to a given
// depth.

#include "mechanics/fem_settings.hpp"

#include <span>
#include <vector>

namespace asperity::meshes {

/// Computes thicknesses of structured layers whose sum is the depth:
///
///     t_i = t_0 g^i,  i = 0..n-1,   t_0 (1 + g + ... + g^(n-1)) = depth  (M.1)
///
/// The surface layer t_0 is kept exactly, because the contact area depends on
/// it. The number n is the smallest that reaches the depth with the requested
/// grading ratio, and g is then lowered until (M.1) holds, so the mesh is never
/// coarser than requested. For a uniform mesh (grading ratio 1) whose depth is
/// not an integer multiple of t_0 this makes the deeper layers slightly
/// thinner.
///
/// @param surface_thickness  t_0, the layer at the contact surface  [m] > 0
/// @param growth             grading ratio: thickness ratio of successive
///                           layers  [1] 1..10
/// @param depth              depth of the block  [m] >= t_0
/// @return                   n thicknesses, starting at the contact surface
///                           [m]
/// @throws std::domain_error  an argument is outside its range; the depth lies
///                            between 1 and 1.5 surface layers, which would
///                            leave a sliver; or more than 100000 layers would
///                            be needed
/// @par Accuracy
///            The first thickness is exactly t_0 unless it is the only one,
///            which equals depth; the sum is depth up to the roundoff of the
///            sum.
std::vector<double> graded_layers(double surface_thickness, double growth,
                                  double depth);

/// As graded_layers, but with a layer boundary on each interface of a block of
/// several materials. Between interfaces the thicknesses t_i = s g^i start from
/// the largest s that is at most g times the layer above and satisfies
///
///     s (1 + g + ... + g^(n-1)) = distance of the interfaces,            (M.2)
///
/// where n is the smallest number for which such an s exists. No layer is
/// thicker than the grading ratio allows; none is thinner than half the layer
/// above it, unless two interfaces are themselves that close. The first layer
/// at the contact surface is t_0 if the depth of the first interface is t_0, or
/// 1.5 t_0 or more; otherwise it is that depth or half of it.
///
/// @param interfaces  depths [m], increasing, each > 0 and < depth; none: (M.1)
/// @return            thicknesses, starting at the contact surface [m]
/// @throws std::domain_error  as graded_layers; also if the interfaces do not
///                            increase
/// @par Accuracy
///            The sum down to each interface is its depth up to the roundoff of
///            the sum.
std::vector<double>
graded_layers_with_interfaces(double surface_thickness, double growth,
                              std::span<const double> interfaces, double depth);

/// The same for the settings of a block.
/// @param spacing  of the nodes of the contact surface [m]; surface_cell_depth
/// is
///                 measured in it: the node planes next to the contact surface
///                 are that far apart, so 1 gives a cubic cell for Q1 and Q2
///                 alike
/// @param depth    of the block [m]
std::vector<double> layers_of_block(const mechanics::BlockSettings& settings,
                                    std::span<const double> interfaces,
                                    double spacing, double depth);

} // namespace asperity::meshes
