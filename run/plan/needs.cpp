#include "run/plan/needs.hpp"

#include "run/methods/cache/file_mesh.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/full_block_method.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "studies/study.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::run {
namespace {

using fem::BlockSolverKind;
using mechanics::Element;

constexpr double bytes_per_mebibyte = 1024.0 * 1024.0;
constexpr double program_memory = 24.0 * bytes_per_mebibyte;
constexpr double fem_memory = 110.0 * bytes_per_mebibyte;
constexpr double full_block_memory = 51.0 * bytes_per_mebibyte; ///< further

constexpr double arrays_per_job = 14.0; ///< of doubles, on the grid
/// Likewise, of a rank on its nodes: 70 to 80 bytes of the solver and the
/// transforms, and the states of two steps; docs/numerics/shared-rows.md.
constexpr double arrays_per_rank = 13.0;
/// Of a rank on all nodes: heights, the gathered pressure, gap and displacement
/// of a step, and the states on their way to the cache.
constexpr double whole_arrays = 7.0;
/// Further ones of a half-space with free boundaries: spectra of rows of twice
/// the points, symbols, and fields of the wide grid.
constexpr double more_arrays_of_free = 3.0;
/// Further ones of a condensed Q2 block: its compliance and its inverse take
/// 16 bytes per node, nodal areas 8, and the spectra of the node classes 6.
constexpr double more_arrays_of_q2 = 4.0;
constexpr double doubles_per_atom = 60.0;
/// Further ones with adhesion: the fields in double precision, the pairs of
/// L-BFGS and the vectors of the test for a minimum.
constexpr double more_arrays_of_adhesion = 10.0;
constexpr double more_arrays_of_hardness = 2.0; ///< imprint, lower heights
/// Of a mirrored map, of which all others have a quarter: heights and answers
/// of the cell.
constexpr double arrays_of_mirrored_cell = 7.0;
/// Of Laplace's equation on a block, per node of the mesh in first and in
/// second order: the matrix and its relaxation [B].
constexpr double conduction_memory_q1 = 400.0, conduction_memory_q2 = 800.0;
constexpr double packing = 0.5; ///< compression ratio of maps by deflate

double nodes(const Grid& grid) {
  return static_cast<double>(grid.size());
}

/// Memory of a full block per unknown, matrix and preconditioner included [B].
/// Measured in the shipped cases; tests/run/plan_blocks_test.cpp has the list.
double memory_per_unknown(const fem::BlockTraits& block) {
  switch (fem::solver_of(block)) {
  case BlockSolverKind::direct:
    return 9000.0;
  case BlockSolverKind::algebraic:
    return 5000.0;
  case BlockSolverKind::box_grid:
  case BlockSolverKind::halved:
    return 1200.0;
  case BlockSolverKind::hexahedra:
    return 1300.0;
  }
  return 0.0;
}

/// What the needs depend on besides the settings of the method.
struct NeedsInput {
  const cases::Case& contact_case;
  const cases::MethodSpec& method;
  const Grid& grid;
  int ranks;
};

bool is_mirrored(const NeedsInput& input) {
  return input.contact_case.surface.edges == mechanics::Edges::mirror;
}

MethodNeeds needs_on_face(const mechanics::ContactSettings& contact,
                          const Grid& grid, bool is_mirrored = false) {
  double arrays =
      arrays_per_job +
      (mechanics::is_adhesive(contact.law) ? more_arrays_of_adhesion : 0.0) +
      (contact.hardness ? more_arrays_of_hardness : 0.0);
  if (is_mirrored)
    arrays = 0.25 * arrays + arrays_of_mirrored_cell;
  return {nodes(grid), arrays * sizeof(double) * nodes(grid)};
}

MethodNeeds needs_of_settings(const mechanics::TheorySettings&,
                              const NeedsInput&) {
  return {1.0, 0.0};
}

MethodNeeds needs_of_settings(const mechanics::HalfspaceSettings& settings,
                              const NeedsInput& input) {
  if (!settings.has_free_boundaries)
    return needs_on_face(settings.contact, input.grid, is_mirrored(input));
  const Grid pressed =
      methods::pressed_grid(input.contact_case, input.method, input.grid);
  Grid padded = pressed;
  padded.points_x *= 2;
  padded.points_y *= 2;
  return {nodes(pressed), mechanics::is_adhesive(settings.contact.law)
                              ? needs_on_face(settings.contact, padded).memory
                              : (arrays_per_job + more_arrays_of_free) *
                                    sizeof(double) * nodes(pressed)};
}

MethodNeeds needs_of_settings(const mechanics::WinklerSettings&,
                              const NeedsInput& input) {
  return {nodes(input.grid), 4.0 * sizeof(double) * nodes(input.grid)};
}

MethodNeeds needs_of_settings(const mechanics::FemSettings& settings,
                              const NeedsInput& input) {
  if (settings.solver != mechanics::FemSolver::full)
    return needs_on_face(settings.contact, input.grid, is_mirrored(input));
  const fem::BlockTraits block = block_of(
      input.contact_case, input.method,
      methods::pressed_grid(input.contact_case, input.method, input.grid),
      input.ranks);
  return {block.unknowns, memory_per_unknown(block) * block.unknowns};
}

MethodNeeds needs_of_settings(const mechanics::MdSettings& settings,
                              const NeedsInput& input) {
  const double side = settings.atoms.value_or(input.grid.points_x);
  double atoms = side * side;
  if (settings.bulk != mechanics::AtomBulk::green) {
    atoms = 0.0;
    for (int level = 0; level < settings.levels; ++level)
      atoms += settings.layers * side * side / std::pow(4.0, level);
  }
  return {3.0 * atoms, doubles_per_atom * sizeof(double) * atoms};
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

MethodNeeds needs_of(const cases::Case& contact_case,
                     const cases::MethodSpec& method, const Grid& grid,
                     int ranks) {
  MethodNeeds needs = std::visit(
      [&](const auto& settings) {
        return needs_of_settings(settings,
                                 NeedsInput{contact_case, method, grid, ranks});
      },
      method.settings);
  if (!method.has_fields())
    return needs;
  const double n = nodes(methods::pressed_grid(contact_case, method, grid));
  double of_studies = 0.0; // which work one after another
  for (const studies::Study* const study : studies::all_studies())
    if (study->keys().is_asked(contact_case) &&
        (study->is_for == nullptr || study->is_for(contact_case, method)))
      of_studies = std::max(of_studies, study->memory);
  needs.memory += of_studies * n;
  if (methods::asks_conduction(contact_case, method)) {
    const auto& fem = std::get<mechanics::FemSettings>(method.settings);
    needs.memory += needs.unknowns / 3.0 *
                    (fem.block.element == Element::q1 ? conduction_memory_q1
                                                      : conduction_memory_q2);
  }
  return needs;
}

double memory_of_rank(const cases::MethodSpec& method, const Grid& grid,
                      int ranks) {
  const auto* block = method.as<mechanics::FemSettings>();
  double arrays = arrays_per_rank;
  if (block != nullptr && block->block.element == Element::q2)
    arrays += more_arrays_of_q2;
  return (whole_arrays + arrays / ranks) * sizeof(double) * nodes(grid);
}

double base_memory(bool uses_fem, bool has_full_block) {
  return program_memory + (uses_fem ? fem_memory : 0.0) +
         (has_full_block ? full_block_memory : 0.0);
}

double map_bytes(const Grid& grid) {
  return 2.0 * sizeof(float) * packing * nodes(grid);
}

} // namespace asperity::run
