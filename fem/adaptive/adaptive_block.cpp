#include "fem/adaptive/adaptive_block.hpp"

#include "base/require.hpp"
#include "fem/adaptive/material_marks.hpp"
#include "fem/adaptive/mesh_change.hpp"
#include "fem/adaptive/refinement_rule.hpp"
#include "fem/block/block_triangulation.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "fem/solution/meshed_block.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::fem {
namespace {

/// Tolerance of solutions that only decide on the mesh.
constexpr double loose_tolerance = 1e-4;

/// Least mean gap of such solutions, over the prescribed one.
constexpr double least_gap_share = 0.5;

/// Share of a prescribed mean gap that gaps between the nodes of a cell in hard
/// contact may have.
constexpr double gap_share = 0.05;

/// Passes in addition to one per halving.
constexpr int extra_passes = 4;

/// Share of cells below which merging alone is not worth another solution.
constexpr double least_coarsened = 0.1;

void check_adaptive(const BlockProblem& problem) {
  if (problem.counter)
    throw std::domain_error(
        "an adaptive mesh with two meshed bodies is not available; use "
        "another kind of mesh or one body");
  require_between("halvings", problem.adaptive->halvings, 1, 12, "1");
}

std::shared_ptr<MeshChange::Mesh> coarsest_mesh(const BlockProblem& problem) {
  check_adaptive(problem);
  start_mpi();
  std::shared_ptr<dealii::parallel::TriangulationBase<3>> mesh =
      make_triangulation(problem.mesh, false);
  auto adaptive = std::dynamic_pointer_cast<MeshChange::Mesh>(mesh);
  if (!adaptive)
    throw std::domain_error("an adaptive mesh must consist of hexahedra");
  refine_for_materials(problem, *adaptive);
  return adaptive;
}

/// The mean height of a surface with the finest cells, in which the functions
/// at the vertices and those at the middle of edges of a second-order cell
/// integrate to the weights of Simpson's rule.
double mean_height(const BlockProblem& problem,
                   std::span<const double> heights) {
  const auto weight = [&](int i) {
    return problem.degree == 1 ? 1.0 : (i % 2 == 0 ? 2.0 : 4.0) / 3.0;
  };
  double sum = 0.0;
  for (int iy = 0; iy < problem.grid.points_y; ++iy)
    for (int ix = 0; ix < problem.grid.points_x; ++ix)
      sum += weight(ix) * weight(iy) * heights[problem.grid.index(ix, iy)];
  return sum / static_cast<double>(heights.size());
}

class AdaptiveBlock final : public FullBlock {
public:
  explicit AdaptiveBlock(const BlockProblem& problem)
      : problem_(problem),
        mesh_(coarsest_mesh(problem)),
        block_(std::make_unique<MeshedBlock>(problem_, mesh_)),
        weights_(problem.grid.size(), 1.0) {}

  const Grid& grid() const override { return problem_.grid; }

  std::size_t unknowns() const override { return block_->unknowns(); }

  std::span<const double> nodal_weights() const override { return weights_; }

  std::string report() const override {
    return fmt::format(
        "adaptive mesh, cells at the contact halved up to {} times; the mesh "
        "before the first load:\n{}",
        problem_.adaptive->halvings, block_->report());
  }

  std::vector<double> displacement(std::span<const double> pressure) override {
    return block_->displacement(pressure);
  }

  BlockSolution solve(std::span<const double> heights,
                      const mechanics::LoadTarget& load,
                      const BlockContact& contact) override;

  ContactStiffness stiffness() override { return block_->stiffness(); }

  BlockConduction conduction() const override { return block_->conduction(); }

  StressPeak strongest_stress() const override {
    return block_->strongest_stress();
  }

  std::vector<double> section(const SectionPlane& plane) const override {
    return block_->section(plane);
  }

  void write(const std::string& folder_and_stem) override {
    block_->write(folder_and_stem);
  }

private:
  /// What one load step needs.
  struct Step {
    std::span<const double> heights;
    mechanics::LoadTarget load;
    BlockContact contact;
  };

  /// Whether gaps have a prescribed mean and cannot be negative.
  static bool excludes_overlap(const Step& step) {
    return step.load.control == mechanics::Control::mean_gap &&
           mechanics::has_wall(step.contact.law);
  }

  BlockSolution solve_on_mesh(const Step& step, double tolerance);
  static BlockWatch watch_of_pass(const Step& step, int pass,
                                  const BlockSolution& before);
  bool change_mesh(const BlockSolution& found, const Step& step,
                   bool may_coarsen);
  void rebuild(MeshChange& change, std::span<const double> pressure);

  BlockProblem problem_;
  std::shared_ptr<MeshChange::Mesh> mesh_;
  std::unique_ptr<MeshedBlock> block_;
  std::vector<double> weights_; ///< all ones: fields are samples
};

/// Solves with the mean height of the finest mesh in place of that of the
/// contact points. On a coarse mesh, no pressure may then lead to the
/// prescribed mean gap: a gap at the nodes of the grid may be an overlap at the
/// contact points, which hard contact excludes. A mean gap of the points of at
/// least half of the prescribed one serves to decide on the mesh.
BlockSolution AdaptiveBlock::solve_on_mesh(const Step& step, double tolerance) {
  const ContactPoints& points = block_->system().contact();
  const std::vector<double> at_points = block_->maps().at_points(step.heights);
  double mean_at_points = 0.0;
  for (std::size_t i = 0; i < at_points.size(); ++i)
    mean_at_points += points[i].area * at_points[i];
  mean_at_points = dealii::Utilities::MPI::sum(mean_at_points, MPI_COMM_WORLD) /
                   points.area();
  const double missed = mean_at_points - mean_height(problem_, step.heights);
  mechanics::LoadTarget load = step.load;
  if (load.control == mechanics::Control::mean_gap) {
    load.amount -= missed;
    if (tolerance > 0.0 && excludes_overlap(step))
      load.amount = std::max(load.amount, least_gap_share * step.load.amount);
  }
  BlockContact contact = step.contact;
  contact.tolerance = std::max(tolerance, contact.tolerance);
  BlockSolution found = block_->solve_contact(step.heights, load, contact);
  found.mean_gap += missed;
  return found;
}

/// Adds what the passes before have cost to the progress of one pass.
BlockWatch AdaptiveBlock::watch_of_pass(const Step& step, int pass,
                                        const BlockSolution& before) {
  if (!step.contact.watch)
    return {};
  return [watch = step.contact.watch, pass, iterations = before.iterations,
          linear = before.linear_iterations](BlockProgress progress) {
    progress.mesh_pass = pass;
    progress.iterations += iterations;
    progress.linear_iterations += linear;
    watch(progress);
  };
}

BlockSolution AdaptiveBlock::solve(std::span<const double> heights,
                                   const mechanics::LoadTarget& load,
                                   const BlockContact& contact) {
  block_->require_arguments(heights, load, contact);
  const Step step{heights, load, contact};
  BlockSolution total;
  const auto add_costs = [&total](BlockSolution found) {
    found.iterations += total.iterations;
    found.linear_iterations += total.linear_iterations;
    found.preconditioner_setups += total.preconditioner_setups;
    found.memory = std::max(found.memory, total.memory);
    total = std::move(found);
  };
  const int most_passes = problem_.adaptive->halvings + extra_passes;
  int pass = 0;
  const auto solve_pass = [&](double tolerance) {
    Step watched = step;
    watched.contact.watch = watch_of_pass(step, pass, total);
    add_costs(solve_on_mesh(watched, tolerance));
  };
  do
    solve_pass(loose_tolerance);
  while (pass++ < most_passes && change_mesh(total, step, pass == 1));
  const bool is_settled = pass <= most_passes;
  solve_pass(0.0);
  total.estimated_gap_error =
      block_->estimated_gap_error(total, problem_.adaptive->moduli_ratio);
  if (!is_settled && total.note.empty())
    total.note = fmt::format("the mesh still changed after {} passes", pass);
  return total;
}

/// Changes the mesh where the solution requires it. Returns whether it has
/// changed; if so, the block on the new mesh continues from that solution.
bool AdaptiveBlock::change_mesh(const BlockSolution& found, const Step& step,
                                bool may_coarsen) {
  const double compliance = step.contact.local_compliance();
  std::vector<double> gap = found.gap;
  for (std::size_t i = 0; i < gap.size(); ++i)
    gap[i] += compliance * found.pressure[i];
  FoundContact fields{found.pressure, gap};
  if (excludes_overlap(step))
    fields.gap_tolerance = gap_share * step.load.amount;
  const RefinementRule rule(problem_, *block_, fields,
                            found.nominal_pressure /
                                std::max(found.area_by_points, 1e-300));
  MeshChange change(problem_, *mesh_, rule.changes(may_coarsen));
  const ChangedCells changed = change.count();
  if (changed.refined == 0 &&
      static_cast<double>(changed.coarsened) <
          least_coarsened * static_cast<double>(mesh_->n_global_active_cells()))
    return false;
  rebuild(change, found.pressure);
  return true;
}

void AdaptiveBlock::rebuild(MeshChange& change,
                            std::span<const double> pressure) {
  const BlockSpace& space = block_->system().space();
  const ContactState& state = block_->newton().state();
  ContactStart start{space.make_vector(),
                     {},
                     state.rigid_gap,
                     state.highest,
                     state.far_pressure};
  MeshChange::Vector whole = state.displacement;
  space.constraints().distribute(whole);
  std::unique_ptr<MeshedBlock> old = std::move(block_);
  const BlockOutput output = old->output();
  const MeshChange::Vector transferred =
      change.execute(whole, [&old] { old.reset(); });

  block_ = std::make_unique<MeshedBlock>(problem_, mesh_);
  block_->continue_output(output);
  start.displacement = transferred;
  block_->system().space().constraints().set_zero(start.displacement);
  start.pressure = block_->maps().at_points(pressure);
  for (double& value : start.pressure)
    value = std::max(0.0, value);
  block_->newton().start_from(std::move(start));
}

} // namespace

std::unique_ptr<FullBlock> make_adaptive_block(const BlockProblem& problem) {
  return std::make_unique<AdaptiveBlock>(problem);
}

} // namespace asperity::fem
