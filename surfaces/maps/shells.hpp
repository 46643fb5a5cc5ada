#pragma once

// Computes the isotropic spectrum of a given map, its power in shells of |q|.
// Both the theory and the plotted C(q) use this grouping.

#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/isotropic_spectrum.hpp"

#include <span>
#include <vector>

namespace asperity::surfaces {

/// The modes of a map with approximately the same |q|. The sums over shells
///
///     sum mean_square_height                 = <h^2>
///     sum wavevector^2 * mean_square_height  = <|grad h|^2>
///
/// equal those of the map (statistics.hpp) to roundoff: a sum over shells of
/// q^n f replaces 2 pi int q^(1+n) C f dq.
struct Shell {
  double wavevector = 0.0;         ///< q [rad/m]: q^2 is the mean of |q|^2,
                                   ///< weighted by power
  double mean_square_height = 0.0; ///< sum of |a_q|^2 [m^2] > 0
  int modes = 0;                   ///< number of modes, q and -q both counted
};

/// The shells of a map in order of ascending wavevector. Up to 8 times the
/// smallest wavevector of the cell every distinct |q| has its own shell; above,
/// the shells are equal steps of ln q, the same for every grid of these
/// lengths: about 200 in total for 1024 points per side. Shells without power
/// (below 1e-28 of the total, which is roundoff) are omitted.
/// @param relative_width  the step of ln q [1] > 0
/// @throws std::domain_error  relative_width is outside its range
std::vector<Shell> spectral_shells(const HeightMap& map,
                                   double relative_width = 0.025);

/// The same of a map that is passed on by pieces (mode_power.hpp), with the
/// same bits. Memory beside that of the columns: some 40 bytes for each shell.
std::vector<Shell> spectral_shells(const Grid& grid, const HeightRows& heights,
                                   int threads = 1,
                                   double relative_width = 0.025);

/// C(q) [m^4] of the shell, the mean over its modes:
///
///     C = mean_square_height * L_x L_y / ((2 pi)^2 modes)
double shell_density(const Shell& shell, const Grid& grid);

/// C(q) of a map as a density: the power of each shell is spread evenly over an
/// annulus of the plane of wavevectors that has the area of its modes and the
/// mean q^2 of the shell, so that <h^2> and <|grad h|^2> are those of the map.
/// Where annuli overlap, their densities are added.
/// @param shells     of a map, at least one
/// @param mode_area  (2 pi)^2/(L_x L_y) [rad^2/m^2] > 0
IsotropicSpectrum spread_spectrum(std::span<const Shell> shells,
                                  double mode_area);

} // namespace asperity::surfaces
