#include "run/plan/plan.hpp"

#include "base/available_memory.hpp"
#include "fem/plugin.hpp"
#include "input/input_error.hpp"
#include "input/reader/locking.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/methods.hpp"
#include "run/methods/sharing.hpp"
#include "run/methods/step_chain.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "run/methods/worker_pool.hpp"
#include "run/plan/needs.hpp"
#include "run/plan/preparation.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace asperity::run {
namespace {

using cases::MethodSpec;

/// Limit on cache look-ups per method. Without it the plan of ten million steps
/// would take hours.
constexpr std::size_t most_lookups = 20000;

/// Counts the cached steps of a method. If there are too many steps to look up,
/// only the first realisations are counted.
int kept_steps(const cases::Case& contact_case, const MethodSpec& method,
               std::span<const int> realizations, const methods::CaseKeys& keys,
               methods::Cache& cache) {
  if (!cache.is_on())
    return 0;
  const std::size_t n_counted =
      std::max(std::size_t{1}, most_lookups / contact_case.load.targets.size());
  int kept = 0;
  for (const int r :
       realizations.first(std::min(n_counted, realizations.size()))) {
    const methods::StepChain chain(cache, keys.steps(method, r));
    for (std::size_t step = 0; step < contact_case.load.targets.size(); ++step)
      kept += chain.has(step) ? 1 : 0;
  }
  return kept;
}

/// Lets the ranks of mpirun share the rows of a method, if they do: the memory
/// is then that of the ranks on this machine.
/// @param grid  that the method presses
void share_by_ranks(const MethodSpec& method, const Grid& grid,
                    const RunOptions& options, PlannedMethod& planned) {
  if (!method.has_fields())
    return;
  planned.why_alone = methods::obstacle_to_sharing(method, grid, options.ranks);
  if (!methods::is_shared_by_ranks(method, grid, options.ranks))
    return;
  planned.ranks = options.ranks;
  planned.runs_alone = true;
  planned.rank_memory = memory_of_rank(method, grid, options.ranks);
  planned.memory = options.ranks_on_machine * planned.rank_memory +
                   (options.ranks_on_machine - 1) * base_memory(true);
}

double predicted_peak(const Plan& plan, const Grid& grid, double n_surfaces,
                      double program) {
  std::vector<double> jobs;
  double alone = 0.0;
  for (const PlannedMethod& method : plan.methods) {
    if (method.kept_steps == method.steps)
      continue;
    if (method.runs_alone)
      alone = std::max(alone, method.memory);
    else
      jobs.insert(jobs.end(), static_cast<std::size_t>(method.realizations),
                  method.memory);
  }
  std::sort(jobs.rbegin(), jobs.rend());
  double beside = 0.0;
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (i < static_cast<std::size_t>(plan.threads))
      beside += jobs[i];
  const double surfaces =
      sizeof(double) * static_cast<double>(grid.size()) * n_surfaces;
  return program + surfaces + std::max(beside, alone);
}

/// Number of surfaces that are held in memory.
double held_surfaces(const cases::Case& contact_case,
                     const RunOptions& options) {
  return options.realizations.empty()
             ? contact_case.surface.realizations
             : static_cast<double>(options.realizations.size());
}

double result_bytes(const cases::Case& contact_case,
                    const std::vector<MethodSpec>& methods, const Grid& grid) {
  if (!methods::needs_surfaces(methods))
    return 0.0;
  double bytes = sizeof(double) * static_cast<double>(grid.size()) *
                 contact_case.surface.realizations;
  for (const MethodSpec& method : methods)
    if (method.has_fields())
      bytes +=
          static_cast<double>(methods::steps_with_fields(contact_case).size()) *
          map_bytes(grid);
  return bytes;
}

/// Memory of a report whose maps are read by pieces [B]: pieces of two maps and
/// their chunks, and for the spectrum of the surface columns of it
/// (surfaces/maps/mode_power.hpp) and its shells.
double memory_of_pieces(double nodes) {
  constexpr double pieces = 2e8; // [B]
  constexpr double per_node = 2.0;
  return pieces + per_node * nodes;
}

/// Memory of the stresses below one map, which is whole [B]: the pressure and
/// its spectrum, the spectra and the fields of six components of a plane and
/// their norm, and the waves of each layer.
double memory_of_stresses(const cases::Case& contact_case, double nodes) {
  const auto layers =
      static_cast<double>(contact_case.material.layers.size() + 1);
  return (sizeof(double) * (2.0 + 6.0 * 2.0 + 1.0) + 16.0 * layers) * nodes;
}

/// Memory of a result that is read after the jobs, when the fields of the
/// solvers are free [B]. Maps below results::large_map are read as a whole, in
/// double precision: heights, and those of the saved steps of realisation 0.
double memory_of_result(const cases::Case& contact_case,
                        const std::vector<MethodSpec>& methods,
                        const Grid& grid, const RunOptions& options) {
  const bool has_stresses = contact_case.report.stress_inside;
  if (!methods::needs_surfaces(methods) ||
      (!options.has_report && !has_stresses))
    return 0.0;
  const auto nodes = static_cast<double>(grid.size());
  const double stresses =
      has_stresses ? memory_of_stresses(contact_case, nodes) : 0.0;
  if (grid.size() >= results::large_map)
    return std::max(stresses, memory_of_pieces(nodes));
  const auto n_methods = static_cast<double>(
      std::ranges::count_if(methods, &MethodSpec::has_fields));
  const double maps =
      contact_case.surface.realizations +
      2.0 * n_methods *
          static_cast<double>(methods::steps_with_fields(contact_case).size());
  return stresses + sizeof(double) * maps * nodes;
}

/// @param kept  steps that the cache has
PlannedMethod planned_method(const cases::Case& contact_case,
                             const MethodSpec& method, const Grid& grid,
                             const RunOptions& options, int kept) {
  const MethodNeeds needs = needs_of(contact_case, method, grid, options.ranks);
  PlannedMethod planned{.name = method.name, .grid = grid};
  planned.realizations = static_cast<int>(
      methods::realizations_of(contact_case, method, options.realizations)
          .size());
  planned.steps =
      planned.realizations * static_cast<int>(contact_case.load.targets.size());
  planned.kept_steps = kept;
  planned.unknowns = needs.unknowns;
  planned.memory = needs.memory;
  planned.runs_alone =
      methods::describe(method, contact_case.material).runs_alone;
  share_by_ranks(method, methods::pressed_grid(contact_case, method, grid),
                 options, planned);
  if (!method.needs_surface())
    planned.grid = {};
  return planned;
}

} // namespace

Plan make_plan(const cases::Case& contact_case, const RunOptions& options) {
  const std::vector<MethodSpec> methods =
      methods::chosen_methods(contact_case, options.methods);
  const Grid grid = grid_of_case(contact_case, methods);
  require_computable(contact_case, methods, grid);
  if (const auto& variation = contact_case.material.variation;
      variation && variation->kind == mechanics::VariationKind::table)
    fem::read_factor_table(variation->file, {1.0, 1.0, 1.0});
  const methods::CaseKeys keys(contact_case, methods::program_identity());
  methods::Cache none;
  methods::Cache& cache = options.cache != nullptr ? *options.cache : none;
  Plan plan;
  plan.warnings = cases::warnings_about(contact_case, methods);
  plan.threads = methods::WorkerPool(options.threads).threads();
  bool uses_fem = false;
  bool uses_block = false;
  for (const MethodSpec& method : methods) {
    const int kept = kept_steps(
        contact_case, method,
        methods::realizations_of(contact_case, method, options.realizations),
        keys, cache);
    PlannedMethod planned =
        planned_method(contact_case, method, grid, options, kept);
    const bool is_left = planned.steps > kept;
    uses_fem |= is_left &&
                std::holds_alternative<mechanics::FemSettings>(method.settings);
    uses_block |= is_left && methods::is_full_block(method);
    plan.methods.push_back(std::move(planned));
  }
  const double program = base_memory(uses_fem, uses_block);
  const Grid kept = methods::presses_images(contact_case, methods)
                        ? grid
                        : methods::grid_without_images(contact_case, grid);
  plan.memory = std::max(
      predicted_peak(plan, grid, held_surfaces(contact_case, options), program),
      program + memory_of_result(contact_case, methods, kept, options));
  plan.disk = result_bytes(contact_case, methods, kept);
  plan.skipped = skipped_by_case({contact_case, methods, grid});
  return plan;
}

std::string refusal_of(const Plan& plan) {
  const std::string shortage = memory_shortage(plan.memory);
  return shortage.empty()
             ? ""
             : shortage +
                   "; reduce surface.points, surface.realizations or --threads";
}

void require_memory(const cases::Case& contact_case,
                    const RunOptions& options) {
  if (!contact_case.surface.points)
    return;
  const std::string refusal = refusal_of(make_plan(contact_case, options));
  if (!refusal.empty())
    throw input::InputError(
        fmt::format("{}: surface.points = {} with {} realisation(s) {}",
                    contact_case.path, *contact_case.surface.points,
                    contact_case.surface.realizations, refusal));
}

} // namespace asperity::run
