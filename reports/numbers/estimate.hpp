#pragma once

// A number with its 95 % confidence interval and the origin of that interval.
// It owns the straight-line fit and Student's t and does not depend on contact
// mechanics.

#include "base/special_numbers.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Least-squares fit of y = intercept + slope x to n points. The errors are the
/// usual ones for independent scatter in y; they are NaN for two points.
struct LineFit {
  double intercept = not_a_number;
  double slope = not_a_number;
  double intercept_error = not_a_number; ///< standard error
  double slope_error = not_a_number;     ///< standard error
  double centre_x = not_a_number;        ///< mean of x
  double centre_y = not_a_number;        ///< value of the line at centre_x
  /// Standard error of centre_y, independent of that of slope.
  double centre_error = not_a_number;
  double largest_residual = not_a_number; ///< max |y - line|
  int points = 0;
};

/// All results are NaN, because no line is defined, for fewer than two points,
/// if all x are equal, or if a number is not finite.
/// @param x,y  of equal length
LineFit fit_line(std::span<const double> x, std::span<const double> y);

/// The result of one fit to one realisation.
struct FittedValue {
  double value = not_a_number;          ///< NaN: there is no result
  double standard_error = not_a_number; ///< of the fit itself
  int degrees_of_freedom = 0; ///< degrees of freedom of standard_error
  std::string reason = {};    ///< why there is no result
};

/// A number for the reader: value +- half_width at 95 % confidence.
struct Estimate {
  double value = not_a_number;      ///< NaN: there is no result, see remark
  double half_width = not_a_number; ///< NaN: no interval can be given
  int realizations = 0;             ///< number of realisations used
  std::string remark;    ///< meaning of the interval, or why there is none
  bool is_input = false; ///< prescribed by the case, not computed

  bool has_value() const { return value == value; }

  bool has_interval() const { return half_width == half_width; }
};

/// A number without an interval, such as that of a formula.
/// @param remark   what it is
/// @param missing  why there is none, if it is NaN
Estimate single_number(double value, const std::string& remark,
                       const std::string& missing);

/// Returns the half-width of the two-sided 95 % interval, t_{0.975, nu} *
/// standard_error; NaN for nu < 1.
double student_half_width(double standard_error, int degrees_of_freedom);

/// Returns the mean over realisations with the interval t_{0.975, n-1}
/// s / sqrt(n). For one realisation the interval is that of its own fit, as the
/// remark states. Fits without a result (NaN) are omitted and counted in the
/// remark; if none has a result, the remark is the first reason given.
///
/// @par Accuracy  The interval has 95 % coverage if the realisations are
///     independent and their scatter is normally distributed.
Estimate mean_over_realizations(std::span<const FittedValue> fits);

/// The mean of number(r) over the realisations r.
/// @param missing  why there is none, if all are NaN
template <class Number>
Estimate mean_over_realizations(std::size_t realizations,
                                const std::string& missing,
                                const Number& number) {
  std::vector<FittedValue> values;
  values.reserve(realizations);
  for (std::size_t r = 0; r < realizations; ++r)
    values.push_back({.value = number(r), .reason = missing});
  return mean_over_realizations(values);
}

/// Mean and standard deviation of one of several numbers; NaN without, and the
/// deviation of one alone.
struct Spread {
  double mean = not_a_number;
  double deviation = not_a_number;
};

Spread spread_of(std::span<const double> numbers);

/// @param numbers  at least one
double median(std::vector<double> numbers);

} // namespace asperity::reports
