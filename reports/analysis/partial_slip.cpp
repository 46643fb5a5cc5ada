#include "reports/analysis/partial_slip.hpp"

#include "reports/analysis/exact.hpp"
#include "reports/numbers/fits.hpp"
#include "theory/exact/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

namespace asperity::reports {
namespace {

using mechanics::NormalContact;
using results::CurvePoint;

NormalContact normal_contact(const CurvePoint& row) {
  const double mean =
      std::isfinite(row.mean_displacement) ? row.mean_displacement : 0.0;
  const double area = std::isfinite(row.area_fraction_corrected)
                          ? row.area_fraction_corrected
                          : row.area_fraction;
  return {row.nominal_pressure, mean - row.mean_gap, area, row.elastic_energy};
}

/// The contact of a sphere on an infinite half-space.
NormalContact hertzian(const mechanics::SurfaceSpec& sphere,
                       double contact_modulus, double pressure) {
  const double side = sphere.length.value_or(not_a_number);
  const theory::HertzContact spot = theory::hertz_contact(
      pressure * side * side, sphere.radius, contact_modulus);
  const double area =
      std::numbers::pi * spot.contact_radius * spot.contact_radius;
  return {pressure, spot.approach, area / (side * side),
          spot.elastic_energy / (side * side)};
}

mechanics::Friction friction_of(const cases::Case& contact_case) {
  return {contact_case.friction_study->coefficient,
          mechanics::tangential_ratio(contact_case.material)};
}

/// P of one realisation [Pa]; infinite: the largest load.
double normal_load(const results::Result& result,
                   const cases::Case& contact_case,
                   const results::MethodRecord& method, std::size_t r) {
  const auto& load = contact_case.friction_study->normal_load;
  if (!load)
    return std::numeric_limits<double>::infinity();
  const results::SurfaceRecord* const surface =
      surface_of(result, method, static_cast<int>(r));
  return load->in_si({.contact_modulus = result.contact_modulus,
                      .rms_slope = surface ? surface->rms_slope : 0.0});
}

std::vector<SlipState> slips_of(const std::vector<CurvePoint>& rows,
                                const mechanics::Friction& friction) {
  std::vector<SlipState> states;
  for (std::size_t i = rows.size(); i-- > 1;) {
    const CurvePoint& eased = rows[i - 1];
    const bool is_free = std::isfinite(eased.mean_displacement);
    const NormalContact pressed = normal_contact(rows.back());
    states.push_back(
        {.step = eased.step,
         .pressure = pressed.pressure,
         .share = 1.0 - eased.nominal_pressure / pressed.pressure,
         .contact = pressed.area_fraction,
         .slip =
             mechanics::partial_slip(pressed, normal_contact(eased), friction),
         .stiffness = is_free ? not_a_number
                              : eased.contact_stiffness / friction.ratio});
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

SlipPoint point_of(const std::vector<SlipState>& states) {
  return {
      .share =
          spread_of(states, [](const SlipState& s) { return s.share; }).mean,
      .tangential_stress =
          spread_of(states,
                    [](const SlipState& s) { return s.slip.tangential_stress; })
              .mean,
      .displacement = spread_of(
          states, [](const SlipState& s) { return s.slip.displacement; }),
      .stick = spread_of(
          states,
          [](const SlipState& s) { return s.slip.stick_area / s.contact; }),
      .stiffness =
          spread_of(states, [](const SlipState& s) { return s.stiffness; }),
      .loss = spread_of(states, [](const SlipState& s) { return s.slip.loss; }),
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
  if (!contact_case.friction_study || spec == nullptr ||
      !cases::has_partial_slip(*spec, contact_case.material) ||
      !(result.contact_modulus > 0.0))
    return curves;
  const mechanics::Friction friction = friction_of(contact_case);
  for (std::size_t r = 0; r < method.realizations.size(); ++r) {
    std::vector<CurvePoint> rows = loading_rows(method.realizations[r].points);
    const double load = normal_load(result, contact_case, method, r);
    std::erase_if(rows, [=](const CurvePoint& row) {
      return row.nominal_pressure > load * (1.0 + 1e-6);
    });
    std::vector<SlipState> states = slips_of(rows, friction);
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
  const mechanics::Friction friction = friction_of(contact_case);
  const double pressure = curves.front().front().pressure;
  const double modulus = result.contact_modulus;
  const NormalContact pressed = hertzian(surface, modulus, pressure);
  const double sliding =
      friction.coefficient * friction.ratio * pressed.approach;
  double largest = not_a_number;
  for (const SlipState& state : curves.front()) {
    const mechanics::PartialSlip exact = mechanics::partial_slip(
        pressed, hertzian(surface, modulus, pressure * (1.0 - state.share)),
        friction);
    largest = std::fmax(largest,
                        std::abs(state.slip.displacement - exact.displacement) /
                            sliding);
    largest =
        std::fmax(largest, std::abs(state.slip.stick_area - exact.stick_area) /
                               pressed.area_fraction);
  }
  found = largest_estimate(largest, "no tangential load");
}

} // namespace asperity::reports
