#include "base/shown_number.hpp"
#include "reports/analysis/two_surfaces.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace asperity::reports {
namespace {

constexpr std::size_t most_curves = 4;
constexpr double bin_width = 0.2; // in h_rms
// In bins. Heights beyond it are inconsistent with rms_height.
constexpr double furthest_bin = 1e6;
constexpr double gaussian_end = 4.0; // in h_rms
constexpr int gaussian_points = 160;

std::map<int, double> densities(const results::SurfaceRecord& surface) {
  std::map<int, double> density;
  const double share =
      1.0 / (bin_width * static_cast<double>(surface.height_map().size()));
  results::each_piece(
      surface.height_map(), [&](std::span<const double> heights) {
        for (const double height : heights)
          if (const double bin =
                  std::floor(height / surface.rms_height / bin_width);
              std::abs(bin) <= furthest_bin)
            density[static_cast<int>(bin)] += share;
      });
  return density;
}

std::string capital(std::string text) {
  text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::optional<Figure> height_figure(const ReportEntry& entry) {
  Figure figure;
  figure.name = "height-distribution";
  figure.title = "Distribution of the heights";
  figure.caption =
      "Symbols: the density P_h; line: the Gaussian with the same h_rms.";
  CsvTable table({"curve", "index", "h/h_rms [1]", "P h_rms [1]"});
  ChartPanel panel{.y = {.label = "P_h h_{rms}"}};
  const int sign = map_sign(entry);
  const auto add = [&](const results::SurfaceRecord& surface, std::size_t r,
                       const std::string& name) {
    if (surface.height_map().empty() || !(surface.rms_height > 0.0) ||
        panel.curves.size() == most_curves)
      return;
    for (const auto& [bin, density] : densities(surface))
      table.add(name,
                {static_cast<double>(r), (bin + 0.5) * bin_width, density});
    panel.add(name, markers(method_color(r), sign, 0.5, 1.2), r, 3, 4);
    figure.caption += fmt::format(
        " {}: skewness {:+.2f}, kurtosis {:.2f}, highest {:.2f} h_rms.",
        capital(name), Shown{surface.skewness}, surface.kurtosis,
        surface.highest / surface.rms_height);
  };
  const auto& surfaces = entry.result->surfaces;
  for (std::size_t r = 0; r < surfaces.size(); ++r)
    add(surfaces[r], r, fmt::format("realisation {}", r));
  if (const auto sum = sum_of_two_surfaces(*entry.result))
    add(*sum, surfaces.size(), "sum of both");
  if (panel.curves.empty())
    return std::nullopt;
  for (int k = 0; k <= gaussian_points; ++k) {
    const double h = gaussian_end * (2.0 * k / gaussian_points - 1.0);
    table.add(
        "Gaussian",
        {-1.0, h, std::exp(-0.5 * h * h) / std::sqrt(2.0 * std::numbers::pi)});
  }
  panel.add("Gaussian", line("#222222", 1.5), 0, 3, 4).index = -1;
  const double rms_height = figure_scales(std::span(&entry, 1)).rms_height;
  panel.x = length_axis("h / h_{rms}", "height h", rms_height, gaussian_end);
  panel.y.other = density_units("P_h", panel.x);
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

} // namespace

const ReportFigure figures::height_distribution{
    .names = {"height-distribution"},
    .section = FigureSection::contact,
    .draw = drawn_by<height_figure>,
    .applies = is_rough};

} // namespace asperity::reports
