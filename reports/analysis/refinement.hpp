#pragma once

// What a series of ever finer settings tells: the power at which an error or a
// cost goes, the limit, and which settings are worth their price. Owns
// Richardson's extrapolation; knows nothing of contact.

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
  int points = 0;                       ///< that went in

  bool is_known() const { return exponent == exponent; }

  /// The exponent as a result: NaN through two points, which any law meets.
  double determined_exponent() const {
    return exponent_error == exponent_error ? exponent : not_a_number;
  }

  double at(double x) const; ///< y, NaN if not known
};

/// Least squares of ln y on ln x over the pairs with both above 0; not known
/// with fewer than two different x.
/// @param x,y  of one length
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y);

/// Root mean square of (a - b) / scale. NaN if an entry is not finite, or if
/// there is none.
/// @param a,b,scale  of one length
double rms_difference(std::span<const double> a, std::span<const double> b,
                      std::span<const double> scale);

/// Order p of values that tend to their limit as c h^p, from three spacings
/// and the sizes of the two differences between them:
///
///     d_12 / d_23 = (h_1^p - h_2^p) / (h_2^p - h_3^p)
///
/// @param spacings  h_1 > h_2 > h_3 > 0
/// @param first,second  d_12, d_23 >= 0
/// @return  p in 0.1 .. 12, NaN if there is none
double observed_order(std::span<const double, 3> spacings, double first,
                      double second);

/// The answers of the finest settings carried on to spacing 0.
struct RefinementLimit {
  std::vector<double> values;        ///< of the limit, or of the finest setting
  double order = not_a_number;       ///< observed; NaN: irregular
  double uncertainty = not_a_number; ///< in the measure of rms_difference
  bool is_extrapolated = false;
};

/// Richardson's extrapolation of the three finest of a series. Where the last
/// two differences are not in one direction (cosine below 0.5) or have no order
/// of at least 0.5, the finest answer stands and its distance to the one before
/// is its uncertainty; else the step of the extrapolation is. Orders above
/// `highest_order` are taken as that, so that a lucky pair promises nothing.
/// @param answers   one a setting, coarse to fine, of one length
/// @param spacings  of the settings, falling
/// @param scale     what an entry is measured in
RefinementLimit refinement_limit(std::span<const std::vector<double>> answers,
                                 std::span<const double> spacings,
                                 std::span<const double> scale,
                                 double highest_order = 4.0);

/// Indices of the pairs that no other one undercuts in both, in ascending cost;
/// pairs that are not finite are left out.
/// @param costs,errors  of one length
std::vector<std::size_t> pareto_front(std::span<const double> costs,
                                      std::span<const double> errors);

} // namespace asperity::reports
