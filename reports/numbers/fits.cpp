#include "reports/numbers/fits.hpp"

#include "base/require.hpp"
#include "results/types/curve_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity::reports {
namespace {

using results::CurvePoint;

constexpr double largest_gap = 2.0;    // in h_rms; finite-size effects beyond
constexpr double outer_start = 1.5;    // in h_rms; windows start beyond
constexpr double smallest_width = 0.5; // in h_rms
constexpr double first_tolerance = 0.005; // in h_rms
constexpr double last_tolerance = 0.08;   // in h_rms
constexpr std::size_t fewest_rows = 4;    // in the window of the slope
constexpr std::size_t fewest_area_rows = 3;
constexpr std::size_t fewest_parameter_rows = 3;

void require_scales(const SurfaceScales& scales) {
  require_positive("contact_modulus", scales.contact_modulus, "Pa");
  require_positive("rms_height", scales.rms_height, "m");
  require_positive("rms_slope", scales.rms_slope, "1");
}

Window window_of(std::span<const CurvePoint> rows) {
  Window window;
  window.gap_high = rows.front().mean_gap;
  window.gap_low = rows.back().mean_gap;
  window.pressure_low = rows.front().nominal_pressure;
  window.pressure_high = rows.back().nominal_pressure;
  window.points = static_cast<int>(rows.size());
  return window;
}

struct Stretch {
  std::size_t first = 0;
  std::size_t count = 0;
  LineFit line; // u/h_rms against ln(p/E*)
};

// The fit uses reduced coordinates: x = ln(p/E*), y = u/h_rms.
struct ReducedCurve {
  std::vector<double> log_pressure;
  std::vector<double> gap;
};

// Finds the longest straight section that starts at row `first`.
std::optional<Stretch> stretch_from(const ReducedCurve& curve,
                                    std::size_t first, double tolerance) {
  std::optional<Stretch> longest;
  const std::span<const double> x = curve.log_pressure;
  const std::span<const double> y = curve.gap;
  for (std::size_t count = fewest_rows; first + count <= x.size(); ++count) {
    const LineFit line =
        fit_line(x.subspan(first, count), y.subspan(first, count));
    if (line.largest_residual > tolerance)
      break;
    if (!std::isfinite(line.slope))
      continue; // repeated load: no line yet
    if (y[first] - y[first + count - 1] >= smallest_width)
      longest = Stretch{first, count, line};
  }
  return longest;
}

std::optional<Stretch> outermost_stretch(const ReducedCurve& curve,
                                         double tolerance,
                                         double lowest_start) {
  for (std::size_t first = 0;
       first < curve.gap.size() && curve.gap[first] >= lowest_start; ++first)
    if (const auto stretch = stretch_from(curve, first, tolerance))
      return stretch;
  return std::nullopt;
}

SlopeFit slope_fit_of(const Stretch& stretch, std::span<const CurvePoint> rows,
                      double tolerance) {
  const LineFit& line = stretch.line;
  const double reduced_decay = -line.slope; // u_0/h_rms
  SlopeFit fit;
  fit.window = window_of(rows.subspan(stretch.first, stretch.count));
  fit.window.largest_deviation = line.largest_residual;
  fit.window.tolerance = tolerance;
  fit.gamma_slope = {reduced_decay, line.slope_error, line.points - 2};
  // ln beta = x_c + y_c/(u_0/h), where (x_c, y_c) is the centre of the fit, at
  // which the errors of value and slope are independent.
  const double lift = line.centre_y / reduced_decay;
  const double beta = std::exp(line.centre_x + lift);
  fit.beta = {beta,
              beta / reduced_decay *
                  std::hypot(line.centre_error, lift * line.slope_error),
              line.points - 2};
  return fit;
}

} // namespace

std::vector<CurvePoint> loading_rows(std::span<const CurvePoint> points) {
  std::vector<CurvePoint> rows;
  for (const CurvePoint& point : points)
    if (point.status == results::StepStatus::converged && !point.is_unloading &&
        point.nominal_pressure > 0.0 && std::isfinite(point.nominal_pressure) &&
        std::isfinite(point.mean_gap))
      rows.push_back(point);
  std::stable_sort(rows.begin(), rows.end(),
                   [](const CurvePoint& a, const CurvePoint& b) {
                     return a.nominal_pressure < b.nominal_pressure;
                   });
  return rows;
}

SlopeFit fit_slope(std::span<const CurvePoint> points,
                   const SurfaceScales& scales) {
  require_scales(scales);
  std::vector<CurvePoint> rows = loading_rows(points);
  std::erase_if(rows, [&](const CurvePoint& row) {
    return row.mean_gap > largest_gap * scales.rms_height;
  });

  ReducedCurve curve;
  for (const CurvePoint& row : rows) {
    curve.log_pressure.push_back(
        std::log(row.nominal_pressure / scales.contact_modulus));
    curve.gap.push_back(row.mean_gap / scales.rms_height);
  }
  for (const double lowest_start : {outer_start, 0.0})
    for (double tolerance = first_tolerance; tolerance <= last_tolerance;
         tolerance *= 2.0)
      if (const auto stretch =
              outermost_stretch(curve, tolerance, lowest_start))
        return slope_fit_of(*stretch, rows, tolerance);

  SlopeFit none;
  none.reason = rows.size() < fewest_rows
                    ? "fewer than 4 load steps below u = 2 h_rms"
                    : "no linear range of at least four load steps and 0.5 "
                      "h_rms below u = 2 h_rms";
  return none;
}

namespace {

ParameterFit no_fit(const std::string& reason) {
  ParameterFit fit;
  fit.reason = reason;
  return fit;
}

/// Least squares of gamma (at_one - at_zero) = number - at_zero.
/// @param numbers  of the rows, in a unit by which deviations become relative
/// @param theory   of the rows, in the same unit
ParameterFit least_squares(std::span<const CurvePoint> rows,
                           std::span<const double> numbers,
                           std::span<const LossSplit> theory) {
  double product = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double lever = theory[i].at_one - theory[i].at_zero;
    product += lever * (numbers[i] - theory[i].at_zero);
    squares += lever * lever;
  }
  const double gamma = product / squares;
  if (!std::isfinite(gamma))
    return no_fit("the theory at these loads does not depend on gamma");
  double residuals = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double residual = numbers[i] - theory[i].at_zero -
                            gamma * (theory[i].at_one - theory[i].at_zero);
    residuals += residual * residual;
    largest = std::max(largest, std::abs(residual));
  }
  const int freedom = static_cast<int>(rows.size()) - 1;
  ParameterFit fit;
  fit.window = window_of(rows);
  fit.window.largest_deviation = largest;
  fit.gamma = {gamma, std::sqrt(residuals / freedom / squares), freedom};
  return fit;
}

/// The rows of a window of u/h_rms.
std::vector<CurvePoint> rows_between(std::span<const CurvePoint> points,
                                     const SurfaceScales& scales, double low,
                                     double high) {
  std::vector<CurvePoint> rows = loading_rows(points);
  std::erase_if(rows, [&](const CurvePoint& row) {
    const double reduced = row.mean_gap / scales.rms_height;
    return !(reduced > 0.0 && reduced >= low && reduced <= high);
  });
  return rows;
}

/// The theory at the loads of the rows.
/// @param unit  of a row
template <class Unit>
std::vector<LossSplit> theory_at(std::span<const CurvePoint> rows,
                                 const TheoryParts& theory, const Unit& unit) {
  std::vector<LossSplit> splits;
  splits.reserve(rows.size());
  for (const CurvePoint& row : rows) {
    const LossSplit split = theory(row.nominal_pressure);
    splits.push_back({split.at_one / unit(row), split.at_zero / unit(row)});
  }
  return splits;
}

} // namespace

ParameterFit fit_curve(std::span<const CurvePoint> points,
                       const SurfaceScales& scales, const TheoryParts& gap) {
  require_scales(scales);
  const std::vector<CurvePoint> rows =
      rows_between(points, scales, 0.0, largest_gap);
  if (rows.size() < fewest_parameter_rows)
    return no_fit(fmt::format("fewer than {} load steps with 0 < u <= 2 h_rms",
                              fewest_parameter_rows));
  std::vector<double> gaps;
  gaps.reserve(rows.size());
  for (const CurvePoint& row : rows)
    gaps.push_back(row.mean_gap / scales.rms_height);
  return least_squares(rows, gaps, theory_at(rows, gap, [&](const auto&) {
                         return scales.rms_height;
                       }));
}

ParameterFit fit_matched(std::span<const CurvePoint> points,
                         const SurfaceScales& scales, const TheoryParts& gap) {
  require_scales(scales);
  const std::vector<CurvePoint> rows =
      rows_between(points, scales, matched_from, matched_to);
  if (rows.size() < fewest_rows)
    return no_fit(fmt::format("fewer than {} load steps with {:.3g} <= u <= "
                              "{:.3g} h_rms",
                              fewest_rows, matched_from, matched_to));
  std::vector<double> log_pressure, gaps, at_one, at_zero;
  const std::vector<LossSplit> splits =
      theory_at(rows, gap, [&](const auto&) { return scales.rms_height; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    log_pressure.push_back(
        std::log(rows[i].nominal_pressure / scales.contact_modulus));
    gaps.push_back(rows[i].mean_gap / scales.rms_height);
    at_one.push_back(splits[i].at_one);
    at_zero.push_back(splits[i].at_zero);
  }
  const LineFit line = fit_line(log_pressure, gaps);
  const double base = fit_line(log_pressure, at_zero).slope;
  const double lever = fit_line(log_pressure, at_one).slope - base;
  const double gamma = (line.slope - base) / lever;
  if (!std::isfinite(gamma))
    return no_fit("the slope of the theory at these loads does not depend on "
                  "gamma");
  ParameterFit fit;
  fit.window = window_of(rows);
  fit.window.largest_deviation = line.largest_residual;
  fit.gamma = {gamma, std::abs(line.slope_error / lever), line.points - 2};
  return fit;
}

ParameterFit fit_energy(std::span<const CurvePoint> points,
                        const SurfaceScales& scales,
                        const TheoryParts& energy) {
  require_scales(scales);
  std::vector<CurvePoint> rows = loading_rows(points);
  std::erase_if(rows, [](const CurvePoint& row) {
    return !(row.area_fraction > 0.0 && row.area_fraction <= light_load_area &&
             std::isfinite(row.elastic_energy));
  });
  if (rows.size() < fewest_parameter_rows)
    return no_fit(fmt::format("fewer than {} load steps of known energy in "
                              "contact with A/A_0 <= {:.0f} %",
                              fewest_parameter_rows, 100.0 * light_load_area));
  const auto unit = [&](const CurvePoint& row) {
    return row.nominal_pressure * scales.rms_height;
  };
  std::vector<double> energies;
  energies.reserve(rows.size());
  for (const CurvePoint& row : rows)
    energies.push_back(row.elastic_energy / unit(row));
  return least_squares(rows, energies, theory_at(rows, energy, unit));
}

namespace {

// Returns the intercept of area * E* h'/p against area, with its error.
FittedValue kappa_of(std::span<const CurvePoint> rows,
                     const SurfaceScales& scales,
                     const results::CurveColumn* area_fraction) {
  std::vector<double> area;
  std::vector<double> coefficient;
  for (const CurvePoint& row : rows) {
    const double reduced_pressure =
        row.nominal_pressure / (scales.contact_modulus * scales.rms_slope);
    if (!(row[*area_fraction] > 0.0) || !std::isfinite(row[*area_fraction]) ||
        (!area.empty() && row[*area_fraction] <= area.back()))
      continue; // unknown, or not larger than the previous area
    area.push_back(row[*area_fraction]);
    coefficient.push_back(row[*area_fraction] / reduced_pressure);
  }
  if (area.size() < fewest_area_rows)
    return {.reason = fmt::format("fewer than {} load steps whose area is "
                                  "known and grows with the load",
                                  fewest_area_rows)};
  const LineFit line = fit_line(area, coefficient);
  return {line.intercept, line.intercept_error, line.points - 2};
}

} // namespace

AreaFit fit_area(std::span<const CurvePoint> points,
                 const SurfaceScales& scales) {
  require_scales(scales);
  std::vector<CurvePoint> rows = loading_rows(points);
  std::erase_if(rows, [](const CurvePoint& row) {
    return !(row.area_fraction > 0.0 && row.area_fraction <= light_load_area);
  });
  AreaFit fit;
  if (rows.size() < fewest_area_rows) {
    fit.reason = fmt::format(
        "fewer than {} load steps in contact with A/A_0 <= {:.0f} %",
        fewest_area_rows, 100.0 * light_load_area);
    return fit;
  }
  fit.window = window_of(rows);
  fit.kappa = kappa_of(rows, scales, &columns::area_fraction_corrected);
  fit.kappa_counted = kappa_of(rows, scales, &columns::area_fraction);
  return fit;
}

} // namespace asperity::reports
