#include "run/plan/cost_model.hpp"

#include "base/special_numbers.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "methods/chosen.hpp"
#include "methods/surfaces_of_case.hpp"
#include "run/plan/block_cost.hpp"
#include "surfaces/build.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::run {
namespace {

using mechanics::Element;

// The constants are measured in the release build on a 2-core AMD EPYC;
// MachineRates::relative_time() scales the times to other machines.

/// Iterations per load step that starts from the previous solution, at 512^2
/// and a tolerance of 1e-8, on the rough surface of `bench_contact_steps`: 8.2
/// with 16 steps over a factor of 400 in load, 8.8 with 10. Their growth with
/// the grid is that from 8.1 at 256^2 to 10.7 at 1024^2 with 10 steps. With
/// 1e-5 they take 5.9, 6.3 and 8.1: the error falls by the same factor in each
/// iteration after those that find the contact, which count as three decades. A
/// single sphere or wave takes fewer: 7.0 and 7.9 instead of 8.8.
constexpr double iterations_at_512 = 8.5;
constexpr double smooth_factor = 0.85;
constexpr double iterations_exponent = 0.2;
constexpr double decades_at_512 = 8.0;
constexpr double decades_of_contact = 3.0;
constexpr double augmented_factor = 2.5; ///< docs/numerics/solver.md: 2 to 3
constexpr double adhesive_factor = 9.0;  ///< docs/numerics/adhesion.md, in
                                         ///< double precision
constexpr double q2_factor = 1.25; ///< 4 x 4 blocks: 2.67 s instead of 2.13 s

constexpr double program_time = 0.3;     ///< a run without any work [s]
constexpr double q1_layer_time = 39e-9;  ///< per wavevector and layer [s]
constexpr double q2_layer_time = 8.5e-6; ///< per wavevector of a cell and layer
                                         ///< [s]

/// CPU time per atom of one force evaluation, including the work of Newton's
/// method for it [s]. A step takes 9 evaluations in `md-small` (100 atoms per
/// side) and 33 in `md-zeta216` (400).
constexpr double atom_evaluation_time = 1.3e-6;
constexpr double evaluations_at_100 = 9.5;
constexpr double evaluations_exponent = 0.8;
constexpr double inner_atom_time = 0.15e-6;   ///< per atom inside the block [s]
constexpr double explicit_evaluations = 55.0; ///< 52 and 55 in `md-verify`

constexpr double theory_setup_time = 1e-3;
constexpr double theory_step_time = 1e-4;
/// Per load and magnification [s].
constexpr double magnification_time = 5.5e-3;
/// Of the flow through the gap, per node in both directions: 128 flows of the
/// case `seal` took 85 s [s], and one at 1024^2 444 MB [bytes].
constexpr double flow_time = 5e-6;
constexpr double flow_memory = 430.0;
/// Of spots and conductance of one map, per node: those of 36 maps of the case
/// `conductance` took 4.6 s with two linear solves for each [s] [bytes].
constexpr double contact_study_time = 5e-7;
constexpr double contact_study_memory = 150.0;
/// Of Laplace's equation on a block, per node of the mesh in first and in
/// second order: the matrix and its relaxation [bytes].
constexpr double conduction_memory_q1 = 400.0, conduction_memory_q2 = 800.0;
constexpr double adhesion_time = 0.45e-6; ///< per ratio and step squared [s]

/// Number of planes in the search of the strongest point of a map, at 512^2 in
/// `hertz`, and number of planes of a section. A plane costs six transforms and
/// as much again for the Fourier coefficients and the stress.
constexpr double planes_per_map = 35.0;
constexpr double planes_per_section = 49.0;
constexpr double transform_pairs_per_plane = 6.0;

constexpr double bytes_per_mebibyte = 1024.0 * 1024.0;
constexpr double program_memory = 24.0 * bytes_per_mebibyte;
constexpr double fem_memory = 110.0 * bytes_per_mebibyte;
constexpr double arrays_per_job = 19.0; ///< of doubles, on the grid
/// Likewise, of a rank on its nodes: 60 to 70 bytes of the solver and the
/// states of two steps, once for the next step and once on their way to the
/// cache; docs/numerics/shared-rows.md.
constexpr double arrays_per_rank = 13.0;
/// Further ones of a half-space with free boundaries: spectra of rows of twice
/// the points, symbols, and fields of the wide grid.
constexpr double more_arrays_of_free = 7.0;
/// Further ones of a condensed Q2 block: its compliance and its inverse take
/// 16 bytes per node, nodal areas 8, and the spectra of the node classes 6.
constexpr double more_arrays_of_q2 = 4.0;
constexpr double doubles_per_atom = 60.0;
/// Likewise, with adhesion: the fields in double precision, the pairs of L-BFGS
/// and the vectors of the test for a minimum.
constexpr double more_arrays_of_adhesion = 10.0;
constexpr double more_arrays_of_hardness = 2.0; ///< imprint, lower heights
constexpr double packing = 0.5; ///< compression ratio of maps by deflate

double nodes(const Grid& grid) {
  return static_cast<double>(grid.size());
}

double iterations_per_step(const mechanics::SurfaceSpec& surface,
                           const mechanics::ContactSettings& contact,
                           const Grid& grid) {
  const bool is_rough = surfaces::is_random(surface.kind) ||
                        surface.kind == mechanics::SurfaceKind::measured;
  const double decades = -std::log10(std::min(contact.tolerance, 0.1));
  return (is_rough ? 1.0 : smooth_factor) * iterations_at_512 *
         ((decades + decades_of_contact) /
          (decades_at_512 + decades_of_contact)) *
         std::pow(std::sqrt(nodes(grid)) / 512.0, iterations_exponent);
}

/// What a cost depends on besides the settings of the method.
struct CostInput {
  const cases::Case& contact_case;
  const cases::MethodSpec& method;
  const Grid& grid;
  MachineRates& rates;
  int ranks = 1;
};

MethodCost cost_on_face(const mechanics::ContactSettings& contact,
                        const CostInput& input) {
  const auto& [contact_case, method, grid, rates, ranks] = input;
  MethodCost cost;
  const double law = mechanics::needs_multipliers(contact.law)
                         ? augmented_factor
                     : mechanics::is_adhesive(contact.law) ? adhesive_factor
                                                           : 1.0;
  cost.unknowns = nodes(grid);
  cost.setup_time = rates.iteration_time(grid);
  cost.step_time = law *
                   iterations_per_step(contact_case.surface, contact, grid) *
                   rates.iteration_time(grid);
  cost.memory =
      (arrays_per_job +
       (mechanics::is_adhesive(contact.law) ? more_arrays_of_adhesion : 0.0) +
       (contact.hardness ? more_arrays_of_hardness : 0.0)) *
      sizeof(double) * nodes(grid);
  return cost;
}

MethodCost cost_of_settings(const mechanics::TheorySettings&,
                            const CostInput& input) {
  const double relative_time = input.rates.relative_time();
  return {1.0, relative_time * theory_setup_time,
          relative_time * theory_step_time, 0.0};
}

MethodCost cost_of_settings(const mechanics::HalfspaceSettings& settings,
                            const CostInput& input) {
  if (!settings.has_free_boundaries)
    return cost_on_face(settings.contact, input);
  const Grid pressed =
      methods::pressed_grid(input.contact_case, input.method, input.grid);
  Grid padded = pressed;
  padded.points_x *= 2;
  padded.points_y *= 2;
  MethodCost cost =
      cost_on_face(settings.contact,
                   {input.contact_case, input.method, padded, input.rates});
  cost.unknowns = nodes(pressed);
  if (!mechanics::is_adhesive(settings.contact.law)) // its fields are padded
    cost.memory = (arrays_per_job + more_arrays_of_free) * sizeof(double) *
                  nodes(pressed);
  return cost;
}

/// A sort of the heights, no transform.
MethodCost cost_of_settings(const mechanics::WinklerSettings&,
                            const CostInput& input) {
  MethodCost cost;
  cost.unknowns = nodes(input.grid);
  cost.step_time = input.rates.iteration_time(input.grid);
  cost.memory = 4.0 * sizeof(double) * nodes(input.grid);
  return cost;
}

MethodCost cost_of_settings(const mechanics::FemSettings& settings,
                            const CostInput& input) {
  const auto& [contact_case, method, grid, rates, ranks] = input;
  if (settings.solver == mechanics::FemSolver::full)
    return cost_of_full_block(contact_case, method,
                              methods::pressed_grid(contact_case, method, grid),
                              rates, ranks);
  const mechanics::Scales scales{contact_case.material.contact_modulus,
                                 grid.length_x, grid.spacing_x(), 0.0};
  MethodCost cost = cost_on_face(settings.contact, input);
  const auto layers = static_cast<double>(
      meshes::layers_of_block(
          settings.block,
          meshes::interfaces_of(contact_case.material.layers, scales),
          grid.spacing_x(), settings.block.depth.in_si(scales))
          .size());
  const double symmetry = grid.is_square() ? 8.0 : 4.0;
  if (settings.block.element == Element::q1) {
    cost.setup_time = layers * nodes(grid) / symmetry * q1_layer_time;
  } else {
    cost.setup_time = layers * nodes(grid) / 4.0 / symmetry * q2_layer_time;
    cost.step_time *= q2_factor;
  }
  cost.setup_time = rates.relative_time() * (cost.setup_time + fem_load_time);
  return cost;
}

MethodCost cost_of_settings(const mechanics::MdSettings& settings,
                            const CostInput& input) {
  const auto& [contact_case, method, grid, rates, ranks] = input;
  const double side = settings.atoms.value_or(grid.points_x);
  MethodCost cost;
  cost.unknowns = 3.0 * side * side;
  if (settings.bulk == mechanics::AtomBulk::green) {
    const double evaluation =
        rates.relative_time() * atom_evaluation_time * side * side;
    cost.step_time = evaluations_at_100 *
                     std::pow(side / 100.0, evaluations_exponent) * evaluation;
    cost.setup_time = 0.2 * evaluation;
  } else {
    double atoms = 0.0;
    for (int level = 0; level < settings.levels; ++level)
      atoms += settings.layers * side * side / std::pow(4.0, level);
    cost.unknowns = 3.0 * atoms;
    cost.step_time =
        rates.relative_time() * explicit_evaluations *
        (inner_atom_time * atoms + 0.5 * atom_evaluation_time * side * side);
    cost.setup_time = cost.step_time / explicit_evaluations;
  }
  cost.memory = doubles_per_atom * sizeof(double) * cost.unknowns / 3.0;
  const bool is_unknown =
      settings.engine == mechanics::AtomEngine::lammps ||
      settings.minimizer == mechanics::AtomMinimizer::dynamics;
  if (is_unknown)
    cost.step_time = cost.setup_time = not_a_number;
  return cost;
}

} // namespace

MethodCost cost_of(const cases::Case& contact_case,
                   const cases::MethodSpec& method, const Grid& grid,
                   MachineRates& rates, int ranks) {
  MethodCost cost = std::visit(
      [&](const auto& settings) {
        return cost_of_settings(
            settings, CostInput{contact_case, method, grid, rates, ranks});
      },
      method.settings);
  if (contact_case.flow_study && method.has_fields()) {
    const double n = nodes(methods::pressed_grid(contact_case, method, grid));
    cost.step_time += rates.relative_time() * flow_time * n;
    cost.memory += flow_memory * n;
  }
  if (method.has_fields() &&
      (contact_case.spots_study || contact_case.conductance_study ||
       (contact_case.friction_study &&
        cases::has_partial_slip(method, contact_case.material)))) {
    const double n = nodes(methods::pressed_grid(contact_case, method, grid));
    cost.step_time += rates.relative_time() * contact_study_time * n;
    cost.memory += contact_study_memory * n;
  }
  if (contact_case.conductance_study && methods::conducts_in_block(method)) {
    const auto& fem = std::get<mechanics::FemSettings>(method.settings);
    cost.memory += cost.unknowns / 3.0 *
                   (fem.block.element == Element::q1 ? conduction_memory_q1
                                                     : conduction_memory_q2);
  }
  return cost;
}

double memory_of_rank(const cases::MethodSpec& method, const Grid& grid,
                      int ranks) {
  const auto* half =
      std::get_if<mechanics::HalfspaceSettings>(&method.settings);
  const auto* block = std::get_if<mechanics::FemSettings>(&method.settings);
  double arrays = arrays_per_rank;
  if (half != nullptr && half->has_free_boundaries)
    arrays += more_arrays_of_free;
  if (block != nullptr && block->block.element == mechanics::Element::q2)
    arrays += more_arrays_of_q2;
  return arrays * sizeof(double) * nodes(grid) / ranks;
}

double study_time(const cases::Case& contact_case, MachineRates& rates) {
  double time = 0.0;
  if (const auto& study = contact_case.magnification_study)
    time += magnification_time *
            static_cast<double>(study->nominal_pressures.size()) *
            study->points;
  if (const auto& study = contact_case.adhesion_study)
    time += adhesion_time * study->points * study->steps * study->steps;
  return rates.relative_time() * time;
}

double stress_time(int n_maps, const Grid& grid, MachineRates& rates) {
  return n_maps == 0
             ? 0.0
             : (n_maps * planes_per_map + planes_per_section) *
                   transform_pairs_per_plane * rates.transform_time(grid);
}

double base_time(MachineRates& rates) {
  return rates.relative_time() * program_time;
}

double base_memory(bool uses_fem) {
  return program_memory + (uses_fem ? fem_memory : 0.0);
}

double map_bytes(const Grid& grid) {
  return 2.0 * sizeof(float) * packing * nodes(grid);
}

} // namespace asperity::run
