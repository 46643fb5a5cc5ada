#include "robustness/kinds.hpp"
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

StepSummary summary_of(const theory::PerssonContact& contact,
                       double nominal_pressure) {
  StepSummary summary;
  summary.nominal_pressure = nominal_pressure;
  summary.mean_gap = contact.mean_gap(nominal_pressure);
  summary.separation = summary.mean_gap;
  summary.energy = contact.elastic_energy(nominal_pressure);
  summary.area = contact.area_fraction(nominal_pressure);
  summary.tolerance = relative_accuracy * summary.mean_gap;
  return summary;
}

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
                                   const Instance& instance,
                                   const StepSummary& step) {
  const double slope = contact.spectrum().rms_slope();
  const double expected = std::erf(std::numbers::sqrt2 * step.nominal_pressure /
                                   (instance.contact_modulus * slope));
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

void run_theory(const Instance& instance, InstanceReport& report) {
  const surfaces::IsotropicSpectrum formula = spectrum_of(instance);
  const theory::PerssonContact contact(
      theory::HeightSpectrum(
          theory::SpectrumFormula{formula.density, formula.kinks}),
      instance.contact_modulus, instance.gamma);
  std::vector<StepSummary> steps;
  for (const double factor : {0.5, 1.0, 1.01}) {
    const StepSummary step =
        summary_of(contact, factor * instance.load * instance.contact_modulus *
                                instance.rms_slope);
    for (const auto& failure :
         {verify_values(contact, step), verify_area(contact, instance, step),
          verify_inverse(contact, step)})
      if (failure)
        return fail(report, *failure);
    if (!steps.empty())
      if (const auto failure = verify_pair(steps.back(), step))
        return fail(report, *failure);
    steps.push_back(step);
  }
  report.area = steps[1].area;
  report.reduced_gap = steps[1].mean_gap / contact.spectrum().rms_height();
}

} // namespace asperity::robustness
