#include "reports/analysis/partial_slip.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/map_image.hpp"
#include "reports/figures/map_stacks.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

/// Two saved maps of one method: under the normal load P, and at the lighter
/// load P' of a tangential one.
struct SlipMaps {
  std::optional<results::Fields> pressed, eased;
};

/// The saved map at the normal load with that nearest to half of the load.
SlipMaps slip_maps(const results::MethodRecord& method, double normal_load) {
  SlipMaps found;
  const std::vector<results::Fields> maps = shown_maps(method);
  for (const results::Fields& map : maps)
    if (std::abs(map.nominal_pressure - normal_load) < 1e-6 * normal_load)
      found.pressed = map;
  const auto distance = [=](const std::optional<results::Fields>& map) {
    return map ? std::abs(map->nominal_pressure - 0.5 * normal_load)
               : normal_load;
  };
  for (const results::Fields& map : maps)
    if (map.nominal_pressure < normal_load * (1.0 - 1e-6) &&
        distance(map) < distance(found.eased))
      found.eased = map;
  return found;
}

Figure traction_figure(const std::string& method, const SlipMaps& maps,
                       double friction) {
  const Grid& grid = maps.pressed->grid;
  const double share =
      1.0 - maps.eased->nominal_pressure / maps.pressed->nominal_pressure;
  const ReducedMap pressure =
      reduced(grid, maps.pressed->pressure_map(), most_image_points);
  ReducedMap difference =
      reduced_difference(grid, maps.pressed->pressure_map(),
                         maps.eased->pressure_map(), most_image_points);
  const MapImage traction = image_of(grid, difference, 1e6 / friction);
  for (std::size_t i = 0; i < difference.values.size(); ++i)
    difference.values[i] = pressure.values[i] > 0.0
                               ? difference.values[i] / pressure.values[i]
                               : 0.0;
  const MapImage used = image_of(grid, std::move(difference), 1.0);
  Figure figure;
  figure.name = "traction-" + file_word(method);
  figure.title = "Tangential traction, " + method;
  figure.width = 720;
  figure.height = 330;
  figure.grid = PanelGrid{.rows = 1,
                          .columns = 2,
                          .margins = {{0.09, 0.88, 0.18, 0.95}},
                          .across = 0.2};
  CsvTable table({"map", "Q/(mu P) [1]", "nominal_pressure [Pa]"});
  const auto add = [&](const MapImage& image, const std::string& name,
                       const std::string& label, double largest) {
    figure.maps.emplace_back(name, map_csv(image));
    table.add(name, {share, maps.pressed->nominal_pressure});
    ChartPanel& panel =
        figure.panels.emplace_back(map_panel(image, name, "pressure"));
    panel.x.label = "x [µm]";
    panel.y.label = figure.panels.size() == 1 ? "y [µm]" : "";
    panel.image->label = label;
    set_colors(panel, 0.0, largest);
  };
  add(traction, "traction", "q [MPa]", std::max(traction.largest, 1e-12));
  add(used, "used", "q / (μ p)", 1.0);
  figure.caption = fmt::format(
      "Traction q under the tangential load Q = {:.3g} μ P, and its share of "
      "μ p: nodes at which it is 1 slip, the others of the contact stick. "
      "White: no contact.",
      share);
  figure.data = table.text();
  return figure;
}

CsvTable slip_table() {
  return CsvTable({"curve", "index", "Q/(mu P) [1]", "displacement x [nm]",
                   "least displacement x [nm]", "largest displacement x [nm]",
                   "stick/contact [1]", "least stick/contact [1]",
                   "largest stick/contact [1]", "Q/A_0 [MPa]",
                   "stiffness x [MPa/nm]", "loss x [J/m^2]",
                   "displacement y [nm]", "stiffness y [MPa/nm]",
                   "loss y [J/m^2]"});
}

/// The numbers of slip_table() of a point of a curve.
std::vector<double> slip_row(std::size_t curve, const SlipPoint& at) {
  return {static_cast<double>(curve),
          at.share,
          1e9 * at.displacement.x.mean,
          1e9 * at.displacement.x.low,
          1e9 * at.displacement.x.high,
          at.stick.mean,
          at.stick.low,
          at.stick.high,
          1e-6 * at.tangential_stress,
          1e-15 * at.stiffness.x.mean,
          at.loss.x.mean,
          1e9 * at.displacement.y.mean,
          1e-15 * at.stiffness.y.mean,
          at.loss.y.mean};
}

} // namespace

std::optional<Figure> slip_figure(const ReportEntry& entry, std::size_t index,
                                  std::span<const Series> series) {
  Figure figure;
  figure.name = "partial-slip";
  figure.title = "Partial slip";
  figure.width = 860;
  figure.height = 400;
  figure.panels.resize(2);
  figure.grid = side_by_side(0.2);
  figure.grid->has_shared_legend = true;
  CsvTable table = slip_table();
  std::size_t next = 0;
  for (const results::MethodRecord& method : entry.result->methods) {
    const auto curves =
        partial_slips(*entry.result, *entry.contact_case, method);
    const std::vector<SlipPoint> points = slip_points(curves);
    const auto own = std::ranges::find_if(series, [&](const Series& one) {
      return one.entry == index && one.method != nullptr &&
             one.method->name == method.name;
    });
    if (points.empty() || own == series.end())
      continue;
    for (const SlipPoint& at : points)
      table.add(method.name, slip_row(next, at));
    const CurveStyle style = method.kind == "theory"
                                 ? line("#222222", 1.6)
                                 : joined(point_style(*own));
    for (std::size_t panel = 0; panel < 2; ++panel) {
      ChartCurve& curve = figure.panels[panel].add(
          method.name, style, next, 3, static_cast<int>(4 + 3 * panel));
      if (curves.size() > 1) {
        curve.low = curve.y + 1;
        curve.high = curve.y + 2;
      }
    }
    ++next;
  }
  if (next == 0)
    return std::nullopt;
  figure.panels[0].x =
      figure.panels[1].x = {.label = "Q / (μ P)", .low = 0.0, .high = 1.0};
  figure.panels[0].y = {.label = "displacement along x  [nm]", .low = 0.0};
  figure.panels[1].y = {
      .label = "area that sticks / contact", .low = 0.0, .high = 1.0};
  figure.caption = "Tangential displacement of far points along x and the "
                   "share of the contact that sticks, under the normal load P "
                   "of the case; bars span the realisations.";
  figure.data = table.text();
  return figure;
}

std::vector<Figure> traction_figures(const ReportEntry& entry) {
  std::vector<Figure> figures;
  for (const results::MethodRecord& method : entry.result->methods) {
    const auto curves =
        partial_slips(*entry.result, *entry.contact_case, method);
    if (curves.empty() || !(curves.front().front().contact > 0.0))
      continue;
    if (const SlipMaps maps =
            slip_maps(method, curves.front().front().pressure);
        maps.pressed && maps.eased)
      figures.push_back(traction_figure(
          method.name, maps, entry.contact_case->friction_study->coefficient));
  }
  return figures;
}

} // namespace asperity::reports
