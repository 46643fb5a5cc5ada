
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "robustness/kinds.hpp"
#include "robustness/verify_observables.hpp"

namespace asperity::robustness {
namespace {

/// Unbalanced nodal forces relative to the largest nodal force: the tolerance
/// of the Newton method of the full 3-D model.
constexpr double load_tolerance_of_block = 1e-8;

/// Penalty stiffness of the augmented-Lagrangian method for hard contact, equal
/// to the default of a case [E*/h].
constexpr double wall_spring = 100.0;

contact::ContactSolution as_contact(fem::BlockSolution block,
                                    const Displace& displace) {
  contact::ContactSolution solution;
  solution.pressure = std::move(block.pressure);
  solution.gap = std::move(block.gap);
  solution.displacement.resize(solution.gap.size());
  displace(solution.pressure, solution.displacement);
  solution.nominal_pressure = block.nominal_pressure;
  solution.mean_gap = block.mean_gap;
  solution.iterations = block.iterations;
  solution.converged = block.converged;
  solution.note = std::move(block.note);
  return solution;
}

/// What the steps are verified against, except for the tolerance of the gap,
/// which depends on the step.
AskedContact asked_of_block(const Instance& instance,
                            std::span<const double> heights,
                            const fem::FullBlock& block,
                            const ComplianceRange& range, double spring) {
  AskedContact asked{heights, block.nodal_weights()};
  asked.may_lose_contact = may_lose_contact(instance);
  asked.local_compliance =
      instance.law == mechanics::ContactLaw::penalty ? 1.0 / spring : 0.0;
  asked.long_wave_compliance = range.longest;
  asked.short_wave_compliance = range.shortest;
  asked.load_tolerance = load_tolerance_of_block;
  return asked;
}

} // namespace

void run_full_block(const Instance& instance, InstanceReport& report) {
  const Grid grid = grid_of(instance);
  const InstanceSurface surface = surface_of(instance, grid);
  const std::unique_ptr<fem::FullBlock> block =
      fem::load_fem_module().uncondensed(
          block_request(instance, grid, instance.degree, 1));
  const Displace displace = [&](auto pressure, auto displacement) {
    const std::vector<double> answer = block->displacement(pressure);
    if (answer.size() != displacement.size())
      throw std::runtime_error(
          "the linear solver of the block did not converge");
    std::copy(answer.begin(), answer.end(), displacement.begin());
  };
  const ComplianceRange range = compliance_range(grid, displace);
  const bool is_hard = instance.law == mechanics::ContactLaw::hard;
  const double spring = (is_hard ? wall_spring : instance.penalty) *
                        instance.contact_modulus / grid.spacing_x();
  AskedContact asked =
      asked_of_block(instance, surface.map.heights, *block, range, spring);

  // For a flat surface the model uses a tolerance of its own, a fraction of the
  // node spacing.
  const double tolerance_scale =
      instance.shape == Shape::flat ? grid.spacing_x() : surface.height_scale;
  std::vector<StepSummary> summaries;
  for (const mechanics::LoadTarget& target :
       targets_of(instance, surface.height_scale)) {
    const contact::ContactSolution solution = as_contact(
        block->solve(surface.map.heights, target,
                     {instance.law, spring, relative_tolerance, 2000}),
        displace);
    report.iterations += solution.iterations;
    if (!solution.converged) {
      report.outcome = Outcome::gave_up;
      report.reason = solution.note;
      return;
    }
    // Through the compliance C, the tolerance of the forces contributes to that
    // of the gap.
    asked.gap_tolerance = relative_tolerance * tolerance_scale +
                          load_tolerance_of_block * range.longest *
                              *std::max_element(solution.pressure.begin(),
                                                solution.pressure.end());
    if (const auto failure = verify_step(asked, target, solution, displace))
      return fail(report, *failure);
    if (const auto failure =
            verify_observables(grid, asked, solution, instance.contact_modulus))
      return fail(report, *failure);
    summaries.push_back(summary_of(asked, solution));
  }
  report_load_step(summaries[load_step(instance)], surface.height_scale,
                   report);
  if (const auto failure = verify_program(instance, summaries))
    fail(report, *failure);
}

} // namespace asperity::robustness
