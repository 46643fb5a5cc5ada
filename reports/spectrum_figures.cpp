#include "reports/figures.hpp"
#include "reports/plot_parts.hpp"
#include "surfaces/build.hpp"
#include "theory/pressure_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace asperity::reports {
namespace {

constexpr std::array<const char*, 3> load_colors{"#56B4E9", "#0072B2",
                                                 "#35102b"};

constexpr std::array<const char*, 3> load_signs{"pointtype 8", "pointtype 4",
                                                "pointtype 6"};

constexpr double bin = 0.1; // of the histogram, in E* h'

// Density of the positive numbers among themselves, by the centre of their bin:
// what is not in contact does not count. Bins without any are not there: a
// load far beyond full contact would have millions of them. The sum of the
// densities times bin is 1.
std::map<double, double> histogram_of(const std::vector<double>& map,
                                      double unit) {
  std::map<double, double> histogram;
  const auto in_contact =
      std::count_if(map.begin(), map.end(), [](double p) { return p > 0.0; });
  const double share = 1.0 / (static_cast<double>(in_contact) * bin);
  for (const double number : map)
    if (number > 0.0)
      histogram[(std::floor(number / unit / bin) + 0.5) * bin] += share;
  return histogram;
}

bool has_contact(const results::Fields& fields) {
  return std::any_of(fields.pressure.begin(), fields.pressure.end(),
                     [](double pressure) { return pressure > 0.0; });
}

const results::MethodRecord* first_with_maps(const results::Result& result) {
  for (const results::MethodRecord& method : result.methods)
    if (!method.realizations.empty() &&
        !method.realizations.front().fields.empty() &&
        std::any_of(method.realizations.front().fields.begin(),
                    method.realizations.front().fields.end(), has_contact))
      return &method;
  return nullptr;
}

} // namespace

std::optional<Figure> pressure_distribution_figure(const ReportEntry& entry) {
  const results::MethodRecord* method = first_with_maps(*entry.result);
  if (method == nullptr || entry.result->surfaces.empty() ||
      !(entry.result->surfaces.front().rms_slope > 0.0))
    return std::nullopt;
  const double slope = entry.result->surfaces.front().rms_slope;
  const double modulus = entry.result->contact_modulus;
  const double stress = modulus * slope; // E* h'
  const double variance = theory::stress_variance(modulus, slope);

  Figure figure;
  figure.name = "pressure-distribution";
  figure.title = "Distribution of the contact pressure";
  CsvTable table({"curve", "index", "sigma/(E* h') [1]", "P E* h' A_0/A [1]"});
  std::vector<std::string> plots;
  const auto& maps = method->realizations.front().fields;
  const std::vector<std::size_t> chosen = three_of(maps.size());
  const double furthest = maps[chosen.back()].nominal_pressure / stress + 2.0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const results::Fields& fields = maps[chosen[i]];
    const double load = fields.nominal_pressure;
    const std::string name = fmt::format("p/E* = {:.3g}", load / modulus);
    for (const auto& [sigma, density] : histogram_of(fields.pressure, stress))
      table.add(method->name + ", " + name,
                {static_cast<double>(2 * i), sigma, density});
    const double area = theory::area_fraction(load, variance);
    for (int k = 0; k <= 200; ++k) {
      const double sigma = furthest * k / 200.0;
      table.add("theory, " + name,
                {static_cast<double>(2 * i + 1), sigma,
                 stress / area *
                     theory::pressure_density(sigma * stress, load, variance)});
    }
    plots.push_back(fmt::format(
        "'pressure-distribution.csv' using ($2=={} ? $3 : NaN):4 with points "
        "{} pointsize 0.6 linewidth 1.2 linecolor rgb '{}' title {}",
        2 * i, load_signs[i], load_colors[i], gnuplot_text(name)));
    plots.push_back(fmt::format(
        "'pressure-distribution.csv' using ($2=={} ? $3 : NaN):4 with lines "
        "linewidth 1.5 linecolor rgb '{}' {}",
        2 * i + 1, load_colors[i],
        i + 1 == chosen.size() ? "title 'theory, (1)'" : "notitle"));
  }
  figure.caption = fmt::format(
      "Signs: {}, realisation 0, in bins of {} E* h'; lines: (1) at the same "
      "load with G of the surface's slope {:.3g}. Each is divided by its own "
      "contact fraction, so that the shapes compare and the area under a curve "
      "is 1.",
      method->name, bin, slope);
  figure.script = fmt::format(
      "set xlabel {}\nset ylabel {}\nset xrange [0:{:.4g}]\n"
      "set yrange [0:*]\n{}",
      gnuplot_markup("contact pressure σ / (E* h')"),
      gnuplot_markup("P(σ) E* h' A_0 / A"), furthest, plot_of(plots));
  figure.data = table.text();
  return figure;
}

std::optional<Figure> spectrum_figure(const ReportEntry& entry) {
  const auto& surfaces = entry.result->surfaces;
  const cases::SurfaceSpec& spec = entry.contact_case->surface;
  Figure figure;
  figure.name = "spectrum";
  figure.title = "Its spectrum";
  CsvTable table({"curve", "index", "q [1/m]", "C [m^4]"});
  std::vector<std::string> plots;
  for (std::size_t r = 0; r < surfaces.size(); ++r) {
    if (surfaces[r].spectrum.empty())
      continue;
    for (const results::SpectrumPoint& point : surfaces[r].spectrum)
      if (point.spectrum > 0.0)
        table.add(fmt::format("realisation {}", r),
                  {static_cast<double>(r), point.wavevector, point.spectrum});
    plots.push_back(fmt::format(
        "'spectrum.csv' using ($2=={} ? $3 : NaN):4 with points pointtype 6 "
        "pointsize 0.5 linewidth 1 linecolor rgb '{}' title {}",
        r, method_color(r), gnuplot_text(fmt::format("realisation {}", r))));
  }
  if (plots.empty())
    return std::nullopt;
  figure.caption = "C(q) with ⟨h²⟩ = 2π ∫ q C dq, averaged over rings of equal "
                   "|q|.";
  double floor = 0.0; // of the axis: no interest in rounding beyond the cut-off
  if (spec.kind == cases::SurfaceKind::self_affine) {
    const auto index = static_cast<double>(surfaces.size());
    const surfaces::IsotropicSpectrum formula =
        surfaces::formula_spectrum(spec);
    const double ratio = spec.wavevector_high / spec.wavevector_low;
    for (int k = 0; k <= 200; ++k) {
      const double q = std::min(spec.wavevector_low *
                                    std::pow(ratio, k / 200.0) * (1.0 + 1e-12),
                                spec.wavevector_high);
      table.add("formula", {index, q, formula.density(q)});
    }
    plots.push_back(fmt::format(
        "'spectrum.csv' using ($2=={} ? $3 : NaN):4 with lines linewidth 1.5 "
        "linecolor rgb '#222222' title 'formula'",
        surfaces.size()));
    floor = 0.03 * formula.density(spec.wavevector_high);
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
