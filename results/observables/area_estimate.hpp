#pragma once

// The contact area of the continuum from a solution on a grid. Owns where the
// rim lies between nodes and what the grid still adds, operator by operator.

#include "base/grid.hpp"
#include "results/observables/observables.hpp"

#include <span>

namespace asperity::results {

/// Every map here is grid.size() values in the order of Grid; contact is where
/// the pressure is > 0. Each function throws std::domain_error where a map is
/// not of the grid's size.

/// Share of the step from a node in contact to its open neighbour that is in
/// contact. Beside the rim of a smooth contact, at the distance d,
///
///     p = a sqrt(d),   gap = 4 a d^(3/2)/(3 E*),                         (A.1)
///
/// so with d = t h inside, d = (1 - t) h outside and a eliminated
///
///     (1 - t)^3 = rho t,   rho = (3 E* gap/(4 p h))^2,                   (A.2)
///
/// one root in 0..1, in closed form. A step that crosses the rim aslant, at the
/// angle theta, takes h for h sin(theta): its t is too large. In the mean over
/// directions that is a fixed share of the perimeter, 0.026 S_d h, and part of
/// c of (A.5).
///
/// @param pressure_inside  p of the node in contact       [Pa] > 0
/// @param gap_outside      of the open node; below 0: as 0 [m]
/// @param spacing          h, length of the step          [m]  > 0
/// @param contact_modulus  E*                             [Pa] > 0
/// @return                 t [1] 0..1
/// @throws std::domain_error  an argument is outside its range
/// @par Accuracy  rounding where (A.1) holds; a straight rim of any smooth
///                contact has it to first order in d
/// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 5.1
double rim_share(double pressure_inside, double gap_outside, double spacing,
                 double contact_modulus);

/// The mean share of the grid lines that is in contact, lines along x and
/// along y alike: a node in contact counts 1, and each of its steps to an open
/// neighbour 1/2 (t - 1/2) more, since a node's half step was counted already:
///
///     A_l/A_0 = (1/n) [n_contact + 1/2 sum_pairs (t - 1/2)],             (A.3)
///
/// n nodes in all, t of each pair by rim_share. (Cavalieri: the area is the
/// integral of the chords.) Nodes count alike, whatever weights a quadrature
/// gives them.
/// @param gap  [m], read at open nodes beside the rim
/// @return     [1] 0..1
/// @par Accuracy  first order in the spacing, see (A.5)
double line_area_fraction(const Grid& grid, std::span<const double> pressure,
                          std::span<const double> gap, double contact_modulus);

/// Euler's number of the contact, patches less holes on the periodic face:
///
///     chi = (n_1 - n_3)/4,                                               (A.4)
///
/// n_k the squares of four neighbouring nodes of which k are in contact. Two
/// nodes that touch across a corner alone count as half joined.
/// @return  0 for a bare and for a full face
double euler_number(const Grid& grid, std::span<const double> pressure);

/// What an operator adds to the area of the lines, a step of a rim pair and a
/// patch: the first and the second order in the spacing.
struct AreaCoefficients {
  double perimeter = 0.0; ///< c [1]
  double euler = 0.0;     ///< e [1]
};

/// Of the continuum half-space, calibrated as docs/area.md says.
constexpr AreaCoefficients halfspace_area_coefficients{0.049, 0.35};

/// Of first-order finite elements whose surface layer is `surface_cell_depth`
/// node spacings thick: linear between the measured 0.5, 1 and 1.5, and the
/// nearest of them outside, where nothing was measured.
/// @throws std::domain_error  surface_cell_depth is not > 0
AreaCoefficients q1_area_coefficients(double surface_cell_depth);

/// Of second-order finite elements with cubic surface cells.
constexpr AreaCoefficients q2_area_coefficients{0.051, 0.23};

/// Of the counted nodes, which the estimate must leave to be one [1].
constexpr double least_corrected_share = 0.25;

/// The best estimate of the continuum's area fraction from one solution,
///
///     A/A_0 = A_l/A_0 - c S_d h + e chi h^2/A_0.                         (A.5)
///
/// Beside the rim a solution is not (A.1) but (A.1) as the grid sees it: the
/// rim appears moved out by a part of h that depends on the operator alone.
/// That is c, with S_d h = n_pairs/n the perimeter as drawn
/// (contact_perimeter). The next order is the rim's curvature, and its
/// integral along the rims is 2 pi chi whatever their shape: that is e. Both
/// are calibrated on finer grids of the same surfaces (docs/area.md).
///
/// The rim must be resolved for that. Patches of a node or two, or a contact
/// that alternates from node to node, leave (A.5) far below the count, down to
/// negative areas: below least_corrected_share of it the estimate is not
/// determined. The coarsest grids it was measured on, two nodes in the shortest
/// wave, leave 0.45 of it (docs/area.md).
///
/// @param gap  [m], of the open nodes
/// @return     [1] 0..1, not below that share of the count; NaN with the reason
///             where it is not determined
/// @par Accuracy  docs/area.md: within 1 % of the limit with eight nodes in
///                the shortest wave, for p/(E* h') from 0.01 to 1
Observed corrected_area_fraction(const Grid& grid,
                                 std::span<const double> pressure,
                                 std::span<const double> gap,
                                 double contact_modulus,
                                 const AreaCoefficients& coefficients);

} // namespace asperity::results
