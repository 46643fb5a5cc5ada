// Runs a half-space, slab or condensed block whose faces attract each other,
// and verifies that each state is a minimum of the energy.
#include "base/field_sums.hpp"
#include "contact/solvers/adhesive.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "robustness/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::robustness {
namespace {

using contact::ContactSolution;
using mechanics::ContactInterface;
using mechanics::LoadTarget;

constexpr int most_iterations = 5000;
constexpr double adhesive_rounding =
    1e-12; ///< of sums and transforms, relative

double mean(std::span<const double> field) {
  return results::weighted_mean(field, {});
}

/// The problem of an instance, and what its states are verified by.
struct AdhesiveRun {
  Grid grid;
  InstanceSurface surface;
  std::unique_ptr<contact::SurfaceOperator> elasticity;
  ContactInterface law;
  double scale = 0.0;           ///< k_c [Pa/m] of periodic boundaries
  double contact_modulus = 0.0; ///< E* [Pa]

  double gap_tolerance() const {
    return relative_tolerance * surface.height_scale;
  }

  /// <p u>/2 + <W(g)> + p_0 d [J/m^2], with the displacement u and the distance
  /// d of the mean planes far away.
  double energy(const ContactSolution& state, double nominal) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < state.gap.size(); ++i)
      sum += 0.5 * state.pressure[i] * state.displacement[i] +
             law.energy(state.gap[i]) +
             nominal * (state.gap[i] + surface.map.heights[i] -
                        state.displacement[i]);
    return sum / static_cast<double>(state.gap.size());
  }

  bool has_wall() const { return mechanics::has_wall(law.law); }

  /// Nodes of the grid on which the problem is solved.
  double solved_nodes() const {
    return (elasticity->is_periodic() ? 1.0 : 4.0) *
           static_cast<double>(grid.size());
  }

  /// Bound of the pressures that are left outside free boundaries, the root of
  /// the sum of their squares over the nodes [Pa].
  double pressure_left() const {
    return elasticity->is_periodic()
               ? 0.0
               : gap_tolerance() * stiffest() * std::sqrt(solved_nodes());
  }

  /// Bound of the error of energy() [J/m^2] by the pressures e that the solver
  /// leaves outside free boundaries. With the compliance C of the wide grid and
  /// the pressure p inside, the surface is d + C (p + e) and the energy that no
  /// iteration raises has <(p + e) C (p + e)>/2 + p_0 d in place of
  /// <p C p>/2 + p_0 <d + C e>. They differ by <(p_0 - p) C e> - <e C e>/2,
  /// which Cauchy-Schwarz bounds. The norm of e over the nodes is at most
  /// pressure_left(), and that of C at most the displacement in the middle of a
  /// uniformly pressed square of side 2 L, 8 ln(1 + sqrt 2)/pi L/E*.
  double energy_left(const ContactSolution& state, double nominal) const {
    const double left = pressure_left();
    const double softness = 8.0 * std::numbers::inv_pi *
                            std::log(1.0 + std::numbers::sqrt2) *
                            grid.length_x / contact_modulus;
    double square = 0.0;
    for (const double pressure : state.pressure)
      square += (nominal - pressure) * (nominal - pressure);
    return left * softness * (std::sqrt(square) + 0.5 * left) /
           static_cast<double>(state.pressure.size());
  }

  /// Largest stiffness of the elastic surface on the grid, and k_c. The
  /// shortest waves are 2 sqrt 2 times as short as those of the compliance
  /// [Pa/m].
  double stiffest() const {
    return 2.0 * std::numbers::sqrt2 / elasticity->short_wave_compliance() +
           scale;
  }
};

AdhesiveRun adhesive_run(const Instance& instance, int threads) {
  AdhesiveRun run;
  run.grid = grid_of(instance);
  run.contact_modulus = instance.contact_modulus;
  run.surface = surface_of(instance, run.grid);
  run.elasticity = operator_of(instance, run.grid, threads);
  Instance periodic = instance;
  periodic.has_free_boundaries = false;
  run.scale = contact::adhesive_scale(*operator_of(periodic, run.grid, threads),
                                      run.surface.map.heights);
  const double height = run.surface.height_scale;
  run.law = mechanics::ContactSettings{.law = instance.law,
                                       .work_of_adhesion = instance.adhesion *
                                                           0.5 * run.scale *
                                                           height * height}
                .in_si({.contact_modulus = instance.contact_modulus,
                        .spacing = run.grid.spacing_x()});
  run.law.adhesion_range *=
      std::sqrt(mechanics::accurate_grid_number / instance.grid_number);
  return run;
}

/// The path of the instance, and beyond a load to a tension at which no node
/// can hold the block.
std::vector<LoadTarget> adhesive_targets(const Instance& instance,
                                         const AdhesiveRun& run) {
  std::vector<LoadTarget> targets =
      targets_of(instance, run.surface.height_scale);
  for (LoadTarget& target : targets)
    target.spring = instance.spring * run.scale;
  if (instance.control == mechanics::Control::nominal_pressure) {
    const double tension = run.law.pressure_bounds().smallest;
    for (const double share : {0.0, 0.01, 1.01})
      targets.push_back({instance.control, share * tension});
  }
  return targets;
}

std::optional<Failure> verify_law(const AdhesiveRun& run,
                                  const LoadTarget& target,
                                  const ContactSolution& found) {
  // The rms of M r is at most the tolerance, and M at least S (K + k_c)^-1 S
  // with S = (1 + W''/k_c)^-1/2 in the repulsion of a law without a wall.
  // A spring adds its stiffness to the mean.
  const double spring = std::isfinite(target.spring) ? target.spring : 0.0;
  double repulsion = 0.0;
  for (const double gap : found.gap)
    if (!run.has_wall())
      repulsion = std::max(repulsion, run.law.stiffness(gap));
  const double allowed =
      run.gap_tolerance() * (run.stiffest() + spring) *
          (1.0 + repulsion / run.scale) * std::sqrt(run.solved_nodes()) +
      adhesive_rounding *
          (largest(found.pressure) - run.law.pressure_bounds().smallest);
  for (std::size_t i = 0; i < found.gap.size(); ++i) {
    const double gap = found.gap[i];
    const double off = found.pressure[i] - run.law.pressure(gap);
    if (run.has_wall() && gap < 0.0)
      return Failure{"wall", fmt::format("a gap of {:.3g} m", gap)};
    if (off < -allowed || ((gap > 0.0 || !run.has_wall()) && off > allowed))
      return Failure{"law",
                     fmt::format("at the gap {:.3g} m, p differs from -W' by "
                                 "{:.3g} Pa, allowed {:.3g} Pa",
                                 gap, off, allowed)};
  }
  return {};
}

std::optional<Failure> verify_fields(const AdhesiveRun& run,
                                     const LoadTarget& target,
                                     const ContactSolution& found) {
  if (!all_finite(found.pressure) || !all_finite(found.gap))
    return Failure{"finite", "a field holds a number that is not finite"};
  const bool by_pressure =
      target.control == mechanics::Control::nominal_pressure;
  const double asked = found.is_detached ? 0.0
                       : by_pressure     ? target.amount
                                         : found.nominal_pressure;
  const double nominal = mean(found.pressure);
  const double left = run.pressure_left();
  if (std::abs(nominal - asked) >
      adhesive_rounding * largest(found.pressure) + left)
    return Failure{"balance",
                   fmt::format("mean pressure {:.17g} Pa instead of {:.17g} Pa",
                               nominal, asked)};
  const double asked_gap = target.amount + nominal / target.spring;
  if (!by_pressure &&
      std::abs(mean(found.gap) - asked_gap) >
          adhesive_rounding * (target.amount + largest(found.gap) +
                               largest(found.pressure) / target.spring))
    return Failure{"balance", fmt::format("mean gap {:.17g} m instead of "
                                          "{:.17g} m",
                                          mean(found.gap), asked_gap)};
  std::vector<double> displacement(found.gap.size());
  run.elasticity->displacement(found.pressure, displacement);
  const std::vector<double>& heights = run.surface.map.heights;
  const double level = mean(found.gap) + mean(heights) - mean(displacement);
  const double allowed =
      adhesive_rounding * (largest(found.gap) + largest(heights) +
                           largest(found.pressure) / run.scale) +
      left * run.grid.length_x / run.contact_modulus;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double off = found.gap[i] + heights[i] - level - displacement[i];
    if (std::abs(off) > allowed)
      return Failure{"gap field", fmt::format("C p differs from the gap by "
                                              "{:.3g} m, allowed {:.3g} m",
                                              off, allowed)};
  }
  return {};
}

/// Whether the state is a minimum, and below the state where the solver began
/// under the same load.
std::optional<Failure> verify_minimum(const AdhesiveRun& run,
                                      const LoadTarget& target,
                                      const ContactSolution& found,
                                      const ContactSolution* begun) {
  if (found.smallest_stiffness < -1e-3 * run.scale)
    return Failure{"minimum",
                   fmt::format("the smallest eigenvalue of the Hessian is "
                               "{:.3g} Pa/m",
                               found.smallest_stiffness)};
  if (begun == nullptr || target.control == mechanics::Control::mean_gap)
    return {};
  const double before = run.energy(*begun, target.amount);
  const double after = run.energy(found, target.amount);
  const double allowed =
      1e-10 * (std::abs(before) + std::abs(after) + run.law.work_of_adhesion) +
      run.energy_left(*begun, target.amount) +
      run.energy_left(found, target.amount);
  if (after > before + allowed)
    return Failure{"energy", fmt::format("rises by {:.3g} J/m^2, allowed "
                                         "{:.3g} J/m^2",
                                         after - before, allowed)};
  return {};
}

std::optional<Failure> verify_adhesive(const AdhesiveRun& run,
                                       const LoadTarget& target,
                                       const ContactSolution& found,
                                       const ContactSolution* begun) {
  if (auto failure = verify_fields(run, target, found))
    return failure;
  if (found.is_detached) {
    if (target.amount <= 0.0)
      return {};
    return Failure{"detached", "under a load that presses"};
  }
  if (target.control == mechanics::Control::nominal_pressure &&
      target.amount < run.law.pressure_bounds().smallest)
    return Failure{"detached", "a tension beyond the law is held"};
  if (auto failure = verify_law(run, target, found))
    return failure;
  return verify_minimum(run, target, found, begun);
}

std::vector<ContactSolution>
adhesive_pass(const Instance& instance, int threads, InstanceReport& report) {
  const AdhesiveRun run = adhesive_run(instance, threads);
  contact::LoadSequence sequence(run.elasticity->clone(),
                                 run.surface.map.heights, run.law,
                                 run.gap_tolerance(), most_iterations);
  std::vector<ContactSolution> found;
  for (const LoadTarget& target : adhesive_targets(instance, run)) {
    ContactSolution solution = sequence.solve(target);
    report.iterations += solution.iterations;
    if (!solution.converged) {
      report.outcome = Outcome::not_converged;
      report.reason = solution.note;
      return {};
    }
    const ContactSolution* const begun =
        found.empty() || found.back().is_detached ? nullptr : &found.back();
    if (const auto failure = verify_adhesive(run, target, solution, begun)) {
      fail(report, *failure);
      return {};
    }
    found.push_back(std::move(solution));
  }
  const ContactSolution& asked = found[load_step(instance)];
  report.area = static_cast<double>(std::ranges::count_if(
                    asked.gap, [](double gap) { return gap <= 0.0; })) /
                static_cast<double>(asked.gap.size());
  report.reduced_gap = asked.mean_gap / run.surface.height_scale;
  return found;
}

} // namespace

void run_adhesive(const Instance& instance, InstanceReport& report) {
  const std::vector<ContactSolution> first = adhesive_pass(instance, 1, report);
  const bool by_units = instance.relation == MetamorphicRelation::binary_units;
  if (first.empty() ||
      (!by_units && instance.relation != MetamorphicRelation::threads))
    return;
  Instance pair = instance;
  const double length = by_units ? binary_length : 1.0;
  const double pressure = by_units ? binary_pressure : 1.0;
  pair.length *= length;
  pair.contact_modulus *= pressure;
  const std::vector<ContactSolution> second =
      adhesive_pass(pair, by_units ? 1 : instance.threads, report);
  if (second.empty()) {
    report.reason = "second run of the pair: " + report.reason;
    return;
  }
  report.has_pair = report.has_same_bits = true;
  for (std::size_t i = 0; i < first.size(); ++i)
    report.has_same_bits =
        report.has_same_bits &&
        is_scaled(first[i].pressure, second[i].pressure, pressure) &&
        is_scaled(first[i].gap, second[i].gap, length);
  if (!report.has_same_bits)
    fail(report, {"metamorphic pair", "the bits of both runs differ"});
}

} // namespace asperity::robustness
