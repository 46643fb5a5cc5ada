#include "reports/analysis/comparison.hpp"
#include "reports/numbers/fits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::reports {
namespace {

struct GapRow {
  double reduced_gap = 0.0;  // u/h_rms
  double log_pressure = 0.0; // ln p/p_ref at that gap
};

double median_in_range(const std::vector<GapRow>& rows) {
  std::vector<double> inside;
  for (const GapRow& row : rows)
    if (row.reduced_gap >= comparison_gap_low &&
        row.reduced_gap <= comparison_gap_high)
      inside.push_back(row.log_pressure);
  return inside.empty() ? not_a_number : median(std::move(inside));
}

// Searches from row `start`, towards larger gaps if `direction` is +1 and
// towards smaller ones if it is -1.
double end_of_agreement(const std::vector<GapRow>& rows, double offset,
                        std::ptrdiff_t start, int direction) {
  const auto apart = [&](std::ptrdiff_t i) {
    return std::abs(rows[static_cast<std::size_t>(i)].log_pressure - offset);
  };
  const auto gap = [&](std::ptrdiff_t i) {
    return rows[static_cast<std::size_t>(i)].reduced_gap;
  };
  if (apart(start) > departure_tolerance)
    return not_a_number;
  for (std::ptrdiff_t i = start, next = start + direction;
       next >= 0 && next < std::ssize(rows); i = next, next += direction)
    if (apart(next) > departure_tolerance) {
      const double share =
          (departure_tolerance - apart(i)) / (apart(next) - apart(i));
      return gap(i) + share * (gap(next) - gap(i));
    }
  return not_a_number;
}

} // namespace

Departure departure_from(std::span<const results::CurvePoint> points,
                         const CurveFunction& reference, double rms_height) {
  std::vector<GapRow> rows;
  for (const results::CurvePoint& row : loading_rows(points)) {
    const double ratio =
        row.nominal_pressure / reference.pressure_at_gap(row.mean_gap);
    if (std::isfinite(ratio))
      rows.push_back({row.mean_gap / rms_height, std::log(ratio)});
  }
  std::sort(rows.begin(), rows.end(), [](const GapRow& a, const GapRow& b) {
    return a.reduced_gap < b.reduced_gap;
  });
  Departure departure;
  departure.offset = median_in_range(rows);
  if (!std::isfinite(departure.offset))
    return departure;
  const auto nearest = std::min_element(
      rows.begin(), rows.end(), [](const GapRow& a, const GapRow& b) {
        return std::abs(a.reduced_gap - 1.0) < std::abs(b.reduced_gap - 1.0);
      });
  const std::ptrdiff_t start = nearest - rows.begin();
  departure.low = end_of_agreement(rows, departure.offset, start, -1);
  departure.high = end_of_agreement(rows, departure.offset, start, 1);
  return departure;
}

} // namespace asperity::reports
