#pragma once

// One curve held against another: a method against the theory that ran on the
// same case, or against an exact solution. Owns what "deviation" means.

#include "reports/numbers/estimate.hpp"
#include "results/types/result.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// A column of CurvePoint that holds an area fraction [1].
using AreaColumn = double results::CurvePoint::*;

/// A curve as functions of the nominal pressure. Between rows: monotone cubic
/// (PCHIP) in ln p for the gap, and in ln p for ln(A/A_0); straight if there
/// are fewer than four rows. At a row: the row. Outside: NaN, nothing is
/// extrapolated.
class CurveFunction {
public:
  explicit CurveFunction(std::span<const results::CurvePoint> points,
                         AreaColumn area = &results::CurvePoint::area_fraction);

  double gap(double nominal_pressure) const;           ///< u [m]
  double area_fraction(double nominal_pressure) const; ///< A/A_0 [1]

  /// p [Pa] at a mean gap [m]: monotone cubic of ln p over u, through the rows
  /// at which the gap falls with the load. At a row: the row. Outside: NaN.
  double pressure_at_gap(double mean_gap) const;

private:
  std::function<double(double)> gap_of_log_pressure_;
  std::function<double(double)> log_area_of_log_pressure_;
  std::function<double(double)> log_pressure_of_gap_;
};

/// One loading row beside the reference at the same pressure.
struct Deviation {
  double nominal_pressure = 0.0;                 ///< [Pa]
  double gap = 0.0;                              ///< [m]
  double reference_gap = not_a_number;           ///< [m]
  double area_fraction = 0.0;                    ///< of the asked column [1]
  double reference_area_fraction = not_a_number; ///< [1]
};

/// @param area  the column of `points` that is held against the reference
std::vector<Deviation>
deviations(std::span<const results::CurvePoint> points,
           const CurveFunction& reference,
           AreaColumn area = &results::CurvePoint::area_fraction);

/// The range of u/h_rms over which curves are held against theory: below it
/// the contact is nearly complete, above it the finite size speaks.
inline constexpr double comparison_gap_low = 0.3;
inline constexpr double comparison_gap_high = 1.5;

/// Largest |u - u_ref| / h_rms over the rows with u/h_rms between `low` and
/// `high`; NaN if no row is.
double largest_gap_deviation(std::span<const Deviation> rows, double rms_height,
                             double low = comparison_gap_low,
                             double high = comparison_gap_high);

/// Largest relative difference of the pressure at equal mean gap to another
/// curve, to first order in it: |u - u_ref| over |du_ref/dln p| at the row's
/// pressure. NaN if no row lies in the other curve's range.
double largest_pressure_difference(std::span<const results::CurvePoint> points,
                                   const CurveFunction& reference);

/// Where a curve leaves its reference, in pressure at equal gap.
struct Departure {
  /// Median of ln p/p_ref over the rows with u/h_rms in the comparison's
  /// range: the part of the difference that does not change with the load [1].
  double offset = not_a_number;
  /// u/h_rms at which ln p/p_ref is more than departure_tolerance from the
  /// offset, inwards and outwards of the row nearest to u = h_rms; straight
  /// between rows. NaN: not as far as the rows go, or there already.
  double low = not_a_number;
  double high = not_a_number;
};

/// Of the pressure at equal gap: 10 %.
inline constexpr double departure_tolerance = 0.1;

/// Rows whose gap the reference does not have are left out.
Departure departure_from(std::span<const results::CurvePoint> points,
                         const CurveFunction& reference, double rms_height);

/// Mean of A/A_ref - 1 over the rows with 0 < A/A_0 <= 15 %;
/// NaN if there is none.
double light_load_area_excess(std::span<const Deviation> rows);

} // namespace asperity::reports
