#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/types/method_columns.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace asperity::reports {
namespace {

const char* const elastic_color = "#0072B2";
const char* const plastic_color = "#D55E00";

/// Sums over the realisations at one step.
struct AreaSums {
  double pressure = 0.0, elastic = 0.0, plastic = 0.0;
  int count = 0;
  bool is_complete = true; ///< whether all realisations converged
};

/// The steps under first load of a method with a hardness.
std::map<int, AreaSums> yielding_steps(const results::MethodRecord& method) {
  std::map<int, AreaSums> steps;
  for (const results::CurvePoint& row : method.rows()) {
    if (row.is_unloading)
      continue;
    AreaSums& sums = steps[row.step];
    sums.is_complete = sums.is_complete &&
                       std::isfinite(row[columns::plastic_area]) &&
                       row.status == results::StepStatus::converged;
    sums.pressure += row.nominal_pressure;
    sums.elastic += row.area_fraction - row[columns::plastic_area];
    sums.plastic += row[columns::plastic_area];
    ++sums.count;
  }
  std::erase_if(steps, [](const auto& at) { return !at.second.is_complete; });
  return steps;
}

std::optional<Figure> plastic_area_figure(const ReportEntry& entry) {
  Figure figure;
  figure.name = "plastic-area";
  figure.title = "Elastic and plastic contact area against pressure";
  figure.caption =
      "Symbols: area under a pressure below the hardness, and at the hardness, "
      "under first load; means over the realisations. Lines: Persson's theory "
      "with absorbing boundaries at 0 and at the hardness.";
  CsvTable table(
      {"curve", "index", "p/E* [1]", "A/A_0 elastic [1]", "A/A_0 plastic [1]"});
  std::vector<double> loads;
  ChartPanel panel{.x = {.label = "p / E*"}, .y = {.label = "A / A_0"}};
  panel.y.low = 0.0;
  std::size_t index = 0;
  for (const results::MethodRecord& method : entry.result->methods) {
    const std::map<int, AreaSums> steps = yielding_steps(method);
    if (steps.empty())
      continue;
    for (const auto& [step, sums] : steps) {
      const double pressure =
          sums.pressure / sums.count / entry.result->contact_modulus;
      loads.push_back(pressure);
      table.add(method.name,
                {static_cast<double>(index), pressure,
                 sums.elastic / sums.count, sums.plastic / sums.count});
    }
    const auto style = [&](const char* color, int marker) {
      return method.kind == "theory" ? line(color, 1.6, 1)
                                     : markers(color, marker, 0.9, 1.3);
    };
    panel.add(method.name + ", elastic", style(elastic_color, 7), index, 3, 4);
    panel.add(method.name + ", plastic", style(plastic_color, 5), index++, 3,
              5);
  }
  if (panel.curves.empty())
    return std::nullopt;
  panel.x.is_log = panel.x.has_powers = is_spaced_logarithmically(loads);
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

} // namespace

const ReportFigure figures::plastic_area{.names = {"plastic-area"},
                                         .section = FigureSection::contact,
                                         .draw = drawn_by<plastic_area_figure>};

} // namespace asperity::reports
