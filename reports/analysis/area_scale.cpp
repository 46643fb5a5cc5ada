#include "reports/analysis/area_scale.hpp"

#include "reports/analysis/rough.hpp"
#include "reports/numbers/determined.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::reports {
namespace {

using results::CurvePoint;

constexpr std::size_t fewest_shared_rows = 3;

std::vector<Deviation> known_areas(std::span<const Deviation> rows) {
  std::vector<Deviation> known;
  for (const Deviation& row : rows)
    if (row.area_fraction > 0.0 && row.reference_area_fraction > 0.0 &&
        std::isfinite(row.area_fraction / row.reference_area_fraction))
      known.push_back(row);
  return known;
}

Estimate mean_scale(const std::vector<AreaScale>& scales,
                    double contact_modulus) {
  std::vector<FittedValue> factors;
  double low = not_a_number;
  double high = not_a_number;
  for (const AreaScale& scale : scales) {
    factors.push_back(scale.factor);
    low = std::fmin(low, scale.pressure_low);
    high = std::fmax(high, scale.pressure_high);
  }
  Estimate mean = determined(mean_over_realizations(factors), positive_range);
  if (mean.has_value())
    mean.remark =
        fmt::format("over p/E* from {:.3g} to {:.3g}; {}",
                    low / contact_modulus, high / contact_modulus, mean.remark);
  return mean;
}

} // namespace

AreaScale fit_area_scale(std::span<const Deviation> rows, LoadRange range) {
  const std::vector<Deviation> known = known_areas(rows);
  const std::size_t half = (known.size() + 1) / 2;
  const std::span<const Deviation> taken =
      range == LoadRange::all          ? std::span(known)
      : range == LoadRange::lower_half ? std::span(known).first(half)
                                       : std::span(known).last(half);
  AreaScale scale;
  scale.rows = static_cast<int>(taken.size());
  if (taken.size() < fewest_shared_rows) {
    scale.factor.reason = fmt::format(
        "fewer than {} of these loads have both areas", fewest_shared_rows);
    return scale;
  }
  scale.pressure_low = taken.front().nominal_pressure;
  scale.pressure_high = taken.back().nominal_pressure;
  double product = 0.0;
  double squares = 0.0;
  for (const Deviation& row : taken) {
    product += row.area_fraction * row.reference_area_fraction;
    squares += row.reference_area_fraction * row.reference_area_fraction;
  }
  const double factor = product / squares;
  double residuals = 0.0;
  for (const Deviation& row : taken) {
    const double residual =
        row.area_fraction - factor * row.reference_area_fraction;
    residuals += residual * residual;
  }
  const int freedom = scale.rows - 1;
  scale.factor = {factor, std::sqrt(residuals / freedom / squares), freedom};
  return scale;
}

std::string area_scale_name(bool is_corrected, LoadRange range) {
  const char* const half = range == LoadRange::all          ? ""
                           : range == LoadRange::lower_half ? "_lower_half"
                                                            : "_upper_half";
  return fmt::format("area_scale{}{}", is_corrected ? "_corrected" : "", half);
}

void add_area_scales(const results::MethodRecord& method,
                     const results::MethodRecord& reference,
                     double contact_modulus, MethodSummary& summary) {
  for (const bool is_corrected : {false, true})
    for (const LoadRange range :
         {LoadRange::all, LoadRange::lower_half, LoadRange::upper_half}) {
      std::vector<AreaScale> scales;
      for (std::size_t r = 0; r < method.realizations.size(); ++r)
        scales.push_back(fit_area_scale(
            deviations(method.realizations[r].points,
                       CurveFunction(curve_of(reference, r).points),
                       is_corrected ? &columns::area_fraction_corrected
                                    : &columns::area_fraction),
            range));
      summary.quantities[area_scale_name(is_corrected, range)] =
          mean_scale(scales, contact_modulus);
    }
}

} // namespace asperity::reports
