#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/types/method_columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::reports {
namespace {

/// Adds the panel with axes around the largest tension.
/// @param tension  over E*
void add_tension_panel(Figure& figure, ChartPanel panel, double tension,
                       double contact_modulus) {
  panel.y =
      pressure_axis("p / E*", "nominal pressure p", contact_modulus, tension);
  panel.y.low = rounded(-1.2 * tension, 4);
  panel.y.high = rounded(1.2 * tension, 4);
  figure.panels.push_back(std::move(panel));
  figure.width = 860;
  figure.height = 400;
  figure.grid = side_by_side(0.25);
  figure.grid->across = 0.14;
  figure.grid->has_shared_legend = true;
  figure.caption += " Right: the same around the largest tension.";
}

std::optional<Figure> adhesion_loop_figure(const ReportEntry& entry) {
  const results::Result& result = *entry.result;
  Figure figure;
  figure.name = "adhesion-loop";
  figure.title = "Approach and retraction with adhesion";
  figure.caption = "The nominal pressure along the loading path of the first "
                   "realisation, with the last state before faces jump into "
                   "contact or out of it; tension is negative. The area "
                   "between the approach and the retraction (dashed) of a "
                   "method is the energy that a cycle loses.";
  const double in_nm = 1e9;
  CsvTable table({"curve", "index", "u [nm]", "p/E* [1]"});
  ChartPanel panel{.x = {.label = "mean separation u  [nm]"},
                   .y = {.label = "p / E*"},
                   .has_zero_line = true};
  std::size_t index = 0, color = 0;
  double least = 0.0, largest = 0.0; // p/E*
  const auto add = [&](const std::string& title, double gap, double pressure) {
    const double p = pressure / result.contact_modulus;
    table.add(title, {static_cast<double>(index), gap * in_nm, p});
    least = std::min(least, p);
    largest = std::max(largest, p);
  };
  for (const results::MethodRecord& method : result.methods) {
    for (const bool is_unloading : {false, true}) {
      if (method.realizations.empty())
        continue;
      const std::string title =
          method.name + (is_unloading ? ", retraction" : ", approach");
      bool has_row = false;
      for (const results::CurvePoint& row : method.realizations.front().points)
        if (row.is_unloading == is_unloading &&
            row.status == results::StepStatus::converged &&
            std::isfinite(row[columns::adhesive_energy])) {
          if (std::isfinite(row[columns::jump_pressure]))
            add(title, row[columns::jump_gap], row[columns::jump_pressure]);
          add(title, row.mean_gap, row.nominal_pressure);
          has_row = true;
        }
      if (has_row)
        panel.add(title, line(method_color(color), 1.6, is_unloading ? 2 : 1),
                  index++, 3, 4);
    }
    color += method.kind == "theory" ? 0 : 1;
  }
  if (panel.curves.empty())
    return std::nullopt;
  figure.data = table.text();
  panel.y = pressure_axis("p / E*", "nominal pressure p",
                          result.contact_modulus, std::max(largest, -least));
  figure.panels = {panel};
  if (least < 0.0 && largest > -3.0 * least) // the tension is hard to see
    add_tension_panel(figure, std::move(panel), -least, result.contact_modulus);
  return figure;
}

} // namespace

const ReportFigure figures::adhesion_loop{.names = {"adhesion-loop"},
                                          .section = FigureSection::studies,
                                          .draw =
                                              drawn_by<adhesion_loop_figure>};

} // namespace asperity::reports
