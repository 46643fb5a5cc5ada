#pragma once

// Thicknesses of coarse layers of cells such that interfaces between materials
// become planes of cells when the cells are halved.

#include <span>
#include <vector>

namespace asperity::meshes {

/// Computes thicknesses of layers, near `edge`, of cells that may be halved:
/// every interface is a boundary of layers, or a plane of cells after at most
/// `halvings` halvings of the layer that contains it.
///
/// Where interfaces are at least 0.7 edges apart, equal layers as near to the
/// edge as possible fill the distance t. A thinner distance becomes a fraction
/// of a layer, t = T / 2^m, with T as near to the edge as the next interfaces
/// and `halvings` permit; if they permit none, it becomes a layer of its own,
/// T = t, whose cells are flat.
///
/// @param edge        lateral edge of the coarsest cells [m] > 0
/// @param halvings    of a cell at most [1] 0..12
/// @param interfaces  depths [m], increasing, each > 0 and < depth
/// @param depth       of the block [m] > 0
/// @return            thicknesses, starting at the contact surface [m] > 0;
///                    their sum is the depth up to roundoff
/// @throws std::domain_error  an argument is outside its range, or the layers
///                            would be more than a million
std::vector<double> halvable_layers(double edge, int halvings,
                                    std::span<const double> interfaces,
                                    double depth);

} // namespace asperity::meshes
