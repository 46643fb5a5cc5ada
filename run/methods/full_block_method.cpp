#include "run/methods/full_block_method.hpp"

#include "results/observables/area_estimate.hpp"
#include "results/observables/row_observer.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/cache/file_mesh.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/continuum_block.hpp"
#include "run/methods/curve_row.hpp"
#include "run/methods/methods.hpp"
#include "run/methods/stress_section.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace asperity::methods {
namespace {

/// Takes the fields of the block.
contact::ContactSolution as_contact(fem::BlockSolution& block,
                                    const SurfaceOfCase& surface) {
  const std::vector<double>& heights = surface.record.heights;
  contact::ContactSolution solution;
  solution.displacement.resize(block.gap.size());
  for (std::size_t i = 0; i < block.gap.size(); ++i)
    solution.displacement[i] = block.gap[i] + heights[i] - block.mean_gap;
  solution.pressure = std::move(block.pressure);
  solution.gap = std::move(block.gap);
  solution.nominal_pressure = block.nominal_pressure;
  solution.mean_gap = block.mean_gap;
  solution.gap_error = block.residual * surface.scales.rms_height;
  solution.iterations = block.iterations;
  solution.converged = block.converged;
  solution.note = block.note;
  return solution;
}

/// The load steps with output in addition to a row and fields.
struct StepExtras {
  std::string files; ///< folder and file name stem
  std::set<std::size_t> with_files;
  std::optional<std::size_t> with_section;
  bool has_conduction = false;
};

StepExtras extras_of(const cases::Case& contact_case,
                     const cases::MethodSpec& method,
                     const SurfaceOfCase& surface,
                     const std::filesystem::path& scratch) {
  StepExtras extras;
  extras.files = (scratch / "block").string();
  if (contact_case.report.vtu)
    extras.with_files = steps_with_fields(contact_case);
  extras.with_section = step_with_section(contact_case, method, surface.scales);
  return extras;
}

class FullBlockSolver final : public StepSolver {
public:
  FullBlockSolver(std::unique_ptr<fem::FullBlock> block,
                  const cases::MethodSpec& method, const SurfaceOfCase& surface,
                  mechanics::ElasticBlock continuum, StepExtras extras,
                  const fem::BlockWatch& watch)
      : method_(method.name),
        border_(method.border()),
        criterion_(method.contact_criterion(surface.scales.rms_height)),
        settings_(std::get<mechanics::FemSettings>(method.settings)),
        surface_(surface),
        continuum_(std::move(continuum)),
        boundary_modulus_(boundary_modulus(continuum_, surface.scales.spacing)),
        block_(std::move(block)),
        contact_(fem::block_contact(settings_.contact, surface.scales)),
        extras_(std::move(extras)) {
    contact_.watch = watch;
  }

  StepAnswer find(const StepTarget& target) override {
    fem::BlockSolution solution =
        block_->solve(surface_.record.heights, target.load, contact_);
    const Reached reached = reached_by(solution);
    StepAnswer answer = observe(
        as_contact(solution, surface_),
        {block_->nodal_weights(), contact_.local_compliance(),
         area_coefficients(settings_), boundary_modulus_,
         solution.is_contact_on_grid, border_, criterion_, surface_.has_middle},
        surface_);
    results::CurvePoint& row = answer.row;
    answer.reached = reached;
    row.area_fraction = solution.area_by_points;
    row[columns::estimated_gap_error] = solution.estimated_gap_error;
    row.elastic_energy = solution.elastic_energy;
    row.contact_energy = solution.contact_energy;
    for (const auto& [column, number] : solution.of_material)
      results::curve_column(column).set(row, number);
    if (surface_.has_middle) {
      row[columns::pressure_centre.x] = solution.pressure_centre[0];
      row[columns::pressure_centre.y] = solution.pressure_centre[1];
    }
    if (!solution.is_contact_on_grid) // quadrature points between the nodes do
                                      // not resolve the contact boundary
      row.area_fraction_corrected = solution.area_by_points;
    row[columns::linear_iterations] = solution.linear_iterations;
    row[columns::preconditioner_setups] = solution.preconditioner_setups;
    row[columns::memory] = solution.memory;
    answer.row[columns::unknowns] = static_cast<double>(block_->unknowns());
    if (settings_.full.has_stiffness)
      find_stiffness(answer);
    if (extras_.has_conduction)
      find_conduction(answer);
    look_inside(static_cast<std::size_t>(target.step), answer);
    return answer;
  }

  std::string found_at_setup() const override {
    if (extras_.with_files.empty())
      return block_->report();
    const std::filesystem::path files = extras_.files;
    return block_->report() + "\nfiles for ParaView, beside this result: " +
           (files.parent_path().filename() / files.filename()).string() +
           ".pvd";
  }

  std::vector<double> state() const override { return block_->memory(); }

  bool restore(const std::vector<double>& state) override {
    return block_->recall(state);
  }

private:
  /// The residual bounds nodal forces and gaps, relative to the largest contact
  /// force and to the rms height.
  Reached reached_by(const fem::BlockSolution& solution) const {
    double strongest = std::abs(solution.nominal_pressure); // of samples too
    for (const double pressure : solution.pressure)
      strongest = std::max(strongest, pressure);
    const double height = surface_.scales.rms_height > 0.0
                              ? surface_.scales.rms_height
                              : surface_.scales.spacing;
    return {.nominal_pressure = solution.nominal_pressure,
            .mean_gap = solution.mean_gap,
            .imbalance = solution.residual * strongest,
            .pressure_tolerance = contact_.tolerance * strongest,
            .gap_tolerance = contact_.tolerance * height};
  }

  void find_stiffness(StepAnswer& answer) {
    const fem::ContactStiffness stiffness = block_->stiffness();
    answer.row[columns::linear_iterations] += stiffness.linear_iterations;
    if (!stiffness.converged) {
      answer.row.add_note("the stiffness of the contact did not converge");
      return;
    }
    answer.row[columns::normal_stiffness] = stiffness.normal;
    answer.row[columns::tangential_stiffness] = stiffness.tangential;
  }

  void find_conduction(StepAnswer& answer) {
    if (answer.row.status != results::StepStatus::converged)
      return;
    const fem::BlockConduction found = block_->conduction();
    answer.row[columns::linear_iterations] += found.linear_iterations;
    results::RowObserver(answer.row)(
        columns::relative_conductance, [&]() -> results::Observed {
          if (!found.converged)
            return {results::Observed::none,
                    "the linear solver of Laplace's equation did not converge"};
          if (std::isinf(found.relative))
            return {results::Observed::none, "all nodes are in contact"};
          return found.relative;
        });
  }

  void look_inside(std::size_t step, StepAnswer& answer) {
    const fem::StressPeak peak = block_->strongest_stress();
    answer.row[columns::von_mises] = peak.von_mises;
    answer.row[columns::von_mises_depth] = peak.depth;
    if (extras_.with_section == step)
      answer.section = stress_section(
          {method_, answer.row.nominal_pressure, peak,
           settings_.full.sides == mechanics::BlockSides::periodic,
           settings_.full.bodies == 2},
          *block_, continuum_);
    if (extras_.with_files.contains(step))
      block_->write(extras_.files);
  }

  std::string method_;
  mechanics::Border border_;
  mechanics::ContactCriterion criterion_;
  const mechanics::FemSettings& settings_;
  const SurfaceOfCase& surface_;
  mechanics::ElasticBlock continuum_; ///< provides thickness and layers
  double boundary_modulus_; ///< E* at the length scale of a grid spacing [Pa]
  std::unique_ptr<fem::FullBlock> block_;
  fem::BlockContact contact_;
  StepExtras extras_;
};

} // namespace

fem::FullRequest full_request(const cases::Case& contact_case,
                              const mechanics::FemSettings& settings,
                              const Grid& grid,
                              const mechanics::Scales& scales) {
  return {grid,
          settings.block,
          settings.full,
          contact_case.material,
          contact_case.mesh,
          scales};
}

std::unique_ptr<StepSolver> make_full_block_solver(
    const cases::Case& contact_case, const cases::MethodSpec& method,
    const SurfaceOfCase& surface, int realization, const Resources& resources) {
  const auto& settings = std::get<mechanics::FemSettings>(method.settings);
  const Grid& grid = surface.record.grid;
  fem::FullRequest request =
      full_request(contact_case, settings, grid, surface.scales);
  StepExtras extras;
  if (realization == 0)
    extras = extras_of(contact_case, method, surface, resources.scratch);
  extras.has_conduction = asks_conduction(contact_case, method);
  resources.root->act(
      [&] { request.file_mesh = file_mesh(contact_case, method, grid); });
  return std::make_unique<FullBlockSolver>(
      fem::load_fem_module().full(request), method, surface,
      continuum_of(method, contact_case.material, surface.scales),
      std::move(extras), resources.block_watch);
}

} // namespace asperity::methods
