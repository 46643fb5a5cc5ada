// The figures, tables and quantities of [friction].
#include "base/shown_number.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/map_image.hpp"
#include "reports/figures/map_stacks.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/pages/answers.hpp"
#include "studies/friction/friction.hpp"
#include "studies/friction/partial_slip.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::studies {

using namespace reports;

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

std::optional<Figure> slip_figure(const ReportEntry& entry,
                                  std::span<const Series> series) {
  Figure figure;
  figure.name = "partial-slip";
  figure.title = "Partial slip";
  figure.width = 860;
  figure.height = 400;
  figure.panels.resize(2);
  figure.grid = side_by_side(0.25);
  figure.grid->has_shared_legend = true;
  CsvTable table = slip_table();
  std::size_t next = 0;
  for (const results::MethodRecord& method : entry.result->methods) {
    const auto curves =
        partial_slips(*entry.result, *entry.contact_case, method);
    const std::vector<SlipPoint> points = slip_points(curves);
    const auto own = std::ranges::find(
        series, method_called(entry.summary.methods, method.name),
        &Series::method);
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
          method.name, maps,
          entry.contact_case->study<FrictionStudy>()->coefficient));
  }
  return figures;
}

std::vector<Figure> friction_figures(const FigureData& data) {
  const ReportEntry& entry = data.entries.front();
  std::vector<Figure> figures = as_list(slip_figure(entry, data.series));
  for (Figure& traction : traction_figures(entry))
    figures.push_back(std::move(traction));
  return figures;
}

std::string friction_text(const cases::Case& contact_case) {
  const auto* const study = contact_case.study<FrictionStudy>();
  return study == nullptr
             ? ""
             : fmt::format(" Partial slip with the friction coefficient {:g} "
                           "follows from two normal contacts "
                           "[ciavarella1998].",
                           study->coefficient);
}

/// The first method that is no theory, else the theory.
std::string friction_answer(const ReportEntry& entry) {
  for (const bool is_theory : {false, true})
    for (const results::MethodRecord& method : entry.result->methods) {
      if ((method.kind == "theory") != is_theory)
        continue;
      const auto curves =
          partial_slips(*entry.result, *entry.contact_case, method);
      const std::vector<SlipPoint> points = slip_points(curves);
      if (points.empty() || !(points.back().share > 0.0))
        continue;
      const SlipPoint& last = points.back();
      return fmt::format(
          "Under {} it slides at a tangential load of {}; at {} of that the "
          "faces have moved {} along x and {} % of the contact sticks{}.",
          quantity_text(curves.front().front().pressure, "Pa", 3),
          quantity_text(last.tangential_stress / last.share, "Pa", 3),
          digits_text(last.share, 3),
          quantity_text(last.displacement.x.mean, "m", 3),
          digits_text(100.0 * last.stick.mean, 3),
          method_in_words(entry, method));
    }
  return "";
}

using Json = nlohmann::ordered_json;

/// The mean along y if it differs from that along x.
double other_mean(const SlipSpreads& spreads) {
  return fmt::format("{:.4g}", spreads.x.mean) ==
                 fmt::format("{:.4g}", spreads.y.mean)
             ? not_a_number
             : spreads.y.mean;
}

/// Partial slip by tangential load and method, means over the realisations
/// (studies/friction/partial_slip.hpp).
Json partial_slip(const ReportEntry& entry) {
  Json rows = Json::array();
  for (const results::MethodRecord& method : entry.result->methods)
    for (const SlipPoint& point :
         slip_points(partial_slips(*entry.result, *entry.contact_case, method)))
      rows.push_back({{"method", method.name},
                      {"share", point.share},
                      {"tangential_stress [Pa]", point.tangential_stress},
                      {"displacement_x [m]", point.displacement.x.mean},
                      {"displacement_y [m]", other_mean(point.displacement)},
                      {"stick_fraction", point.stick.mean},
                      {"stiffness_x [Pa/m]", point.stiffness.x.mean},
                      {"stiffness_y [Pa/m]", other_mean(point.stiffness)},
                      {"loss_x [J/m^2]", point.loss.x.mean},
                      {"loss_y [J/m^2]", other_mean(point.loss)}});
  return rows;
}

/// What the table of partial slip means.
std::string slip_note(const ReportEntry& entry) {
  const cases::Case& contact_case = *entry.contact_case;
  std::string load;
  for (const results::MethodRecord& method : entry.result->methods)
    if (const auto curves = partial_slips(*entry.result, contact_case, method);
        load.empty() && !curves.empty())
      load = fmt::format(" of {:.4g} MPa A_0",
                         1e-6 * curves.front().front().pressure);
  const double beta = mechanics::coupling(contact_case.material);
  return fmt::format(
      "A tangential load Q acts under a constant normal load P{}, with the "
      "friction coefficient {:g}: Q = {:g} (P − P'), where the nodes "
      "in contact at the lighter load P' stick and the others slip. The loss "
      "is that of a cycle between Q and −Q, per nominal area. Two numbers "
      "are those of Q along x and along y. Tangential compliance over normal "
      "compliance, mean over the directions: {:.4g}. {}",
      load, contact_case.study<FrictionStudy>()->coefficient,
      contact_case.study<FrictionStudy>()->coefficient,
      mechanics::tangential_ratio(contact_case.material),
      std::abs(beta) < 1e-12
          ? "Normal and tangential tractions of this pair do not couple."
          : fmt::format("The coupling of normal and tangential tractions of "
                        "this pair, Dundurs' β = {:.3g}, is neglected.",
                        beta));
}

void add_friction_tables(const ReportEntry& entry, Json& page) {
  page["partial_slip"] = partial_slip(entry);
  if (!page["partial_slip"].empty())
    page["slip_note"] = slip_note(entry);
}

void add_friction_quantities(const results::Result& result,
                             const cases::Case& contact_case,
                             const results::MethodRecord& method,
                             std::span<const std::string>,
                             MethodSummary& summary) {
  if (asks<FrictionStudy>(contact_case))
    add_slip_quantities(result, contact_case, method, summary);
}

std::vector<cases::ExpectationName> quantities_of_friction() {
  return {{.name = "partial_slip_error",
           .description =
               "Largest error of the displacement of a tangential load, over "
               "that at which the contact slides, and of the area that sticks, "
               "over that of the contact; needs [friction] and free boundaries "
               "[1].",
           .surfaces = {mechanics::SurfaceKind::sphere}}};
}

} // namespace

const StudyPages& friction_pages() {
  static const StudyPages pages{.name = "friction",
                                .figure_names = {"partial-slip", "traction-"},
                                .figures = friction_figures,
                                .answer = friction_answer,
                                .methods_text = friction_text,
                                .quantities = quantities_of_friction(),
                                .add_quantities = add_friction_quantities,
                                .add_tables = add_friction_tables};
  return pages;
}

} // namespace asperity::studies
