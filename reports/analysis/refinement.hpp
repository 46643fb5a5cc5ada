#pragma once

// Evaluates a series of increasingly fine settings: the exponent with which an
// error or a cost scales, the limit, and the settings that are worth their
// cost. It owns Richardson's extrapolation and does not depend on contact
// mechanics.

#include "reports/numbers/estimate.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::reports {

/// y = factor * x^exponent.
struct PowerLaw {
  double exponent = not_a_number;
  double factor = not_a_number;
  double exponent_error = not_a_number; ///< standard error; NaN for two points
  int points = 0;                       ///< number of points used

  bool is_known() const { return exponent == exponent; }

  /// The exponent as a result; NaN if fitted to two points, which any power law
  /// satisfies.
  double determined_exponent() const {
    return exponent_error == exponent_error ? exponent : not_a_number;
  }

  double at(double x) const; ///< y, NaN if the law is not known
};

/// Fits ln y on ln x by least squares over the pairs in which both numbers are
/// positive. The law is not known if there are fewer than two different x.
/// @param x,y  of equal length
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y);

/// Returns the root mean square of (a - b) / scale; NaN if an entry is not
/// finite or if there are no entries.
/// @param a,b,scale  of equal length
double rms_difference(std::span<const double> a, std::span<const double> b,
                      std::span<const double> scale);

/// Returns the order p of values that converge to their limit as c h^p, from
/// three spacings and the magnitudes of the two differences between the values:
///
///     d_12 / d_23 = (h_1^p - h_2^p) / (h_2^p - h_3^p)
///
/// @param spacings  h_1 > h_2 > h_3 > 0
/// @param first,second  d_12, d_23 >= 0
/// @return  p in 0.1 .. 12, NaN if there is none
double observed_order(std::span<const double, 3> spacings, double first,
                      double second);

/// The results of the finest settings, extrapolated to zero spacing.
struct RefinementLimit {
  std::vector<double> values;  ///< limit, or result of the finest setting
  double order = not_a_number; ///< observed order; NaN: irregular convergence
  double uncertainty = not_a_number; ///< as measured by rms_difference()
  bool is_extrapolated = false;
};

/// Applies Richardson's extrapolation to the three finest settings of a series.
/// If the last two differences have different directions (cosine below 0.5) or
/// no order of at least 0.5, the finest result is returned and its distance to
/// the previous one is the uncertainty; otherwise the uncertainty is the
/// extrapolation step. Orders above `highest_order` are limited to it, so that
/// a coincidentally close pair does not suggest too small an uncertainty.
/// @param answers   one result per setting, coarse to fine, of equal length
/// @param spacings  of the settings, decreasing
/// @param scale     unit in which each entry is measured
RefinementLimit refinement_limit(std::span<const std::vector<double>> answers,
                                 std::span<const double> spacings,
                                 std::span<const double> scale,
                                 double highest_order = 4.0);

/// Returns the indices of the Pareto front, in ascending cost: the pairs for
/// which no other pair has both a lower cost and a lower error. Pairs that are
/// not finite are ignored.
/// @param costs,errors  of equal length
std::vector<std::size_t> pareto_front(std::span<const double> costs,
                                      std::span<const double> errors);

} // namespace asperity::reports
