#include "base/shown_number.hpp"
#include "reports/analysis/stress_quantities.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace asperity::reports {
namespace {

/// The subsurface stress maxima of a method: either from its own stress field,
/// or from the continuum solution under its contact pressure.
struct Strength {
  std::string title;
  std::vector<double> von_mises, depth; ///< [Pa], [m]
  std::vector<double> largest_shear;    ///< [Pa]; empty if unknown
  bool is_beside = false; ///< continuum result beside the method's own
};

/// Returns the data sets that have a stress and a depth for each load.
std::vector<Strength> strengths_of(const results::Table& table,
                                   const std::string& method) {
  std::vector<Strength> strengths{{method, table.values("von_mises"),
                                   table.values("depth"),
                                   table.values("largest_shear"), false}};
  if (std::vector<double> beside = table.values("von_mises_from_pressure");
      !beside.empty())
    strengths.push_back({method + ", from its pressure",
                         std::move(beside),
                         table.values("depth_from_pressure"),
                         {},
                         true});
  const std::size_t loads = table.values("nominal_pressure").size();
  std::erase_if(strengths, [&](const Strength& one) {
    return one.von_mises.size() != loads || one.depth.size() != loads;
  });
  for (Strength& one : strengths)
    if (one.largest_shear.size() != loads)
      one.largest_shear.clear();
  return strengths;
}

/// Plots the largest von Mises stress against the load, and its depth below the
/// surface.
Figure strength_figure(const ReportEntry& entry) {
  Figure figure;
  figure.name = "stress-inside";
  figure.title = "Largest subsurface stress";
  const double modulus = entry.result->contact_modulus;
  CsvTable table({"method", "index", "p/E* [1]", "von Mises/E* [1]",
                  "depth [um]", "largest shear/von Mises [1]"});
  ChartPanel strengths{.y = {.label = "σ_{vM} / E*", .is_log = true}};
  ChartPanel depths{.y = {.label = "depth [µm]", .is_log = true}};
  double largest = 0.0; // load and stress over E*
  double strongest = 0.0;
  bool has_whole = false;
  int color = 0;
  for (const results::MethodRecord& method : entry.result->methods) {
    const results::Table* found =
        entry.result->table(stress_table_name(method.name));
    if (found == nullptr)
      continue;
    const std::vector<double> pressure = found->values("nominal_pressure");
    for (const Strength& one : strengths_of(*found, method.name)) {
      has_whole = has_whole || one.is_beside;
      const std::size_t index = strengths.curves.size();
      for (std::size_t i = 0; i < pressure.size(); ++i)
        table.add(one.title, {static_cast<double>(index), pressure[i] / modulus,
                              one.von_mises[i] / modulus, one.depth[i] * 1e6,
                              one.largest_shear.empty()
                                  ? not_a_number
                                  : one.largest_shear[i] / one.von_mises[i]});
      for (std::size_t i = 0; i < pressure.size(); ++i) {
        largest = std::fmax(largest, pressure[i] / modulus);
        strongest = std::fmax(strongest, one.von_mises[i] / modulus);
      }
      CurveStyle style =
          joined(markers(method_color(color), 5 + 2 * color, 0.9, 1.4));
      style.dash = one.is_beside ? 2 : 1;
      strengths.add(one.title, style, index, 3, 4);
      depths.add("", style, index, 3, 5);
    }
    ++color;
  }
  figure.height = 560;
  figure.caption = "The largest von Mises stress anywhere in the block under "
                   "each saved pressure map, and its depth below the contact "
                   "surface (lower plot). Computed from the pressure by the "
                   "continuum solution for each wavevector.";
  if (has_whole)
    figure.caption += " A full 3-D model shows its own values, the largest at "
                      "a quadrature point of its cells; dashed is the "
                      "continuum solution for its pressure.";
  depths.x = pressure_axis("nominal pressure p / E*", "nominal pressure p",
                           modulus, largest);
  depths.x.is_log = true;
  strengths.x = depths.x;
  strengths.y.other = pressure_axis("", "σ_{vM}", modulus, strongest).other;
  figure.panels = {std::move(strengths), std::move(depths)};
  figure.grid = PanelGrid{.rows = 2, .across = 0.02, .down = 0.11};
  figure.data = table.text();
  return figure;
}

/// Returns the edge of the first cell of a row of nodes, and of the last one
/// [um].
std::pair<double, double> cell_edges(double first, double last, int n) {
  const double half = n > 1 ? 0.5 * (last - first) / (n - 1) : 0.5e-6;
  return {1e6 * (first - half), 1e6 * (last + half)};
}

/// Prepares sections at one or more loads for the browser. Their rows are
/// ordered by load and by depth, x fastest.
std::optional<MapStack> section_stack(const results::Table& table,
                                      double modulus) {
  const std::vector<double> depth = table.values("depth");
  const std::vector<double> x = table.values("x");
  const std::vector<double> strength = table.values("von_mises");
  const std::vector<double> pressure = table.values("nominal_pressure");
  if (depth.empty() || x.size() != depth.size() ||
      strength.size() != depth.size() ||
      (!pressure.empty() && pressure.size() != depth.size()))
    return std::nullopt;
  const auto columns = static_cast<std::size_t>(
      std::ranges::find_if(depth,
                           [&](double one) { return one != depth.front(); }) -
      depth.begin());
  const auto size = static_cast<std::size_t>(
      std::ranges::adjacent_find(
          depth, [](double one, double next) { return next < one; }) -
      depth.begin());
  const std::size_t rows_of_map = size == depth.size() ? size : size + 1;
  if (columns == 0 || rows_of_map % columns != 0 ||
      depth.size() % rows_of_map != 0)
    return std::nullopt;
  MapStack stack;
  stack.columns = static_cast<int>(columns);
  stack.rows = static_cast<int>(rows_of_map / columns);
  std::tie(stack.left, stack.right) =
      cell_edges(x.front(), x[columns - 1], stack.columns);
  std::tie(stack.upper, stack.lower) =
      cell_edges(depth.front(), depth[rows_of_map - 1], stack.rows);
  stack.y_label = "depth [µm]";
  stack.quantities = {{.label = "σ_{vM} / E*", .colors = "pressure"}};
  for (std::size_t start = 0; start < depth.size(); start += rows_of_map) {
    std::vector<double> map; // the lowest row first
    for (std::size_t row = rows_of_map; row > 0; row -= columns)
      for (std::size_t i = row - columns; i < row; ++i)
        map.push_back(strength[start + i] / modulus);
    stack.frames.push_back(
        {pressure.empty()
             ? ""
             : fmt::format("p / E* = {:.3g}", pressure[start] / modulus),
         {packed_map(map, columns)}});
  }
  return stack;
}

/// Shows the von Mises stress in a section of x and depth, as an image.
std::optional<Figure> section_figure(const ReportEntry& entry,
                                     const results::MethodRecord& method) {
  const results::Table* section =
      entry.result->table(stress_section_name(method.name));
  if (section == nullptr)
    return std::nullopt;
  const std::vector<double> depth = section->values("depth");
  const std::vector<double> x = section->values("x");
  const std::vector<double> strength = section->values("von_mises");
  if (strength.empty() || depth.size() != strength.size() ||
      x.size() != strength.size())
    return std::nullopt;
  Figure figure;
  figure.name = "stress-section-" + file_word(method.name);
  const bool has_counter = depth.front() < 0.0;
  figure.title = has_counter
                     ? "Section through both bodies, " + method.name
                     : "Section below the contact surface, " + method.name;
  const double modulus = entry.result->contact_modulus;
  CsvTable table({"method", "depth [um]", "x [um]", "von Mises/E* [1]"});
  for (std::size_t i = 0; i < strength.size(); ++i)
    table.add(method.name, {depth[i] * 1e6, x[i] * 1e6, strength[i] / modulus});
  const auto strongest = std::max_element( // points without a stress are NaN
      strength.begin(), strength.end(), [](double a, double b) {
        return b > a || (std::isnan(a) && !std::isnan(b));
      });
  const std::size_t at = static_cast<std::size_t>(strongest - strength.begin());
  const results::Table* const sections =
      entry.result->table(stress_sections_name(method.name));
  figure.stack =
      section_stack(sections == nullptr ? *section : *sections, modulus);
  figure.width = 660;
  figure.height = 330;
  figure.caption = fmt::format(
      "{}. The plane through the point of the largest stress; at most {} "
      "E*, at a depth of {}; {}.",
      section->title, digits_text(*strongest / modulus, 3),
      quantity_text(depth[at], "m", 3),
      has_counter
          ? "the contact surface is at depth 0, and negative depths lie "
            "in the second body"
          : "the contact surface is the upper edge");
  figure.panels = {
      {.x = {.label = "x [µm]",
             .low = rounded(x.front() * 1e6, 6),
             .high = rounded(x.back() * 1e6, 6)},
       .y = {.label = "depth [µm]",
             .low = rounded(depth.back() * 1e6, 6),
             .high = rounded(depth.front() * 1e6, 6)},
       .image = ChartImage{.x = 3,
                           .y = 2,
                           .value = 4,
                           .colors = "pressure",
                           .low = 0.0,
                           .high = rounded(*strongest / modulus, 6),
                           .label = "σ_{vM} / E*",
                           .proportions = Proportions::filling}}};
  figure.data = table.text();
  return figure;
}

std::vector<Figure> stress_figures(const ReportEntry& entry) {
  std::vector<Figure> figures;
  for (const results::MethodRecord& method : entry.result->methods)
    if (std::optional<Figure> section = section_figure(entry, method))
      figures.push_back(std::move(*section));
  if (!figures.empty())
    figures.insert(figures.begin(), strength_figure(entry));
  return figures;
}

} // namespace

const ReportFigure figures::stress{
    .names = {"stress-inside", "stress-section-"},
    .section = FigureSection::contact,
    .draw = drawn_by<stress_figures>};

} // namespace asperity::reports
