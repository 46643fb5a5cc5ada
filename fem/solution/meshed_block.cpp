#include "fem/solution/meshed_block.hpp"

#include "base/field_sums.hpp"
#include "base/maximum.hpp"
#include "base/require.hpp"
#include "fem/block/all_ranks.hpp"
#include "fem/block/block_conduction.hpp"
#include "fem/linear/box_grid_block.hpp"
#include "fem/linear/hexahedron_block.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/parallel/ranks.hpp"
#include "fem/refined/refined_block.hpp"
#include "fem/solution/block_section.hpp"
#include "fem/solution/gap_error.hpp"
#include "meshes/layered_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace asperity::fem {
namespace {

/// Scale of the gap tolerance: the rms height [m], or the node spacing for a
/// surface that is flat up to roundoff.
double height_scale_of(std::span<const double> heights, double spacing) {
  constexpr double rounding = 1e-12;
  const double rms = rms_height(heights);
  return rms > rounding * largest_magnitude(heights) ? rms : spacing;
}

/// Checks the problem before anything is built.
const BlockProblem& checked(const BlockProblem& problem) {
  require_cells(problem.grid, 1);
  if (!is_same_length(problem.mesh.length_x, problem.grid.length_x) ||
      !is_same_length(problem.mesh.length_y, problem.grid.length_y))
    refuse_argument("length of the mesh", problem.mesh.length_x,
                    "that of the surface");
  if (problem.law && (problem.counter || problem.adaptive ||
                      problem.mesh.shape != meshes::CellShape::hexahedron ||
                      (problem.degree != 2 && !is_refined_block(problem))))
    throw std::domain_error(
        "a block with a yield stress or another material law must be one body "
        "of second-order hexahedra, or of first-order boxes, on a mesh that "
        "does not follow the contact");
  return problem;
}

bool is_compressible(const BlockSystem& system) {
  bool is_own = true;
  for (const auto& cell : system.space().dof_handler().active_cell_iterators())
    is_own = is_own && (!cell->is_locally_owned() ||
                        is_compressible(system.moduli_of(cell)));
  return dealii::Utilities::MPI::min(is_own ? 1 : 0, MPI_COMM_WORLD) == 1;
}

/// What the choice of the linear solver depends on. Collective.
/// @param grid of boxes  of a mesh that is one, else empty
BlockTraits traits_of(const BlockProblem& problem, const BlockSystem& system,
                      const std::optional<BoxGrid>& box_grid) {
  BlockTraits traits{
      .requested = problem.linear_solver,
      .unknowns = static_cast<double>(system.n_unknowns()),
      .ranks = n_ranks(),
      .is_compressible =
          box_grid ? std::ranges::all_of(
                         box_grid->moduli,
                         [](const CellModuli& own) {
                           return is_compressible(Moduli{own.lame, own.shear});
                         })
                   : is_compressible(system),
      .is_nonlinear = problem.law != nullptr};
  if (box_grid)
    traits.structure = MeshStructure::box_grid;
  else if (is_refined_block(problem))
    traits.structure = MeshStructure::halved;
  else if (is_hexahedron_block(system))
    traits.structure = MeshStructure::hexahedra;
  return traits;
}

/// The solver of the contact problem with the linear solver that solver_of()
/// chooses. Collective.
/// @param has_own_mesh  whether the mesh is that of the problem
ContactNewton newton_of(const BlockProblem& problem, const BlockSystem& system,
                        bool has_own_mesh) {
  // The direct solver, to which an automatic one turns, has no tangents.
  const LinearSolver requested =
      problem.law ? LinearSolver::multigrid : problem.linear_solver;
  if (requested == LinearSolver::direct)
    return ContactNewton(system, requested);
  const std::optional<BoxGrid> box_grid =
      has_own_mesh ? box_grid_of(problem) : std::nullopt;
  const BlockTraits traits = traits_of(problem, system, box_grid);
  switch (solver_of(traits)) {
  case BlockSolverKind::direct:
    return ContactNewton(system, LinearSolver::direct);
  case BlockSolverKind::box_grid:
    return ContactNewton(system, requested,
                         std::make_unique<BoxGridBlock>(system, *box_grid));
  case BlockSolverKind::halved:
    return ContactNewton(system, requested, refined_block_of(problem, system));
  case BlockSolverKind::hexahedra:
    return ContactNewton(system, requested,
                         std::make_unique<HexahedronBlock>(problem, system));
  case BlockSolverKind::algebraic:
    break;
  }
  return ContactNewton(system, requested);
}

} // namespace

MeshedBlock::MeshedBlock(
    const BlockProblem& problem,
    const std::shared_ptr<dealii::parallel::TriangulationBase<3>>&
        triangulation)
    : system_(checked(problem), triangulation),
      maps_(system_),
      weights_(maps_.weights()),
      report_(system_.report()),
      newton_(newton_of(problem, system_, triangulation == nullptr)),
      far_boundary_(problem.far_boundary),
      depth_(problem.mesh.depth) {}

ContactStiffness MeshedBlock::stiffness() {
  if (system_.has_counter())
    throw std::domain_error("the stiffness of a contact needs one body");
  if (system_.law() != nullptr)
    throw std::domain_error(
        "the stiffness of a contact needs elastic material");
  if (far_boundary_ != mechanics::FarBoundary::clamped)
    throw std::domain_error(
        "the stiffness of a contact needs a clamped far boundary, top = "
        "\"clamped\"");
  return newton_.stiffness();
}

BlockConduction MeshedBlock::conduction() const {
  return fem::conduction(system_, contact_set(newton_.state().pressure),
                         depth_);
}

StressPeak MeshedBlock::strongest_stress() const {
  return BlockStress(system_, newton_.state().displacement,
                     newton_.state().material())
      .strongest();
}

std::vector<double> MeshedBlock::section(const SectionPlane& plane) const {
  BlockStress stress(system_, newton_.state().displacement,
                     newton_.state().material());
  return von_mises_in(plane, system_.space(), stress);
}

void MeshedBlock::write(const std::string& folder_and_stem) {
  BlockStress stress(system_, newton_.state().displacement,
                     newton_.state().material());
  output_.write(
      folder_and_stem, system_, stress,
      SurfaceOutput(maps_, newton_.state(), stress.displacement(), heights_),
      nominal_pressure_);
}

double MeshedBlock::weighted_mean(std::span<const double> field) const {
  return std::inner_product(field.begin(), field.end(), weights_.begin(), 0.0) /
         static_cast<double>(field.size());
}

std::vector<double>
MeshedBlock::displacement(std::span<const double> pressure) {
  require_field("pressure", pressure, "Pa");
  auto whole = system_.space().make_vector();
  if (!newton_.solve_linear(maps_.at_points(pressure), whole))
    return {};
  std::vector<double> face = maps_.displacement(whole);
  const double mean = weighted_mean(face);
  for (double& value : face)
    value -= mean;
  return face;
}

/// Requires one finite value per node of the grid.
void MeshedBlock::require_field(const char* name, std::span<const double> field,
                                const char* unit) const {
  if (field.size() != grid().size())
    refuse_argument(std::string("number of values of ") + name,
                    static_cast<double>(field.size()),
                    std::to_string(grid().size()));
  for (std::size_t i = 0; i < field.size(); ++i)
    if (!std::isfinite(field[i]))
      refuse_argument(std::string(name) + " of node " + std::to_string(i),
                      field[i], std::string("finite [") + unit + "]");
}

void MeshedBlock::require_arguments(std::span<const double> heights,
                                    const mechanics::LoadTarget& load,
                                    const BlockContact& contact) const {
  require_positive("penalty", contact.penalty, "Pa/m");
  require_positive("tolerance", contact.tolerance, "1");
  if (load.control == mechanics::Control::nominal_pressure)
    require_positive("nominal pressure", load.amount, "Pa");
  else if (system_.law() != nullptr)
    throw std::domain_error("a block with a yield stress or another material "
                            "law needs a nominal pressure as its load");
  else if (!std::isfinite(load.amount))
    refuse_argument("mean gap", load.amount, "finite [m]");
  require_field("height", heights, "m");
  const bool is_wall =
      mechanics::block_solver_of(mechanics::traits_of(contact.law)) ==
      mechanics::BlockSolver::wall;
  if (is_wall && system_.has_counter())
    throw std::domain_error(
        "contact = hard with two meshed bodies: hard contact is not available "
        "between two meshes; choose augmented");
}

/// @param pressure  the field on the grid
bool MeshedBlock::is_contact_on_grid(std::span<const double> pressure) const {
  const ContactPoints& points = system_.contact();
  const std::vector<double>& at_points = newton_.state().pressure;
  unsigned int on_grid = 0;
  unsigned int beside = 0;
  for (std::size_t i = 0; i < at_points.size(); ++i)
    if (at_points[i] > 0.0)
      ++(points[i].grid_node < 0 ? beside : on_grid);
  on_grid = dealii::Utilities::MPI::sum(on_grid, MPI_COMM_WORLD);
  beside = dealii::Utilities::MPI::sum(beside, MPI_COMM_WORLD);
  const auto on_map = static_cast<unsigned int>(
      std::ranges::count_if(pressure, [](double p) { return p > 0.0; }));
  return beside == 0 && on_grid == on_map;
}

BlockSolution MeshedBlock::solve(std::span<const double> heights,
                                 const mechanics::LoadTarget& load,
                                 const BlockContact& contact) {
  BlockSolution answer = solve_contact(heights, load, contact);
  answer.estimated_gap_error =
      estimated_gap_error(answer, AdaptiveMesh{}.moduli_ratio);
  return answer;
}

double MeshedBlock::estimated_gap_error(const BlockSolution& solution,
                                        double ratio) const {
  if (!solution.converged || !(solution.nominal_pressure > 0.0) ||
      system_.law() != nullptr)
    return std::numeric_limits<double>::quiet_NaN();
  const LoadedResponse by_load{newton_.state().displacement,
                               solution.nominal_pressure *
                                   system_.contact().area()};
  // Without a support at the far boundary, an approach alone moves the block.
  if (far_boundary_ == mechanics::FarBoundary::pressure ||
      !(newton_.approach_stiffness() > 0.0))
    return gap_error(system_, by_load, by_load, ratio);
  return gap_error(
      system_, by_load,
      {newton_.response_to_approach(), newton_.approach_stiffness()}, ratio);
}

BlockSolution MeshedBlock::solve_contact(std::span<const double> heights,
                                         const mechanics::LoadTarget& load,
                                         const BlockContact& contact) {
  require_arguments(heights, load, contact);
  BlockSolution answer;
  newton_.solve(maps_.at_points(heights),
                height_scale_of(heights, grid().spacing_x()), load, contact,
                answer);
  heights_.assign(heights.begin(), heights.end());
  nominal_pressure_ = answer.nominal_pressure;
  answer.pressure = maps_.pressure(newton_.state().pressure);
  answer.is_contact_on_grid = is_contact_on_grid(answer.pressure);
  answer.gap = maps_.displacement(newton_.state().displacement);
  for (std::size_t i = 0; i < answer.gap.size(); ++i)
    answer.gap[i] +=
        newton_.state().rigid_gap - (heights[i] - newton_.state().highest);
  return answer;
}

// The number of ranks, how many numbers each has, and these.
std::vector<double> MeshedBlock::memory() const {
  const std::vector<double> own = newton_.memory();
  const std::vector<double> numbers = of_all_ranks(own);
  std::vector<double> memory;
  if (numbers.empty())
    return memory;
  const std::vector<double> counts =
      of_all_ranks(std::vector<double>{static_cast<double>(own.size())});
  memory.reserve(1 + counts.size() + numbers.size());
  memory.push_back(static_cast<double>(counts.size()));
  memory.insert(memory.end(), counts.begin(), counts.end());
  memory.insert(memory.end(), numbers.begin(), numbers.end());
  return memory;
}

bool MeshedBlock::recall(std::span<const double> memory) {
  const auto rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const std::vector<double> all =
      of_all_ranks(rank == 0 ? std::vector<double>(memory.begin(), memory.end())
                             : std::vector<double>());
  const auto ranks = static_cast<std::size_t>(n_ranks());
  if (all.size() <= ranks || all.front() != static_cast<double>(ranks))
    return false;
  const std::span<const double> counts = std::span(all).subspan(1, ranks);
  const double before =
      std::accumulate(counts.begin(), counts.begin() + rank, 0.0);
  return newton_.recall(
      std::span(all).subspan(1 + ranks + static_cast<std::size_t>(before),
                             static_cast<std::size_t>(counts[rank])));
}

std::unique_ptr<FullBlock> make_full_block(const BlockProblem& problem) {
  return std::make_unique<MeshedBlock>(problem);
}

std::unique_ptr<FullBlock> make_full_block(const Grid& grid, int degree,
                                           const LayeredBlock& block,
                                           LinearSolver linear_solver) {
  require_cells(grid, degree);
  require_block(block);
  Grid columns = grid;
  columns.points_x /= degree;
  columns.points_y /= degree;
  std::vector<double> thickness;
  for (const ElasticLayer& layer : block.layers)
    thickness.push_back(layer.thickness);
  BlockProblem problem{.grid = grid,
                       .mesh = meshes::layered_mesh(columns, thickness),
                       .degree = degree,
                       .moduli = ModuliField(block),
                       .far_boundary = block.far_boundary,
                       .linear_solver = linear_solver};
  return make_full_block(problem);
}

} // namespace asperity::fem
