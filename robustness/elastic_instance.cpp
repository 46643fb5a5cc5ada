#include "cases/reader/locking.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "robustness/kinds.hpp"
#include "robustness/verify_observables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity::robustness {
namespace {

constexpr int max_iterations = 2000;

/// The results of one pass along the loading path.
struct Pass {
  std::vector<contact::ContactSolution> solutions;
  std::vector<StepSummary> summaries;
};

mechanics::ContactInterface interface_of(const Instance& instance,
                                         const Grid& grid) {
  const double penalty =
      instance.penalty * instance.contact_modulus / grid.spacing_x();
  return {instance.law, mechanics::needs_penalty(instance.law) ? penalty : 0.0};
}

/// Runs one pass and applies every check to every step. The solutions are empty
/// if a check failed.
Pass run_pass(const Instance& instance, int threads, InstanceReport& report) {
  const Grid grid = grid_of(instance);
  const InstanceSurface surface = surface_of(instance, grid);
  std::unique_ptr<contact::SurfaceOperator> elasticity =
      operator_of(instance, grid, threads);
  const std::unique_ptr<contact::SurfaceOperator> independent =
      elasticity->clone();
  const Displace displace = [&](auto pressure, auto displacement) {
    independent->displacement(pressure, displacement);
  };
  const ComplianceRange range = compliance_range(grid, displace);
  AskedContact asked{surface.map.heights, independent->nodal_weights()};
  asked.gap_tolerance = relative_tolerance * surface.height_scale;
  asked.may_lose_contact = may_lose_contact(instance);
  if (!independent->is_periodic())
    asked.border = results::Border::free;
  asked.long_wave_compliance = range.longest;
  asked.short_wave_compliance = range.shortest;

  contact::LoadSequence sequence(std::move(elasticity), surface.map.heights,
                                 interface_of(instance, grid),
                                 asked.gap_tolerance, max_iterations);
  asked.local_compliance = sequence.local_compliance();
  Pass pass;
  for (const mechanics::LoadTarget& target :
       targets_of(instance, surface.height_scale)) {
    contact::ContactSolution solution = sequence.solve(target);
    report.iterations += solution.iterations;
    if (!solution.converged) {
      report.outcome = Outcome::not_converged;
      report.reason = solution.note;
      return {};
    }
    if (const auto failure = verify_step(asked, target, solution, displace)) {
      fail(report, *failure);
      return {};
    }
    if (const auto failure = verify_observables(grid, asked, solution,
                                                instance.contact_modulus)) {
      fail(report, *failure);
      return {};
    }
    if (const auto failure =
            verify_certificate(asked, solution, *independent)) {
      fail(report, *failure);
      return {};
    }
    pass.summaries.push_back(summary_of(asked, solution));
    pass.solutions.push_back(std::move(solution));
  }
  report_load_step(pass.summaries[load_step(instance)], surface.height_scale,
                   report);
  return pass;
}

void compare(const Instance& instance, const Pass& first, const Pass& second,
             double length_ratio, double pressure_ratio,
             InstanceReport& report) {
  report.has_pair = true;
  report.has_same_bits = true;
  for (std::size_t i = 0; i < first.solutions.size(); ++i) {
    const StepSummary& a = first.summaries[i];
    const StepSummary& b = second.summaries[i];
    report.has_same_bits =
        report.has_same_bits &&
        is_scaled(first.solutions[i].pressure, second.solutions[i].pressure,
                  pressure_ratio) &&
        is_scaled(first.solutions[i].gap, second.solutions[i].gap,
                  length_ratio);
    report.pair_difference = std::max(
        report.pair_difference,
        std::abs(b.mean_gap / length_ratio - a.mean_gap) / a.tolerance);
    if (auto failure = verify_same(a, b, length_ratio, pressure_ratio)) {
      failure->check = "metamorphic pair";
      return fail(report, *failure);
    }
  }
  if (instance.relation == MetamorphicRelation::binary_units &&
      !report.has_same_bits)
    fail(report,
         {"metamorphic pair",
          "the bits differ when the units are scaled by powers of two"});
  if (instance.relation == MetamorphicRelation::threads &&
      !report.has_same_bits)
    fail(report, {"metamorphic pair", "the bits differ on several threads"});
}

void run_pair(const Instance& instance, const Pass& first,
              InstanceReport& report) {
  Instance pair = instance;
  double length_ratio = 1.0;
  double pressure_ratio = 1.0;
  if (instance.relation == MetamorphicRelation::binary_units) {
    length_ratio = binary_length;
    pressure_ratio = binary_pressure;
  } else if (instance.relation == MetamorphicRelation::decimal_units) {
    length_ratio = decimal_length;
    pressure_ratio = decimal_pressure;
  }
  pair.length *= length_ratio;
  pair.contact_modulus *= pressure_ratio;
  const Pass second = run_pass(
      pair,
      instance.relation == MetamorphicRelation::threads ? instance.threads : 1,
      report);
  if (second.solutions.empty()) {
    report.reason = "second run of the pair: " + report.reason;
    return;
  }
  compare(instance, first, second, length_ratio, pressure_ratio, report);
}

} // namespace

bool is_scaled(std::span<const double> first, std::span<const double> second,
               double ratio) {
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [ratio](double a, double b) { return a * ratio == b; });
}

bool may_lose_contact(const Instance& instance) {
  constexpr double plate = 0.05; // thickness [lengths]
  if (instance.family != Family::halfspace && instance.thickness < plate &&
      instance.far_boundary == mechanics::FarBoundary::pressure)
    return true;
  const bool is_block = instance.family == Family::full_block;
  if (is_block && instance.modulus_ratio != 1.0)
    return true;
  if (!is_block && instance.family != Family::condensed_q1 &&
      instance.family != Family::condensed_q2)
    return false;
  const bool is_q2 =
      is_block ? instance.degree == 2 : instance.family == Family::condensed_q2;
  return instance.poisson_ratio >=
         cases::locking_ratio(is_q2 ? mechanics::Element::q2
                                    : mechanics::Element::q1);
}

fem::BlockRequest block_request(const Instance& instance, const Grid& grid,
                                int degree, int threads) {
  fem::BlockRequest request;
  request.grid = grid;
  request.settings.element =
      degree == 1 ? mechanics::Element::q1 : mechanics::Element::q2;
  request.settings.surface_cell_depth =
      std::min(1.0, 0.5 * instance.thickness * grid.points_x / degree);
  request.settings.growth = instance.growth;
  request.settings.depth = {instance.thickness,
                            mechanics::ReferenceUnit::length};
  request.settings.far_boundary = instance.far_boundary;
  request.scales = {instance.contact_modulus, instance.length, grid.spacing_x(),
                    instance.rms_slope * grid.spacing_x()};
  request.youngs_modulus =
      instance.contact_modulus *
      (1.0 - instance.poisson_ratio * instance.poisson_ratio);
  request.poisson_ratio = instance.poisson_ratio;
  request.threads = threads;
  if (instance.coating_stiffness != 1.0)
    request.layers = {{{instance.coating_thickness * instance.thickness,
                        mechanics::ReferenceUnit::length},
                       {instance.coating_stiffness * request.youngs_modulus,
                        instance.poisson_ratio}}};
  return request;
}

std::unique_ptr<contact::SurfaceOperator>
operator_of(const Instance& instance, const Grid& grid, int threads) {
  if (instance.family == Family::condensed_q1 ||
      instance.family == Family::condensed_q2)
    return fem::load_fem_module().condensed(block_request(
        instance, grid, instance.family == Family::condensed_q1 ? 1 : 2,
        threads));
  if (instance.has_free_boundaries)
    return std::make_unique<contact::FreeHalfspace>(
        grid, instance.contact_modulus, threads);
  mechanics::ElasticBlock block{
      instance.contact_modulus, instance.poisson_ratio,
      std::numeric_limits<double>::infinity(), instance.far_boundary};
  if (instance.family == Family::slab)
    block.thickness = instance.thickness * instance.length;
  return std::make_unique<contact::FourierOperator>(
      contact::halfspace_operator(grid, block, threads));
}

void run_elastic(const Instance& instance, InstanceReport& report) {
  const Pass pass = run_pass(instance, 1, report);
  if (pass.solutions.empty())
    return;
  if (const auto failure = verify_program(instance, pass.summaries))
    return fail(report, *failure);
  if (instance.relation != MetamorphicRelation::none)
    run_pair(instance, pass, report);
}

} // namespace asperity::robustness
