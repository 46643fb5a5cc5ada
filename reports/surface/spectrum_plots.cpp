// The figures of spectra of a surface report.
#include "base/special_numbers.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/surface/surface_figures.hpp"
#include "reports/surface/surface_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

constexpr double shown_per_decade = 15.0;

/// Returns the logarithmic axes of C(q).
ChartPanel spectrum_panel() {
  return {.x = {.label = "q [1/m]", .is_log = true, .has_powers = true},
          .y = {.label = "C(q) [m^4]", .is_log = true, .has_powers = true}};
}

/// A vertical line with its name beside it.
void add_limit(ChartPanel& panel, double wavevector, const std::string& name) {
  const double place = rounded(wavevector, 6);
  panel.marks.push_back(
      {.low = place, .high = place, .color = "#8a5a00", .label = name});
}

/// Shades the wavevectors that are not reliable.
void shade_unreliable(ChartPanel& panel, double low, double high) {
  for (const auto& [start, end] : {std::pair(-infinity, rounded(low, 6)),
                                   std::pair(rounded(high, 6), infinity)})
    panel.marks.push_back(
        {.low = start, .high = end, .color = "#59636e", .opacity = 0.1});
}

void add_model(const surfaces::SelfAffineFit& fit, CsvTable& table) {
  const double ratio = fit.wavevector_high / fit.wavevector_low;
  for (int k = 0; k <= 100; ++k) {
    const double q = fit.wavevector_low * std::pow(ratio, k / 100.0);
    table.add("model", {1.0, q, fit.density(q), std::nan(""), std::nan("")});
  }
}

std::string model_caption(const surfaces::SelfAffineFit& fit) {
  std::string text = " Line: the fitted self-affine model,";
  for (const FittedQuantity& quantity : quantities_of(fit))
    if (std::isfinite(quantity.parameter.value))
      text += fmt::format(" {} = {};", quantity.symbol, fitted_text(quantity));
  text.back() = '.';
  return text;
}

} // namespace

Figure map_spectrum_figure(const surfaces::MapAnalysis& map) {
  Figure figure;
  figure.name = "map-spectrum";
  figure.title = "Power spectrum";
  CsvTable table(
      {"curve", "index", "q [1/m]", "C [m^4]", "low [m^4]", "high [m^4]"});
  double lowest = HUGE_VAL;
  for (const surfaces::SpectrumRing& ring :
       joined_rings(map.spectrum.rings, shown_per_decade)) {
    const surfaces::DensityInterval interval = confidence_of(ring);
    table.add("measured", {0.0, ring.wavevector, ring.density, interval.low,
                           interval.high});
    if (ring.wavevector <= map.spectrum.wavevector_high)
      lowest = std::min(lowest, ring.density);
  }
  ChartPanel panel = spectrum_panel();
  const CurveStyle measured = joined(markers("#0072B2", 6, 0.5));
  panel.curves = {{.label = "95 % confidence",
                   .style = {.color = measured.color},
                   .x = 3,
                   .y = 5,
                   .low = 5,
                   .high = 6,
                   .is_area = true},
                  curve("measured", measured, 0, 3, 4)};
  figure.caption = fmt::format(
      "C(q) with ⟨h²⟩ = 2π ∫ q C dq, averaged over rings of |q|, {}; the band "
      "is the 95 % confidence interval for a Gaussian surface. Reliable "
      "(unshaded): {}.",
      map.is_periodic ? "the map being periodic"
                      : "with a Hann window, corrected for its mean square",
      range_text(map));
  if (map.fit) {
    add_model(*map.fit, table);
    panel.add("self-affine model", line("#222222", 1.6), 1, 3, 4);
    figure.caption += model_caption(*map.fit);
  }
  shade_unreliable(panel, map.range.low, map.range.high);
  if (map.range.noise)
    add_limit(panel, map.range.noise->wavevector, "noise floor");
  if (map.range.tip_wavevector)
    add_limit(panel, *map.range.tip_wavevector, "tip radius");
  panel.y.low = rounded(0.1 * lowest, 3);
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

std::vector<Figure> figures_of(const surfaces::LineAnalysis& scan) {
  Figure profile;
  profile.name = "profile";
  profile.title = "Profile";
  CsvTable heights({"curve", "index", "x [um]", "z [nm]"});
  for (std::size_t i = 0; i < scan.line.heights.size(); ++i)
    heights.add("profile",
                {0.0, static_cast<double>(i) * scan.line.spacing * 1e6,
                 scan.line.heights[i] * 1e9});
  profile.data = heights.text();
  profile.caption = scan.origin;
  profile.panels = {{.x = {.label = "x [µm]"},
                     .y = {.label = "z [nm]"},
                     .curves = {curve("", line("#0072B2"), 0, 3, 4)}}};
  Figure spectrum;
  spectrum.name = "profile-spectrum";
  spectrum.title = "Spectrum of the line and of the surface";
  CsvTable table({"curve", "index", "q [1/m]", "C [m^4]", "C_1 [m^3]"});
  for (const surfaces::SpectrumRing& row : scan.line_rows)
    table.add("line", {0.0, row.wavevector, std::nan(""), row.density});
  for (const surfaces::SpectrumRing& row : scan.rows)
    table.add("surface", {1.0, row.wavevector, row.density, std::nan("")});
  spectrum.data = table.text();
  spectrum.caption = fmt::format(
      "C₁(q) of the line, ⟨h²⟩ = 2 ∫ C₁ dq, and C(q) of the isotropic surface "
      "that has such lines, by Abel's inversion. Reliable (unshaded): {}.",
      range_text(scan));
  ChartPanel panel = spectrum_panel();
  shade_unreliable(panel, scan.low, scan.high);
  panel.second =
      ChartAxis{.label = "C_1(q) [m^3]", .is_log = true, .has_powers = true};
  panel.curves = {
      curve("C(q), left", joined(markers("#0072B2", 6, 0.6)), 1, 3, 4),
      curve("C₁(q), right", joined(markers("#D55E00", 4, 0.5)), 0, 3, 5)};
  panel.curves.back().is_on_second_axis = true;
  spectrum.panels = {std::move(panel)};
  return {profile, spectrum};
}

} // namespace asperity::reports
