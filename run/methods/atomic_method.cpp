#include "run/methods/atomic_method.hpp"

#include "input/input_error.hpp"
#include "md/engines.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/curve_row.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace asperity::methods {
namespace {

using mechanics::MdSettings;

Grid square(int points, double length) {
  return {points, points, length, length};
}

double square_length(const AtomisticInput& atomistic) {
  const Grid& grid = atomistic.surface.record.grid;
  if (grid.length_x != grid.length_y)
    throw input::InputError(fmt::format(
        "{}: [{}] needs a square surface, but this one is {:g} m by {:g} m",
        atomistic.contact_case.path, atomistic.method.name, grid.length_x,
        grid.length_y));
  return grid.length_x;
}

/// Returns the heights of the rigid atoms. They sample the same surface that
/// the other methods use, at the lattice sites of the substrate.
std::vector<double> substrate_heights(const AtomisticInput& atomistic,
                                      const Grid& substrate) {
  if (substrate == atomistic.surface.record.grid)
    return atomistic.surface.record.heights;
  return surfaces::build_surface_on(
             atomistic.contact_case.surface, atomistic.realization, substrate,
             highest_wavevector(atomistic.contact_case, atomistic.method))
      .heights;
}

md::AtomRequest request_of(const AtomisticInput& atomistic) {
  const auto& settings = std::get<MdSettings>(atomistic.method.settings);
  const double length = square_length(atomistic);
  md::AtomRequest request;
  request.settings = settings;
  request.scales = atomistic.surface.scales;
  request.youngs_modulus =
      atomistic.contact_case.material.block_youngs_modulus();
  request.poisson_ratio = *atomistic.contact_case.material.poisson_ratio;
  request.layer = square(
      settings.atoms.value_or(atomistic.surface.record.grid.points_x), length);
  request.substrate =
      square(settings.substrate_atoms.value_or(
                 mechanics::incommensurate_atoms(request.layer.points_x)),
             length);
  request.heights = substrate_heights(atomistic, request.substrate);
  request.threads = atomistic.threads;
  request.scratch = atomistic.scratch;
  return request;
}

/// The areas of a row without attraction, and the energy of all pairs.
void observe_repulsion(results::CurvePoint& row, const md::AtomStep& step) {
  row.area_fraction = step.contact_count;
  row.contact_energy = step.interface_energy;
  results::RowObserver observe(row);
  observe_pressure_fits(observe, step.pressure);
  // Weak pressures in the soft tail contribute least to the second moment: on
  // the surface of the paper it is within 4 % of the area of hard contact,
  // while the least-squares fit is 20 % above it (docs/numerics/md.md).
  row.area_fraction_corrected = row[columns::area_fraction_moment];
}

/// The same with attraction, as for a contact law without a wall.
void observe_attraction(results::CurvePoint& row, const md::AtomStep& step,
                        const mechanics::ContactCriterion& criterion,
                        const mechanics::ContactInterface& law) {
  const mechanics::ContactNodes nodes(criterion, step.pressure, step.gap);
  row.area_fraction = results::counted_area_fraction(nodes);
  row.area_fraction_corrected = results::Observed::none;
  row[columns::adhesive_energy] = step.interface_energy;
  observe_tension(row, step.pressure, nodes, law);
}

results::CurvePoint
row_of(const md::AtomStep& step, const mechanics::ContactCriterion& criterion,
       const std::optional<mechanics::ContactInterface>& law) {
  results::CurvePoint row;
  row.nominal_pressure = step.nominal_pressure;
  row.mean_gap = step.mean_gap;
  row.note = step.note;
  if (law)
    observe_attraction(row, step, criterion, *law);
  else
    observe_repulsion(row, step);
  row.contact_perimeter = std::numeric_limits<double>::quiet_NaN();
  row.elastic_energy = step.elastic_energy;
  row.contact_stiffness = std::numeric_limits<double>::quiet_NaN();
  row.iterations = step.evaluations;
  row.residual = step.residual;
  row.status = step.converged ? results::StepStatus::converged
                              : results::StepStatus::not_converged;
  return row;
}

class AtomicSolver final : public StepSolver {
public:
  explicit AtomicSolver(const AtomisticInput& atomistic)
      : watch_(atomistic.watch),
        criterion_(atomistic.method.contact_criterion(
            atomistic.surface.scales.rms_height)),
        law_(atomistic.method.adhesion(atomistic.surface.scales)),
        request_(request_of(atomistic)),
        layer_(request_.layer),
        atoms_(md::make_atomic_contact(std::move(request_))) {}

  StepAnswer find(const StepTarget& target) override {
    md::AtomStep step = atoms_->solve(target.load, target.step, watch_);
    StepAnswer answer{row_of(step, criterion_, law_), layer_,
                      std::move(step.pressure), std::move(step.gap)};
    answer.reached = {.nominal_pressure = step.nominal_pressure,
                      .mean_gap = step.mean_gap,
                      .imbalance = 0.0, // the residual bounds it
                      .pressure_tolerance = step.pressure_tolerance,
                      .gap_tolerance = step.gap_tolerance};
    // A row that is balanced, though only within the tolerance, has the load
    // that was asked for.
    if (step.converged &&
        target.load.control == mechanics::Control::nominal_pressure)
      answer.row.nominal_pressure = target.load.amount;
    return answer;
  }

  std::string found_at_setup() const override {
    return atoms_->description() +
           (law_ ? fmt::format("; flat faces: w = {:.5g} J/m^2, range {:.5g} m",
                               law_->work_of_adhesion, law_->adhesion_range)
                 : std::string());
  }

  std::vector<double> state() const override { return atoms_->state(); }

  bool restore(const std::vector<double>& state) override {
    atoms_->restore(state);
    return true;
  }

private:
  md::Watch watch_;
  mechanics::ContactCriterion criterion_;
  std::optional<mechanics::ContactInterface> law_; ///< of flat faces
  md::AtomRequest request_;
  Grid layer_;
  std::unique_ptr<md::AtomicContact> atoms_;
};

} // namespace

MethodDescription describe(const MdSettings& settings) {
  return {"md",
          settings.potential == mechanics::AtomPotential::repulsive
              ? "atoms, repulsion r^-12"
              : "atoms, Lennard-Jones 12-6",
          true};
}

std::unique_ptr<StepSolver>
make_atomic_solver(const AtomisticInput& atomistic) {
  return std::make_unique<AtomicSolver>(atomistic);
}

} // namespace asperity::methods
