#include "base/special_numbers.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/load_spread.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/observables/clusters.hpp"
#include "results/types/study_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::reports {
namespace {

using results::CurvePoint;

constexpr double per_millimetre = 1e3; // [1/m]

class ConductanceFigure {
public:
  explicit ConductanceFigure(const ReportEntry& entry) : entry_(entry) {}

  void add_theory(const results::MethodRecord& method) {
    panel_.add(method.name + ", -dp/du", line("#222222", 1.6),
               curve(method, [&](const CurvePoint& row, std::size_t) {
                 return row.contact_stiffness / modulus();
               }));
    panel_.add(method.name + ", p/u_0", line("#222222", 1.0, 2),
               curve(method, [&](const CurvePoint& row, std::size_t r) {
                 return row.nominal_pressure / decay_length(method, r) /
                        modulus();
               }));
  }

  void add_numbers(const results::MethodRecord& method, std::size_t color) {
    Series as_series;
    as_series.kind = method.kind;
    as_series.color = color;
    const std::string own = series_color(as_series);
    panel_.add(method.name + ", standing contact", point_style(as_series),
               curve(method, [](const CurvePoint& row, std::size_t) {
                 return row[columns::relative_conductance];
               }));
    panel_.add(method.name + ", -dp/du of the curve", line(own, 1.4),
               curve(method, [&](const CurvePoint& row, std::size_t) {
                 return row.contact_stiffness / modulus();
               }));
    panel_.add(method.name + ", spots as circles alone", line(own, 1.0, 2),
               curve(method, [](const CurvePoint& row, std::size_t) {
                 return 2.0 * row[columns::spot_radii];
               }));
    panel_.add(method.name + ", Barber's lower bound", line(own, 1.0, 3),
               curve(method, [&](const CurvePoint& row, std::size_t r) {
                 const results::SurfaceRecord* const surface =
                     surface_of(*entry_.result, method, r);
                 return surface == nullptr
                            ? not_a_number
                            : row.nominal_pressure /
                                  (surface->highest - row.mean_gap) / modulus();
               }));
  }

  bool is_empty() const { return panel_.is_empty(); }

  Figure take() && {
    Figure figure;
    figure.name = "conductance";
    figure.title = "Conductance and stiffness against load";
    figure.caption =
        "Conductance over conductivity, G/k, which is the incremental normal "
        "stiffness K over E*, both per nominal area. Markers: of the "
        "standing contact, the median over realisations; bars span their "
        "range, and crosses at the axis are loads without contact, where it "
        "is 0. Lines: the slope of the curve of pressure against mean "
        "gap, which lies between the loads, that of the theory and its limit "
        "p/u_0 at light load, Eq. (18) of Yang and Persson (2008), the spots "
        "as circles of their areas that do not disturb each other, and "
        "Barber's lower bound p/(h_max - u).";
    const CurvePoint unit = unit_row();
    if (unit[columns::thermal_conductance] > 0.0)
      figure.caption +=
          fmt::format(" 1/mm is {:.4g} W/(m^2 K).",
                      unit[columns::thermal_conductance] * per_millimetre);
    if (unit[columns::electrical_conductance] > 0.0)
      figure.caption +=
          fmt::format(" 1/mm is {:.4g} per Ohm m^2.",
                      unit[columns::electrical_conductance] * per_millimetre);
    panel_.move_to(figure, "K/E^* = G/k  [1/mm]");
    return figure;
  }

private:
  double modulus() const { return entry_.result->contact_modulus; }

  /// u_0 of Eq. (18) of a theory [m]; NaN without it.
  double decay_length(const results::MethodRecord& method,
                      std::size_t realization) const {
    const auto& methods = entry_.summary.methods;
    const auto found =
        std::ranges::find(methods, method.name, &MethodSummary::name);
    if (found == methods.end() || found->fits.size() <= realization)
      return not_a_number;
    const RealizationFits& fits = found->fits[realization];
    return fits.asymptotic_slope * fits.scales.rms_height;
  }

  template <class Number>
  SpreadCurve curve(const results::MethodRecord& method,
                    const Number& number) const {
    return spread_curve(method, number);
  }

  /// The conductances over the relative one, of the first row that has them.
  CurvePoint unit_row() const {
    for (const results::MethodRecord& method : entry_.result->methods)
      for (const results::Curve& realization : method.realizations)
        for (CurvePoint row : realization.points)
          if (row[columns::relative_conductance] > 0.0) {
            row[columns::thermal_conductance] /=
                row[columns::relative_conductance];
            row[columns::electrical_conductance] /=
                row[columns::relative_conductance];
            return row;
          }
    return {};
  }

  const ReportEntry& entry_;
  SpreadPanel panel_{"G/k [1/mm]", per_millimetre, "without contact"};
};

/// The clusters of a saved map.
std::vector<results::Cluster> clusters_of(const ReportEntry& entry,
                                          const results::MethodRecord& method,
                                          const results::Fields& map,
                                          bool is_gap) {
  const mechanics::ContactCriterion criterion = contact_criterion_of(
      *entry.contact_case, method, method_scales(entry, method).rms_height);
  std::vector<std::uint8_t> set;
  set.reserve(map.grid.size());
  results::each_piece(
      std::array{map.pressure_map(), map.gap_map()},
      [&](std::size_t, const auto& values) {
        const mechanics::ContactNodes nodes(criterion, values[0], values[1]);
        std::ranges::copy(is_gap ? nodes.open_set() : nodes.contact_set(),
                          std::back_inserter(set));
      });
  const results::SurfaceRecord* const pressed =
      surface_of(*entry.result, method, 0);
  const bool has_images =
      pressed != nullptr && !pressed->map.is_whole(pressed->grid);
  return results::find_clusters(map.grid, set,
                                has_images
                                    ? results::Border::free
                                    : border_of(*entry.contact_case, method));
}

/// Adds how many clusters have at least an area, one row for each area.
void add_sizes(std::vector<results::Cluster> clusters, const std::string& label,
               CurveStyle style, ChartPanel& panel, CsvTable& table) {
  if (clusters.empty())
    return;
  std::ranges::sort(clusters, std::ranges::greater{}, &results::Cluster::area);
  const std::size_t index = panel.curves.size();
  for (std::size_t i = 0; i < clusters.size(); ++i)
    if (i + 1 == clusters.size() || clusters[i + 1].area < clusters[i].area)
      table.add(label, {static_cast<double>(index), clusters[i].area * 1e12,
                        static_cast<double>(i + 1)});
  panel.add(label, std::move(style), index, 3, 4);
}

} // namespace

std::optional<Figure> conductance_figure(const ReportEntry& entry) {
  if (!entry.contact_case->conductance_study)
    return std::nullopt;
  return figure_of_methods(ConductanceFigure(entry), entry.result->methods);
}

std::vector<Figure> spot_figures(const ReportEntry& entry) {
  std::vector<Figure> figures;
  if (!entry.contact_case->spots_study)
    return figures;
  for (const results::MethodRecord* method : methods_with_maps(*entry.result)) {
    Figure figure;
    figure.name = "spots-" + file_word(method->name);
    figure.title = "Sizes of the spots of contact, " + method->name;
    figure.caption =
        "Number of clusters of at least this area, of nodes that are joined by "
        "their four neighbours, on saved maps of the first realisation: solid "
        "lines, spots of contact; dashed lines, parts of the gap.";
    CsvTable table({"clusters", "index", "area [um^2]", "number [1]"});
    ChartPanel panel;
    const std::vector<results::Fields> maps = shown_maps(*method);
    const FigureScales scales = method_scales(entry, *method);
    std::size_t load = 0;
    for (const std::size_t i : three_of(maps.size())) {
      const std::string words = load_text(scales, maps[i].nominal_pressure);
      add_sizes(clusters_of(entry, *method, maps[i], false),
                "contact, " + words, line(load_color(load), 1.6), panel, table);
      add_sizes(clusters_of(entry, *method, maps[i], true), "gap, " + words,
                line(load_color(load), 1.2, 2), panel, table);
      ++load;
    }
    if (panel.curves.empty())
      continue;
    panel.x = {.label = "area  [µm^2]", .is_log = true, .has_powers = true};
    panel.y = {.label = "number of at least this area", .is_log = true};
    figure.panels = {std::move(panel)};
    figure.data = table.text();
    figures.push_back(std::move(figure));
  }
  return figures;
}

} // namespace asperity::reports
