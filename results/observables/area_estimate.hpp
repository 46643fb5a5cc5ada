#pragma once

// Estimates the contact area of the continuum from a solution on a grid. It
// locates the contact boundary between nodes and corrects the remaining
// discretisation error of each operator.

#include "base/grid.hpp"
#include "results/observables/observables.hpp"

#include <span>

namespace asperity::results {

/// Every map here has grid.size() values in the order of Grid and is that of a
/// contact without tension, ContactField::pressure, for which alone (A.1)
/// holds. Beyond a free border there is neither
/// contact nor a gap: a contact that reaches it ends with its last cell. Each
/// function throws std::domain_error if the size of a map is not that of the
/// grid.

/// Returns the fraction t of the interval between a node in contact and its
/// open neighbour that is in contact. Near the boundary of a smooth contact, at
/// the distance d from it,
///
///     p = a sqrt(d),   gap = 4 a d^(3/2)/(3 E*),                         (A.1)
///
/// With d = t h inside, d = (1 - t) h outside and a eliminated,
///
///     (1 - t)^3 = rho t,   rho = (3 E* gap/(4 p h))^2,                   (A.2)
///
/// which has one root in 0..1 in closed form. If the interval crosses the
/// boundary at an angle theta, h is used instead of h sin(theta), and t is too
/// large. On average over directions this error is a fixed fraction of the
/// perimeter, 0.026 S_d h, and is included in c of (A.5).
///
/// @param pressure_inside  p of the node in contact          [Pa] > 0
/// @param gap_outside      gap of the open node; values < 0 are treated as 0
///                         [m]
/// @param spacing          h, distance between the two nodes [m]  > 0
/// @param contact_modulus  E*                                [Pa] > 0
/// @return                 t [1] 0..1
/// @throws std::domain_error  an argument is outside its range
/// @par Accuracy  Roundoff where (A.1) holds. The straight boundary of any
///                smooth contact satisfies (A.1) to first order in d.
/// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 5.1
double boundary_share(double pressure_inside, double gap_outside,
                      double spacing, double contact_modulus);

/// Returns the mean fraction of the grid lines in x and y that is in contact. A
/// node in contact counts 1, and each of its intervals to an open neighbour
/// adds 1/2 (t - 1/2), because half of the interval is already counted with the
/// node:
///
///     A_l/A_0 = (1/n) [n_contact + 1/2 sum_pairs (t - 1/2)],             (A.3)
///
/// Here n is the total number of nodes, and t of each pair is given by
/// boundary_share(). By Cavalieri's principle, the area is the integral of the
/// chords. All nodes have equal weights, whatever the weights of a quadrature
/// rule.
/// @param gap  [m], used at open nodes next to the contact boundary
/// @return     [1] 0..1
/// @par Accuracy  first order in the spacing, see (A.5)
double line_area_fraction(const Grid& grid, std::span<const double> pressure,
                          std::span<const double> gap, double contact_modulus,
                          Border border = Border::periodic);

/// Returns the Euler characteristic of the contact area, i.e. the number of
/// patches minus the number of holes:
///
///     chi = (n_1 - n_3)/4,                                               (A.4)
///
/// where n_k is the number of squares of four neighbouring nodes of which k are
/// in contact. Two nodes that touch only across a corner count as half
/// connected.
/// @return  0 without contact and in full contact
double euler_characteristic(const Grid& grid, std::span<const double> pressure,
                            Border border = Border::periodic);

/// Coefficients of an operator in (A.5), which correct the line area to first
/// order (per pair at the contact boundary) and second order (per patch) in the
/// spacing.
struct AreaCoefficients {
  double perimeter = 0.0; ///< c [1]
  double euler = 0.0;     ///< e [1]
};

/// Coefficients of the continuum half-space, calibrated as described in
/// docs/numerics/area.md.
constexpr AreaCoefficients halfspace_area_coefficients{0.049, 0.35};

/// Coefficients of the half-space with free boundaries, whose pressure is
/// uniform in the cell of each node: a least-squares fit to 720 Hertzian
/// contacts with radii of 5 to 58 spacings around random points of a cell.
constexpr AreaCoefficients free_area_coefficients{0.034, 0.51};

/// Returns the coefficients of first-order finite elements whose surface layer
/// is `surface_cell_depth` node spacings thick. They are interpolated linearly
/// between the measured depths 0.5, 1 and 1.5; outside this range the nearest
/// of them is used.
/// @throws std::domain_error  surface_cell_depth is not > 0
AreaCoefficients q1_area_coefficients(double surface_cell_depth);

/// Coefficients of second-order finite elements with cubic surface cells.
constexpr AreaCoefficients q2_area_coefficients{0.051, 0.23};

/// What the estimate needs to know of the operator.
struct AreaOperator {
  double contact_modulus = 0.0; ///< E* [Pa] > 0
  AreaCoefficients coefficients = {};
  Border border = Border::periodic;
};

/// Smallest admissible ratio of the estimate to the counted area [1].
constexpr double least_corrected_share = 0.25;

/// Returns the best estimate of the area fraction of the continuum from one
/// solution:
///
///     A/A_0 = A_l/A_0 - c S_d h + e chi h^2/A_0.                         (A.5)
///
/// Near the contact boundary a discrete solution follows (A.1) only
/// approximately: the boundary appears displaced outwards by a fraction of h
/// that depends only on the operator. This gives the term with c, where
/// S_d h = n_pairs/n and S_d is the perimeter on the grid (contact_perimeter).
/// The next order is proportional to the curvature of the boundary, whose
/// integral is 2 pi chi for any shape; this gives the term with e. Both
/// coefficients are calibrated on finer grids of the same surfaces
/// (docs/numerics/area.md).
///
/// The estimate requires a resolved contact boundary. For patches of one or two
/// nodes, or a contact that alternates from node to node, (A.5) is far below
/// the counted area and may even be negative. If it is below
/// least_corrected_share of the counted area, the estimate is not determined.
/// The coarsest grids of the calibration, with two nodes in the shortest
/// wavelength, have a ratio of 0.45 (docs/measurements/area.md).
///
/// @param gap  [m], used at open nodes
/// @return     [1] 0..1, not below that fraction of the counted area; NaN with
///             the reason if it is not determined
/// @par Accuracy  docs/numerics/area.md: within 1 % of the limit with eight
///                nodes in the shortest wavelength, p/(E* h') from 0.01 to 1
Observed corrected_area_fraction(const Grid& grid,
                                 std::span<const double> pressure,
                                 std::span<const double> gap,
                                 const AreaOperator& elasticity,
                                 int threads = 1);

} // namespace asperity::results
