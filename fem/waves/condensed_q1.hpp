#pragma once

// The surface compliance of a laterally uniform Q1 block, exactly that of the
// finite-element discretisation, one lateral wavevector at a time.

#include "fem/waves/elastic_layers.hpp"

#include <vector>

namespace asperity::fem {

/// Symbol of the surface compliance: a pressure exp(i q.x) on the contact face
/// gives the normal displacement C(q) exp(i q.x), at the nodes.
///
/// With u_j(q) exp(i q.x) at the nodes of plane j, and u_x, u_y multiplied by
/// i, layer l couples its planes by real 3x3 blocks of deal.II's cell matrix,
///
///     [ A_l  B_l ; B_l^T  D_l ](q),
///
/// and elimination from the top (plane n) down to the contact face (plane 0),
///
///     T_l = A_l - B_l (D_l + T_(l+1))^-1 B_l^T,                        (Q1.1)
///     T_n = infinite (clamped), infinite in z only (sliding), 0 (pressure),
///
/// leaves C(q) = h_x h_y (T_0^-1)_zz: the shear tractions are zero.  (Q1.2)
///
/// @param grid     of the nodes of the contact face, at least 2 a side
/// @param threads  changes no bit of the answer
/// @return         C [m/Pa] on the half spectrum of `grid`; mode (0,0) is 0
/// @throws std::domain_error  the grid or the block is outside its range
/// @par Accuracy
///         Rounding: T_l of thin layers under a long wave cancels; measured
///         against a direct solve of the whole block below 1e-12 at 32^2.
///         Discretisation: second order in the node spacing; layers growing
///         by 1.2 are 0.2 % too stiff for long waves, 1.5 0.9 %, 2 2 %.
std::vector<double> condensed_compliance_q1(const Grid& grid,
                                            const LayeredBlock& block,
                                            int threads = 1);

} // namespace asperity::fem
