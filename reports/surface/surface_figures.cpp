#include "reports/surface/surface_figures.hpp"

#include "base/shown_number.hpp"
#include "reports/figures/map_image.hpp"
#include "reports/figures/map_stacks.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/surface/surface_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace asperity::reports {
namespace {

Figure topography_figure(const surfaces::MapAnalysis& map) {
  const Grid& grid = map.map.grid;
  const MapImage picture = map_image(grid, map.map.heights, 1e-9);
  const double shown = height_span(picture);
  const bool is_high = shown > 2000.0;
  const double unit = is_high ? 1e-3 : 1.0;
  const double span = shown * unit;
  Figure figure;
  figure.name = "topography";
  figure.title = "Heights";
  figure.data = fmt::format("Sq [m]\n{:.10g}\n", map.heights.sq);
  figure.maps.emplace_back("heights", map_csv(picture, is_high ? 1e3 : 1.0));
  figure.stack = height_stack(grid, map.map.heights);
  figure.stack->quantities.front().span = shown;
  figure.caption = fmt::format("{} × {} points over {} × {}. {}", grid.points_x,
                               grid.points_y, quantity_text(grid.length_x, "m"),
                               quantity_text(grid.length_y, "m"), map.origin);
  figure.caption += span_note(picture);
  // A stripe would be unreadable at its true proportions.
  const double ratio = grid.length_y / grid.length_x;
  const bool is_stripe = ratio > 3.0 || ratio < 1.0 / 3.0;
  ChartPanel& panel =
      figure.panels.emplace_back(map_panel(picture, "heights", "height"));
  panel.x.label = "x [µm]";
  panel.y.label = "y [µm]";
  panel.image->low = rounded(-span, 4);
  panel.image->high = rounded(span, 4);
  panel.image->label = is_high ? "height [µm]" : "height [nm]";
  if (is_stripe) {
    panel.image->proportions = Proportions::square;
    panel.x.tick_step = panel.y.tick_step = 0.0;
  }
  return figure;
}

Figure heights_figure(const surfaces::MapAnalysis& map) {
  constexpr double bin = 0.1; // in Sq
  const double rms = map.heights.sq;
  const auto first = static_cast<long>(std::floor(-map.heights.sv / rms / bin));
  const auto last = static_cast<long>(std::floor(map.heights.sp / rms / bin));
  const std::size_t bins =
      static_cast<std::size_t>(std::clamp(last - first + 1, 1L, 1000L));
  std::vector<double> density(bins, 0.0);
  const double mean = surfaces::mean_height(map.map);
  const double share =
      1.0 / (bin * static_cast<double>(map.map.heights.size()));
  for (const double height : map.map.heights) {
    const double place =
        std::floor((height - mean) / rms / bin) - static_cast<double>(first);
    if (place >= 0.0 && place < static_cast<double>(bins))
      density[static_cast<std::size_t>(place)] += share;
  }
  Figure figure;
  figure.name = "heights";
  figure.title = "Distribution of the heights";
  CsvTable table({"curve", "index", "h/Sq [1]", "P Sq [1]"});
  for (std::size_t i = 0; i < bins; ++i)
    if (density[i] > 0.0)
      table.add(
          "measured",
          {0.0,
           (static_cast<double>(first) + static_cast<double>(i) + 0.5) * bin,
           density[i]});
  const double edge =
      std::min(std::max(map.heights.sp, map.heights.sv) / rms, 6.0);
  for (int k = 0; k <= 120; ++k) {
    const double h = edge * (k / 60.0 - 1.0);
    table.add(
        "Gaussian",
        {1.0, h, std::exp(-0.5 * h * h) / std::sqrt(2.0 * std::numbers::pi)});
  }
  figure.data = table.text();
  figure.caption = fmt::format(
      "Skewness {:+.2f}, kurtosis {:.2f}; the highest point is {:.2f} Sq above "
      "the mean, the lowest {:.2f} Sq below. Line: the Gaussian of the same "
      "Sq.",
      Shown{map.heights.ssk}, map.heights.sku, map.heights.sp / rms,
      map.heights.sv / rms);
  const ChartAxis height =
      length_axis("h / Sq", "height h", rms, map.heights.sp / rms);
  figure.panels = {
      {.x = height,
       .y = {.label = "probability density × Sq",
             .low = rounded(std::max(1e-6, 0.5 * share), 3),
             .high = 1.0,
             .is_log = true,
             .has_powers = true,
             .other = density_units("probability density", height)},
       .curves = {curve("measured", markers("#0072B2", 6, 0.5, 1.2), 0, 3, 4),
                  curve("Gaussian", line("#222222", 1.5), 1, 3, 4)}}};
  use_other_units(figure.panels.front());
  figure.is_physical = true;
  return figure;
}

/// Rms slope or rms curvature of differences against their distance.
Figure scale_figure(const surfaces::MapAnalysis& map, bool is_slope) {
  Figure figure;
  figure.name = "scale-curvature";
  if (is_slope)
    figure.name = "scale-slope";
  figure.title = is_slope ? "Slope at each scale" : "Curvature at each scale";
  CsvTable table({"curve", "index", "distance [um]",
                  is_slope ? "rms slope [1]" : "rms curvature [1/m]",
                  "sharpest peak [1/m]"});
  for (const surfaces::LocalDifferences& scale : map.scales)
    table.add(
        "differences",
        {0.0, 1e6 * scale.distance(),
         is_slope ? scale.rms_slope() : scale.rms_curvature(),
         scale.lowest_second < 0.0 ? -scale.lowest_second : not_a_number});
  figure.data = table.text();
  figure.caption =
      is_slope
          ? fmt::format("Rms slope of differences over a distance, both "
                        "directions. Over one spacing: {}; by the "
                        "spectrum: {}.",
                        digits_text(map.heights.sdq, 4),
                        digits_text(map.spectrum.rms_slope, 4))
          : fmt::format("Rms value of half the Laplacian of differences over a "
                        "distance, and the curvature of the sharpest peak. A "
                        "tip of radius R shapes the map where the latter "
                        "exceeds 1/(2R). Over one spacing: {}; by the "
                        "spectrum: {}.",
                        quantity_text(map.neighbours.rms_curvature(), "1/m"),
                        quantity_text(map.spectrum.rms_curvature, "1/m"));
  figure.panels = {
      {.x = {.label = "distance [µm]", .is_log = true},
       .y = {.label = is_slope ? "rms slope" : "curvature [1/m]",
             .is_log = true,
             .has_powers = true},
       .curves = {curve(is_slope ? "rms slope" : "rms curvature",
                        joined(markers("#0072B2", 6, 0.6, 1.3)), 0, 3, 4)}}};
  if (!is_slope)
    figure.panels.front().add("sharpest peak",
                              joined(markers("#D55E00", 8, 0.6)), 0, 3, 5);
  return figure;
}

} // namespace

std::vector<Figure> figures_of(const surfaces::MapAnalysis& map) {
  std::vector<Figure> figures{topography_figure(map), map_spectrum_figure(map),
                              heights_figure(map)};
  if (!map.scales.empty())
    for (const bool is_slope : {true, false})
      figures.push_back(scale_figure(map, is_slope));
  return figures;
}

} // namespace asperity::reports
