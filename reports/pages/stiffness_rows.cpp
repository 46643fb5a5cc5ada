// Shows how stiff each contact is and where its load acts, as rows of the page.
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::reports {
namespace {

using results::CurvePoint;

std::string digits(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "–";
}

/// In micrometres; a distance that is roundoff of the side is 0.
std::string distance(double metres, double side) {
  return std::abs(metres) < 1e-9 * side ? "0" : digits(1e6 * metres);
}

bool is_shown(const CurvePoint& point, double side) {
  return point.status == results::StepStatus::converged &&
         (std::isfinite(point.tangential_stiffness) || // of a full block
          std::hypot(point.pressure_centre_x, point.pressure_centre_y) >
              1e-6 * side);
}

kainjow::mustache::data stiffness_row(const std::string& method,
                                      const CurvePoint& point,
                                      double contact_modulus, double side) {
  kainjow::mustache::data row;
  row.set("name", method);
  row.set("pressure",
          fmt::format("{:.3g}", point.nominal_pressure / contact_modulus));
  row.set("normal", digits(point.normal_stiffness));
  row.set("tangential", digits(point.tangential_stiffness));
  row.set("ratio", digits(point.tangential_stiffness / point.normal_stiffness));
  row.set("x", distance(point.pressure_centre_x, side));
  row.set("y", distance(point.pressure_centre_y, side));
  return row;
}

} // namespace

kainjow::mustache::list stiffness_rows(const results::Result& result) {
  kainjow::mustache::list rows;
  for (const results::MethodRecord& method : result.methods) {
    const results::SurfaceRecord* const surface = surface_of(result, method, 0);
    if (surface == nullptr || method.realizations.empty())
      continue;
    const double side = surface->grid.length_x;
    for (const CurvePoint& point : method.realizations.front().points)
      if (is_shown(point, side))
        rows.push_back(
            stiffness_row(method.name, point, result.contact_modulus, side));
  }
  return rows;
}

} // namespace asperity::reports
