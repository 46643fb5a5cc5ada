#include "reports/analysis/certified.hpp"

#include "reports/analysis/summary.hpp"

#include <cmath>

namespace asperity::reports {

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
      if (surface == nullptr || !std::isfinite(point.certified_gap_error))
        continue;
      const double bound = point.certified_gap_error / surface->rms_height;
      if (!(bound <= found.largest)) {
        found.largest = bound;
        found.pressure = point.nominal_pressure;
      }
      ++found.certified;
    }
  }
  return found;
}

} // namespace asperity::reports
