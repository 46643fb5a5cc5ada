#include "md/engines.hpp"
#include "robustness/kinds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

/// Values of Sec. 4 of Yang and Persson (2008). A block of atoms has intrinsic
/// lengths and energies, which cannot be removed by scaling.
constexpr double contact_distance = 4.3615e-10;           // [m]
constexpr double interaction_distance = 3.28e-10;         // [m]
constexpr double cutoff = 10e-10;                         // [m]
constexpr double interaction_energy = 1.192021805256e-20; // [J], 74.4 meV

/// Root-mean-square force relative to the load per atom [1].
constexpr double force_tolerance = 1e-8;

md::AtomRequest request_of(const Instance& instance) {
  md::AtomRequest request;
  request.settings.interaction_energy = interaction_energy;
  request.settings.interaction_distance = interaction_distance;
  request.settings.cutoff = cutoff;
  request.settings.contact_distance = contact_distance;
  request.settings.tolerance = force_tolerance;
  request.settings.modes = instance.index % 2 == 0
                               ? mechanics::AtomModes::vector
                               : mechanics::AtomModes::normal;
  request.layer = grid_of(instance);
  const int substrate_points = mechanics::incommensurate_atoms(instance.points);
  request.substrate = {substrate_points, substrate_points, instance.length,
                       instance.length};
  request.scales = {instance.contact_modulus, instance.length,
                    instance.spacing(),
                    instance.rms_slope * instance.spacing()};
  request.youngs_modulus =
      instance.contact_modulus *
      (1.0 - instance.poisson_ratio * instance.poisson_ratio);
  request.poisson_ratio = instance.poisson_ratio;
  request.heights = surface_of(instance, request.substrate).map.heights;
  return request;
}

StepSummary summary_of(const Instance& instance, const md::AtomStep& step) {
  StepSummary summary;
  summary.nominal_pressure = step.nominal_pressure;
  summary.mean_gap = summary.separation = step.mean_gap;
  summary.energy = step.elastic_energy + step.interface_energy;
  // Residual forces displace the longest wave most, by L/(pi E*) per unit of
  // pressure.
  summary.tolerance =
      force_tolerance *
      (contact_distance + step.nominal_pressure * instance.length /
                              (std::numbers::pi * instance.contact_modulus));
  return summary;
}

std::optional<Failure> verify_forces(const md::AtomStep& step, double asked) {
  double sum = 0.0;
  for (const double pressure : step.pressure)
    sum += pressure;
  const double mean = sum / static_cast<double>(step.pressure.size());
  // The mean of the residual is bounded by its root mean square.
  if (std::abs(mean - asked) > 2.0 * force_tolerance * asked)
    return Failure{"balance",
                   "the mean pressure of the atoms differs from the load"};
  const double lowest =
      *std::min_element(step.pressure.begin(), step.pressure.end());
  if (lowest < 0.0)
    return Failure{
        "pressure sign",
        "an atom with a repulsive interaction carries a tensile force"};
  return {};
}

} // namespace

void run_atoms(const Instance& instance, InstanceReport& report) {
  const std::unique_ptr<md::AtomicContact> atoms =
      md::make_atomic_contact(request_of(instance));
  std::vector<StepSummary> steps;
  for (const double factor : {0.5, 1.0, 1.01}) {
    const double pressure =
        factor * instance.load * instance.contact_modulus * instance.rms_slope;
    const md::AtomStep step =
        atoms->solve({mechanics::Control::nominal_pressure, pressure},
                     static_cast<int>(steps.size()));
    report.iterations += step.evaluations;
    if (!step.converged) {
      report.outcome = Outcome::not_converged;
      report.reason = step.note;
      return;
    }
    if (const auto failure = verify_forces(step, pressure))
      return fail(report, *failure);
    const StepSummary summary = summary_of(instance, step);
    if (!steps.empty())
      if (const auto failure = verify_pair(steps.back(), summary))
        return fail(report, *failure);
    steps.push_back(summary);
  }
  report.area = 0.0; // atoms have a fitted area but no counted area
  report.reduced_gap =
      steps[1].mean_gap / (instance.rms_slope * instance.spacing());
}

} // namespace asperity::robustness
