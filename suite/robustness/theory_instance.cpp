// Evaluates a theory and verifies its rows against each other.
#include "run/methods/surfaces_of_case.hpp"
#include "run/methods/theory_method.hpp"
#include "suite/robustness/case_pass.hpp"
#include "theory/persson/persson.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

/// A hundred times the accuracy of an integral that theory/persson/persson.hpp
/// states.
constexpr double relative_accuracy = 1e-12;

/// In full contact, u below this value has lost digits to underflow.
constexpr double smallest_gap = 1e-280;

std::optional<Failure> verify_values(const theory::PerssonContact& contact,
                                     const StepSummary& step) {
  const double stiffness = contact.contact_stiffness(step.nominal_pressure);
  if (!std::isfinite(step.mean_gap) || !std::isfinite(step.energy) ||
      !std::isfinite(step.area))
    return Failure{"finite", "a number of the theory is not finite"};
  if (step.mean_gap < 0.0 || step.energy < 0.0 || step.area < 0.0 ||
      step.area > 1.0 || !(stiffness > 0.0))
    return Failure{"sign", "a number of the theory is outside its range"};
  // The stored energy is the work int p du from u on, for gamma = 0 and 1; it
  // cannot exceed that of full contact.
  if (step.energy > contact.full_contact_energy() * (1.0 + relative_accuracy))
    return Failure{"energy", "the energy exceeds that of full contact"};
  return {};
}

/// Compares A/A_0 = erf(sqrt2 p/(E* h')) with the error function evaluated
/// here; h' comes from the theory's own moments of the spectrum.
std::optional<Failure> verify_area(const theory::PerssonContact& contact,
                                   double contact_modulus,
                                   const StepSummary& step) {
  const double slope = contact.spectrum().rms_slope();
  const double expected = std::erf(std::numbers::sqrt2 * step.nominal_pressure /
                                   (contact_modulus * slope));
  if (std::abs(step.area - expected) > relative_accuracy * expected)
    return Failure{
        "area",
        fmt::format("A/A_0 = {:.17g}, but the error function gives {:.17g}",
                    step.area, expected)};
  return {};
}

std::optional<Failure> verify_inverse(const theory::PerssonContact& contact,
                                      const StepSummary& step) {
  if (step.mean_gap < smallest_gap)
    return {};
  const double again =
      contact.mean_gap(contact.nominal_pressure(step.mean_gap));
  // The relative error of p is eps; that of u is larger by the factor D/u.
  const double steepness =
      contact.mean_gap_slope(step.nominal_pressure) / step.mean_gap;
  const double allowed = relative_accuracy * (1.0 + steepness);
  if (!(std::abs(again / step.mean_gap - 1.0) <= allowed))
    return Failure{"inverse", fmt::format("u(p(u))/u - 1 = {:.3g}",
                                          again / step.mean_gap - 1.0)};
  return {};
}

} // namespace

void run_theory(const MethodOfCase& what, InstanceReport& report) {
  const auto& settings =
      std::get<mechanics::TheorySettings>(what.method.settings);
  const methods::CaseSurfaces surfaces(what.contact_case, {what.method}, {0});
  const methods::TheoryInput input =
      methods::theory_input(what.contact_case, what.method, surfaces, 0);
  const double contact_modulus = input.scales.contact_modulus;
  const theory::PerssonContact contact(input.spectrum, contact_modulus,
                                       settings.gamma);
  const bool is_first_law =
      settings.loss_factor == mechanics::LossFactor::yang_persson;
  std::vector<StepSummary> steps;
  for (const results::CurvePoint& row :
       methods::theory_rows(settings, what.contact_case.load, input)) {
    StepSummary step;
    step.nominal_pressure = row.nominal_pressure;
    step.mean_gap = step.separation = row.mean_gap;
    step.energy = row.elastic_energy;
    step.area = row.area_fraction;
    step.tolerance = relative_accuracy * step.mean_gap;
    if (const auto failure = verify_values(contact, step))
      return fail(report, *failure);
    for (const auto& failure : {verify_area(contact, contact_modulus, step),
                                verify_inverse(contact, step)})
      if (failure && is_first_law)
        return fail(report, *failure);
    if (!steps.empty() && is_first_law)
      if (const auto failure = verify_pair(steps.back(), step))
        return fail(report, *failure);
    steps.push_back(step);
  }
  report.area = steps[steps.size() / 2].area;
  report.reduced_gap =
      steps[steps.size() / 2].mean_gap / input.spectrum.rms_height();
}

} // namespace asperity::robustness
