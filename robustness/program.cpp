#include "robustness/kinds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity::robustness {
namespace {

/// Returns pressures relative to the load of the instance, or gaps in h_rms
/// that are added to its gap.
std::vector<double> steps_of(const Instance& instance) {
  const bool by_pressure =
      instance.control == mechanics::Control::nominal_pressure;
  switch (instance.program) {
  case Program::increments:
    return by_pressure ? std::vector{0.5, 1.0, 1.01}
                       : std::vector{0.5, 0.0, -0.01};
  case Program::jump:
    return by_pressure ? std::vector{1e-6, 1.0, 1.01}
                       : std::vector{10.0, 0.0, -0.01};
  case Program::cycle:
    break;
  }
  return by_pressure ? std::vector{0.25, 0.5, 1.0, 0.5, 0.25}
                     : std::vector{1.0, 0.5, 0.0, 0.5, 1.0};
}

} // namespace

std::size_t load_step(const Instance& instance) {
  return instance.program == Program::cycle ? 2 : 1;
}

std::vector<mechanics::LoadTarget> targets_of(const Instance& instance,
                                              double height_scale) {
  std::vector<mechanics::LoadTarget> targets;
  for (const double step : steps_of(instance)) {
    if (instance.control == mechanics::Control::nominal_pressure) {
      targets.push_back({mechanics::Control::nominal_pressure,
                         instance.load * step * instance.contact_modulus *
                             instance.rms_slope});
      continue;
    }
    // The last decrease, by one hundredth, must not lead to a negative gap in
    // hard contact.
    const double reach = step < 0.0 ? std::abs(instance.load) : 1.0;
    targets.push_back({mechanics::Control::mean_gap,
                       (instance.load + step * reach) * height_scale});
  }
  return targets;
}

ComplianceRange compliance_range(const Grid& grid, const Displace& displace) {
  ComplianceRange range{0.0, std::numeric_limits<double>::infinity()};
  std::vector<double> wave(grid.size());
  std::vector<double> answer(grid.size());
  for (int waves = 1; waves <= grid.points_x / 2; waves *= 2) {
    for (std::size_t i = 0; i < wave.size(); ++i)
      wave[i] = std::cos(2.0 * std::numbers::pi * waves *
                         static_cast<double>(i) / grid.points_x);
    displace(wave, answer);
    double height = 0.0;
    for (const double value : answer)
      height = std::max(height, std::abs(value));
    range.longest = std::max(range.longest, height);
    range.shortest = std::min(range.shortest, height);
  }
  return range;
}

std::optional<Failure> verify_program(const Instance& instance,
                                      const std::vector<StepSummary>& steps) {
  for (std::size_t i = 1; i < steps.size(); ++i)
    if (auto failure = verify_pair(steps[i - 1], steps[i]))
      return failure;
  if (instance.program == Program::cycle)
    for (std::size_t i = 0; i < steps.size() / 2; ++i)
      if (auto failure = verify_same(steps[i], steps[steps.size() - 1 - i])) {
        failure->check = "cycle";
        return failure;
      }
  return {};
}

void report_load_step(const StepSummary& step, double height_scale,
                      InstanceReport& report) {
  report.area = step.area;
  report.reduced_gap = step.mean_gap / height_scale;
  report.reduced_tolerance = step.tolerance / height_scale;
}

void fail(InstanceReport& report, const Failure& failure) {
  report.outcome = Outcome::check_failed;
  report.check = failure.check;
  report.reason = failure.detail;
}

} // namespace asperity::robustness
