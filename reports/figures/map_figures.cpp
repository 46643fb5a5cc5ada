#include "base/shown_number.hpp"
#include "reports/analysis/two_surfaces.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/map_image.hpp"
#include "reports/figures/map_stacks.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace asperity::reports {
namespace {

/// Places panels beside each other.
PanelGrid map_grid(int rows, std::size_t columns) {
  return {.rows = rows,
          .columns = static_cast<int>(columns),
          .margins = {{0.07, 0.92, 0.14, 0.9}},
          .across = 0.11,
          .down = 0.05};
}

Figure map_figure(const std::string& method,
                  const std::vector<results::Fields>& maps,
                  const FigureScales& scales,
                  const mechanics::ContactCriterion& criterion) {
  const std::vector<std::size_t> chosen = three_of(maps.size());
  const MapUnits units = map_units(maps, scales);
  Figure figure;
  figure.name = "maps-" + file_word(method);
  figure.title = "Pressure and gap, " + method;
  figure.width = 350 * static_cast<int>(chosen.size()) + 20;
  figure.height = 590;
  CsvTable table({"map", "step", "nominal_pressure [Pa]"});
  std::vector<ChartPanel> gaps;
  for (const std::size_t i : chosen) {
    const results::Fields& fields = maps[i];
    table.add(fmt::format("{}", i),
              {static_cast<double>(fields.step), fields.nominal_pressure});
    const MapImage pressure =
        map_image(fields.grid, fields.pressure_map(), units.pressure);
    const MapImage gap = map_image(fields.grid, fields.gap_map(), units.gap);
    const std::string pressure_name = fmt::format("pressure-{}", fields.step);
    const std::string gap_name = fmt::format("gap-{}", fields.step);
    ChartPanel& upper = figure.panels.emplace_back(
        map_panel(pressure, pressure_name, units.quantities[0].colors));
    upper.title = load_text(scales, fields.nominal_pressure);
    const double span = std::max(
        {pressure.largest, units.has_tension ? -pressure.least : 0.0, 1e-12});
    set_colors(upper, units.has_tension ? -span : 0.0, span);
    ChartPanel& lower = gaps.emplace_back(map_panel(gap, gap_name, "gap"));
    set_colors(lower, 0.0, std::max(gap.largest, 1e-12));
    lower.x.label = "x [µm]";
    if (i == chosen.front())
      upper.y.label = lower.y.label = "y [µm]";
    if (i == chosen.back()) {
      upper.image->label = units.quantities[0].label;
      lower.image->label = units.quantities[2].label;
    }
    figure.maps.emplace_back(pressure_name, map_csv(pressure));
    figure.maps.emplace_back(gap_name, map_csv(gap));
  }
  figure.caption = fmt::format(
      "Realisation 0 at {} loads. Pressure, white where there is none{}, and "
      "gap (in print the lower maps), dark where the surfaces touch. E* h' = "
      "{}, h_rms = {}.",
      chosen.size(), units.has_tension ? " and blue where it is a tension" : "",
      quantity_text(scales.contact_modulus * scales.rms_slope, "Pa", 3),
      quantity_text(scales.rms_height, "m", 3));
  std::ranges::move(gaps, std::back_inserter(figure.panels));
  figure.grid = map_grid(2, chosen.size());
  figure.grid->margins = {{0.07, 0.92, 0.08, 0.94}};
  figure.grid->down = 0.06;
  figure.data = table.text();
  figure.stack = contact_stack(maps, scales, units, criterion);
  return figure;
}

/// Pairs of maps at one load on one grid: of a method and of the reference.
using MapPairs = std::vector<std::pair<results::Fields, results::Fields>>;

MapPairs map_pairs(const results::MethodRecord& method,
                   const results::MethodRecord& reference) {
  MapPairs pairs;
  for (const results::Fields& mine : shown_maps(method))
    for (const results::Fields& other : shown_maps(reference))
      if (mine.grid == other.grid &&
          std::abs(mine.nominal_pressure - other.nominal_pressure) <=
              1e-6 * std::abs(other.nominal_pressure))
        pairs.emplace_back(mine, other);
  return pairs;
}

Figure difference_figure(const std::string& name, const std::string& reference,
                         const MapPairs& pairs, const FigureScales& scales) {
  const std::vector<std::size_t> chosen = three_of(pairs.size());
  Figure figure;
  figure.name = "pressure-difference-" + file_word(name);
  figure.title = "Pressure of " + name + " less that of " + reference;
  figure.width = 350 * static_cast<int>(chosen.size()) + 20;
  figure.height = 330;
  figure.grid = map_grid(1, chosen.size());
  CsvTable table({"map", "nominal_pressure [Pa]", "largest (p - p_ref)/p_0"});
  MapStack stack = stack_on(pairs.front().first.grid);
  stack.quantities = {{.label = "(p − p_{ref}) / p_0", .colors = "height"}};
  for (const std::size_t i : chosen) {
    const results::Fields& mine = pairs[i].first;
    const results::Fields& other = pairs[i].second;
    const auto difference = [&](int most) {
      return reduced_difference(mine.grid, mine.pressure_map(),
                                other.pressure_map(), most);
    };
    const MapImage picture = image_of(mine.grid, difference(most_image_points),
                                      mine.nominal_pressure);
    if (mine.grid == pairs.front().first.grid)
      stack.frames.push_back(
          {load_text(scales, mine.nominal_pressure),
           {add_reduced(stack, difference(stack_side(chosen.size())),
                        mine.nominal_pressure)}});
    const double span =
        std::max({std::abs(picture.least), picture.largest, 1e-300});
    const std::string suffix = std::to_string(i);
    figure.maps.emplace_back(suffix, map_csv(picture));
    table.add(suffix, {mine.nominal_pressure, span});
    ChartPanel& panel =
        figure.panels.emplace_back(map_panel(picture, suffix, "height"));
    panel.title = load_text(scales, mine.nominal_pressure);
    panel.x.label = "x [µm]";
    if (i == chosen.front())
      panel.y.label = "y [µm]";
    if (i == chosen.back())
      panel.image->label = "(p − p_{ref}) / p_0";
    set_colors(panel, -span, span);
  }
  figure.stack = std::move(stack);
  figure.caption = "Difference over the nominal pressure, at loads at which "
                   "both maps are saved; averaged over blocks of nodes if the "
                   "grid is larger than 256 x 256. Axes in µm.";
  figure.data = table.text();
  return figure;
}

std::vector<Figure> difference_figures(std::span<const ReportEntry> entries) {
  std::vector<Figure> figures;
  const std::vector<results::MethodRecord>& own =
      entries.front().result->methods;
  const auto reference =
      std::ranges::find_if(own, [](const results::MethodRecord& method) {
        return !shown_maps(method).empty();
      });
  if (reference == own.end())
    return figures;
  for (const ReportEntry& entry : entries.subspan(1))
    for (const results::MethodRecord& method : entry.result->methods)
      if (const MapPairs pairs = map_pairs(method, *reference); !pairs.empty())
        figures.push_back(difference_figure(method.name, reference->name, pairs,
                                            method_scales(entry, method)));
  return figures;
}

std::vector<Figure> map_figures(const ReportEntry& entry) {
  std::vector<Figure> figures;
  for (const results::MethodRecord* method : methods_with_maps(*entry.result)) {
    const std::vector<results::Fields> maps = shown_maps(*method);
    const FigureScales scales = method_scales(entry, *method);
    if (!maps.empty() && scales.rms_height > 0.0 && scales.rms_slope > 0.0)
      figures.push_back(
          map_figure(method->name, maps, scales,
                     contact_criterion_of(*entry.contact_case, *method,
                                          scales.rms_height)));
  }
  return figures;
}

std::optional<Figure> surface_figure(const ReportEntry& entry) {
  if (entry.result->surfaces.empty())
    return std::nullopt;
  const results::SurfaceRecord& surface = entry.result->surfaces.front();
  if (!surface.has_heights())
    return std::nullopt;
  const Grid grid = surface.map_grid();
  const results::StoredMap heights = surface.heights_of_map();
  const MapImage picture = map_image(grid, heights, 1e-9);
  const double span = height_span(picture);
  Figure figure;
  figure.name = "surface";
  figure.title = "The surface";
  figure.maps.emplace_back("map", map_csv(picture));
  figure.stack = height_stack(grid, heights);
  figure.stack->quantities.front().span = span;
  CsvTable table({"realization", "rms_height [m]", "rms_slope [1]",
                  "rms_curvature [1/m]", "skewness [1]", "kurtosis [1]",
                  "highest [m]"});
  for (std::size_t r = 0; r < entry.result->surfaces.size(); ++r) {
    const results::SurfaceRecord& one = entry.result->surfaces[r];
    table.add(std::to_string(r),
              {one.rms_height, one.rms_slope, one.rms_curvature, one.skewness,
               one.kurtosis, one.highest});
  }
  figure.data = table.text();
  figure.caption = fmt::format(
      "{} over {} × {}, {} × {} points: rms height {}, rms slope {}, skewness "
      "{:.2f}, kurtosis {:.2f}.{}",
      entry.result->surfaces.size() > 1 ? "Heights of realisation 0"
                                        : "Heights",
      quantity_text(grid.length_x, "m"), quantity_text(grid.length_y, "m"),
      grid.points_x, grid.points_y, quantity_text(surface.rms_height, "m", 3),
      digits_text(surface.rms_slope, 3), Shown{surface.skewness},
      surface.kurtosis, span_note(picture));
  ChartPanel& panel =
      figure.panels.emplace_back(map_panel(picture, "map", "height"));
  set_colors(panel, -span, span);
  panel.image->label = "height [nm]";
  panel.x.label = "x [µm]";
  panel.y.label = "y [µm]";
  panel.sides = {0.14, 0.74};
  return figure;
}

std::optional<Figure> two_faces_figure(const ReportEntry& entry) {
  const auto sum = sum_of_two_surfaces(*entry.result);
  if (!sum)
    return std::nullopt;
  Figure figure;
  figure.name = "two-faces";
  figure.title = "Both surfaces and their sum";
  figure.width = 1070;
  figure.height = 330;
  figure.grid = map_grid(1, 3);
  CsvTable table({"face", "rms_height [m]", "rms_slope [1]", "skewness [1]",
                  "kurtosis [1]", "highest [m]"});
  const auto add = [&](const results::SurfaceRecord& face,
                       const std::string& name, const std::string& title) {
    const MapImage picture = map_image(face.grid, face.height_map(), 1e-9);
    const double span = height_span(picture);
    figure.maps.emplace_back(name, map_csv(picture));
    table.add(name, {face.rms_height, face.rms_slope, face.skewness,
                     face.kurtosis, face.highest});
    ChartPanel& panel =
        figure.panels.emplace_back(map_panel(picture, name, "height"));
    panel.title = fmt::format("{}, {} rms", title,
                              quantity_text(face.rms_height, "m", 3));
    panel.x.label = "x [µm]";
    if (figure.panels.size() == 1)
      panel.y.label = "y [µm]";
    if (figure.panels.size() == 3)
      panel.image->label = "height [nm]";
    set_colors(panel, -span, span);
  };
  add(entry.result->surfaces[0], "first", "realisation 0");
  add(entry.result->surfaces[1], "second", "realisation 1");
  add(*sum, "sum", "sum of both");
  figure.caption =
      "Heights in nm, axes in µm. The sum is the surface in the equivalent "
      "contact of a flat block with the combined stiffness of the two bodies. "
      "Colours end beyond 99 % of the heights where a few are much larger.";
  figure.data = table.text();
  return figure;
}

} // namespace

const ReportFigure figures::surface{.names = {"surface"},
                                    .section = FigureSection::contact,
                                    .draw = drawn_by<surface_figure>};

const ReportFigure figures::two_faces{.names = {"two-faces"},
                                      .section = FigureSection::contact,
                                      .draw = drawn_by<two_faces_figure>};

const ReportFigure figures::maps{.names = {"maps-"},
                                 .section = FigureSection::contact,
                                 .draw = drawn_by<map_figures>};

const ReportFigure figures::pressure_difference{
    .names = {"pressure-difference-"},
    .section = FigureSection::differences,
    .draw = drawn_by<difference_figures>};

} // namespace asperity::reports
