#include "app/run/provenance_of_run.hpp"

#include "fem/plugin.hpp"
#include "surfaces/measured_map.hpp"
#include "surfaces/measured_rows.hpp"

#include <fmt/format.h>

#include <string>

namespace asperity::app {
namespace {

/// Describes for the report how the window function changes a measured map.
std::string effect_of_window(const mechanics::SurfaceSpec& surface) {
  const auto [measured, pressed] = surfaces::edge_effect(surface);
  return fmt::format("the window changes the rms height of the measured map "
                     "from {:.3g} nm to {:.3g} nm (factor {:.2f}) and the rms "
                     "slope from {:.3g} to {:.3g} (factor {:.2f})",
                     measured.rms_height * 1e9, pressed.rms_height * 1e9,
                     pressed.rms_height / measured.rms_height,
                     measured.rms_slope, pressed.rms_slope,
                     pressed.rms_slope / measured.rms_slope);
}

} // namespace

results::Provenance provenance_at_start(const cases::Case& contact_case,
                                        int threads) {
  results::Provenance facts = results::program_facts();
  facts.emplace_back("threads", std::to_string(threads));
  facts.emplace_back("seed", std::to_string(contact_case.surface.seed));
  facts.emplace_back("realizations",
                     std::to_string(contact_case.surface.realizations));
  facts.emplace_back("started", results::utc_now());
  if (contact_case.surface.kind == mechanics::SurfaceKind::measured)
    facts.emplace_back("map", surfaces::description_of(surfaces::described_map(
                                  contact_case.surface)));
  if (contact_case.surface.kind == mechanics::SurfaceKind::measured &&
      contact_case.surface.edges == mechanics::Edges::window)
    facts.emplace_back("window", effect_of_window(contact_case.surface));
  return facts;
}

results::Provenance provenance_of_fem() {
  return {{"deal.II", fem::load_fem_module().versions()}};
}

} // namespace asperity::app
