#pragma once

// The surface compliance of a laterally uniform Q1 block, identical to that of
// the finite-element discretisation, computed for one lateral wavevector at a
// time.

#include "base/ranks/convolution.hpp"
#include "fem/waves/elastic_layers.hpp"

#include <vector>

namespace asperity::fem {

/// Symbol C(q) of the surface compliance: a pressure exp(i q.x) on the contact
/// surface causes the normal displacement C(q) exp(i q.x) at the nodes.
///
/// With displacements u_j(q) exp(i q.x) at the nodes of plane j, and u_x and
/// u_y multiplied by i, a layer couples its two planes by real 3x3 blocks of
/// deal.II's cell matrix. Their elimination from the far boundary down to the
/// contact surface,
///
///     T_l = S_bb - S_bt (S_tt + T_(l+1))^-1 S_tb                      (Q1.2)
///
/// for a layer l between the planes b below and t on its top, gives the
/// stiffness T_0 of the surface. T is 0 above a free far boundary; components
/// that are held there have rows of the identity. Since the shear tractions are
/// zero,
///
///     C(q) = h_x h_y (T_0^-1)_zz.                                     (Q1.1)
///
/// @param grid     grid of the nodes of the contact surface, at least 2 per
///                 side
/// @param threads  the result is bitwise independent of it
/// @return         C [m/Pa] on the half spectrum of `grid`; mode (0,0) is 0
/// @throws std::domain_error  the grid or the block is outside its range
/// @par Accuracy
///         Roundoff: T_l suffers cancellation for thin layers and long waves;
///         the error measured against a direct solve of the full 3-D block is
///         below 1e-12 at 32^2.
///         Discretisation: second order in the node spacing; a grading ratio
///         of 1.2 makes long waves 0.2 % too stiff, 1.5 makes them 0.9 % and
///         2 makes them 2 % too stiff.
std::vector<double> condensed_compliance_q1(const Grid& grid,
                                            const LayeredBlock& block,
                                            int threads = 1);

/// The same numbers, bit by bit, for one column of wavevectors at a time, so
/// that each of several ranks computes those of its own columns.
/// @throws std::domain_error  as above
EvenColumn condensed_column_q1(const Grid& grid, const LayeredBlock& block);

} // namespace asperity::fem
