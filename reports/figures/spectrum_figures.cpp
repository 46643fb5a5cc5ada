#include "base/shown_number.hpp"
#include "reports/analysis/two_surfaces.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

/// Adds the spectrum of the case's formula as a line.
/// @param index  of the line in the table
/// @return       the smallest C(q) that the axis shows [m^4]
double add_formula(const mechanics::SurfaceSpec& spec, std::size_t index,
                   CsvTable& table, ChartPanel& panel) {
  const surfaces::IsotropicSpectrum formula = surfaces::formula_spectrum(spec);
  const double ratio = spec.wavevector_high / spec.wavevector_low;
  for (int k = 0; k <= 200; ++k) {
    const double q = std::min(spec.wavevector_low * std::pow(ratio, k / 200.0) *
                                  (1.0 + 1e-12),
                              spec.wavevector_high);
    table.add("formula", {static_cast<double>(index), q, formula.density(q)});
  }
  panel.add("formula", line("#222222", 1.5), index, 3, 4);
  return 0.03 * formula.density(spec.wavevector_high);
}

std::optional<Figure> spectrum_figure(const ReportEntry& entry) {
  const auto& surfaces = entry.result->surfaces;
  const mechanics::SurfaceSpec& spec = entry.contact_case->surface;
  Figure figure;
  figure.name = "spectrum";
  figure.title = "Power spectrum";
  CsvTable table({"curve", "index", "q [1/m]", "C [m^4]"});
  ChartPanel panel{
      .x = {.label = "q [1/m]", .is_log = true, .has_powers = true},
      .y = {.label = "C(q) [m^4]", .is_log = true, .has_powers = true}};
  const auto add = [&](const results::SurfaceRecord& surface, std::size_t index,
                       const std::string& name, std::size_t color) {
    if (surface.spectrum.empty())
      return;
    for (const results::SpectrumPoint& point : surface.spectrum)
      if (point.spectrum > 0.0)
        table.add(name, {static_cast<double>(index), point.wavevector,
                         point.spectrum});
    panel.add(name, markers(method_color(color), map_sign(entry), 0.4), index,
              3, 4);
  };
  for (std::size_t r = 0; r < surfaces.size(); ++r)
    add(surfaces[r], r, fmt::format("realisation {}", r), r);
  const auto sum = sum_of_two_surfaces(*entry.result);
  if (sum)
    add(*sum, surfaces.size() + 1, "sum of both", surfaces.size());
  if (panel.curves.empty())
    return std::nullopt;
  figure.caption = "C(q) with ⟨h²⟩ = 2π ∫ q C dq, averaged over rings of equal "
                   "|q|.";
  if (spec.kind == mechanics::SurfaceKind::self_affine) {
    // Roundoff beyond the cut-off is hidden.
    const double floor = add_formula(spec, surfaces.size(), table, panel);
    if (floor > 0.0)
      panel.y.low = rounded(floor, 3);
    if (sum) {
      panel
          .add("twice the formula", line("#222222", 1.5, 2), surfaces.size(), 3,
               4)
          .factor = 2.0;
      figure.caption += fmt::format(
          " The spectrum of the sum of both surfaces is expected to be C_0 + "
          "C_1: their ratio is {:.3f} on average between roll-off and cut-off.",
          sum_spectrum_ratio(*entry.result, *sum, spec.wavevector_roll_off,
                             spec.wavevector_high));
    }
    figure.caption += fmt::format(
        " Line: the case's own formula, H = {:.3g}, roll-off at 2π/({}).",
        spec.hurst,
        quantity_text(2.0 * std::acos(-1.0) / spec.wavevector_roll_off, "m",
                      3));
  }
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

} // namespace

const ReportFigure figures::spectrum{.names = {"spectrum"},
                                     .section = FigureSection::contact,
                                     .draw = drawn_by<spectrum_figure>};

} // namespace asperity::reports
