#include "cases/reader/locking.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robustness/kinds.hpp"
#include "robustness/verify_observables.hpp"

namespace asperity::robustness {
namespace {

constexpr int max_iterations = 2000;

/// Unit ratios of the second runs of metamorphic pairs, for length and
/// pressure. The binary ones are powers of two, the decimal ones powers of ten.
constexpr double binary_length = 0x1p+20;
constexpr double binary_pressure = 0x1p-17;
constexpr double decimal_length = 1e-3;
constexpr double decimal_pressure = 1e6;

/// The results of one pass along the loading path.
struct Pass {
  std::vector<contact::ContactSolution> solutions;
  std::vector<StepSummary> summaries;
};

mechanics::ContactInterface interface_of(const Scene& scene, const Grid& grid) {
  const bool is_hard = scene.law == mechanics::ContactLaw::hard;
  return {scene.law,
          is_hard ? 0.0
                  : scene.penalty * scene.contact_modulus / grid.spacing_x()};
}

/// Runs one pass and applies every check to every step. The solutions are empty
/// if a check failed.
Pass run_pass(const Scene& scene, int threads, SceneReport& report) {
  const Grid grid = grid_of(scene);
  const SceneSurface surface = surface_of(scene, grid);
  std::unique_ptr<contact::SurfaceOperator> elasticity =
      operator_of(scene, grid, threads);
  const std::unique_ptr<contact::SurfaceOperator> judge = elasticity->clone();
  const Displace displace = [&](auto pressure, auto displacement) {
    judge->displacement(pressure, displacement);
  };
  const ComplianceRange range = compliance_range(grid, displace);
  AskedContact asked{surface.map.heights, judge->nodal_weights()};
  asked.gap_tolerance = relative_tolerance * surface.height_scale;
  asked.may_lose_contact = may_lose_contact(scene);
  if (!judge->is_periodic())
    asked.border = results::Border::free;
  asked.long_wave_compliance = range.longest;
  asked.short_wave_compliance = range.shortest;

  contact::LoadSequence sequence(std::move(elasticity), surface.map.heights,
                                 interface_of(scene, grid), asked.gap_tolerance,
                                 max_iterations);
  asked.local_compliance = sequence.local_compliance();
  Pass pass;
  for (const mechanics::LoadTarget& target :
       targets_of(scene, surface.height_scale)) {
    contact::ContactSolution solution = sequence.solve(target);
    report.iterations += solution.iterations;
    if (!solution.converged) {
      report.outcome = Outcome::gave_up;
      report.reason = solution.note;
      return {};
    }
    if (const auto failure = verify_step(asked, target, solution, displace)) {
      fail(report, *failure);
      return {};
    }
    if (const auto failure =
            verify_observables(grid, asked, solution, scene.contact_modulus)) {
      fail(report, *failure);
      return {};
    }
    if (const auto failure = verify_certificate(asked, solution, *judge)) {
      fail(report, *failure);
      return {};
    }
    pass.summaries.push_back(summary_of(asked, solution));
    pass.solutions.push_back(std::move(solution));
  }
  report_load_step(pass.summaries[load_step(scene)], surface.height_scale,
                   report);
  return pass;
}

bool is_scaled(const std::vector<double>& first,
               const std::vector<double>& second, double ratio) {
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [ratio](double a, double b) { return a * ratio == b; });
}

void compare(const Scene& scene, const Pass& first, const Pass& second,
             double length_ratio, double pressure_ratio, SceneReport& report) {
  report.has_twin = true;
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
    report.twin_difference = std::max(
        report.twin_difference,
        std::abs(b.mean_gap / length_ratio - a.mean_gap) / a.tolerance);
    if (auto failure = verify_same(a, b, length_ratio, pressure_ratio)) {
      failure->check = "twin";
      return fail(report, *failure);
    }
  }
  if (scene.twin == Twin::binary_units && !report.has_same_bits)
    fail(
        report,
        {"twin", "the bits differ when the units are scaled by powers of two"});
  if (scene.twin == Twin::threads && !report.has_same_bits)
    fail(report, {"twin", "the bits differ on several threads"});
}

void run_twin(const Scene& scene, const Pass& first, SceneReport& report) {
  Scene twin = scene;
  double length_ratio = 1.0;
  double pressure_ratio = 1.0;
  if (scene.twin == Twin::binary_units) {
    length_ratio = binary_length;
    pressure_ratio = binary_pressure;
  } else if (scene.twin == Twin::decimal_units) {
    length_ratio = decimal_length;
    pressure_ratio = decimal_pressure;
  }
  twin.length *= length_ratio;
  twin.contact_modulus *= pressure_ratio;
  const Pass second =
      run_pass(twin, scene.twin == Twin::threads ? scene.threads : 1, report);
  if (second.solutions.empty()) {
    report.reason = "second run of the pair: " + report.reason;
    return;
  }
  compare(scene, first, second, length_ratio, pressure_ratio, report);
}

} // namespace

bool may_lose_contact(const Scene& scene) {
  constexpr double plate = 0.05; // thickness [lengths]
  if (scene.family != Family::halfspace && scene.thickness < plate &&
      scene.top == mechanics::FarBoundary::pressure)
    return true;
  const bool is_block = scene.family == Family::full_block;
  if (!is_block && scene.family != Family::condensed_q1 &&
      scene.family != Family::condensed_q2)
    return false;
  const bool is_q2 =
      is_block ? scene.degree == 2 : scene.family == Family::condensed_q2;
  return scene.poisson_ratio >=
         cases::locking_ratio(is_q2 ? mechanics::Element::q2
                                    : mechanics::Element::q1);
}

fem::BlockRequest block_request(const Scene& scene, const Grid& grid,
                                int degree, int threads) {
  fem::BlockRequest request;
  request.grid = grid;
  request.settings.element =
      degree == 1 ? mechanics::Element::q1 : mechanics::Element::q2;
  request.settings.surface_cell_depth =
      std::min(1.0, 0.5 * scene.thickness * grid.points_x / degree);
  request.settings.growth = scene.growth;
  request.settings.depth = {scene.thickness, mechanics::ReferenceUnit::length};
  request.settings.far_boundary = scene.top;
  request.scales = {scene.contact_modulus, scene.length, grid.spacing_x(),
                    scene.rms_slope * grid.spacing_x()};
  request.youngs_modulus =
      scene.contact_modulus * (1.0 - scene.poisson_ratio * scene.poisson_ratio);
  request.poisson_ratio = scene.poisson_ratio;
  request.threads = threads;
  if (scene.coating_stiffness != 1.0)
    request.layers = {{{scene.coating_thickness * scene.thickness,
                        mechanics::ReferenceUnit::length},
                       {scene.coating_stiffness * request.youngs_modulus,
                        scene.poisson_ratio}}};
  return request;
}

std::unique_ptr<contact::SurfaceOperator>
operator_of(const Scene& scene, const Grid& grid, int threads) {
  if (scene.family == Family::condensed_q1 ||
      scene.family == Family::condensed_q2)
    return fem::load_fem_module().condensed(block_request(
        scene, grid, scene.family == Family::condensed_q1 ? 1 : 2, threads));
  if (scene.has_free_boundaries)
    return std::make_unique<contact::FreeHalfspace>(grid, scene.contact_modulus,
                                                    threads);
  mechanics::ElasticBlock block{scene.contact_modulus, scene.poisson_ratio,
                                std::numeric_limits<double>::infinity(),
                                scene.top};
  if (scene.family == Family::slab)
    block.thickness = scene.thickness * scene.length;
  return std::make_unique<contact::FourierOperator>(
      contact::halfspace_operator(grid, block, threads));
}

void run_elastic(const Scene& scene, SceneReport& report) {
  const Pass pass = run_pass(scene, 1, report);
  if (pass.solutions.empty())
    return;
  if (const auto failure = verify_program(scene, pass.summaries))
    return fail(report, *failure);
  if (scene.twin != Twin::none)
    run_twin(scene, pass, report);
}

} // namespace asperity::robustness
