#include "reports/analysis/comparison.hpp"

#include "reports/numbers/fits.hpp"

// Boost 1.74's pchip.hpp calls isnan without std::, which <math.h> declares.
// clang-format off
#include <math.h>
#include <boost/math/interpolators/pchip.hpp>
#include <boost/math/special_functions/fpclassify.hpp>
// clang-format on

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace asperity::reports {
namespace {

using results::CurvePoint;
using Function = std::function<double(double)>;

// Two rows whose ln p differ by less than this have the same pressure. The
// limit is far above the rounding of a file's decimals and far below any step
// of a loading path.
constexpr double same_pressure = 1e-9;

// Rows with a larger difference of ln p determine nothing between them: a
// decade, and the rounding of a file's decimals.
constexpr double widest_interval = std::numbers::ln10 + same_pressure;

Function straight(std::vector<double> x, std::vector<double> y) {
  return [x = std::move(x), y = std::move(y)](double at) {
    const auto upper = std::upper_bound(x.begin() + 1, x.end() - 1, at);
    const auto i = static_cast<std::size_t>(upper - x.begin());
    return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
  };
}

Function smooth(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2)
    return [](double) { return not_a_number; };
  if (x.size() < 4)
    return straight(x, y);
  using Pchip = boost::math::interpolators::pchip<std::vector<double>>;
  auto curve =
      std::make_shared<Pchip>(std::vector<double>(x), std::vector<double>(y));
  return [curve](double at) { return (*curve)(at); };
}

// Over x = ln p.
Function interpolant(const std::vector<double>& x,
                     const std::vector<double>& y) {
  return [x, y, between = smooth(x, y)](double at) {
    for (std::size_t i = 0; i < x.size(); ++i)
      if (std::abs(x[i] - at) <= same_pressure)
        return y[i];
    const auto upper = std::upper_bound(x.begin(), x.end(), at);
    if (upper == x.begin() || upper == x.end() ||
        *upper - *(upper - 1) > widest_interval)
      return not_a_number;
    return between(at);
  };
}

// Inverts the curve, x over y. Starting at the heaviest load, it uses the rows
// at which y still increases.
Function falling_inverse(const std::vector<double>& x,
                         const std::vector<double>& y) {
  std::vector<double> rising;
  std::vector<double> at;
  for (std::size_t i = x.size(); i-- > 0;)
    if (rising.empty() || y[i] > rising.back()) {
      rising.push_back(y[i]);
      at.push_back(x[i]);
    }
  return [rising, between = smooth(rising, at)](double gap) {
    if (rising.empty() || gap < rising.front() || gap > rising.back())
      return not_a_number;
    return between(gap);
  };
}

} // namespace

AreaColumn best_area(const results::MethodRecord& method) {
  for (const CurvePoint& point : method.rows())
    if (point.area_fraction_corrected > 0.0)
      return &columns::area_fraction_corrected;
  return &columns::area_fraction;
}

CurveFunction::CurveFunction(std::span<const CurvePoint> points,
                             AreaColumn area) {
  std::vector<double> gap_pressure;
  std::vector<double> gap;
  std::vector<double> area_pressure;
  std::vector<double> log_area;
  for (const CurvePoint& row : loading_rows(points)) {
    const double log_pressure = std::log(row.nominal_pressure);
    if (!gap_pressure.empty() &&
        log_pressure - gap_pressure.back() <= same_pressure)
      continue; // repeated load
    gap_pressure.push_back(log_pressure);
    gap.push_back(row.mean_gap);
    if (row[*area] > 0.0) {
      area_pressure.push_back(log_pressure);
      log_area.push_back(std::log(row[*area]));
    }
  }
  log_pressure_of_gap_ = falling_inverse(gap_pressure, gap);
  gap_of_log_pressure_ = interpolant(gap_pressure, gap);
  log_area_of_log_pressure_ = interpolant(area_pressure, log_area);
}

double CurveFunction::gap(double nominal_pressure) const {
  return gap_of_log_pressure_(std::log(nominal_pressure));
}

double CurveFunction::area_fraction(double nominal_pressure) const {
  return std::exp(log_area_of_log_pressure_(std::log(nominal_pressure)));
}

double CurveFunction::pressure_at_gap(double mean_gap) const {
  return std::exp(log_pressure_of_gap_(mean_gap));
}

std::vector<Deviation> deviations(std::span<const CurvePoint> points,
                                  const CurveFunction& reference,
                                  AreaColumn area) {
  std::vector<Deviation> rows;
  for (const CurvePoint& row : loading_rows(points))
    rows.push_back({row.nominal_pressure, row.mean_gap,
                    reference.gap(row.nominal_pressure), row[*area],
                    reference.area_fraction(row.nominal_pressure)});
  return rows;
}

CurveDistance distance_from(std::span<const CurvePoint> points,
                            const results::MethodRecord& reference) {
  const CurveFunction function(reference.realizations.front().points,
                               best_area(reference));
  CurveDistance distance;
  for (const CurvePoint& row : points) { // also those without a gap
    const double pressure = row.nominal_pressure;
    distance.gap = std::fmax(distance.gap,
                             std::abs(row.mean_gap - function.gap(pressure)));
    distance.area = std::fmax(
        distance.area,
        std::abs(row.area_fraction / function.area_fraction(pressure) - 1.0));
  }
  return distance;
}

double largest_gap_deviation(std::span<const Deviation> rows, double rms_height,
                             double low, double high) {
  double largest = not_a_number;
  for (const Deviation& row : rows) {
    const double reduced_gap = row.gap / rms_height;
    if (!(reduced_gap >= low && reduced_gap <= high))
      continue;
    // fmax returns the number if the other argument is NaN.
    largest =
        std::fmax(largest, std::abs(row.gap - row.reference_gap) / rms_height);
  }
  return largest;
}

double largest_pressure_difference(std::span<const CurvePoint> points,
                                   const CurveFunction& reference) {
  const double step = 1e-3; // in ln p, for the derivative du_ref
  const double ratio = std::exp(step);
  double largest = not_a_number;
  for (const CurvePoint& row : loading_rows(points)) {
    if (!(row.area_fraction < 1.0))
      continue; // in full contact, the gap says nothing of the pressure
    double fall = reference.gap(row.nominal_pressure) -
                  reference.gap(row.nominal_pressure * ratio);
    if (!std::isfinite(fall)) // last row of the other curve
      fall = reference.gap(row.nominal_pressure / ratio) -
             reference.gap(row.nominal_pressure);
    const double shift =
        std::abs(row.mean_gap - reference.gap(row.nominal_pressure));
    largest = std::fmax(largest, shift * step / std::abs(fall));
  }
  return largest;
}

double light_load_area_excess(std::span<const Deviation> rows) {
  double sum = 0.0;
  int count = 0;
  for (const Deviation& row : rows) {
    const double excess = row.area_fraction / row.reference_area_fraction - 1.0;
    if (!(row.area_fraction > 0.0 && row.area_fraction <= light_load_area) ||
        !std::isfinite(excess))
      continue;
    sum += excess;
    ++count;
  }
  return count > 0 ? sum / count : not_a_number;
}

} // namespace asperity::reports
