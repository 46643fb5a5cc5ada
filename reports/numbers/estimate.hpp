#pragma once

// A number with its 95 % confidence interval, and where that interval comes
// from. Owns the straight-line fit and Student's t; knows nothing of contact.

#include "base/special_numbers.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Least squares of y = intercept + slope x over n points; the errors are the
/// usual ones for independent scatter in y, NaN for two points.
struct LineFit {
  double intercept = not_a_number;
  double slope = not_a_number;
  double intercept_error = not_a_number;  ///< standard error
  double slope_error = not_a_number;      ///< standard error
  double centre_x = not_a_number;         ///< mean of x
  double centre_y = not_a_number;         ///< the line at centre_x
  double centre_error = not_a_number;     ///< of centre_y, independent of slope
  double largest_residual = not_a_number; ///< max |y - line|
  int points = 0;
};

/// All NaN for fewer than two points, one abscissa only or numbers that are not
/// finite: there is no such line.
/// @param x,y  of one length
LineFit fit_line(std::span<const double> x, std::span<const double> y);

/// What one fit to one realisation gives.
struct FittedValue {
  double value = not_a_number;          ///< NaN: there is no answer
  double standard_error = not_a_number; ///< of the fit itself
  int degrees_of_freedom = 0;           ///< of standard_error
  std::string reason = {};              ///< why there is no answer
};

/// A number for the reader: value +- half_width at 95 % confidence.
struct Estimate {
  double value = not_a_number;      ///< NaN: there is no answer, see remark
  double half_width = not_a_number; ///< NaN: no interval can be given
  int realizations = 0;             ///< how many went into the value
  std::string remark;               ///< what the interval means, or why none
  bool is_input = false;            ///< set in the case, not found

  bool has_value() const { return value == value; }

  bool has_interval() const { return half_width == half_width; }
};

/// Half-width of the two-sided 95 % interval: t_{0.975, nu} * standard_error.
/// NaN for nu < 1.
double student_half_width(double standard_error, int degrees_of_freedom);

/// Mean over realisations with the interval t_{0.975, n-1} s / sqrt(n). With
/// one realisation the interval is that of its own fit, and the remark says
/// so. Fits without an answer (NaN) are left out and counted in the remark; if
/// none has one the remark is the first reason given.
///
/// @par Accuracy  The interval covers 95 % if the realisations are independent
///                and their scatter is normal.
Estimate mean_over_realizations(std::span<const FittedValue> fits);

} // namespace asperity::reports
