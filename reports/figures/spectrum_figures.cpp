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
                   CsvTable& table, std::vector<std::string>& plots) {
  const surfaces::IsotropicSpectrum formula = surfaces::formula_spectrum(spec);
  const double ratio = spec.wavevector_high / spec.wavevector_low;
  for (int k = 0; k <= 200; ++k) {
    const double q = std::min(spec.wavevector_low * std::pow(ratio, k / 200.0) *
                                  (1.0 + 1e-12),
                              spec.wavevector_high);
    table.add("formula", {static_cast<double>(index), q, formula.density(q)});
  }
  plots.push_back(fmt::format(
      "'spectrum.csv' using ($2=={} ? $3 : NaN):4 with lines linewidth 1.5 "
      "linecolor rgb '#222222' title 'formula'",
      index));
  return 0.03 * formula.density(spec.wavevector_high);
}

} // namespace

std::optional<Figure> spectrum_figure(const ReportEntry& entry) {
  const auto& surfaces = entry.result->surfaces;
  const mechanics::SurfaceSpec& spec = entry.contact_case->surface;
  Figure figure;
  figure.name = "spectrum";
  figure.title = "Power spectrum";
  CsvTable table({"curve", "index", "q [1/m]", "C [m^4]"});
  std::vector<std::string> plots;
  const auto add = [&](const results::SurfaceRecord& surface, std::size_t index,
                       const std::string& name, std::size_t color) {
    if (surface.spectrum.empty())
      return;
    for (const results::SpectrumPoint& point : surface.spectrum)
      if (point.spectrum > 0.0)
        table.add(name, {static_cast<double>(index), point.wavevector,
                         point.spectrum});
    plots.push_back(fmt::format(
        "'spectrum.csv' using ($2=={} ? $3 : NaN):4 with points pointtype 6 "
        "pointsize 0.5 linewidth 1 linecolor rgb '{}' title {}",
        index, method_color(color), gnuplot_text(name)));
  };
  for (std::size_t r = 0; r < surfaces.size(); ++r)
    add(surfaces[r], r, fmt::format("realisation {}", r), r);
  const auto sum = sum_of_two_surfaces(*entry.result);
  if (sum)
    add(*sum, surfaces.size() + 1, "sum of both", surfaces.size());
  if (plots.empty())
    return std::nullopt;
  figure.caption = "C(q) with ⟨h²⟩ = 2π ∫ q C dq, averaged over rings of equal "
                   "|q|.";
  double floor = 0.0; // of the axis: hides roundoff beyond the cut-off
  if (spec.kind == mechanics::SurfaceKind::self_affine) {
    floor = add_formula(spec, surfaces.size(), table, plots);
    if (sum) {
      plots.push_back(fmt::format(
          "'spectrum.csv' using ($2=={} ? $3 : NaN):(2*$4) with lines "
          "linewidth 1.5 dashtype 2 linecolor rgb '#222222' title 'twice the "
          "formula'",
          surfaces.size()));
      figure.caption += fmt::format(
          " The spectrum of the sum of both surfaces is expected to be C_0 + "
          "C_1: their ratio is {:.3f} on average between roll-off and cut-off.",
          sum_spectrum_ratio(*entry.result, *sum, spec.wavevector_roll_off,
                             spec.wavevector_high));
    }
    figure.caption += fmt::format(
        " Line: the case's own formula, H = {:.3g}, roll-off at 2π/{:.3g} µm.",
        spec.hurst, 2e6 * std::acos(-1.0) / spec.wavevector_roll_off);
  }
  figure.script = fmt::format(
      "set logscale xy\nset format '10^{{%T}}'\nset xlabel {}\nset ylabel {}\n"
      "set yrange [{}:*]\n{}",
      gnuplot_markup("q [1/m]"), gnuplot_markup("C(q) [m^4]"),
      floor > 0.0 ? fmt::format("{:.3g}", floor) : "*", plot_of(plots));
  figure.data = table.text();
  return figure;
}

} // namespace asperity::reports
