#pragma once

// The observables of a contact: counted area, perimeter and energy. The same
// definitions apply to all methods.

#include "base/grid.hpp"
#include "mechanics/contact_nodes.hpp"

#include <limits>
#include <span>
#include <string>
#include <utility>

namespace asperity::results {

/// A number derived from a solution, which may not be determined for every
/// solution.
struct Observed {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  Observed(double number, std::string why = {})
      : value(number), reason(std::move(why)) {}

  double value;       ///< NaN: not determined
  std::string reason; ///< why not; empty if it is determined
};

using mechanics::Border;
using mechanics::ContactNodes;

/// Every map here has grid.size() values in the order of Grid. `weights` are
/// the areas of the nodes relative to their mean (mean 1, as
/// contact::SurfaceOperator::nodal_weights); empty if all are equal.
///
/// Sums are those of base/ranks/chunked_sum.hpp: bitwise the same on any number
/// of threads.

/// Returns <f> = sum_i weight_i f_i / n, in the unit of the field.
/// @throws std::domain_error  the sizes differ or the field is empty
double weighted_mean(std::span<const double> field,
                     std::span<const double> weights = {}, int threads = 1);

/// Returns A/A_0, the fraction of the nominal area that belongs to nodes in
/// contact.
/// @return  [1] 0..1
/// @throws std::domain_error  the sizes differ or there are no nodes
/// @par Accuracy    first order in the spacing; see
///                  results/observables/area_estimate.hpp for the correction
double counted_area_fraction(const ContactNodes& nodes,
                             std::span<const double> weights = {},
                             int threads = 1);

/// Returns the perimeter of the contact per nominal area on the grid:
///
///     S_d = (n_x h_y + n_y h_x) / A_0
///
/// Here n_x (n_y) is the number of pairs of neighbours in x (y), including
/// those across the border, of which exactly one is in contact. Each such pair
/// has an edge of length h_y (h_x) between its cells. Nodes beyond a free
/// border are not in contact.
///
/// A boundary made of cell edges is longer than the smooth curve it represents,
/// by a factor 4/pi on average over directions. The perimeter of an isotropic
/// contact is therefore pi/4 S_d.
/// @param nodes  grid.size()
/// @return       S_d [1/m] >= 0
/// @throws std::domain_error  their number is not that of the grid
/// @see  V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int. 114, 161
///       (2017)
double contact_perimeter(const Grid& grid, const ContactNodes& nodes,
                         Border border = Border::periodic, int threads = 1);

/// The place (x, y) of the resultant force of a pressure.
struct PressureCentre {
  double x = Observed::none; ///< [m] from the middle of the map
  double y = Observed::none; ///< [m]
};

/// Returns the centre of pressure, sum w p x / sum w p, from the middle of the
/// map: the node (points_x / 2, points_y / 2), where shapes have their axis.
/// The moment of the load about the middle is the force times this lever.
/// @param pressure  [Pa], with adhesion also tensile
/// @return          NaN unless the load is above 1e-6 of the sum of all
///                  magnitudes, where it may be an error of the solver
/// @throws std::domain_error  the size of a map is wrong
PressureCentre pressure_centre(const Grid& grid,
                               std::span<const double> pressure,
                               std::span<const double> weights = {},
                               int threads = 1);

/// Returns U/A_0 = <p w>/2, the elastic energy of the block due to the contact
/// pressure.
/// @param pressure      [Pa]
/// @param displacement  surface displacement w [m]. If its mean is excluded,
///                      the energy of the uniform compression of the block is
///                      excluded as well.
/// @return  [J/m^2]
/// @throws std::domain_error  the sizes differ or the maps are empty
double elastic_energy(std::span<const double> pressure,
                      std::span<const double> displacement,
                      std::span<const double> weights = {}, int threads = 1);

/// Returns <p^2> local_compliance / 2, the energy of the penalty springs.
/// @param local_compliance  1/k [m/Pa] >= 0, 0 for hard (unilateral) contact
/// @return  [J/m^2]
/// @throws std::domain_error  the sizes differ, the map is empty, or
///                            local_compliance is negative
double contact_energy(std::span<const double> pressure, double local_compliance,
                      std::span<const double> weights = {}, int threads = 1);

} // namespace asperity::results
