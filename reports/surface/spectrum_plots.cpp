// The figures of spectra of a surface report.
#include "reports/figures/plot_parts.hpp"
#include "reports/surface/surface_figures.hpp"
#include "reports/surface/surface_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

constexpr double shown_per_decade = 15.0;
constexpr const char* double_logarithmic =
    "set logscale xy\nset format '10^{%T}'\n";

std::string spectrum_axes() {
  return double_logarithmic + ("set xlabel " + gnuplot_markup("q [1/m]")) +
         "\nset ylabel " + gnuplot_markup("C(q) [m^4]") + "\n";
}

/// A vertical line with its name beside it.
std::string limit_line(double wavevector, const std::string& name) {
  return fmt::format(
      "set arrow from {0:.6g}, graph 0 to {0:.6g}, graph 1 nohead dashtype 3 "
      "linewidth 1.2 linecolor rgb '#8a5a00' back\nset label {1} at {0:.6g}, "
      "graph 0.03 rotate by 90 offset -0.6,0 textcolor rgb '#8a5a00' font "
      "',10'\n",
      wavevector, gnuplot_text(name));
}

/// Shades the wavevectors that are not reliable.
std::string unreliable_areas(double low, double high) {
  return fmt::format(
      "set object rectangle from graph 0, graph 0 to first {:.6g}, graph 1 "
      "behind fillcolor rgb '#59636e' fillstyle solid 0.1 noborder\nset object "
      "rectangle from first {:.6g}, graph 0 to graph 1, graph 1 behind "
      "fillcolor rgb '#59636e' fillstyle solid 0.1 noborder\n",
      low, high);
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
  const std::string file = "'map-spectrum.csv' ";
  std::vector<std::string> plots{
      file + of_series(0, "$3:5:6") +
          " with filledcurves linecolor rgb '#0072B2' fillstyle transparent "
          "solid 0.2 noborder title '95 % confidence'",
      file + of_series(0, "$3:4") +
          " with linespoints pointtype 6 pointsize 0.5 linewidth 1 linecolor "
          "rgb '#0072B2' title 'measured'"};
  figure.caption = fmt::format(
      "C(q) with ⟨h²⟩ = 2π ∫ q C dq, averaged over rings of |q|, {}; the band "
      "is the 95 % confidence interval for a Gaussian surface. Reliable "
      "(unshaded): {}.",
      map.is_periodic ? "the map being periodic"
                      : "with a Hann window, corrected for its mean square",
      range_text(map));
  if (map.fit) {
    add_model(*map.fit, table);
    plots.push_back(file + of_series(1, "$3:4") +
                    " with lines linewidth 1.6 linecolor rgb '#222222' title "
                    "'self-affine model'");
    figure.caption += model_caption(*map.fit);
  }
  figure.script =
      spectrum_axes() + unreliable_areas(map.range.low, map.range.high);
  if (map.range.noise)
    figure.script += limit_line(map.range.noise->wavevector, "noise floor");
  if (map.range.tip_wavevector)
    figure.script += limit_line(*map.range.tip_wavevector, "tip radius");
  figure.script += fmt::format("set yrange [{:.3g}:*]\n", 0.1 * lowest);
  figure.script += plot_of(plots);
  figure.data = table.text();
  return figure;
}

Figure stitched_figure(const SurfaceReport& report) {
  Figure figure;
  figure.name = "stitched-spectrum";
  figure.title = "Spectrum of all measurements";
  CsvTable table(
      {"curve", "index", "q [1/m]", "C [m^4]", "low [m^4]", "high [m^4]"});
  const std::string file = "'stitched-spectrum.csv' ";
  std::vector<std::string> plots;
  const auto add = [&](std::size_t part,
                       const surfaces::SpectrumPart& spectrum) {
    const bool is_line = part >= report.maps.size();
    const std::vector<surfaces::SpectrumRing> rows =
        is_line ? spectrum.rings
                : joined_rings(spectrum.rings, shown_per_decade);
    for (const surfaces::SpectrumRing& row :
         rings_between(rows, spectrum.low, spectrum.high))
      table.add(report.name_of(part),
                {static_cast<double>(part + 1), row.wavevector, row.density,
                 std::nan(""), std::nan("")});
    plots.push_back(
        file + of_series(part + 1, "$3:4") +
        fmt::format(" with points pointtype 6 pointsize 0.6 linewidth 1.2 "
                    "linecolor rgb '{}' title {}",
                    method_color(part), gnuplot_text(report.name_of(part))));
  };
  for (std::size_t i = 0; i < report.maps.size(); ++i)
    add(i, part_of(report.maps[i]));
  for (std::size_t i = 0; i < report.lines.size(); ++i)
    add(report.maps.size() + i, part_of(report.lines[i]));
  for (const surfaces::SpectrumRing& row : report.stitched.rows) {
    const surfaces::DensityInterval interval = confidence_of(row);
    table.add("mean",
              {0.0, row.wavevector, row.density, interval.low, interval.high});
  }
  plots.push_back(file + of_series(0, "$3:4") +
                  " with lines linewidth 1.6 linecolor rgb '#222222' title "
                  "'mean, spectrum.txt'");
  figure.caption =
      "Each measurement within its reliable range, and their mean, weighted by "
      "the number of independent modes.";
  for (const std::string& note : stitching_notes(report))
    figure.caption += fmt::format(" Note: {}.", note);
  figure.script = spectrum_axes() + plot_of(plots);
  figure.data = table.text();
  return figure;
}

std::vector<Figure> figures_of(const surfaces::LineAnalysis& line) {
  Figure profile;
  profile.name = "profile";
  profile.title = "Profile";
  CsvTable heights({"curve", "index", "x [um]", "z [nm]"});
  for (std::size_t i = 0; i < line.line.heights.size(); ++i)
    heights.add("profile",
                {0.0, static_cast<double>(i) * line.line.spacing * 1e6,
                 line.line.heights[i] * 1e9});
  profile.data = heights.text();
  profile.caption = line.origin;
  profile.script =
      "set xlabel 'x [µm]'\nset ylabel 'z [nm]'\n" +
      plot_of({"'profile.csv' " + of_series(0, "$3:4") +
               " with lines linewidth 1 linecolor rgb '#0072B2' notitle"});
  Figure spectrum;
  spectrum.name = "profile-spectrum";
  spectrum.title = "Spectrum of the line and of the surface";
  CsvTable table({"curve", "index", "q [1/m]", "C [m^4]", "C_1 [m^3]"});
  for (const surfaces::SpectrumRing& row : line.line_rows)
    table.add("line", {0.0, row.wavevector, std::nan(""), row.density});
  for (const surfaces::SpectrumRing& row : line.rows)
    table.add("surface", {1.0, row.wavevector, row.density, std::nan("")});
  spectrum.data = table.text();
  spectrum.caption = fmt::format(
      "C₁(q) of the line, ⟨h²⟩ = 2 ∫ C₁ dq, and C(q) of the isotropic surface "
      "that has such lines, by Abel's inversion. Reliable (unshaded): {}.",
      range_text(line));
  spectrum.script =
      spectrum_axes() + unreliable_areas(line.low, line.high) + "set y2label " +
      gnuplot_markup("C_1(q) [m^3]") +
      "\nset logscale y2\nset format y2 '10^{%T}'\nset y2tics\nset ytics "
      "nomirror\nset border 11\n" +
      plot_of({"'profile-spectrum.csv' " + of_series(1, "$3:4") +
                   " with linespoints pointtype 6 pointsize 0.6 linecolor rgb "
                   "'#0072B2' title 'C(q), left'",
               "'profile-spectrum.csv' " + of_series(0, "$3:5") +
                   " axes x1y2 with linespoints pointtype 4 pointsize 0.5 "
                   "linecolor rgb '#D55E00' title 'C_1(q), right'"});
  return {profile, spectrum};
}

} // namespace asperity::reports
