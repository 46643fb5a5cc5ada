#include "studies/friction/partial_slip.hpp"

#include "reports/analysis/exact.hpp"
#include "reports/numbers/fits.hpp"
#include "results/types/method_columns.hpp"
#include "studies/friction/friction.hpp"
#include "studies/study.hpp"
#include "theory/exact/hertz.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <span>

namespace asperity::studies {
namespace {

using mechanics::NormalContact;
using results::CurvePoint;

/// kappa of the contact of a row, from its stiffnesses along x and y, whose
/// compliances have the mean of that ratio; that ratio for an isotropic theory.
mechanics::Directions ratios_of(const CurvePoint& row, double mean_ratio) {
  const double x = row[columns::stick_stiffness.x],
               y = row[columns::stick_stiffness.y];
  if (!(x > 0.0 && y > 0.0))
    return {mean_ratio, mean_ratio};
  return {2.0 * mean_ratio * y / (x + y), 2.0 * mean_ratio * x / (x + y)};
}

NormalContact normal_contact(const CurvePoint& row, double mean_ratio) {
  const double mean = std::isfinite(row[columns::mean_displacement])
                          ? row[columns::mean_displacement]
                          : 0.0;
  const double area = std::isfinite(row.area_fraction_corrected)
                          ? row.area_fraction_corrected
                          : row.area_fraction;
  return {row.nominal_pressure, mean - row.mean_gap, area, row.elastic_energy,
          ratios_of(row, mean_ratio)};
}

/// The contact of a sphere on an infinite half-space, whose ratio is that of
/// all directions.
NormalContact hertzian(const mechanics::SurfaceSpec& sphere,
                       double contact_modulus, double ratio, double pressure) {
  const double side = sphere.length.value_or(not_a_number);
  const theory::HertzContact spot = theory::hertz_contact(
      pressure * side * side, sphere.radius, contact_modulus);
  const double area =
      std::numbers::pi * spot.contact_radius * spot.contact_radius;
  return {pressure,
          spot.approach,
          area / (side * side),
          spot.elastic_energy / (side * side),
          {ratio, ratio}};
}

/// P of one realisation [Pa]; infinite: the largest load.
double normal_load(const results::Result& result,
                   const cases::Case& contact_case,
                   const results::MethodRecord& method, std::size_t r) {
  const auto& load = contact_case.study<FrictionStudy>()->normal_load;
  if (!load)
    return std::numeric_limits<double>::infinity();
  const results::SurfaceRecord* const surface =
      surface_of(result, method, static_cast<int>(r));
  return load->in_si({.contact_modulus = result.contact_modulus,
                      .rms_slope = surface ? surface->rms_slope : 0.0});
}

/// The stiffness of the contact of a row that sticks [Pa/m].
mechanics::Directions stiffness_of(const CurvePoint& row, double mean_ratio,
                                   bool is_theory) {
  if (!is_theory)
    return {row[columns::stick_stiffness.x], row[columns::stick_stiffness.y]};
  const double of_theory = row.contact_stiffness / mean_ratio;
  return {of_theory, of_theory};
}

/// @param rows  of rising loads
std::vector<SlipState> slips_of(const std::vector<CurvePoint>& rows,
                                const cases::Case& contact_case,
                                bool is_theory) {
  const double mean_ratio = mechanics::tangential_ratio(contact_case.material);
  std::vector<NormalContact> path;
  path.reserve(rows.size());
  for (const CurvePoint& row : rows)
    path.push_back(normal_contact(row, mean_ratio));
  std::vector<SlipState> states;
  for (std::size_t i = rows.size(); i-- > 1;) {
    const CurvePoint& eased = rows[i - 1];
    const NormalContact& pressed = path.back();
    states.push_back({.step = eased.step,
                      .pressure = pressed.pressure,
                      .share = 1.0 - eased.nominal_pressure / pressed.pressure,
                      .contact = pressed.area_fraction,
                      .slip = mechanics::partial_slip(
                          std::span(path).subspan(i - 1),
                          contact_case.study<FrictionStudy>()->coefficient),
                      .stiffness = stiffness_of(eased, mean_ratio, is_theory)});
  }
  return states;
}

template <class Value>
SlipSpread spread_of(const std::vector<SlipState>& states, const Value& value) {
  SlipSpread spread{0.0, value(states.front()), value(states.front())};
  for (const SlipState& state : states) {
    spread.mean += value(state) / static_cast<double>(states.size());
    spread.low = std::min(spread.low, value(state));
    spread.high = std::max(spread.high, value(state));
  }
  return spread;
}

template <class Value>
SlipSpreads spreads_of(const std::vector<SlipState>& states,
                       const Value& value) {
  return {spread_of(states, [&](const SlipState& s) { return value(s).x; }),
          spread_of(states, [&](const SlipState& s) { return value(s).y; })};
}

SlipPoint point_of(const std::vector<SlipState>& states) {
  return {
      .share =
          spread_of(states, [](const SlipState& s) { return s.share; }).mean,
      .tangential_stress =
          spread_of(states,
                    [](const SlipState& s) { return s.slip.tangential_stress; })
              .mean,
      .displacement = spreads_of(
          states, [](const SlipState& s) { return s.slip.displacement; }),
      .stick = spread_of(
          states,
          [](const SlipState& s) { return s.slip.stick_area / s.contact; }),
      .stiffness =
          spreads_of(states, [](const SlipState& s) { return s.stiffness; }),
      .loss =
          spreads_of(states, [](const SlipState& s) { return s.slip.loss; }),
  };
}

} // namespace

std::vector<SlipPoint>
slip_points(const std::vector<std::vector<SlipState>>& curves) {
  std::map<int, std::vector<SlipState>, std::greater<>> by_step;
  for (const std::vector<SlipState>& curve : curves)
    for (const SlipState& state : curve)
      by_step[state.step].push_back(state);
  std::vector<SlipPoint> points;
  for (const auto& [step, states] : by_step)
    if (states.size() == curves.size())
      points.push_back(point_of(states));
  return points;
}

std::vector<std::vector<SlipState>>
partial_slips(const results::Result& result, const cases::Case& contact_case,
              const results::MethodRecord& method) {
  std::vector<std::vector<SlipState>> curves;
  const cases::MethodSpec* const spec = spec_of(contact_case, method);
  if (!asks<FrictionStudy>(contact_case) || spec == nullptr ||
      !cases::has_partial_slip(*spec, contact_case.material) ||
      !(result.contact_modulus > 0.0))
    return curves;
  for (std::size_t r = 0; r < method.realizations.size(); ++r) {
    std::vector<CurvePoint> rows = loading_rows(method.realizations[r].points);
    const double load = normal_load(result, contact_case, method, r);
    std::erase_if(rows, [=](const CurvePoint& row) {
      return row.nominal_pressure > load * (1.0 + 1e-6);
    });
    std::vector<SlipState> states =
        slips_of(rows, contact_case, method.kind == "theory");
    if (!states.empty())
      curves.push_back(std::move(states));
  }
  return curves;
}

void add_slip_quantities(const results::Result& result,
                         const cases::Case& contact_case,
                         const results::MethodRecord& method,
                         MethodSummary& summary) {
  const auto curves = partial_slips(result, contact_case, method);
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (curves.empty() || surface.kind != mechanics::SurfaceKind::sphere)
    return;
  Estimate& found = summary.quantities["partial_slip_error"];
  found.remark = "needs free boundaries: one sphere alone";
  if (!has_free_boundaries(contact_case, method))
    return;
  const double ratio = mechanics::tangential_ratio(contact_case.material);
  const double mu = contact_case.study<FrictionStudy>()->coefficient;
  const auto exact_at = [&](double pressure) {
    return hertzian(surface, result.contact_modulus, ratio, pressure);
  };
  const NormalContact pressed = exact_at(curves.front().front().pressure);
  const double sliding = mu * ratio * pressed.approach;
  double largest = not_a_number;
  for (const SlipState& state : curves.front()) {
    const std::array path{exact_at(pressed.pressure * (1.0 - state.share)),
                          pressed};
    const mechanics::PartialSlip exact = mechanics::partial_slip(path, mu);
    for (const double error :
         {(state.slip.displacement.x - exact.displacement.x) / sliding,
          (state.slip.displacement.y - exact.displacement.y) / sliding,
          (state.slip.stick_area - exact.stick_area) / pressed.area_fraction})
      largest = std::fmax(largest, std::abs(error));
  }
  found = largest_estimate(largest, "no tangential load");
}

} // namespace asperity::studies
