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

namespace asperity::reports {
namespace {

// The palettes are perceptually uniform: a sequential one for non-negative
// quantities, and a diverging one from blue to red with a light centre for
// heights.
constexpr const char* sequential_palette =
    "set palette maxcolors 128 defined (0 '#ffffff', 0.02 '#fdf2d0', 0.25 "
    "'#f6b65a', 0.5 '#dd6137', 0.75 '#98253f', 1 '#35102b')\n";
constexpr const char* gap_palette =
    "set palette maxcolors 128 defined (0 '#08203a', 0.25 '#1f5a8c', 0.5 "
    "'#5b9fc7', 0.75 '#b5d7e8', 1 '#f7fbfd')\n";
constexpr const char* height_palette =
    "set palette maxcolors 128 defined (0 '#1f3b66', 0.25 '#6f93bd', 0.5 "
    "'#f2efe8', 0.75 '#cf8a63', 1 '#7a2a1d')\n";

/// Returns the tics and the plot command of an image.
std::string image_plot(const MapImage& image, const std::string& file) {
  return map_tics(image) + plot_of_map(image, file);
}

/// Returns the commands for the range of colours, with few enough tics that
/// their numbers fit beside the next map.
std::string color_range(double low, double high) {
  return fmt::format("set cbrange [{:.4g}:{:.4g}]\nset cbtics {:g}\n", low,
                     high, round_step((high - low) / 5.0));
}

constexpr const char* map_style =
    "unset grid\nset border 15 linewidth 0.6\nset tics out scale 0.4\nset size "
    "ratio -1\nset colorbox\nset cbtics scale 0.4\n";

Figure map_figure(const std::string& method,
                  const std::vector<const results::Fields*>& maps,
                  const SurfaceScales& scales) {
  const std::vector<std::size_t> chosen = three_of(maps.size());
  const double stress = scales.contact_modulus * scales.rms_slope; // E* h'
  Figure figure;
  figure.name = "maps-" + file_word(method);
  figure.title = "Pressure and gap, " + method;
  figure.width = 350 * static_cast<int>(chosen.size()) + 20;
  figure.height = 590;
  CsvTable table({"map", "step", "nominal_pressure [Pa]"});
  std::string pressures;
  std::string gaps;
  for (const std::size_t i : chosen) {
    const results::Fields& fields = *maps[i];
    const double load = fields.nominal_pressure / scales.contact_modulus;
    table.add(fmt::format("{}", i),
              {static_cast<double>(fields.step), fields.nominal_pressure});
    const MapImage pressure =
        map_image(fields.grid, fields.pressure_map(), stress);
    const MapImage gap =
        map_image(fields.grid, fields.gap_map(), scales.rms_height);
    const std::string pressure_name = fmt::format("pressure-{}", fields.step);
    const std::string gap_name = fmt::format("gap-{}", fields.step);
    pressures +=
        fmt::format("set title {}\n",
                    gnuplot_markup(fmt::format("p / E* = {:.3g}", load))) +
        color_range(0.0, std::max(pressure.largest, 1e-12));
    pressures +=
        image_plot(pressure, figure.name + "-" + pressure_name + ".csv");
    gaps += "unset title\n" + color_range(0.0, std::max(gap.largest, 1e-12));
    gaps += image_plot(gap, figure.name + "-" + gap_name + ".csv");
    figure.maps.emplace_back(pressure_name, map_csv(pressure));
    figure.maps.emplace_back(gap_name, map_csv(gap));
  }
  figure.caption = fmt::format(
      "Realisation 0 at {} loads. Pressure over E* h' ({:.3g} MPa), white "
      "where there is none; gap (in print the lower maps) over h_rms ({:.3g} "
      "nm), dark where the surfaces touch. Axes in µm.",
      chosen.size(), stress * 1e-6, scales.rms_height * 1e9);
  figure.script = fmt::format("{}set multiplot layout 2,{} margins "
                              "0.05,0.93,0.05,0.94 spacing 0.11,0.06\n{}{}{}{}"
                              "unset multiplot\n",
                              map_style, chosen.size(), sequential_palette,
                              pressures, gap_palette, gaps);
  figure.data = table.text();
  figure.stack = contact_stack(maps, scales);
  return figure;
}

/// Pairs of maps at one load on one grid: of a method and of the reference.
using MapPairs =
    std::vector<std::pair<const results::Fields*, const results::Fields*>>;

MapPairs map_pairs(const results::MethodRecord& method,
                   const results::MethodRecord& reference) {
  MapPairs pairs;
  for (const results::Fields* mine : whole_maps(method))
    for (const results::Fields* other : whole_maps(reference))
      if (mine->grid == other->grid &&
          std::abs(mine->nominal_pressure - other->nominal_pressure) <=
              1e-6 * other->nominal_pressure)
        pairs.emplace_back(mine, other);
  return pairs;
}

Figure difference_figure(const std::string& name, const std::string& reference,
                         const MapPairs& pairs, double contact_modulus) {
  const std::vector<std::size_t> chosen = three_of(pairs.size());
  Figure figure;
  figure.name = "pressure-difference-" + file_word(name);
  figure.title = "Pressure of " + name + " less that of " + reference;
  figure.width = 350 * static_cast<int>(chosen.size()) + 20;
  figure.height = 330;
  figure.script = fmt::format("{}{}set multiplot layout 1,{} margins "
                              "0.05,0.92,0.08,0.9 spacing 0.11,0.05\n",
                              map_style, height_palette, chosen.size());
  CsvTable table({"map", "nominal_pressure [Pa]", "largest (p - p_ref)/p_0"});
  MapStack stack = stack_on(pairs.front().first->grid);
  stack.quantities = {{"(p − p_ref) / p₀", "height", false}};
  for (const std::size_t i : chosen) {
    const auto [mine, other] = pairs[i];
    const auto difference = [&, one = mine, two = other](int most) {
      return reduced_difference(one->grid, one->pressure_map(),
                                two->pressure_map(), most);
    };
    const MapImage picture = image_of(mine->grid, difference(most_image_points),
                                      mine->nominal_pressure);
    if (mine->grid == pairs.front().first->grid)
      stack.frames.push_back(
          {fmt::format("p / E* = {:.3g}",
                       mine->nominal_pressure / contact_modulus),
           {add_reduced(stack, difference(stack_side(chosen.size())),
                        mine->nominal_pressure)}});
    const double span =
        std::max({std::abs(picture.least), picture.largest, 1e-300});
    const std::string suffix = std::to_string(i);
    figure.maps.emplace_back(suffix, map_csv(picture));
    table.add(suffix, {mine->nominal_pressure, span});
    figure.script += fmt::format("set title {}\n",
                                 gnuplot_markup(fmt::format(
                                     "p / E* = {:.3g}", mine->nominal_pressure /
                                                            contact_modulus))) +
                     color_range(-span, span);
    figure.script += image_plot(picture, figure.name + "-" + suffix + ".csv");
  }
  figure.script += "unset multiplot\n";
  figure.stack = std::move(stack);
  figure.caption = "Difference over the nominal pressure, at loads at which "
                   "both maps are saved; averaged over blocks of nodes if the "
                   "grid is larger than 256 x 256. Axes in µm.";
  figure.data = table.text();
  return figure;
}

} // namespace

std::vector<Figure> difference_figures(std::span<const ReportEntry> entries) {
  std::vector<Figure> figures;
  const std::vector<results::MethodRecord>& own =
      entries.front().result->methods;
  const auto reference =
      std::ranges::find_if(own, [](const results::MethodRecord& method) {
        return !whole_maps(method).empty();
      });
  if (reference == own.end())
    return figures;
  for (const ReportEntry& entry : entries.subspan(1))
    for (const results::MethodRecord& method : entry.result->methods)
      if (const MapPairs pairs = map_pairs(method, *reference); !pairs.empty())
        figures.push_back(difference_figure(method.name, reference->name, pairs,
                                            entry.result->contact_modulus));
  return figures;
}

std::vector<Figure> map_figures(const ReportEntry& entry) {
  std::vector<Figure> figures;
  for (const results::MethodRecord* method : methods_with_maps(*entry.result)) {
    const std::vector<const results::Fields*> maps = whole_maps(*method);
    const SurfaceScales scales =
        scales_of(*entry.result, *entry.contact_case, *method, 0);
    if (!maps.empty() && scales.rms_height > 0.0 && scales.rms_slope > 0.0)
      figures.push_back(map_figure(method->name, maps, scales));
  }
  return figures;
}

std::optional<Figure> surface_figure(const ReportEntry& entry) {
  if (entry.result->surfaces.empty())
    return std::nullopt;
  const results::SurfaceRecord& surface = entry.result->surfaces.front();
  if (!surface.has_heights())
    return std::nullopt;
  const MapImage picture = map_image(surface.grid, surface.height_map(), 1e-9);
  const double span = std::max(std::abs(picture.least), picture.largest);
  Figure figure;
  figure.name = "surface";
  figure.title = "The surface";
  figure.maps.emplace_back("map", map_csv(picture));
  figure.stack = height_stack(surface.grid, surface.height_map());
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
      "Heights in nm of realisation 0 over {:.4g} × {:.4g} µm, {} × {} points: "
      "rms height {:.4g} nm, rms slope {:.3g}, skewness {:.2f}, kurtosis "
      "{:.2f}.",
      surface.grid.length_x * 1e6, surface.grid.length_y * 1e6,
      surface.grid.points_x, surface.grid.points_y, surface.rms_height * 1e9,
      surface.rms_slope, Shown{surface.skewness}, surface.kurtosis);
  figure.script = fmt::format(
      "{}{}{}set lmargin at screen 0.14\nset rmargin at screen 0.74\nset "
      "cblabel 'height [nm]'\nset xlabel 'x [µm]'\nset ylabel 'y [µm]'\n{}",
      map_style, height_palette, color_range(-span, span),
      image_plot(picture, "surface-map.csv"));
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
  figure.script = fmt::format("{}{}set multiplot layout 1,3 margins "
                              "0.05,0.93,0.08,0.9 spacing 0.11,0.05\n",
                              map_style, height_palette);
  CsvTable table({"face", "rms_height [m]", "rms_slope [1]", "skewness [1]",
                  "kurtosis [1]", "highest [m]"});
  const auto add = [&](const results::SurfaceRecord& face,
                       const std::string& name, const std::string& title) {
    const MapImage picture = map_image(face.grid, face.height_map(), 1e-9);
    const double span = std::max(std::abs(picture.least), picture.largest);
    figure.maps.emplace_back(name, map_csv(picture));
    table.add(name, {face.rms_height, face.rms_slope, face.skewness,
                     face.kurtosis, face.highest});
    figure.script +=
        fmt::format("set title {}\n",
                    gnuplot_text(fmt::format("{}, {:.3g} nm rms", title,
                                             face.rms_height * 1e9))) +
        color_range(-span, span);
    figure.script += image_plot(picture, "two-faces-" + name + ".csv");
  };
  add(entry.result->surfaces[0], "first", "realisation 0");
  add(entry.result->surfaces[1], "second", "realisation 1");
  add(*sum, "sum", "sum of both");
  figure.script += "unset multiplot\n";
  figure.caption =
      "Heights in nm, axes in µm. The sum is the surface in the equivalent "
      "contact of a flat block with the combined stiffness of the two bodies.";
  figure.data = table.text();
  return figure;
}

} // namespace asperity::reports
