#include "reports/surface/surface_report.hpp"

#include "input/input_error.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/surface/surface_quantities.hpp"
#include "surfaces/formats/tabulated_spectrum.hpp"
#include "theory/persson/persson.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::reports {
namespace {

constexpr int contact_loads = 31;
constexpr double lightest_load = 1e-4; // in E* h'

theory::HeightSpectrum spectrum_for(const SurfaceReport& report) {
  if (!report.maps.empty()) {
    const surfaces::MapAnalysis& map = report.maps.front();
    std::vector<theory::SpectrumShell> shells;
    for (const surfaces::SpectrumRing& ring :
         surfaces::rings_between(map.spectrum.rings, 0.0, map.range.high))
      shells.push_back({ring.wavevector, ring.mean_square_height});
    return theory::HeightSpectrum(std::move(shells));
  }
  std::vector<double> wavevectors;
  std::vector<double> densities;
  for (const surfaces::SpectrumRing& row :
       reliable_rows(report.lines.front())) {
    wavevectors.push_back(row.wavevector);
    densities.push_back(row.density);
  }
  const surfaces::IsotropicSpectrum table =
      surfaces::TabulatedSpectrum(std::move(wavevectors), std::move(densities))
          .isotropic();
  return theory::HeightSpectrum(
      theory::SpectrumFormula{table.density, table.kinks});
}

/// A/A_0 = erf(sqrt(2) p/(E* h')) with the rms slope h' of all waves down to
/// each cut-off: G of Eq. (4) is (E* h')^2/8.
std::vector<CutOffArea>
areas_of_cut_offs(const std::vector<surfaces::SpectrumRing>& rings,
                  const PredictedContact& contact) {
  std::vector<CutOffArea> areas;
  areas.reserve(rings.size());
  double mean_square_slope = 0.0;
  for (const surfaces::SpectrumRing& ring : rings) {
    mean_square_slope +=
        ring.wavevector * ring.wavevector * ring.mean_square_height;
    const double variance =
        0.125 * std::pow(contact.contact_modulus, 2) * mean_square_slope;
    areas.push_back({2.0 * std::numbers::pi / ring.wavevector,
                     theory::area_fraction(contact.light_load, variance),
                     theory::area_fraction(contact.heavy_load, variance)});
  }
  return areas;
}

/// What would give a map a reliable range.
std::string remedy_for(const surfaces::MapAnalysis& map) {
  constexpr double enough = 8.0; // spacings of a side, for a factor of two
  const Grid& grid = map.map.grid;
  const double needed = enough * std::max(grid.spacing_x(), grid.spacing_y());
  if (std::min(grid.length_x, grid.length_y) < needed)
    return fmt::format(
        "its shorter side must be at least 8 times its larger spacing, {}, or "
        "half of that with --periodic if the map continues at its edges",
        quantity_text(needed, "m"));
  return "leave out --tip-radius, or use a scan of a larger part";
}

} // namespace

void require_reliable(const SurfaceReport& report) {
  const auto is_reliable = [](const auto& part) {
    return !reliable_rows(part).empty();
  };
  if (std::ranges::any_of(report.maps, is_reliable) ||
      std::ranges::any_of(report.lines, is_reliable))
    return;
  std::string text;
  for (const surfaces::MapAnalysis& map : report.maps)
    text +=
        fmt::format("{}{}: {} x {} points: {}; {}", text.empty() ? "" : "\n",
                    map.name, map.map.grid.points_x, map.map.grid.points_y,
                    range_text(map), remedy_for(map));
  for (const surfaces::LineAnalysis& line : report.lines)
    text += fmt::format("{}{}: {} points are too few for a spectrum; a line "
                        "scan of at least 64 points is needed",
                        text.empty() ? "" : "\n", line.name,
                        line.line.heights.size());
  throw input::InputError(text);
}

void add_contact(SurfaceReport& report, double contact_modulus, double gamma) {
  const theory::PerssonContact theory(spectrum_for(report), contact_modulus,
                                      gamma);
  PredictedContact contact;
  contact.contact_modulus = contact_modulus;
  contact.gamma = gamma;
  contact.rms_height = theory.spectrum().rms_height();
  contact.rms_slope = theory.spectrum().rms_slope();
  contact.wavevector_low = theory.spectrum().wavevector_low();
  contact.wavevector_high = theory.spectrum().wavevector_high();
  contact.decay_length = theory.gap_decay_length();
  contact.pressure_prefactor = theory.pressure_prefactor();
  const double scale = contact_modulus * contact.rms_slope;
  for (int i = 0; i < contact_loads; ++i) {
    const double share = static_cast<double>(i) / (contact_loads - 1);
    const double pressure = scale * std::pow(lightest_load, 1.0 - share);
    contact.loads.push_back(
        {pressure, theory.mean_gap(pressure), theory.area_fraction(pressure)});
  }
  contact.light_load = 0.01 * scale;
  contact.heavy_load = 0.1 * scale;
  if (!report.maps.empty())
    contact.cut_offs =
        areas_of_cut_offs(report.maps.front().spectrum.rings, contact);
  report.contact = std::move(contact);
}

} // namespace asperity::reports
