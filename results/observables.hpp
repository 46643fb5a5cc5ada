#pragma once

// What is read off a contact: area, perimeter, energy, and the correction of
// the counted area. Owns the definitions; every method is measured by these.

#include "base/grid.hpp"

#include <span>

namespace asperity::results {

/// Every map here is grid.size() values in the order of Grid. `weights` are
/// the areas of the nodes relative to their mean (mean 1, as
/// contact::SurfaceOperator::nodal_weights); empty if all are equal. A node is
/// in contact where its pressure is > 0.

/// <f> = sum_i weight_i f_i / n, in the unit of the field.
/// @throws std::domain_error  the sizes differ or the field is empty
double weighted_mean(std::span<const double> field,
                     std::span<const double> weights = {});

/// A/A_0: the share of the nominal area that belongs to nodes in contact.
/// @param pressure  [Pa]
/// @return          [1] 0..1
/// @throws std::domain_error  the sizes differ or the map is empty
/// @par Accuracy    first order in the spacing, see corrected_area_fraction
double counted_area_fraction(std::span<const double> pressure,
                             std::span<const double> weights = {});

/// The perimeter of the contact per nominal area, as drawn on the grid:
///
///     S_d = (n_x h_y + n_y h_x) / A_0
///
/// with n_x (n_y) the pairs of neighbours in x (y), across the periodic border
/// too, of which one is in contact and one is not: each such pair has an edge
/// h_y (h_x) between its cells.
///
/// A line drawn in edges of cells is longer than the smooth line it stands
/// for, by 4/pi in the mean over directions: the perimeter of an isotropic
/// contact is isotropic_perimeter(S_d). The correction of the area is
/// calibrated to S_d itself.
/// @param pressure  grid.size() values [Pa]
/// @return          S_d [1/m] >= 0
/// @throws std::domain_error  the map is not of the grid's size
/// @see  V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int. 114, 161
///       (2017)
double contact_perimeter(const Grid& grid, std::span<const double> pressure);

/// pi/4 S_d [1/m]: the length per nominal area of a smooth line without a
/// preferred direction whose drawing on the grid has the length S_d.
double isotropic_perimeter(double contact_perimeter);

/// The nodes along a contact's edge are counted whole though part of their
/// cell is open. With S_d the drawn perimeter and h the node spacing,
///
///     A = A_counted - coefficient S_d h.
///
/// @param counted_area_fraction  [1] 0..1
/// @param contact_perimeter      S_d [1/m] >= 0
/// @param spacing                h [m] > 0
/// @param coefficient            of the elastic operator [1] >= 0, see below
/// @return  [1], not below 0 and not above the counted one
/// @throws std::domain_error  an argument is outside its range
/// @par Accuracy  leaves about 0.5 % with eight nodes in the shortest wave
double corrected_area_fraction(double counted_area_fraction,
                               double contact_perimeter, double spacing,
                               double coefficient);

/// The coefficient of Yastrebov et al. (2017): (pi - 1 + ln 2)/24 = 0.118 [1],
/// from the mean share of an edge cell that is open, direction by direction.
double geometric_area_coefficient();

/// Of the continuum half-space on the grid [1]: measured against series of
/// finer grids (docs/results.md).
constexpr double halfspace_area_coefficient = 0.10;

/// Of first-order finite elements whose surface layer is `surface_cell_depth`
/// node spacings thick [1]: linear between the measured 0.2425 at 0.5, 0.205
/// at 1 and 0.16 at 1.5, and the nearest of them outside, where nothing was
/// measured.
/// @throws std::domain_error  surface_cell_depth is not > 0
double q1_area_coefficient(double surface_cell_depth);

/// Of second-order finite elements with cubic surface cells [1]: from pairs of
/// grids, 0.138 to 0.150 between 10 and 95 % contact (docs/results.md).
constexpr double q2_area_coefficient = 0.14;

/// U/A_0 = <p w>/2: the energy that pressing the face took from the block.
/// @param pressure      [Pa]
/// @param displacement  w [m] of the face, without its mean or with: where
///                      the mean is left out the energy of the uniform
///                      compression of the block is left out with it
/// @return  [J/m^2]
/// @throws std::domain_error  the sizes differ or the maps are empty
double elastic_energy(std::span<const double> pressure,
                      std::span<const double> displacement,
                      std::span<const double> weights = {});

/// <p^2> local_compliance / 2: the energy in the springs of a penalty.
/// @param local_compliance  1/k [m/Pa] >= 0, 0 for a hard wall
/// @return  [J/m^2]
/// @throws std::domain_error  the sizes differ, the map is empty, or
///                            local_compliance is negative
double contact_energy(std::span<const double> pressure, double local_compliance,
                      std::span<const double> weights = {});

} // namespace asperity::results
