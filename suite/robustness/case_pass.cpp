// Solves the load steps of a case by the library and verifies each of them.
#include "suite/robustness/case_pass.hpp"

#include "base/maximum.hpp"
#include "contact/solvers/adhesive.hpp"
#include "fem/plugin.hpp"
#include "input/reader/locking.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/continuum_block.hpp"
#include "run/methods/methods.hpp"
#include "suite/robustness/verify_adhesive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace asperity::robustness {
namespace {

using contact::ContactSolution;
using mechanics::FemSettings;
using mechanics::HalfspaceSettings;
using methods::StepAnswer;
using methods::SurfaceOfCase;

/// Unbalanced nodal forces relative to the largest nodal force: the tolerance
/// of the Newton method of the full 3-D model.
constexpr double load_tolerance_of_block = 1e-8;

/// The compliance C of the longest and of the shortest of the waves with 1, 2,
/// 4, ... periods along x [m/Pa].
struct ComplianceRange {
  double longest = 0.0;
  double shortest = std::numeric_limits<double>::infinity();
};

ComplianceRange compliance_range(const Grid& grid, const Displace& displace) {
  ComplianceRange range;
  std::vector<double> wave(grid.size());
  std::vector<double> answer(grid.size());
  for (int waves = 1; waves <= grid.points_x / 2; waves *= 2) {
    for (std::size_t i = 0; i < wave.size(); ++i)
      wave[i] = std::cos(2.0 * std::numbers::pi * waves *
                         static_cast<double>(i) / grid.points_x);
    displace(wave, answer);
    const double height = largest_magnitude(answer);
    range.longest = std::max(range.longest, height);
    range.shortest = std::min(range.shortest, height);
  }
  return range;
}

/// The smallest factor on Young's modulus at some thousand places.
double smallest_factor(const fem::ModuliField& moduli, const Grid& grid,
                       double depth) {
  constexpr int places = 16; // along each axis
  double smallest = 1.0;
  if (moduli.has_factor())
    for (int i = 0; i < places * places * places; ++i) {
      const int row = i / places % places, layer = i / (places * places);
      smallest = std::min(
          smallest, moduli.factor({(i % places + 0.5) / places * grid.length_x,
                                   (row + 0.5) / places * grid.length_y,
                                   (layer + 0.5) / places * depth}));
    }
  return smallest;
}

/// A bound of the compliance of a full block [m/Pa]: that of a half-space or of
/// a plate with a free back for the longest wave, and that of the uniform
/// pressure, the thickness over the modulus of uniaxial strain, all with the
/// softest moduli of the block.
double softest_compliance(const MethodOfCase& what, const Grid& grid) {
  const mechanics::MaterialSpec& material = what.contact_case.material;
  const auto& fem = std::get<FemSettings>(what.method.settings);
  const double nu = material.poisson_ratio.value_or(0.3);
  double youngs_modulus = material.block_youngs_modulus();
  if (fem.full.bodies == 2 && material.counter)
    youngs_modulus = std::min(material.first_body().youngs_modulus,
                              material.counter->youngs_modulus);
  for (const mechanics::MaterialLayer& layer : material.layers)
    youngs_modulus = std::min(youngs_modulus, layer.moduli.youngs_modulus);
  const mechanics::Scales scales{material.contact_modulus, grid.length_x,
                                 grid.spacing_x()};
  const double depth = fem.block.depth.in_si(scales);
  youngs_modulus *= smallest_factor(
      fem::moduli_field(material, scales,
                        fem::own_moduli(material, fem.full.bodies), grid,
                        depth),
      grid, depth);
  const double q = 2.0 * std::numbers::pi / grid.length_x;
  const double plane = youngs_modulus / (1.0 - nu * nu);
  const double uniaxial =
      youngs_modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  double wave = 2.0 / (plane * q);
  if (fem.block.far_boundary == mechanics::FarBoundary::pressure)
    wave += 12.0 / (plane * std::pow(depth, 3.0) * std::pow(q, 4.0));
  return std::max(wave, depth / uniaxial);
}

/// Whether a larger load may open contact: the block is a plate, thinner than
/// 1/20 length with a traction-free back, which bends over its asperities, its
/// moduli differ from cell to cell, or its elements are nearly incompressible
/// and lock.
bool may_lose_contact(const MethodOfCase& what, const Grid& grid) {
  constexpr double plate = 0.05; // thickness [lengths]
  const mechanics::ElasticBlock block =
      methods::continuum_of(what.method, what.contact_case.material,
                            {what.contact_case.material.contact_modulus,
                             grid.length_x, grid.spacing_x()});
  if (block.thickness < plate * grid.length_x &&
      block.far_boundary == mechanics::FarBoundary::pressure)
    return true;
  const auto* fem = std::get_if<FemSettings>(&what.method.settings);
  return fem != nullptr &&
         (what.contact_case.material.variation.has_value() ||
          what.contact_case.material.inclusion.has_value() ||
          what.contact_case.material.poisson_ratio.value_or(0.0) >=
              cases::locking_ratio(fem->block.element));
}

/// Verifies what samples must satisfy: finite values, no tension, and the
/// prescribed load or mean gap, which are sums over the contact points.
std::optional<Failure> verify_samples(const AskedContact& asked,
                                      const mechanics::LoadTarget& target,
                                      const ContactSolution& found) {
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

/// The atoms of a row: the mean of the residual forces is bounded by their root
/// mean square.
std::optional<Failure> verify_forces(const StepAnswer& answer, double asked,
                                     double tolerance) {
  double sum = 0.0;
  for (const double pressure : answer.pressure)
    sum += pressure;
  const double mean = sum / static_cast<double>(answer.pressure.size());
  if (std::abs(mean - asked) > 2.0 * tolerance * asked)
    return Failure{"balance",
                   "the mean pressure of the atoms differs from the load"};
  if (*std::ranges::min_element(answer.pressure) < 0.0)
    return Failure{
        "pressure sign",
        "an atom with a repulsive interaction carries a tensile force"};
  return {};
}

/// The method on one realisation.
class SurfacePass {
public:
  SurfacePass(const MethodOfCase& what, const PassSettings& settings,
              const methods::CaseSurfaces& surfaces,
              methods::MethodFactory& factory, int realization,
              InstanceReport& report);

  /// @return  whether to go on; otherwise the report says why not
  bool run(Pass& pass);

private:
  std::unique_ptr<methods::StepSolver>
  solver_of(const cases::MethodSpec& method);
  void ask();
  bool end_without_solution(const std::string& note,
                            const methods::StepTarget& target);
  ContactSolution solution_of(const StepAnswer& answer) const;
  void set_tolerances(const ContactSolution& solution);
  StepSummary summary(const ContactSolution& solution,
                      const StepAnswer& answer) const;
  std::optional<Failure> verify(const mechanics::LoadTarget& target,
                                const StepAnswer& answer,
                                const ContactSolution& solution);
  std::optional<Failure>
  verify_steps(const std::vector<StepSummary>& steps) const;

  bool has_operator() const {
    return what_.method.contact() != nullptr &&
           !methods::is_full_block(what_.method);
  }

  const MethodOfCase& what_;
  const PassSettings& settings_;
  const SurfaceOfCase& surface_;
  methods::MethodFactory& factory_;
  int realization_;
  InstanceReport& report_;
  RootWork alone_;
  std::unique_ptr<contact::SurfaceOperator> elasticity_; ///< independent
  Displace displace_;
  ComplianceRange range_;
  AskedContact asked_;
  std::optional<AdhesiveCheck> adhesive_;
};

SurfacePass::SurfacePass(const MethodOfCase& what, const PassSettings& settings,
                         const methods::CaseSurfaces& surfaces,
                         methods::MethodFactory& factory, int realization,
                         InstanceReport& report)
    : what_(what),
      settings_(settings),
      surface_(surfaces.of(what.method, realization)),
      factory_(factory),
      realization_(realization),
      report_(report),
      asked_{.heights = surface_.record.heights, .weights = {}} {
  ask();
}

std::unique_ptr<methods::StepSolver>
SurfacePass::solver_of(const cases::MethodSpec& method) {
  methods::Resources resources;
  resources.threads = settings_.threads;
  resources.root = &alone_;
  return factory_.make(method, surface_, realization_, resources);
}

/// What the steps are verified against.
void SurfacePass::ask() {
  const Grid& grid = surface_.record.grid;
  const auto* contact = what_.method.contact();
  if (contact == nullptr)
    return;
  asked_.may_lose_contact = may_lose_contact(what_, grid);
  const mechanics::ContactInterface law = contact->in_si(surface_.scales);
  asked_.local_compliance = law.local_compliance();
  asked_.border = what_.method.border();
  asked_.gap_tolerance = contact->tolerance * surface_.scales.rms_height;
  if (!has_operator()) {
    asked_.long_wave_compliance = softest_compliance(what_, grid);
    asked_.load_tolerance = load_tolerance_of_block;
    return;
  }
  elasticity_ = factory_.operator_of(what_.method, surface_, settings_.threads);
  displace_ = [this](auto pressure, auto displacement) {
    elasticity_->displacement(pressure, displacement);
  };
  asked_.weights = elasticity_->nodal_weights();
  range_ = compliance_range(grid, displace_);
  asked_.long_wave_compliance = range_.longest;
  asked_.short_wave_compliance = range_.shortest;
  if (!what_.method.is_adhesive())
    return;
  cases::MethodSpec periodic = what_.method;
  if (auto* half = std::get_if<HalfspaceSettings>(&periodic.settings))
    half->has_free_boundaries = false;
  methods::MethodFactory other(what_.contact_case);
  const double scale = contact::adhesive_scale(
      *other.operator_of(periodic, surface_, settings_.threads),
      surface_.record.heights);
  adhesive_.emplace(*elasticity_, surface_.record.heights, law,
                    AdhesiveScales{scale, asked_.gap_tolerance,
                                   surface_.scales.contact_modulus});
}

/// The displacement follows from the gap, up to its mean, which only free
/// boundaries have.
ContactSolution SurfacePass::solution_of(const StepAnswer& answer) const {
  ContactSolution solution;
  solution.pressure = answer.pressure;
  solution.gap = answer.gap;
  solution.nominal_pressure = answer.row.nominal_pressure;
  solution.mean_gap = answer.row.mean_gap;
  solution.smallest_stiffness = answer.row[columns::smallest_stiffness];
  solution.is_detached = answer.reached.is_detached;
  if (answer.gap.size() != asked_.heights.size())
    return solution; // of atoms
  double mean = answer.row.mean_gap +
                results::weighted_mean(asked_.heights, asked_.weights);
  if (asked_.border == results::Border::free &&
      std::isfinite(answer.row[columns::mean_displacement]))
    mean -= answer.row[columns::mean_displacement];
  for (std::size_t i = 0; i < answer.gap.size(); ++i)
    solution.displacement.push_back(answer.gap[i] + asked_.heights[i] - mean);
  return solution;
}

/// Each nodal force of a full block is known to a fraction of the largest one,
/// so that the mean pressure is known to this fraction of the largest pressure.
/// Through the compliance C it contributes to the tolerance of the gap. The
/// largest pressure is at least the mean one, also where samples miss it.
void SurfacePass::set_tolerances(const ContactSolution& solution) {
  const double strongest =
      std::max(largest_magnitude(solution.pressure), solution.nominal_pressure);
  if (solution.nominal_pressure > 0.0)
    asked_.load_tolerance =
        load_tolerance_of_block * strongest / solution.nominal_pressure;
  asked_.gap_tolerance =
      what_.method.contact()->tolerance * surface_.scales.rms_height +
      load_tolerance_of_block * asked_.long_wave_compliance * strongest;
}

StepSummary SurfacePass::summary(const ContactSolution& solution,
                                 const StepAnswer& answer) const {
  StepSummary step;
  if (has_operator()) {
    step = summary_of(asked_, solution);
  } else {
    step.nominal_pressure = answer.row.nominal_pressure;
    step.mean_gap = step.separation = answer.row.mean_gap;
    step.area = answer.row.area_fraction;
    step.may_lose_contact = true; // the area is one of points or atoms
    step.tolerance = allowed_gap(asked_, solution);
  }
  if (const auto* md =
          std::get_if<mechanics::MdSettings>(&what_.method.settings))
    // Residual forces displace the longest wave most, by L/(pi E*) per unit of
    // pressure.
    step.tolerance = md->tolerance *
                     (md->contact_distance +
                      step.nominal_pressure * surface_.scales.length /
                          (std::numbers::pi * surface_.scales.contact_modulus));
  step.energy = answer.row.elastic_energy + answer.row.contact_energy;
  return step;
}

std::optional<Failure> SurfacePass::verify(const mechanics::LoadTarget& target,
                                           const StepAnswer& answer,
                                           const ContactSolution& solution) {
  if (auto failure = verify_row(answer.row))
    return failure;
  if (const auto* md =
          std::get_if<mechanics::MdSettings>(&what_.method.settings))
    return verify_forces(answer, target.amount, md->tolerance);
  if (adhesive_)
    return adhesive_->verify(target, solution);
  if (!has_operator()) {
    auto failure = verify_samples(asked_, target, solution);
    return failure || !has_nodal_fields(what_)
               ? failure
               : verify_contact(asked_, solution);
  }
  if (auto failure = verify_step(asked_, target, solution, displace_))
    return failure;
  // For a uniform pressure the displacement consists of rounding only.
  if (answer.row.elastic_energy <
      -largest_magnitude(solution.pressure) * gap_rounding(asked_, solution))
    return Failure{"observables", fmt::format("elastic_energy = {:.6g}",
                                              answer.row.elastic_energy)};
  return verify_certificate(asked_, solution, *elasticity_);
}

bool SurfacePass::end_without_solution(const std::string& note,
                                       const methods::StepTarget& target) {
  report_.reason = note;
  report_.outcome =
      outcome_of_note(report_.reason, [&]() -> std::optional<std::string> {
        if (settings_.direct == nullptr)
          return "is not available";
        const StepAnswer direct = solver_of(*settings_.direct)->solve(target);
        if (direct.row.status == results::StepStatus::converged)
          return {};
        return direct.row.note;
      });
  return false;
}

/// Verifies all pairs of consecutive steps, and equal loads of a cycle.
std::optional<Failure>
SurfacePass::verify_steps(const std::vector<StepSummary>& steps) const {
  if (what_.method.is_adhesive() || !is_laterally_uniform(what_) ||
      !has_nodal_fields(what_))
    return {};
  for (std::size_t i = 1; i < steps.size(); ++i)
    if (auto failure = verify_pair(steps[i - 1], steps[i]))
      return failure;
  const std::vector<bool>& is_unloading = what_.contact_case.load.is_unloading;
  const mechanics::LoadingPath& load = what_.contact_case.load;
  const std::size_t n = is_unloading.size();
  for (std::size_t i = 0; i < n / 2; ++i)
    if (n % 2 == 1 && load.targets[i].value == load.targets[n - 1 - i].value)
      if (auto failure = verify_same(steps[i], steps[n - 1 - i])) {
        failure->check = "cycle";
        return failure;
      }
  return {};
}

bool SurfacePass::run(Pass& pass) {
  const std::unique_ptr<methods::StepSolver> solver = solver_of(what_.method);
  const mechanics::LoadingPath& load = what_.contact_case.load;
  std::vector<StepSummary> steps;
  for (std::size_t i = 0; i < load.targets.size(); ++i) {
    const methods::StepTarget target{load.target(i, surface_.scales),
                                     static_cast<int>(i)};
    StepAnswer answer = solver->solve(target);
    report_.iterations += answer.row.iterations;
    if (answer.row.status != results::StepStatus::converged)
      return end_without_solution(answer.row.note, target);
    const ContactSolution solution = solution_of(answer);
    if (methods::is_full_block(what_.method))
      set_tolerances(solution);
    if (const auto failure = verify(target.load, answer, solution)) {
      fail(report_, *failure);
      return false;
    }
    steps.push_back(summary(solution, answer));
    pass.unknowns.push_back(answer.row[columns::unknowns]);
    pass.pressures.push_back(std::move(answer.pressure));
    pass.gaps.push_back(std::move(answer.gap));
  }
  pass.steps.insert(pass.steps.end(), steps.begin(), steps.end());
  if (realization_ == 0) {
    const StepSummary& asked = steps[steps.size() / 2];
    report_.area = asked.area;
    report_.gap_scale = surface_.scales.rms_height;
    report_.reduced_gap = asked.mean_gap / surface_.scales.rms_height;
    report_.reduced_tolerance = asked.tolerance / surface_.scales.rms_height;
  }
  const auto failure = verify_steps(steps);
  if (failure)
    fail(report_, *failure);
  return !failure;
}

} // namespace

bool is_laterally_uniform(const MethodOfCase& what) {
  const auto* fem = std::get_if<FemSettings>(&what.method.settings);
  const mechanics::MaterialSpec& material = what.contact_case.material;
  return fem == nullptr || fem->solver != mechanics::FemSolver::full ||
         (!fem->has_free_sides() && !material.variation &&
          !material.inclusion && !fem->full.yield_stress);
}

bool has_nodal_fields(const MethodOfCase& what) {
  using mechanics::MeshKind;
  if (!methods::is_full_block(what.method))
    return true;
  const auto& fem = std::get<FemSettings>(what.method.settings);
  const MeshKind kind = what.contact_case.mesh.kind;
  return !fem.has_free_sides() && fem.full.bodies == 1 &&
         (!fem.full.uses_case_mesh || kind == MeshKind::layers ||
          kind == MeshKind::hanging);
}

void fail(InstanceReport& report, const Failure& failure) {
  report.outcome = Outcome::check_failed;
  report.check = failure.check;
  report.reason = failure.detail;
}

Pass run_pass(const MethodOfCase& what, const PassSettings& settings,
              InstanceReport& report) {
  const std::vector<cases::MethodSpec> only{what.method};
  const methods::CaseSurfaces surfaces(what.contact_case, only);
  methods::MethodFactory factory(what.contact_case);
  Pass pass;
  for (const int r :
       methods::realizations_of(what.contact_case, what.method, {}))
    if (!SurfacePass(what, settings, surfaces, factory, r, report).run(pass))
      return {};
  return pass;
}

} // namespace asperity::robustness
