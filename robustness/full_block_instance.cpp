// Solves the load steps of full 3-D models and verifies them.
#include "robustness/kinds.hpp"
#include "robustness/verify_observables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

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

/// The compliance of the uniform pressure, the thickness over the modulus of
/// uniaxial strain. Under a stiff coating it exceeds that of all waves [m/Pa].
double uniform_compliance(const Instance& instance) {
  const double nu = instance.poisson_ratio;
  const double uniaxial = instance.contact_modulus * (1.0 - nu * nu) *
                          (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double coating = instance.coating_thickness;
  const double thickness = instance.thickness * instance.length;
  return thickness / uniaxial *
         (1.0 - coating + coating / instance.coating_stiffness);
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
      mechanics::ContactInterface{instance.law, spring}.local_compliance();
  asked.long_wave_compliance =
      std::max(range.longest, uniform_compliance(instance));
  asked.short_wave_compliance = range.shortest;
  asked.load_tolerance = load_tolerance_of_block;
  return asked;
}

/// Whether a uniform pressure moves the contact surface as a whole. Only then
/// is the energy about the mean displacement that of verify_pair, positive and
/// convex in the mean gap.
bool is_laterally_uniform(const Instance& instance) {
  return !instance.has_free_sides && instance.modulus_ratio == 1.0;
}

/// Whether the fields of a solution are those of the contact points. Otherwise
/// they are samples, which need not satisfy the contact conditions.
bool has_nodal_fields(const Instance& instance) {
  return !instance.has_free_sides && instance.counter == CounterBody::none &&
         (instance.mesh == mechanics::MeshKind::layers ||
          instance.mesh == mechanics::MeshKind::hanging);
}

/// Verifies what samples must satisfy: finite values, no tension, and the
/// prescribed load or mean gap, which are sums over the contact points.
std::optional<Failure> verify_samples(const AskedContact& asked,
                                      const mechanics::LoadTarget& target,
                                      const contact::ContactSolution& found) {
  for (const double pressure : found.pressure)
    if (!std::isfinite(pressure) || pressure < 0.0)
      return Failure{"sign of the pressure", fmt::format("{}", pressure)};
  for (const double gap : found.gap)
    if (!std::isfinite(gap))
      return Failure{"finite", "a gap is not finite"};
  const bool is_load = target.control == mechanics::Control::nominal_pressure;
  const double value = is_load ? found.nominal_pressure : found.mean_gap;
  const double tolerance =
      is_load ? asked.load_tolerance * target.amount : asked.gap_tolerance;
  if (!(std::abs(value - target.amount) <= tolerance))
    return Failure{"equilibrium",
                   fmt::format("{:.17g} instead of {:.17g}, tolerance {:.3g}",
                               value, target.amount, tolerance)};
  return {};
}

/// Compares a step with that of the direct solver.
std::optional<Failure> verify_direct(const Instance& instance,
                                     const StepSummary& found,
                                     const StepSummary& direct,
                                     InstanceReport& report) {
  report.has_pair = true;
  report.pair_difference =
      std::max(report.pair_difference,
               std::abs(found.mean_gap - direct.mean_gap) / found.tolerance);
  StepSummary expected = direct;
  if (!is_laterally_uniform(instance) || !has_nodal_fields(instance))
    expected.energy = found.energy;
  auto failure = verify_same(found, expected);
  if (failure)
    failure->check = "direct solver";
  return failure;
}

/// One instance, load step by load step.
class FullBlockRun {
public:
  FullBlockRun(const Instance& instance, InstanceReport& report);

  /// @return  whether to go on; otherwise the report says why not
  bool run_step(const mechanics::LoadTarget& target);

  /// Verifies what concerns all steps together.
  void finish();

  double height_scale() const { return surface_.height_scale; }

private:
  contact::ContactSolution solved_by(fem::FullBlock& block,
                                     const mechanics::LoadTarget& target) const;
  void set_tolerances(const contact::ContactSolution& solution);
  std::optional<Failure> verify(const mechanics::LoadTarget& target,
                                const contact::ContactSolution& solution);
  /// Ends the instance; false.
  bool end_without_solution(const std::string& note,
                            const mechanics::LoadTarget& target);

  const Instance& instance_;
  InstanceReport& report_;
  Grid grid_;
  InstanceSurface surface_;
  std::unique_ptr<fem::FullBlock> block_;
  std::unique_ptr<fem::FullBlock> direct_;
  Displace displace_; ///< by the factorised matrix
  ComplianceRange range_;
  double spring_; ///< [Pa/m]
  AskedContact asked_;
  std::vector<StepSummary> summaries_;
};

Displace displacement_by(fem::FullBlock& direct) {
  return [&direct](auto pressure, auto displacement) {
    const std::vector<double> answer = direct.displacement(pressure);
    if (answer.size() != displacement.size())
      throw std::runtime_error(
          "the linear solver of the block did not converge");
    std::copy(answer.begin(), answer.end(), displacement.begin());
  };
}

/// The compliance of a block is at most that of its softest cell everywhere.
ComplianceRange range_of(const Instance& instance, const Grid& grid,
                         const Displace& displace) {
  ComplianceRange range = compliance_range(grid, displace);
  range.longest =
      std::max(range.longest, range.shortest) * instance.modulus_ratio;
  return range;
}

double spring_of(const Instance& instance, const Grid& grid) {
  const double spring =
      mechanics::needs_penalty(instance.law) ? instance.penalty : wall_spring;
  return spring * instance.contact_modulus / grid.spacing_x();
}

FullBlockRun::FullBlockRun(const Instance& instance, InstanceReport& report)
    : instance_(instance),
      report_(report),
      grid_(grid_of(instance)),
      surface_(surface_of(instance, grid_)),
      block_(full_block_of(instance, grid_, instance.linear_solver)),
      direct_(full_block_of(instance, grid_, mechanics::LinearSolver::direct)),
      displace_(displacement_by(*direct_)),
      range_(range_of(instance, grid_, displace_)),
      spring_(spring_of(instance, grid_)),
      asked_(asked_of_block(instance, surface_.map.heights, *block_, range_,
                            spring_)) {}

contact::ContactSolution
FullBlockRun::solved_by(fem::FullBlock& block,
                        const mechanics::LoadTarget& target) const {
  return as_contact(
      block.solve(surface_.map.heights, target,
                  {instance_.law, spring_, relative_tolerance, 2000}),
      displace_);
}

bool FullBlockRun::end_without_solution(const std::string& note,
                                        const mechanics::LoadTarget& target) {
  report_.reason = note;
  report_.outcome =
      outcome_of_note(report_.reason, [&]() -> std::optional<std::string> {
        const contact::ContactSolution direct = solved_by(*direct_, target);
        if (direct.converged)
          return {};
        return direct.note;
      });
  return false;
}

/// Each nodal force is known to a fraction of the largest one, so that the mean
/// pressure is known to this fraction of the largest pressure. Through the
/// compliance C it contributes to the tolerance of the gap. The largest
/// pressure is at least the mean one, also where samples miss it. For a flat
/// surface the model uses a tolerance of its own, a fraction of the node
/// spacing.
void FullBlockRun::set_tolerances(const contact::ContactSolution& solution) {
  const double largest_pressure =
      *std::max_element(solution.pressure.begin(), solution.pressure.end());
  if (solution.nominal_pressure > 0.0)
    asked_.load_tolerance =
        load_tolerance_of_block *
        std::max(1.0, largest_pressure / solution.nominal_pressure);
  const double scale = instance_.shape == Shape::flat ? grid_.spacing_x()
                                                      : surface_.height_scale;
  asked_.gap_tolerance = relative_tolerance * scale + load_tolerance_of_block *
                                                          range_.longest *
                                                          largest_pressure;
}

/// With free sides a node of the grid stands for two of the mesh, and fields
/// are their means; on meshes whose nodes are not those of the grid they are
/// samples.
std::optional<Failure>
FullBlockRun::verify(const mechanics::LoadTarget& target,
                     const contact::ContactSolution& solution) {
  if (!has_nodal_fields(instance_))
    return verify_samples(asked_, target, solution);
  std::optional<Failure> failure =
      verify_step(asked_, target, solution, displace_);
  if (!failure && is_laterally_uniform(instance_))
    failure =
        verify_observables(grid_, asked_, solution, instance_.contact_modulus);
  return failure;
}

bool FullBlockRun::run_step(const mechanics::LoadTarget& target) {
  const contact::ContactSolution solution = solved_by(*block_, target);
  report_.iterations += solution.iterations;
  if (!solution.converged)
    return end_without_solution(solution.note, target);
  set_tolerances(solution);
  std::optional<Failure> failure = verify(target, solution);
  if (!failure) {
    summaries_.push_back(summary_of(asked_, solution));
    if (instance_.relation == MetamorphicRelation::direct_solver) {
      const contact::ContactSolution expected = solved_by(*direct_, target);
      if (!expected.converged)
        return end_without_solution("direct solver: " + expected.note, target);
      // Adaptive meshes follow solutions of a loose tolerance, in which the two
      // solvers differ. On two meshes, the results differ by discretisation.
      if (block_->unknowns() == direct_->unknowns())
        failure = verify_direct(instance_, summaries_.back(),
                                summary_of(asked_, expected), report_);
    }
  }
  if (failure)
    fail(report_, *failure);
  return !failure;
}

void FullBlockRun::finish() {
  report_load_step(summaries_[load_step(instance_)], surface_.height_scale,
                   report_);
  if (!is_laterally_uniform(instance_) || !has_nodal_fields(instance_))
    return;
  if (const auto failure = verify_program(instance_, summaries_))
    fail(report_, *failure);
}

} // namespace

void run_full_block(const Instance& instance, InstanceReport& report) {
  FullBlockRun run(instance, report);
  for (const mechanics::LoadTarget& target :
       targets_of(instance, run.height_scale()))
    if (!run.run_step(target))
      return;
  run.finish();
}

} // namespace asperity::robustness
