#pragma once

// What is read off a contact: counted area, perimeter, energy. Owns the
// definitions; every method is measured by these.

#include "base/grid.hpp"

#include <limits>
#include <span>
#include <string>
#include <utility>

namespace asperity::results {

/// A number read off a solution, which need not have a meaning for every one.
struct Observed {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  Observed(double number, std::string why = {})
      : value(number), reason(std::move(why)) {}

  double value;       ///< NaN: not determined
  std::string reason; ///< why not; empty if it is determined
};

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
/// @par Accuracy    first order in the spacing;
/// results/observables/area_estimate.hpp
///                  corrects it
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
/// contact is isotropic_perimeter(S_d).
/// @param pressure  grid.size() values [Pa]
/// @return          S_d [1/m] >= 0
/// @throws std::domain_error  the map is not of the grid's size
/// @see  V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int. 114, 161
///       (2017)
double contact_perimeter(const Grid& grid, std::span<const double> pressure);

/// pi/4 S_d [1/m]: the length per nominal area of a smooth line without a
/// preferred direction whose drawing on the grid has the length S_d.
double isotropic_perimeter(double contact_perimeter);

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
