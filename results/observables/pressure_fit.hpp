#pragma once

// The theory's pressure distribution fitted to a map of pressures, and the
// contact area that the fit stands for. Unlike a count of nodes it does not ask
// where contact begins, so it serves atoms too, whose pressures never end.

#include <limits>
#include <span>
#include <string>

namespace asperity::results {

/// The distribution of contact pressure of a map as the theory draws it,
///
///     P = [e^{-(sigma - p)^2/4G} - e^{-(sigma + p)^2/4G}]/(2 sqrt(pi G))  (20)
///
/// with p the mean of the map and G (the paper's G with a tilde) free, and the
/// area of that distribution,
///
///     A/A_0 = erf(p/(2 sqrt G)).                                          (21)
///
/// Without contact the area is 0 and there is no G; of a uniform pressure G is
/// 0 and the area 1.
/// @see  C. Yang, B. N. J. Persson, J. Phys.: Condens. Matter 20, 215214 (2008)
struct PressureFit {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double nominal_pressure = none; ///< p, mean of the map [Pa]
  double variance = none;         ///< G of (20) [Pa^2]; NaN: see reason
  double area_fraction = none;    ///< (21) [1] 0..1
  std::string reason;             ///< why there is no G; empty if there is one
};

/// Least squares of (20) on the histogram of the map.
///
/// Bins are s/8 wide with s = sqrt(2G), the spread of the pressure in full
/// contact, and lie within 6 s of p: the rule knows no unit and no number of
/// nodes. The first bin, sigma < s/8, is left out: (20) vanishes at sigma = 0,
/// while the weak pressures of atoms that are not in contact, and of nodes on
/// the contact's edge, pile up there. All others weigh the same, and (20) is
/// integrated over each: what is least is int (P - P_map)^2 dsigma. The bins
/// follow from the second moment's G first, then once more from the fit's.
///
/// @param pressure  [Pa], any sign; contact where > 0
/// @param weights   relative nodal areas, empty if all are equal
/// @return  without G also where the mean is not positive, or is lost in
///          rounding beside the pressures; where fewer than 20 nodes are in
///          contact; where no G within a factor of 50 of the second moment's
///          is best
/// @throws std::domain_error  the map is empty or not finite, the sizes differ
/// @par Accuracy  on samples of (20) itself that of counting them; how well
///                (20) describes a contact is the model's affair
PressureFit fit_pressure_distribution(std::span<const double> pressure,
                                      std::span<const double> weights = {});

/// G from the second moment: the mean square of the positive pressures over
/// the whole face is
///
///     <sigma^2> = (p^2 + 2G) erf(p/2 sqrt G) + 2p sqrt(G/pi) e^{-p^2/4G},
///
/// solved for G, to rounding. Needs no bins; the largest pressures decide.
/// @throws std::domain_error  as above
PressureFit pressure_fit_by_moment(std::span<const double> pressure,
                                   std::span<const double> weights = {});

} // namespace asperity::results
