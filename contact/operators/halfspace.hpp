#pragma once

// Computes the surface compliance, per wavevector, of an elastic continuum with
// a frictionless surface: an isotropic half-space or a slab of finite
// thickness.

#include "base/grid.hpp"
#include "contact/operators/fourier_operator.hpp"
#include "mechanics/elastic_block.hpp"

#include <functional>

namespace asperity::contact {

/// C(q) [m/Pa] as a function of q [rad/m] > 0: 2/(E* q) of a half-space, else
/// the compliance of LayerStack.
/// @throws std::domain_error  a number of the block is outside its range
std::function<double(double)>
compliance_function(const mechanics::ElasticBlock& block);

/// C(q) [m/Pa] of the wavevectors of a grid. The uniform mode is left as it is.
/// @throws std::domain_error  a number of the block is outside its range
EvenColumn compliance_column(const Grid& grid,
                             const mechanics::ElasticBlock& block);

/// The operator of a block: a convolution with this compliance, or with free
/// boundaries that of free_halfspace().
/// @throws std::domain_error  also if a block with free boundaries is no
///                            half-space
FourierOperator halfspace_operator(const Grid& grid,
                                   const mechanics::ElasticBlock& block,
                                   int threads = 1);

} // namespace asperity::contact
