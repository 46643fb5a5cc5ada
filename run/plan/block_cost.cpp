#include "run/plan/block_cost.hpp"

#include "methods/cache/file_mesh.hpp"
#include "methods/full_block_method.hpp"
#include "surfaces/build.hpp"

namespace asperity::run {
namespace {

using fem::BlockSolverKind;

/// What an unknown costs, on the reference machine of cost_model.cpp. Measured
/// in the shipped cases; tests/run/plan_blocks_test.cpp has the list.
struct SolverRate {
  double step_time = 0.0;  ///< CPU time per load step [s]
  double setup_time = 0.0; ///< CPU time of mesh, matrix and set-up [s]
  double memory = 0.0;     ///< [B], matrix and preconditioner included
};

/// Of a load step with a smooth surface on moduli that are uniform in each
/// layer, which takes fewer Newton steps and iterations, over another one.
constexpr double easy_factor = 0.4;

/// Of a load step with the augmented Lagrangian over one with another law,
/// which takes fewer Newton steps.
constexpr double augmented_steps = 2.5;

/// Solutions per load step on a mesh that follows the contact.
constexpr double adaptive_solutions = 3.0;

SolverRate rate_of(const fem::BlockTraits& block) {
  switch (fem::solver_of(block)) {
  case BlockSolverKind::direct: // 2.6 s for 12 138 unknowns and Newton step
    return {1.3e-7 * block.unknowns, 20e-6, 9000.0};
  case BlockSolverKind::algebraic:
    return {170e-6, 15e-6, 5000.0};
  case BlockSolverKind::fourier:
    return {15e-6, 10e-6, 2000.0};
  case BlockSolverKind::lattice:
    return {9e-6, 3e-6, 1200.0};
  case BlockSolverKind::halved:
    return {11e-6, 5e-6, 1200.0};
  case BlockSolverKind::hexahedra:
    return {55e-6, 4e-6, 1300.0};
  }
  return {};
}

bool is_easy(const cases::Case& contact_case) {
  const mechanics::SurfaceKind surface = contact_case.surface.kind;
  return !surfaces::is_random(surface) &&
         surface != mechanics::SurfaceKind::measured &&
         !contact_case.material.inclusion && !contact_case.material.variation;
}

} // namespace

fem::BlockTraits block_of(const cases::Case& contact_case,
                          const cases::MethodSpec& method, const Grid& grid,
                          int ranks) {
  fem::FullRequest request = methods::full_request(
      contact_case, std::get<mechanics::FemSettings>(method.settings), grid,
      {contact_case.material.contact_modulus, grid.length_x, grid.spacing_x(),
       0.0});
  request.file_mesh = methods::file_mesh(contact_case, method, grid);
  return fem::expected_block(request, ranks);
}

MethodCost cost_of_full_block(const cases::Case& contact_case,
                              const cases::MethodSpec& method, const Grid& grid,
                              MachineRates& rates, int ranks) {
  const fem::BlockTraits block = block_of(contact_case, method, grid, ranks);
  const SolverRate rate = rate_of(block);
  const auto& settings = std::get<mechanics::FemSettings>(method.settings);
  double solutions = is_easy(contact_case) ? easy_factor : 1.0;
  if (settings.full.uses_case_mesh &&
      contact_case.mesh.kind == mechanics::MeshKind::adaptive)
    solutions *= adaptive_solutions;
  if (mechanics::needs_multipliers(settings.contact.law))
    solutions *= augmented_steps;
  MethodCost cost;
  cost.unknowns = block.unknowns;
  cost.step_time =
      rates.relative_time() * block.unknowns * rate.step_time * solutions;
  cost.setup_time = rates.relative_time() *
                    (fem_load_time + rate.setup_time * block.unknowns);
  cost.memory = rate.memory * block.unknowns;
  return cost;
}

double full_block_memory() {
  return 51.0 * 1024.0 * 1024.0;
}

} // namespace asperity::run
