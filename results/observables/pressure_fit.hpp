#pragma once

// Fits the theoretical pressure distribution to a pressure map and computes the
// corresponding contact area. Unlike the number of nodes in contact, this area
// needs no criterion for the onset of contact. It is therefore also defined for
// atoms, whose pressure never vanishes exactly.

#include "results/types/map_view.hpp"

#include <limits>
#include <span>
#include <string>

namespace asperity::results {

/// The pressure distribution of a map, approximated by Eq. (20) of Yang and
/// Persson (2008),
///
///     P = [e^{-(sigma - p)^2/4G} - e^{-(sigma + p)^2/4G}]/(2 sqrt(pi G))  (20)
///
/// where p is the mean of the map and G (with a tilde in the paper) is fitted,
/// and the contact area that follows from it by their Eq. (21),
///
///     A/A_0 = erf(p/(2 sqrt G)).                                          (21)
///
/// Without contact the area is 0 and G is not determined. For a uniform
/// pressure G is 0 and the area is 1.
/// @see  C. Yang, B. N. J. Persson, J. Phys.: Condens. Matter 20, 215214 (2008)
struct PressureFit {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double nominal_pressure = none; ///< p, mean of the map [Pa]
  double variance = none;         ///< G of Eq. (20) [Pa^2]; NaN: see reason
  double area_fraction = none;    ///< Eq. (21) [1] 0..1
  std::string reason;             ///< why G is not determined; otherwise empty
};

/// Fits Eq. (20) to the histogram of the map by least squares.
///
/// The bins have the width s/8, where s = sqrt(2G) is the standard deviation of
/// the pressure in full contact, and lie within 6 s of p. This rule is
/// independent of units and of the number of nodes. The first bin, sigma < s/8,
/// is excluded: Eq. (20) vanishes at sigma = 0, whereas weak pressures of atoms
/// that are not in contact, and of nodes at the contact boundary, accumulate
/// there. All other bins have equal weights, and Eq. (20) is integrated over
/// each bin, so that the fit minimises int (P - P_map)^2 dsigma. The bins are
/// based on G from the second moment in a first pass and on the fitted G in a
/// second pass.
///
/// @param pressure  [Pa], any sign; contact where > 0
/// @param weights   relative nodal areas, empty if all are equal and for a map
///                  in a file
/// @param workers   as explained in observables.hpp; without ranks for a map in
///                  a file
/// @return  the fit. G is also not determined if the mean is not positive or is
///          dominated by roundoff, if fewer than 20 nodes are in contact, or if
///          there is no minimum within a factor of 50 of the second moment's G.
/// @throws std::domain_error  the map is empty or not finite, or the sizes
///                            differ
/// @par Accuracy  For samples of Eq. (20), the statistical error of the
///                histogram. How well Eq. (20) describes a contact is a
///                property of the model.
PressureFit fit_pressure_distribution(const MapView& pressure,
                                      std::span<const double> weights = {},
                                      int threads = 1);

/// Both fits, which share the moments of the map. That by the second moment
/// takes the mean square of the positive pressures over the nominal area,
///
///     <sigma^2> = (p^2 + 2G) erf(p/2 sqrt G) + 2p sqrt(G/pi) e^{-p^2/4G},
///
/// which is solved for G up to roundoff. It requires no bins, but is dominated
/// by the largest pressures.
struct PressureFits {
  PressureFit by_histogram, by_moment;
};

/// @throws std::domain_error  as fit_pressure_distribution
PressureFits pressure_fits(std::span<const double> pressure,
                           std::span<const double> weights = {},
                           int threads = 1);

} // namespace asperity::results
