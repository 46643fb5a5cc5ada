#include "run/methods/surfaces_of_case.hpp"

#include "input/input_error.hpp"
#include "run/methods/chosen.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"

#include <algorithm>
#include <utility>

namespace asperity::methods {
namespace {

/// @throws input::InputError  the surface is flat
SurfaceOfCase as_taken(const cases::Case& contact_case, SurfaceOfCase surface) {
  if (!(surface.record.rms_height > 0.0))
    throw input::InputError(contact_case.path +
                            ": the surface is flat; there is no roughness "
                            "to press on");
  surface.has_middle = contact_case.surface.has_middle();
  if (const Grid map = grid_without_images(contact_case, surface.record.grid);
      map != surface.record.grid)
    surface.record.map = {map.points_x, map.points_y};
  return surface;
}

bool presses_single_map(const cases::Case& contact_case,
                        const cases::MethodSpec& method) {
  const auto* half =
      std::get_if<mechanics::HalfspaceSettings>(&method.settings);
  return half != nullptr && half->has_free_boundaries &&
         contact_case.surface.kind == mechanics::SurfaceKind::measured;
}

/// Whether a method presses the heights of the surface of the case, of a
/// measured map with its periodic continuation.
bool presses_whole(const cases::Case& contact_case,
                   const cases::MethodSpec& method) {
  return method.needs_surface() &&
         !std::holds_alternative<mechanics::TheorySettings>(method.settings) &&
         !presses_single_map(contact_case, method);
}

/// Returns the measured map without its periodic continuation. Slope, curvature
/// and spectrum are those of the continuation: a step at the border, which no
/// method presses, would dominate them.
/// @param surface  with the continuation
SurfaceOfCase single_map(const cases::Case& contact_case, SurfaceOfCase surface,
                         const BuildSurface& build) {
  surface.record.heights = {};
  surface.record.map = {};
  mechanics::SurfaceSpec alone = contact_case.surface;
  alone.has_images = false;
  SurfaceOfCase built = build({alone, 0});
  surface.record.grid = built.record.grid;
  surface.record.heights = std::move(built.record.heights);
  surface.scales.length = surface.record.grid.length_x;
  surface.has_middle = true;
  return surface;
}

} // namespace

bool presses_images(const cases::Case& contact_case,
                    const std::vector<cases::MethodSpec>& methods) {
  return std::ranges::none_of(methods,
                              [&](const cases::MethodSpec& method) {
                                return presses_single_map(contact_case, method);
                              }) ||
         std::ranges::any_of(methods, [&](const cases::MethodSpec& method) {
           return method.magnification || presses_whole(contact_case, method);
         });
}

Grid pressed_grid(const cases::Case& contact_case,
                  const cases::MethodSpec& method, const Grid& grid) {
  return presses_single_map(contact_case, method)
             ? grid_without_images(contact_case, grid)
             : grid;
}

Grid grid_without_images(const cases::Case& contact_case, const Grid& grid) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  const mechanics::Edges edges = surface.edges;
  if (surface.kind != mechanics::SurfaceKind::measured ||
      surfaces::grid_with_edges(grid, edges).points_x == grid.points_x)
    return grid;
  return {grid.points_x / 2, grid.points_y / 2, grid.length_x / 2.0,
          grid.length_y / 2.0};
}

SurfaceOfCase surface_of_map(const surfaces::HeightMap& map,
                             double contact_modulus) {
  const Grid& grid = map.grid;
  const surfaces::Statistics numbers = surfaces::statistics(map);
  SurfaceOfCase surface;
  surface.shells = surfaces::spectral_shells(map);
  results::SurfaceRecord& record = surface.record;
  record.grid = grid;
  record.rms_height = numbers.rms_height;
  record.rms_slope = numbers.rms_slope;
  record.rms_curvature = numbers.rms_curvature;
  record.skewness = numbers.skewness;
  record.kurtosis = numbers.kurtosis;
  record.highest = numbers.highest;
  for (const surfaces::Shell& shell : surface.shells)
    record.spectrum.push_back(
        {shell.wavevector, surfaces::shell_density(shell, grid)});
  surface.scales = {contact_modulus, grid.length_x, grid.spacing_x(),
                    record.rms_height, record.rms_slope};
  record.heights = map.heights;
  return surface;
}

SurfaceOfCase whole_surface(const SurfaceSource& source,
                            double contact_modulus) {
  surfaces::MeasuredMap facts;
  SurfaceOfCase surface = surface_of_map(
      source.highest_wavevector
          ? surfaces::build_surface_on(source.surface, source.realization,
                                       source.grid, source.highest_wavevector)
          : surfaces::build_surface(source.surface, source.realization, &facts),
      contact_modulus);
  if (source.surface.kind == mechanics::SurfaceKind::measured)
    surface.map_facts = facts;
  return surface;
}

BuildSurface surfaces_of_rank_0(RootWork& root, double contact_modulus) {
  struct Numbers {
    Grid grid;
    mechanics::Scales scales;
  };

  return [&root, contact_modulus](const SurfaceSource& source) {
    SurfaceOfCase surface;
    root.act([&] { surface = whole_surface(source, contact_modulus); });
    const auto [grid, scales] = root.value([&] {
      return Numbers{surface.record.grid, surface.scales};
    });
    surface.record.grid = grid;
    surface.record.rms_height = scales.rms_height;
    surface.scales = scales;
    surface.record.heights =
        root.value([&] { return std::move(surface.record.heights); });
    return surface;
  };
}

bool needs_surfaces(const std::vector<cases::MethodSpec>& methods) {
  return std::ranges::any_of(methods, &cases::MethodSpec::needs_surface);
}

std::optional<double> highest_wavevector(const cases::Case& contact_case,
                                         const cases::MethodSpec& method) {
  if (!method.magnification)
    return std::nullopt;
  return *method.magnification * contact_case.surface.wavevector_roll_off;
}

CaseSurfaces::CaseSurfaces(const cases::Case& contact_case,
                           const std::vector<cases::MethodSpec>& methods,
                           const std::set<int>& only, const BuildSurface& build)
    : case_(contact_case) {
  if (!needs_surfaces(methods))
    return;
  const BuildSurface build_one =
      build ? build : [this](const SurfaceSource& source) {
        return whole_surface(source, case_.material.contact_modulus);
      };
  const auto is_built = [&](int r) { return only.empty() || only.contains(r); };
  for (int r = 0; r < contact_case.surface.realizations; ++r)
    whole_.push_back(
        is_built(r)
            ? as_taken(contact_case, build_one({contact_case.surface, r}))
            : SurfaceOfCase{});
  const bool has_single_map =
      std::ranges::any_of(methods, [&](const cases::MethodSpec& method) {
        return presses_single_map(contact_case, method);
      });
  if (!presses_images(contact_case, methods))
    whole_.front() =
        single_map(contact_case, std::move(whole_.front()), build_one);
  else if (has_single_map)
    single_map_ = single_map(contact_case, whole_.front(), build_one);
  for (const cases::MethodSpec& method : methods) {
    if (!method.magnification || !method.needs_surface() ||
        magnified_.contains(*method.magnification))
      continue;
    const double highest = *highest_wavevector(contact_case, method);
    std::vector<SurfaceOfCase>& shown = magnified_[*method.magnification];
    for (int r = 0; r < contact_case.surface.realizations; ++r)
      shown.push_back(
          is_built(r)
              ? as_taken(contact_case,
                         build_one(
                             {contact_case.surface, r, highest,
                              whole_[static_cast<std::size_t>(r)].record.grid}))
              : SurfaceOfCase{});
  }
}

const std::vector<SurfaceOfCase>& CaseSurfaces::whole() const {
  return whole_;
}

std::optional<surfaces::MeasuredMap> CaseSurfaces::map_facts() const {
  return whole_.empty() ? std::nullopt : whole_.front().map_facts;
}

bool CaseSurfaces::has_own(const cases::MethodSpec& method) const {
  return method.magnification ||
         (single_map_ && presses_single_map(case_, method));
}

const SurfaceOfCase& CaseSurfaces::of(const cases::MethodSpec& method,
                                      int realization) const {
  const auto r = static_cast<std::size_t>(realization);
  if (method.magnification)
    return magnified_.at(*method.magnification).at(r);
  return has_own(method) ? single_map_.value() : whole_.at(r);
}

results::SurfaceRecord CaseSurfaces::record_of(const cases::MethodSpec& method,
                                               int realization) const {
  if (method.needs_surface())
    return of(method, realization).record;
  const theory::HeightSpectrum spectrum = formula_of_case(case_, method);
  results::SurfaceRecord record;
  record.rms_height = spectrum.rms_height();
  record.rms_slope = spectrum.rms_slope();
  return record;
}

theory::HeightSpectrum formula_of_case(const cases::Case& contact_case,
                                       const cases::MethodSpec& method) {
  const surfaces::IsotropicSpectrum formula =
      surfaces::formula_spectrum(contact_case.surface);
  theory::HeightSpectrum spectrum(
      theory::SpectrumFormula{formula.density, formula.kinks});
  const std::optional<double> highest =
      highest_wavevector(contact_case, method);
  return highest ? spectrum.between(0.0, *highest) : spectrum;
}

theory::HeightSpectrum spread_spectrum_of(const SurfaceOfCase& surface) {
  const surfaces::Shell& first = surface.shells.front();
  const double mode_area =
      first.mean_square_height /
      (first.modes * surface.record.spectrum.front().spectrum);
  const surfaces::IsotropicSpectrum spread =
      surfaces::spread_spectrum(surface.shells, mode_area);
  return theory::HeightSpectrum(
      theory::SpectrumFormula{spread.density, spread.kinks});
}

theory::HeightSpectrum spectrum_of(const SurfaceOfCase& surface) {
  std::vector<theory::SpectrumShell> shells;
  for (const surfaces::Shell& shell : surface.shells)
    shells.push_back({shell.wavevector, shell.mean_square_height});
  return theory::HeightSpectrum(std::move(shells));
}

mechanics::Scales formula_scales(const cases::Case& contact_case,
                                 const theory::HeightSpectrum& spectrum) {
  const double length = contact_case.surface.length.value_or(0.0);
  const int points = contact_case.surface.points.value_or(0);
  return {contact_case.material.contact_modulus, length,
          points > 0 ? length / points : 0.0, spectrum.rms_height(),
          spectrum.rms_slope()};
}

} // namespace asperity::methods
