#include "run/provenance_of_run.hpp"

#include "fem/plugin.hpp"
#include "surfaces/measured_map.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace asperity::run {
namespace {

/// Describes for the report how the window function changes a measured map.
std::string words_of(const surfaces::EdgeEffect& effect) {
  const auto& [measured, pressed] = effect;
  return fmt::format("the window changes the rms height of the measured map "
                     "from {:.3g} nm to {:.3g} nm (factor {:.2f}) and the rms "
                     "slope from {:.3g} to {:.3g} (factor {:.2f})",
                     measured.rms_height * 1e9, pressed.rms_height * 1e9,
                     pressed.rms_height / measured.rms_height,
                     measured.rms_slope, pressed.rms_slope,
                     pressed.rms_slope / measured.rms_slope);
}

std::string words_of_cut_off(double asked, const surfaces::MeasuredMap& map) {
  const double wavelength = asked > 0.0 ? asked : map.cut_off;
  if (wavelength == 0.0)
    return "no waves removed: the spectrum has no noise floor";
  return fmt::format("waves shorter than {:.6g} nm removed{}", wavelength * 1e9,
                     asked > 0.0 ? "" : ", those in the noise floor");
}

} // namespace

results::Provenance
provenance_at_start(const cases::Case& contact_case, int threads,
                    const std::optional<surfaces::MeasuredMap>& found) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  results::Provenance facts = results::program_facts();
  facts.emplace_back("threads", std::to_string(threads));
  facts.emplace_back("seed", std::to_string(surface.seed));
  facts.emplace_back("realizations", std::to_string(surface.realizations));
  facts.emplace_back("started", results::utc_now());
  if (surface.kind != mechanics::SurfaceKind::measured)
    return facts;
  const surfaces::MeasuredMap map =
      found ? *found : surfaces::measured_map(surface);
  facts.emplace_back("map", surfaces::description_of(map));
  if (found)
    if (const std::vector<std::string> warnings =
            surfaces::warnings_of(found->faults);
        !warnings.empty())
      facts.emplace_back("map warnings",
                         fmt::format("{}", fmt::join(warnings, ". ")));
  if (surface.cut_off)
    facts.emplace_back("cut-off", words_of_cut_off(*surface.cut_off, map));
  if (surface.edges == mechanics::Edges::window)
    facts.emplace_back("window", words_of(surfaces::edge_effect(surface)));
  return facts;
}

results::Provenance provenance_of_fem() {
  return {{"deal.II", fem::load_fem_module().versions()}};
}

} // namespace asperity::run
