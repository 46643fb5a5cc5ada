#include "app/plan/block_cost.hpp"

#include "app/plan/block_size.hpp"
#include "fem/plugin.hpp"
#include "surfaces/build.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::app {
namespace {

using mechanics::LinearSolver;

// All constants are measured in the release build on one thread of a shared
// 2-core AMD EPYC. Their sources are tools/plan_accuracy.py and the table of
// blocks in the report.

/// Newton steps per load step: 7 to 8 in `heterogeneous`, `rough-3d` and
/// `two-blocks`; 4 and 6 in `step42` at 32^2 and 64^2.
constexpr double rough_newton_steps = 7.5;
constexpr double smooth_newton_steps = 5.0;

/// Multigrid iterations per Newton step at 32 nodes per side: 36 in
/// `heterogeneous` (24 at 16), 16 in `step42`. The factor of two bodies is that
/// of the CPU time of `two-blocks` in 12 138 unknowns, 1.0 s per load step.
constexpr double iterations_at_32 = 36.0;
constexpr double block_iterations_exponent = 0.6; ///< of the nodes per side
constexpr double block_smooth_factor = 0.45;
constexpr double two_bodies_factor = 0.5;
constexpr double block_q2_factor = 1.3;
/// Multigrid set-ups per Newton step. Contact between two bodies needs a new
/// hierarchy in each step.
constexpr double hierarchies = 0.2;
constexpr double hierarchies_between_bodies = 1.0;

/// CPU times per unknown and iteration, and per unknown and set-up, for Q1 and
/// Q2 [s].
constexpr double multigrid_iteration_time[] = {0.6e-6, 1.0e-6};
constexpr double hierarchy_time[] = {10e-6, 36e-6};
/// CPU times of the Fourier solver per unknown and Newton step, with moduli
/// that are uniform within each layer (2 iterations) and with moduli that are
/// not (12 iterations) [s].
constexpr double fourier_time[] = {2.0e-6, 3.7e-6};
constexpr double heterogeneous_fourier_time[] = {2.2e-6, 6.0e-6};
/// CPU time of a factorisation per unknown squared [s]: 2.6 s for 12138.
constexpr double direct_time = 1.75e-8;
constexpr double assembly_time = 20e-6; ///< mesh and matrix assembly, per
                                        ///< unknown [s]
/// Geometric multigrid on a lattice of boxes (`rough-3d` and
/// `heterogeneous` at 64^2 in Q1, `rough-3d` at 128^2 in Q2): CPU times per
/// unknown and Newton step, and of mesh and set-up per unknown [s].
constexpr double lattice_time[] = {1.4e-6, 2.2e-6};
constexpr double lattice_setup_time[] = {14e-6, 4e-6};

/// Multigrid without a matrix for second-order hexahedra (`hertz-3d`), in the
/// same units.
constexpr double hexahedron_time = 3.5e-6;
constexpr double hexahedron_setup_time = 10e-6;
/// The same on boxes that are halved from a lattice (`step42` in Q1,
/// `hertz-adaptive` in Q2, whose meshes have a third of the assumed unknowns
/// but are solved several times per load).
constexpr double halved_time[] = {1.0e-6, 1.7e-6};
constexpr double halved_setup_time = 5e-6;
/// The same for a block and a counter-body of finite size (`elastic-sphere`),
/// which take twice the Newton steps, and with stiff springs at Gauss points
/// twice the iterations or more.
constexpr double pair_time = 9e-6;
constexpr double gauss_pair_time = 18e-6;

constexpr double kilobyte = 1000.0;
constexpr double hexahedron_memory = 0.46 * kilobyte;
constexpr double fourier_memory[] = {2.3 * kilobyte, 4.5 * kilobyte};
constexpr double multigrid_memory[] = {3.2 * kilobyte, 5.8 * kilobyte};
constexpr double lattice_memory[] = {2.9 * kilobyte, 0.85 * kilobyte};
/// In addition to multigrid_memory.
constexpr double direct_memory = 5.5 * kilobyte;

/// Whether the mesh consists of equal columns of boxes, for which multigrid is
/// geometric and needs no matrix.
bool is_on_lattice(const cases::Case& contact_case,
                   const mechanics::FemSettings& settings) {
  return settings.full.bodies == 1 &&
         (!settings.full.uses_case_mesh ||
          contact_case.mesh.kind == mechanics::MeshKind::layers);
}

/// Whether the mesh consists of boxes that are halved from a lattice.
bool has_halved_boxes(const cases::Case& contact_case,
                      const mechanics::FemSettings& settings) {
  return settings.full.uses_case_mesh &&
         (contact_case.mesh.kind == mechanics::MeshKind::hanging ||
          contact_case.mesh.kind == mechanics::MeshKind::adaptive);
}

/// Whether the mesh consists of second-order hexahedra for which multigrid
/// needs no matrix. The cells of a file are not known yet.
bool has_hexahedra(const cases::Case& contact_case,
                   const mechanics::FemSettings& settings) {
  const mechanics::MeshSpec& mesh = contact_case.mesh;
  return settings.full.uses_case_mesh &&
         settings.block.element == mechanics::Element::q2 &&
         (has_halved_boxes(contact_case, settings) ||
          (mesh.kind == mechanics::MeshKind::gmsh &&
           mesh.cells == mechanics::MeshCells::hexahedra &&
           mesh.geometry != mechanics::MeshGeometry::file));
}

/// Poisson's ratio above which multigrid without a matrix may need too many
/// iterations.
constexpr double largest_poisson_ratio = 0.49;

bool is_compressible(const mechanics::MaterialSpec& material) {
  double largest = material.poisson_ratio.value_or(0.0);
  for (const mechanics::MaterialLayer& layer : material.layers)
    largest = std::max(largest, layer.moduli.poisson_ratio);
  if (material.inclusion)
    largest = std::max(largest, material.inclusion->moduli.poisson_ratio);
  if (material.counter)
    largest = std::max(largest, material.counter->poisson_ratio);
  return largest <= largest_poisson_ratio;
}

bool is_rough(const mechanics::SurfaceSpec& surface) {
  return surfaces::is_random(surface.kind) ||
         surface.kind == mechanics::SurfaceKind::measured;
}

/// Returns the CPU time of multigrid per unknown and Newton step [s].
double multigrid_time(const cases::Case& contact_case,
                      const mechanics::FemSettings& settings,
                      double nodes_per_side, std::size_t order) {
  const bool has_two = settings.full.bodies == 2;
  const double iterations =
      iterations_at_32 *
      std::pow(nodes_per_side / 32.0, block_iterations_exponent) *
      (is_rough(contact_case.surface) ? 1.0 : block_smooth_factor) *
      (has_two ? two_bodies_factor : 1.0) *
      (order == 0 ? 1.0 : block_q2_factor);
  return iterations * multigrid_iteration_time[order] +
         (has_two ? hierarchies_between_bodies : hierarchies) *
             hierarchy_time[order];
}

/// Returns what multigrid without a matrix is used, if the block allows it:
/// algebraic otherwise.
BlockCostKind matrix_free_kind(const cases::Case& contact_case,
                               const mechanics::FemSettings& settings) {
  const bool has_two = settings.full.bodies == 2;
  if (is_on_lattice(contact_case, settings))
    return BlockCostKind::lattice;
  if (!has_two && has_halved_boxes(contact_case, settings))
    return BlockCostKind::halved;
  if (!has_hexahedra(contact_case, settings))
    return BlockCostKind::algebraic;
  if (!has_two)
    return BlockCostKind::hexahedra;
  return contact_case.mesh.counter ? BlockCostKind::pair
                                   : BlockCostKind::algebraic;
}

} // namespace

BlockCostKind block_cost_kind(const cases::Case& contact_case,
                              const mechanics::FemSettings& settings,
                              double unknowns, int ranks) {
  const LinearSolver asked = settings.full.linear_solver;
  if (asked == LinearSolver::direct)
    return BlockCostKind::direct;
  if (asked == LinearSolver::fourier)
    return BlockCostKind::fourier;
  const BlockCostKind free = matrix_free_kind(contact_case, settings);
  if (asked == LinearSolver::multigrid)
    return free;
  const bool is_lattice = free == BlockCostKind::lattice;
  if (unknowns <= fem::most_direct_unknowns && !(is_lattice && ranks > 1))
    return BlockCostKind::direct;
  if (is_compressible(contact_case.material))
    return free;
  if (is_lattice && settings.full.sides == mechanics::BlockSides::periodic)
    return BlockCostKind::fourier;
  const double largest = ranks == 1 ? fem::most_direct_stiff_unknowns
                                    : fem::most_direct_stiff_unknowns_on_ranks;
  return unknowns <= largest ? BlockCostKind::direct : BlockCostKind::algebraic;
}

MethodCost cost_of_full_block(const cases::Case& contact_case,
                              const mechanics::FemSettings& settings,
                              const Grid& grid, MachineRates& rates,
                              int ranks) {
  const mechanics::Scales scales{contact_case.material.contact_modulus,
                                 grid.length_x, grid.spacing_x(), 0.0};
  const BlockSize size = block_size(contact_case, settings, scales, grid);
  const std::size_t order =
      settings.block.element == mechanics::Element::q1 ? 0 : 1;
  const bool is_heterogeneous = contact_case.material.inclusion.has_value() ||
                                contact_case.material.variation.has_value();
  double unknown_time = 0.0; // per Newton step
  double unknown_setup = assembly_time;
  double unknown_memory = multigrid_memory[order];
  switch (block_cost_kind(contact_case, settings, size.unknowns, ranks)) {
  case BlockCostKind::direct:
    unknown_time = direct_time * size.unknowns;
    unknown_memory += direct_memory;
    break;
  case BlockCostKind::fourier:
    unknown_time =
        (is_heterogeneous ? heterogeneous_fourier_time : fourier_time)[order];
    unknown_memory = fourier_memory[order];
    break;
  case BlockCostKind::lattice:
    unknown_time = lattice_time[order];
    unknown_setup = lattice_setup_time[order];
    unknown_memory = lattice_memory[order];
    break;
  case BlockCostKind::halved:
    unknown_time = halved_time[order];
    unknown_setup = halved_setup_time;
    unknown_memory = hexahedron_memory;
    break;
  case BlockCostKind::hexahedra:
  case BlockCostKind::pair:
    unknown_time = hexahedron_time;
    if (settings.full.bodies == 2)
      unknown_time = settings.full.contact_at == mechanics::ContactPoints::gauss
                         ? gauss_pair_time
                         : pair_time;
    unknown_setup = hexahedron_setup_time;
    unknown_memory = hexahedron_memory;
    break;
  case BlockCostKind::algebraic:
    unknown_time =
        multigrid_time(contact_case, settings, size.nodes_per_side, order);
    break;
  }
  MethodCost cost;
  cost.unknowns = size.unknowns;
  cost.step_time = rates.relative_time() * size.unknowns * unknown_time *
                   (is_rough(contact_case.surface) ? rough_newton_steps
                                                   : smooth_newton_steps);
  cost.setup_time =
      rates.relative_time() * (fem_load_time + unknown_setup * size.unknowns);
  cost.memory = unknown_memory * size.unknowns;
  return cost;
}

double full_block_memory() {
  return 51.0 * 1024.0 * 1024.0;
}

} // namespace asperity::app
