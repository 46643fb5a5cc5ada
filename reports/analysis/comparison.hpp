#pragma once

// Compares one curve with another: a method with the theory of the same case,
// or with an exact solution. It defines the meaning of "deviation".

#include "reports/numbers/estimate.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/result.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// A column of CurvePoint that contains an area fraction [1].
using AreaColumn = const results::CurveColumn*;

/// The corrected area if the method has one, else the counted area.
AreaColumn best_area(const results::MethodRecord& method);

/// A curve as a function of the nominal pressure. Between rows, a monotone
/// cubic (PCHIP) in ln p interpolates the gap and ln(A/A_0); with fewer than
/// four rows the interpolation is linear. At a row the value of the row is
/// returned. Outside the rows, and between two that are more than a decade of p
/// apart, the result is NaN.
class CurveFunction {
public:
  explicit CurveFunction(std::span<const results::CurvePoint> points,
                         AreaColumn area = &columns::area_fraction);

  double gap(double nominal_pressure) const;           ///< u [m]
  double area_fraction(double nominal_pressure) const; ///< A/A_0 [1]

  /// Returns p [Pa] at a mean gap [m] from a monotone cubic of ln p over u,
  /// through the rows at which the gap decreases with the load. At a row the
  /// value of the row is returned; outside the rows the result is NaN.
  double pressure_at_gap(double mean_gap) const;

private:
  std::function<double(double)> gap_of_log_pressure_;
  std::function<double(double)> log_area_of_log_pressure_;
  std::function<double(double)> log_pressure_of_gap_;
};

/// One loading row and the reference at the same pressure.
struct Deviation {
  double nominal_pressure = 0.0;                 ///< [Pa]
  double gap = 0.0;                              ///< [m]
  double reference_gap = not_a_number;           ///< [m]
  double area_fraction = 0.0;                    ///< of the selected column [1]
  double reference_area_fraction = not_a_number; ///< [1]
};

/// @param area  the column of `points` that is compared with the reference
std::vector<Deviation> deviations(std::span<const results::CurvePoint> points,
                                  const CurveFunction& reference,
                                  AreaColumn area = &columns::area_fraction);

/// How far a curve is from a method at the loads that both have; NaN without
/// such loads, or without gaps or areas.
struct CurveDistance {
  double gap = not_a_number;  ///< largest |u - u_ref| [m]
  double area = not_a_number; ///< largest |A/A_ref - 1| [1]
};

/// @param reference  with rows of its first realisation, by its best area
CurveDistance distance_from(std::span<const results::CurvePoint> points,
                            const results::MethodRecord& reference);

/// Range of u/h_rms in which curves are compared with theory. Below it the
/// contact is nearly complete; above it finite-size effects dominate.
inline constexpr double comparison_gap_low = 0.3;
inline constexpr double comparison_gap_high = 1.5;

/// Returns the largest |u - u_ref| / h_rms over the rows with u/h_rms between
/// `low` and `high`; NaN if there is no such row.
double largest_gap_deviation(std::span<const Deviation> rows, double rms_height,
                             double low = comparison_gap_low,
                             double high = comparison_gap_high);

/// Returns the largest relative difference in pressure from another curve at
/// equal mean gap. To first order in the difference it is |u - u_ref| over
/// |du_ref/dln p| at the pressure of the row. The result is NaN if no row lies
/// in the range of the other curve. Rows in full contact do not count.
double largest_pressure_difference(std::span<const results::CurvePoint> points,
                                   const CurveFunction& reference);

/// Describes where a curve departs from its reference, in pressure at equal
/// gap.
struct Departure {
  /// Median of ln p/p_ref over the rows with u/h_rms in the comparison range:
  /// the part of the difference that does not depend on the load [1].
  double offset = not_a_number;
  /// u/h_rms at which ln p/p_ref differs from the offset by more than
  /// departure_tolerance, searched towards smaller and larger gaps from the row
  /// nearest to u = h_rms and interpolated linearly between rows. NaN: no
  /// departure within the load range, or a departure already at that row.
  double low = not_a_number;
  double high = not_a_number;
};

/// Relative tolerance of the pressure at equal gap.
inline constexpr double departure_tolerance = 0.1;

/// Finds the departure. Rows whose gap lies outside the reference are ignored.
Departure departure_from(std::span<const results::CurvePoint> points,
                         const CurveFunction& reference, double rms_height);

/// Returns the mean of A/A_ref - 1 over the rows with 0 < A/A_0 <= 15 %; NaN if
/// there is no such row.
double light_load_area_excess(std::span<const Deviation> rows);

} // namespace asperity::reports
