#include "reports/analysis/certified.hpp"

#include "reports/analysis/summary.hpp"
#include "results/types/method_columns.hpp"

#include <cmath>

namespace asperity::reports {
namespace {

/// @param error  of the mean gap at the point [h_rms]; NaN: not known
void add(double error, const results::CurvePoint& point, ErrorsOfSteps& found) {
  if (!std::isfinite(error))
    return;
  ++found.steps;
  if (!(error <= found.largest)) {
    found.largest = error;
    found.pressure = point.nominal_pressure;
  }
}

} // namespace

Certified certified_of(const results::Result& result,
                       const results::MethodRecord& method) {
  Certified found;
  for (std::size_t r = 0; r < method.realizations.size(); ++r) {
    const results::SurfaceRecord* surface = surface_of(result, method, r);
    for (const results::CurvePoint& point : method.realizations[r].points) {
      if (point.status != results::StepStatus::converged ||
          !(point.nominal_pressure > 0.0))
        continue;
      ++found.steps;
      if (surface == nullptr)
        continue;
      add(point[columns::certified_gap_error] / surface->rms_height, point,
          found.bounds);
      add(point[columns::estimated_gap_error] / surface->rms_height, point,
          found.estimates);
    }
  }
  return found;
}

} // namespace asperity::reports
