#include "suite/exchange/board/board_figures.hpp"

#include "base/shown_number.hpp"
#include "reports/figures/map_image.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::exchange {
namespace {

bool has_point(const BoardEntry& entry) {
  return entry.state == BoardEntry::State::certified && entry.answer.timing &&
         entry.missing_loads == 0 && std::isfinite(entry.cpu_time) &&
         entry.gap_error > 0.0;
}

std::vector<std::string> codes_of(const std::vector<BoardEntry>& entries) {
  std::vector<std::string> codes;
  for (const BoardEntry& entry : entries)
    if (has_point(entry) &&
        std::ranges::find(codes, entry.answer.code) == codes.end())
      codes.push_back(entry.answer.code);
  std::ranges::sort(codes);
  return codes;
}

} // namespace

reports::Figure surface_figure(const Problem& problem) {
  const Grid& grid = problem.grid;
  const reports::MapImage image =
      reports::map_image(grid, problem.heights, problem.rms_height);
  reports::Figure figure;
  figure.name = "surface-" + reports::file_word(problem.name);
  figure.title = "Heights over h_rms";
  figure.caption = fmt::format(
      "{} × {} nodes over {} × {}; h_rms = {}, rms slope {}. Positive towards "
      "the body.{}",
      grid.points_x, grid.points_y, quantity_text(grid.length_x, "m"),
      quantity_text(grid.length_y, "m"), quantity_text(problem.rms_height, "m"),
      digits_text(problem.rms_slope, 3),
      image.columns < grid.points_x ? " Means over blocks of nodes." : "");
  figure.data = "h_rms [m]\n" + fmt::format("{}\n", problem.rms_height);
  figure.maps.emplace_back("heights", reports::map_csv(image));
  reports::ChartPanel& panel = figure.panels.emplace_back(
      reports::map_panel(image, "heights", "height"));
  panel.x.label = "x [µm]";
  panel.y.label = "y [µm]";
  return figure;
}

reports::Figure error_figure(const BoardProblem& problem) {
  reports::Figure figure;
  figure.name = "error-" + reports::file_word(problem.problem.name);
  figure.title = "Certified error against CPU time";
  figure.caption =
      "Largest bound of the error of the mean gap over all loads, against the "
      "CPU time of all loads (median). Open: default accuracy, filled: best. "
      "Only answers to all loads whose times were measured in a named run; "
      "times of different runs, of which the table has the names, do not "
      "compare.";
  const std::vector<std::string> codes = codes_of(problem.entries);
  if (codes.empty())
    figure.problem =
        "no certified answer to all loads states how its CPU time was measured";
  reports::CsvTable table({"code", "index", "cpu_time [s]", "error [h_rms]"});
  reports::ChartPanel panel{
      .x = {.label = "CPU time [s]", .is_log = true, .has_powers = true},
      .y = {.label = "bound of |u - u*| / h_{rms}",
            .is_log = true,
            .has_powers = true}};
  for (std::size_t c = 0; c < codes.size(); ++c)
    for (const bool is_best : {false, true}) {
      const std::size_t index = 2 * c + (is_best ? 1 : 0);
      bool has_any = false;
      for (const BoardEntry& entry : problem.entries)
        if (has_point(entry) && entry.answer.code == codes[c] &&
            (entry.answer.accuracy == "best") == is_best) {
          table.add(
              entry.answer.code + " " + entry.answer.version,
              {static_cast<double>(index), entry.cpu_time, entry.gap_error});
          has_any = true;
        }
      if (has_any)
        panel.add(codes[c] + (is_best ? ", best" : ""),
                  reports::markers(reports::method_color(c), is_best ? 7 : 6,
                                   0.9, 1.4),
                  index, 3, 4);
    }
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

reports::Figure mesh_figure(const BoardProblem& problem, MeshCost cost) {
  const bool is_time = cost == MeshCost::time;
  const std::string words = is_time ? "CPU time" : "memory";
  reports::Figure figure;
  figure.name = (is_time ? "mesh-time-" : "mesh-memory-") +
                reports::file_word(problem.problem.name);
  figure.title = "Distance from the continuum against " + words;
  figure.caption =
      "Largest distance of the stated mean gaps from the continuum's, "
      "against " +
      words + (is_time ? " (median)" : " (peak)") +
      ". Only answers to all loads whose times were measured in a named run.";
  figure.problem =
      "no certified answer to all loads states how its CPU time was measured";
  const std::string unit = is_time ? "CPU time [s]" : "memory [MB]";
  reports::CsvTable table({"code", "index", unit, "error [h_rms]"});
  reports::ChartPanel panel{
      .x = {.label = unit, .is_log = true, .has_powers = true},
      .y = {.label = "|u - u_{continuum}| / h_{rms}",
            .is_log = true,
            .has_powers = true}};
  std::size_t index = 0;
  for (const BoardEntry& entry : problem.entries)
    if (has_point(entry) && entry.continuum_error > 0.0) {
      const std::string label =
          entry.answer.code + " " + entry.answer.version +
          (entry.answer.accuracy == "best" ? ", best" : "");
      table.add(label, {static_cast<double>(index),
                        is_time ? entry.cpu_time : 1e-6 * entry.peak_memory,
                        entry.continuum_error});
      panel.add(label,
                reports::markers(reports::method_color(index),
                                 entry.answer.accuracy == "best" ? 7 : 6, 0.9,
                                 1.4),
                index, 3, 4);
      figure.problem.clear();
      ++index;
    }
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

} // namespace asperity::exchange
