#include "run/methods/elastic_method.hpp"

#include "base/cpu_clock.hpp"
#include "fem/plugin.hpp"
#include "mechanics/adhesion_scales.hpp"
#include "results/observables/area_estimate.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/methods/continuum_block.hpp"
#include "run/methods/curve_row.hpp"
#include "run/methods/load_steps.hpp"
#include "run/methods/sharing.hpp"

#include <fmt/format.h>

#include <cstring>
#include <string>
#include <utility>

namespace asperity::methods {

/// Returns functions that read and write the cache entry `key`. The entry holds
/// the CPU time of the operator set-up, followed by the bytes of the operator.
///
/// @param threads           number of threads of the set-up; its time is
///                          measured from this call
/// @param saved_setup_time  [s], set when the entry is read; must outlive the
///                          returned functions
fem::OperatorCache operator_cache(Cache& cache, const std::string& key,
                                  int threads, double& saved_setup_time) {
  const auto read = [&cache, key, &saved_setup_time] {
    std::optional<std::string> bytes = cache.read(key, entry_kind::face);
    if (!bytes || bytes->size() < sizeof(double))
      return std::optional<std::string>();
    std::memcpy(&saved_setup_time, bytes->data(), sizeof(double));
    return std::optional(bytes->substr(sizeof(double)));
  };
  const auto write = [&cache, key,
                      clock = CpuClock(threads)](std::string_view bytes) {
    const double cost = clock.seconds();
    std::string kept(sizeof(double), '\0');
    std::memcpy(kept.data(), &cost, sizeof(double));
    cache.write(key, entry_kind::face, kept.append(bytes));
  };
  return {read, write};
}

namespace {

using mechanics::ContactSettings;
using mechanics::FemSettings;
using mechanics::HalfspaceSettings;

} // namespace

results::AreaCoefficients area_coefficients(const FemSettings& settings) {
  return settings.block.element == mechanics::Element::q1
             ? results::q1_area_coefficients(settings.block.surface_cell_depth)
             : results::q2_area_coefficients;
}

SolverFactory::SolverFactory(const mechanics::MaterialSpec& material,
                             Cache& cache, const CaseKeys& keys)
    : material_(material), cache_(cache), keys_(keys) {}

std::unique_ptr<StepSolver> SolverFactory::make(const cases::MethodSpec& method,
                                                const SurfaceOfCase& surface,
                                                const Workforce& workforce) {
  const auto* block = std::get_if<FemSettings>(&method.settings);
  const mechanics::ElasticBlock continuum =
      continuum_of(method, material_, surface.scales);
  const ContactSettings& contact =
      block != nullptr ? block->contact
                       : std::get<HalfspaceSettings>(method.settings).contact;
  const mechanics::Scales scales =
      method.is_adhesive()
          ? mechanics::adhesion_scales(surface.scales, surface.record.grid)
          : surface.scales;
  LoadStepsSetting setting{
      contact.in_si(scales), contact.tolerance * surface.scales.rms_height,
      contact.max_iterations, workforce.threads, surface.scales.rms_height};
  Observation& observation = setting.observation;
  observation.local_compliance = setting.interface.local_compliance();
  observation.area_coefficients = block != nullptr
                                      ? area_coefficients(*block)
                                      : results::halfspace_area_coefficients;
  observation.contact_modulus =
      boundary_modulus(continuum, surface.scales.spacing);
  observation.has_middle = surface.has_middle;
  observation.border = continuum.border;
  observation.criterion = method.contact_criterion(surface.scales.rms_height);
  observation.hardness = setting.interface.hardness;
  if (method.is_adhesive()) {
    observation.adhesion = setting.interface;
    observation.grid_number =
        setting.interface.grid_number(scales.contact_modulus, scales.spacing);
  }
  const Grid& grid = surface.record.grid;
  if (continuum.is_free())
    observation.area_coefficients = results::free_area_coefficients;
  if (workforce.ranks != nullptr &&
      is_shared_by_ranks(method, grid, workforce.ranks->size())) {
    setting.threads = workforce.threads_a_rank;
    auto elasticity = operator_on_ranks(method, surface, workforce);
    const auto own = elasticity->rows().own(surface.record.heights);
    return make_load_steps(std::move(elasticity), {own.begin(), own.end()},
                           setting);
  }
  Face face = shared_operator(method, surface, workforce.threads);
  setting.saved_setup_time = face.saved_setup_time;
  return make_load_steps(std::move(face.elasticity), surface.record.heights,
                         setting);
}

std::unique_ptr<contact::SurfaceOperator>
SolverFactory::operator_on_ranks(const cases::MethodSpec& method,
                                 const SurfaceOfCase& surface,
                                 const Workforce& workforce) const {
  const Grid& grid = surface.record.grid;
  const int threads = workforce.threads_a_rank;
  if (const auto* block = std::get_if<FemSettings>(&method.settings))
    return fem::load_fem_module().condensed_on_ranks(
        request(*block, surface, threads));
  return std::make_unique<contact::FourierOperator>(
      grid, *workforce.ranks,
      contact::compliance_column(
          grid, continuum_of(method, material_, surface.scales)),
      threads);
}

SolverFactory::Face
SolverFactory::shared_operator(const cases::MethodSpec& method,
                               const SurfaceOfCase& surface, int threads) {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<contact::SurfaceOperator>& kept =
      operators_[keys_.operator_text(method, surface.record.grid)];
  if (kept)
    return {kept->clone(), 0.0};
  Face built = build_operator(method, surface, threads);
  kept = std::move(built.elasticity);
  return {kept->clone(), built.saved_setup_time};
}

SolverFactory::Face
SolverFactory::build_operator(const cases::MethodSpec& method,
                              const SurfaceOfCase& surface, int threads) {
  if (std::holds_alternative<HalfspaceSettings>(method.settings))
    return {contact::halfspace_operator(
                surface.record.grid,
                continuum_of(method, material_, surface.scales), threads)
                .clone(),
            0.0};
  // Loading is not part of the cached set-up time.
  const fem::FemModule& fem_module = fem::load_fem_module();
  Face face;
  fem::BlockRequest asked =
      request(std::get<FemSettings>(method.settings), surface, threads);
  asked.cache = operator_cache(
      cache_,
      keys_.of_operator(keys_.operator_text(method, surface.record.grid)),
      threads, face.saved_setup_time);
  face.elasticity = fem_module.condensed(asked);
  return face;
}

fem::BlockRequest SolverFactory::request(const FemSettings& settings,
                                         const SurfaceOfCase& surface,
                                         int threads) const {
  return {surface.record.grid,
          settings.block,
          surface.scales,
          material_.block_youngs_modulus(),
          *material_.poisson_ratio,
          threads,
          {},
          material_.layers};
}

} // namespace asperity::methods
