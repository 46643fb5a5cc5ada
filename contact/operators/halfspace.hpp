#pragma once

// Computes the surface compliance, per wavevector, of an elastic continuum with
// a frictionless surface: an isotropic half-space or a slab of finite
// thickness.

#include "base/grid.hpp"
#include "contact/operators/fourier_operator.hpp"
#include "mechanics/elastic_block.hpp"

#include <functional>

namespace asperity::contact {

/// Compliance of a slab of thickness d relative to the half-space, with
/// x = q d:
///
///     clamped   ((3-4 nu) sinh 2x - 2x)
///               / ((3-4 nu) cosh 2x + 2 x^2 + 5 - 12 nu + 8 nu^2)
///     sliding   (cosh 2x - 1) / (sinh 2x + 2x)
///     pressure  (sinh 2x + 2x) / (cosh 2x - 1 - 2 x^2)
///
/// All three tend to 1 for x -> inf, with a difference of at most
/// 4 x^2 exp(-2x).
/// @param reduced_wavevector  q d                                 [1] > 0
/// @param poisson_ratio       nu; used by `clamped` only          [1] -1..0.5
/// @throws std::domain_error  an argument is outside its range
/// @par Accuracy  relative error 1e-14 for x > 0.1; below that, the `pressure`
///            and `sliding` forms are evaluated by series, to 1e-12.
/// @see  K. L. Johnson, Contact Mechanics (1985), ch. 5; G. Carbone et al.,
///       J. Mech. Phys. Solids 56, 684 (2008)
double slab_compliance_factor(double reduced_wavevector,
                              mechanics::FarBoundary far_boundary,
                              double poisson_ratio);

/// C(q) [m/Pa] as a function of q [rad/m] > 0: 2 factor(q d) / (E* q), or the
/// compliance of LayerStack if there are layers.
/// @throws std::domain_error  a number of the block is outside its range
std::function<double(double)>
compliance_function(const mechanics::ElasticBlock& block);

/// C(q) [m/Pa] of the wavevectors of a grid. The uniform mode is left as it is.
/// @throws std::domain_error  a number of the block is outside its range
EvenColumn compliance_column(const Grid& grid,
                             const mechanics::ElasticBlock& block);

/// The operator with this compliance.
FourierOperator halfspace_operator(const Grid& grid,
                                   const mechanics::ElasticBlock& block,
                                   int threads = 1);

} // namespace asperity::contact
