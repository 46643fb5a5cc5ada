#include "base/shown_number.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/observables/distributions.hpp"
#include "results/observables/pressure_fit.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

using results::Fields;
using results::Histogram;
using results::PressureFit;

constexpr int most_bins = 2000;
constexpr int gap_bins = 60;

/// One load of a figure: its saved fields, the fitted distribution and its
/// histogram.
struct Load {
  const Fields* fields = nullptr;
  PressureFit fit;
  double variance = 0.0; ///< of the fit, or else of the theory [Pa^2]
  double area = 0.0;     ///< Eq. (21), or else the area of the histogram [1]
  Histogram histogram;
};

Load load_of(const Fields& fields, double theory_variance) {
  Load load;
  load.fields = &fields;
  load.fit = results::fit_pressure_distribution(fields.pressure_map());
  const bool is_fitted = load.fit.variance > 0.0;
  load.variance = is_fitted ? load.fit.variance : theory_variance;
  const double bin = std::sqrt(2.0 * load.variance) / 8.0; // as in the fit
  const double highest = results::extremes_of(fields.pressure_map()).largest;
  load.histogram = results::pressure_histogram(
      fields.pressure_map(),
      static_cast<int>(std::fmin(std::fmax(std::ceil(highest / bin), 1.0),
                                 static_cast<double>(most_bins))));
  double counted = 0.0;
  for (const double density : load.histogram.density)
    counted += density * load.histogram.bin_width();
  load.area = is_fitted ? load.fit.area_fraction : counted;
  return load;
}

/// Adds rows of Eq. (1) or Eq. (20) of Yang and Persson (2008), divided by the
/// corresponding area, up to six spreads s on either side of the mean pressure.
/// Returns the largest density.
double add_curve(CsvTable& table, const std::string& label, double index,
                 double pressure, double variance, double stress) {
  if (!(pressure > 0.0))
    return 0.0; // tensile: the theory has no such load
  const double spread = std::sqrt(2.0 * variance);
  const double start = std::max(0.0, pressure - 6.0 * spread);
  const double area = theory::area_fraction(pressure, variance);
  double largest = 0.0;
  for (int k = 0; k <= 160; ++k) {
    const double sigma = start + (pressure + 6.0 * spread - start) * k / 160.0;
    const double density =
        stress / area * theory::pressure_density(sigma, pressure, variance);
    table.add(label, {index, sigma / stress, density});
    largest = std::max(largest, density);
  }
  return largest;
}

/// Adds the non-empty bins of a histogram. Returns the largest density beyond
/// the first bin, where low pressures accumulate.
double add_histogram(CsvTable& table, const std::string& label, double index,
                     const Load& load, double stress) {
  double largest = 0.0;
  for (std::size_t i = 0; i < load.histogram.density.size(); ++i) {
    const double density = load.histogram.density[i] * stress / load.area;
    if (!(density > 0.0))
      continue;
    table.add(label, {index, load.histogram.bin_centre(i) / stress, density});
    if (i > 0)
      largest = std::max(largest, density);
  }
  return largest;
}

std::string legend_of(const Load& load, const FigureScales& scales,
                      double variance) {
  std::string words = load_text(scales, load.fields->nominal_pressure);
  if (load.fit.variance > 0.0)
    words += fmt::format(", A/A₀ = {:.3g}, r = {:.2f}", load.fit.area_fraction,
                         load.fit.variance / variance);
  return words;
}

Figure pressure_figure(const std::string& method,
                       const std::vector<const Fields*>& maps,
                       const FigureScales& scales) {
  const double stress = scales.contact_modulus * scales.rms_slope; // E* h'
  // Eq. (2)
  const double variance =
      theory::stress_variance(scales.contact_modulus, scales.rms_slope);
  Figure figure;
  figure.name = "pressure-distribution-" + file_word(method);
  figure.title = "Distribution of the contact pressure, " + method;
  CsvTable table({"curve", "index", "sigma/(E* h') [1]", "P E* h' A_0/A [1]"});
  ChartPanel panel{.y = {.label = "P(σ) E* h' A_0 / A", .low = 0.0},
                   .has_narrow_legend = true};
  double furthest = 0.0;
  double top = 0.0;
  std::size_t index = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const Load load = load_of(*maps[i], variance);
    const std::string name = legend_of(load, scales, variance);
    const double pressure = load.fit.nominal_pressure;
    panel.add(name, load_sign(i), index, 3, 4);
    top = std::max(top,
                   add_histogram(table, method + ", " + name,
                                 static_cast<double>(index++), load, stress));
    const bool is_last = i + 1 == maps.size();
    panel.add(is_last ? "theory, Eq. (1)" : "", line(load_color(i), 0.9, 2),
              index, 3, 4);
    add_curve(table, "theory, " + name, static_cast<double>(index++), pressure,
              variance, stress);
    furthest =
        std::max(furthest, pressure + 4.0 * std::sqrt(2.0 * load.variance));
    if (!(load.fit.variance > 0.0))
      continue;
    panel.add(is_last ? "fitted, Eq. (20)" : "", line(load_color(i), 1.5),
              index, 3, 4);
    top = std::max(top, add_curve(table, "Eq. (20), " + name,
                                  static_cast<double>(index++), pressure,
                                  load.fit.variance, stress));
  }
  figure.caption = fmt::format(
      "Markers: realisation 0 in bins of an eighth of √(2 G̃); lines: Eq. (20) "
      "of Yang and Persson (2008) fitted to them by least squares, from which "
      "A/A₀ follows by Eq. (21); dashed: the theory's Eq. (1) at the same "
      "load, with G of the slope {}. r = G̃/G. Each curve is divided by its "
      "contact fraction, so that the shapes can be compared.",
      digits_text(scales.rms_slope, 3));
  panel.x = pressure_axis("contact pressure σ / (E* h')", "contact pressure σ",
                          stress, furthest / stress);
  panel.y.other = density_units("P(σ) A_0 / A", panel.x);
  panel.x.low = 0.0;
  panel.x.high = rounded(furthest / stress, 4);
  panel.y.high = rounded(top > 0.0 ? 1.15 * top : 1.0, 4);
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

Figure gap_figure(const std::string& method,
                  const std::vector<const Fields*>& maps,
                  const FigureScales& scales,
                  const mechanics::ContactCriterion& criterion) {
  Figure figure;
  figure.name = "gap-distribution-" + file_word(method);
  figure.title = "Distribution of the separation, " + method;
  CsvTable table({"curve", "index", "u/h_rms [1]", "P_u h_rms [1]"});
  ChartPanel panel{
      .y = {.label = "P_u h_{rms}", .is_log = true, .has_powers = true},
      .has_narrow_legend = true};
  double widest = 0.0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const Histogram histogram = results::gap_histogram(
        maps[i]->gap_map(), maps[i]->pressure_map(), gap_bins, criterion);
    double open = 0.0;
    for (const double density : histogram.density)
      open += density * histogram.bin_width();
    const std::string name = fmt::format(
        "{}, {:.3g} % in contact", load_text(scales, maps[i]->nominal_pressure),
        100.0 * std::max(0.0, 1.0 - open));
    for (std::size_t k = 0; k < histogram.density.size(); ++k)
      if (histogram.density[k] > 0.0)
        table.add(method + ", " + name,
                  {static_cast<double>(i),
                   histogram.bin_centre(k) / scales.rms_height,
                   histogram.density[k] * scales.rms_height});
    if (histogram.density.empty())
      continue;
    panel.add(name, joined(load_sign(i)), i, 3, 4);
    widest = std::max(widest, histogram.bin_centre(gap_bins - 1));
  }
  panel.x = length_axis("separation u / h_{rms}", "separation u",
                        scales.rms_height, widest / scales.rms_height);
  panel.x.low = 0.0;
  panel.y.other = density_units("P_u", panel.x);
  figure.caption =
      fmt::format("P_u of Eq. (26) of Yang and Persson (2008) where the "
                  "surfaces are separated, realisation 0, in {} bins up to the "
                  "widest gap; the part in contact is a peak at zero, or below "
                  "zero for a penalty and for atoms. h_rms = {}.",
                  gap_bins, quantity_text(scales.rms_height, "m", 3));
  if (panel.curves.empty())
    return {};
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

/// Selects up to three complete maps of a method in which some points press.
/// @param is_pressed  only those under a load that presses, not pulls
std::vector<const Fields*> chosen_maps(const results::MethodRecord& method,
                                       bool is_pressed) {
  std::vector<const Fields*> maps = whole_maps(method);
  std::erase_if(maps, [&](const Fields* fields) {
    return !(results::extremes_of(fields->pressure_map()).largest > 0.0) ||
           (is_pressed && !(fields->nominal_pressure > 0.0));
  });
  std::vector<const Fields*> chosen;
  for (const std::size_t i : three_of(maps.size()))
    chosen.push_back(maps[i]);
  return chosen;
}

/// Calls draw(method, maps, scales) for every method that has maps, with the
/// scales of its realisation 0.
template <class Draw>
std::vector<Figure> figure_a_method(const ReportEntry& entry, bool is_pressed,
                                    Draw draw) {
  std::vector<Figure> figures;
  for (const results::MethodRecord* method : methods_with_maps(*entry.result)) {
    const std::vector<const Fields*> maps = chosen_maps(*method, is_pressed);
    const FigureScales scales = method_scales(entry, *method);
    if (!maps.empty() && scales.rms_height > 0.0 && scales.rms_slope > 0.0)
      figures.push_back(draw(*method, maps, scales));
  }
  std::erase_if(figures, [](const Figure& one) { return one.name.empty(); });
  return figures;
}

std::vector<Figure> pressure_distribution_figures(const ReportEntry& entry) {
  return figure_a_method(entry, true,
                         [](const results::MethodRecord& method,
                            const auto& maps, const FigureScales& scales) {
                           return pressure_figure(method.name, maps, scales);
                         });
}

std::vector<Figure> gap_distribution_figures(const ReportEntry& entry) {
  return figure_a_method(entry, false,
                         [&](const results::MethodRecord& method,
                             const auto& maps, const FigureScales& scales) {
                           return gap_figure(
                               method.name, maps, scales,
                               contact_criterion_of(*entry.contact_case, method,
                                                    scales.rms_height));
                         });
}

} // namespace

const ReportFigure figures::pressure_distribution{
    .names = {"pressure-distribution-"},
    .section = FigureSection::contact,
    .draw = drawn_by<pressure_distribution_figures>,
    .applies = is_rough};

const ReportFigure figures::gap_distribution{
    .names = {"gap-distribution-"},
    .section = FigureSection::contact,
    .draw = drawn_by<gap_distribution_figures>,
    .applies = is_rough};

} // namespace asperity::reports
