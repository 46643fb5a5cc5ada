#include "reports/figures/figures.hpp"

#include "reports/analysis/warnings.hpp"
#include "reports/figures/height_figure.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/study_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <iterator>
#include <new>
#include <string_view>

namespace asperity::reports {
namespace {

using TableRow = std::vector<double>; ///< without the label

/// Reads the rows of a CsvTable, whose labels are quoted.
std::vector<TableRow> rows_in(std::string_view table) {
  std::vector<TableRow> rows;
  table.remove_prefix(std::min(table.find('\n') + 1, table.size()));
  while (!table.empty()) {
    const std::string_view line = table.substr(0, table.find('\n'));
    table.remove_prefix(std::min(line.size() + 1, table.size()));
    const std::size_t label_end = line.rfind('"');
    TableRow row;
    for (std::size_t comma = line.find(
             ',', label_end == std::string_view::npos ? 0 : label_end);
         comma != std::string_view::npos; comma = line.find(',', comma + 1)) {
      double number = std::nan("");
      std::from_chars(line.data() + comma + 1, line.data() + line.size(),
                      number);
      row.push_back(number);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// @param column  counted from 1, with the label
double cell_number(const TableRow& row, int column) {
  const auto place = static_cast<std::size_t>(column - 2);
  return column >= 2 && place < row.size() ? row[place] : std::nan("");
}

bool is_on_axis(double number, const ChartAxis& axis) {
  return std::isfinite(number) && (!axis.is_log || number > 0.0);
}

bool has_points(const ChartCurve& curve, const ChartPanel& panel,
                const std::vector<TableRow>& rows) {
  const ChartAxis& y =
      curve.is_on_second_axis && panel.second ? *panel.second : panel.y;
  return std::ranges::any_of(rows, [&](const TableRow& row) {
    return cell_number(row, 2) == curve.index &&
           is_on_axis(cell_number(row, curve.x), panel.x) &&
           is_on_axis(cell_number(row, curve.y), y);
  });
}

/// Whether all that a panel has are curves, and none of them has a point. Lines
/// without data belong to the others.
bool shows_nothing(const ChartPanel& panel, const std::vector<TableRow>& rows) {
  if (panel.image || !panel.bands.empty() || panel.curves.empty())
    return false;
  return std::ranges::none_of(panel.curves, [&](const ChartCurve& curve) {
    return curve.is_per_row || (curve.x != 0 && has_points(curve, panel, rows));
  });
}

/// Removes the panels whose curves have no point with a number on both axes,
/// and the figures of which no panel is left.
void leave_out_empty_panels(std::vector<Figure>& figures) {
  std::erase_if(figures, [](Figure& figure) {
    if (figure.panels.empty() || !figure.problem.empty())
      return false;
    const std::vector<TableRow> rows = rows_in(figure.data);
    std::erase_if(figure.panels, [&](const ChartPanel& panel) {
      return shows_nothing(panel, rows);
    });
    if (figure.panels.size() == 1)
      figure.grid.reset();
    return figure.panels.empty();
  });
}

void append(std::vector<Figure>& figures, Figure figure) {
  figures.push_back(std::move(figure));
}

void append(std::vector<Figure>& figures, std::optional<Figure> figure) {
  if (figure)
    figures.push_back(std::move(*figure));
}

void append(std::vector<Figure>& figures, std::vector<Figure> more) {
  std::move(more.begin(), more.end(), std::back_inserter(figures));
}

// Adds the figures that `build` returns. If it throws, a placeholder figure
// that states the reason is added instead, so that the report continues.
template <class Build>
void add(std::vector<Figure>& figures, const char* name, const Build& build) {
  try {
    append(figures, build());
  } catch (const std::bad_alloc&) {
    throw; // a system error, not a property of the data
  } catch (const std::exception& error) {
    Figure none;
    none.name = none.title = name;
    none.problem = error.what();
    figures.push_back(std::move(none));
  }
}

// Returns the folder name of a case. The leading number makes it unique.
std::string folder_name(std::size_t index, const std::string& name) {
  return fmt::format("{}-{}", index + 1, file_word(name));
}

bool has_tension(const results::Result& result) {
  for (const results::MethodRecord& method : result.methods)
    for (const results::Curve& curve : method.realizations)
      for (const results::CurvePoint& row : curve.points)
        if (row.status == results::StepStatus::converged &&
            row.nominal_pressure < 0.0)
          return true;
  return false;
}

/// True if steps converged and none is pressed: a warning says so, or the
/// figure of the path with adhesion shows it.
bool is_never_pressed(std::span<const ReportEntry> entries,
                      std::span<const Series> series) {
  return std::ranges::all_of(
             series, [](const Series& one) { return one.rows.empty(); }) &&
         std::ranges::any_of(entries, [](const ReportEntry& entry) {
           return has_tension(*entry.result) ||
                  std::ranges::any_of(
                      warnings_of(*entry.result, *entry.contact_case),
                      [](const Warning& one) {
                        return one.kind == "no_contact";
                      });
         });
}

FigureGroup shared_curves(std::span<const ReportEntry> entries,
                          std::span<const Series> series) {
  FigureGroup group{"The curves", "", {}};
  const bool has_rough =
      std::any_of(entries.begin(), entries.end(), [](const ReportEntry& e) {
        return !is_exact_shape(*e.contact_case);
      });
  if (!has_rough || is_never_pressed(entries, series))
    return group;
  auto& figures = group.figures;
  const FigureScales scales = figure_scales(entries);
  add(figures, "pressure-gap",
      [&] { return pressure_gap_figure(series, scales); });
  add(figures, "gap-deviation",
      [&] { return gap_deviation_figure(series, scales); });
  add(figures, "area-pressure", [&] { return area_figure(series, scales); });
  add(figures, "area-coefficient",
      [&] { return area_coefficient_figure(series); });
  add(figures, "area-theory", [&] { return area_theory_figure(series); });
  return group;
}

FigureGroup figures_of_one(const ReportEntry& entry, std::size_t index,
                           bool is_one_of_many) {
  FigureGroup group{"Surface and contact", "", {}};
  if (is_one_of_many) {
    group.heading += ": " + entry.summary.case_name;
    group.folder = folder_name(index, entry.summary.case_name);
  }
  auto& figures = group.figures;
  const bool is_exact = is_exact_shape(*entry.contact_case);
  if (is_exact)
    add(figures, "exact", [&] { return exact_figures(entry); });
  add(figures, "surface", [&] { return surface_figure(entry); });
  add(figures, "two-faces", [&] { return two_faces_figure(entry); });
  add(figures, "spectrum", [&] { return spectrum_figure(entry); });
  add(figures, "height-distribution", [&] { return height_figure(entry); });
  if (!is_exact) {
    add(figures, "pressure-distribution",
        [&] { return pressure_distribution_figures(entry); });
    add(figures, "gap-distribution",
        [&] { return gap_distribution_figures(entry); });
  }
  add(figures, "plastic-area", [&] { return plastic_area_figure(entry); });
  add(figures, "maps", [&] { return map_figures(entry); });
  add(figures, "stress-inside", [&] { return stress_figures(entry); });
  return group;
}

/// Returns the figures of the studies of one result; the group is empty if the
/// result has none.
FigureGroup study_figures(const ReportEntry& entry, std::size_t index,
                          std::span<const Series> series, bool is_one_of_many) {
  FigureGroup group{
      "Magnification, adhesion, flow, conductance and friction", "", {}};
  if (is_one_of_many) {
    group.heading += ": " + entry.summary.case_name;
    group.folder = folder_name(index, entry.summary.case_name);
  }
  add(group.figures, "adhesion-loop",
      [&] { return adhesion_loop_figure(entry); });
  for (const StudyPages* const study : study_pages())
    if (study->figures != nullptr)
      add(group.figures, study->name.c_str(),
          [&] { return study->figures(entry, index, series); });
  return group;
}

} // namespace

std::vector<FigureGroup> figures_of(std::span<const ReportEntry> entries) {
  const std::vector<Series> series = series_of(entries);
  const bool has_many = entries.size() > 1;
  std::vector<FigureGroup> groups;
  groups.push_back(shared_curves(entries, series));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    groups.push_back(figures_of_one(entries[i], i, has_many));
    groups.push_back(study_figures(entries[i], i, series, has_many));
  }
  FigureGroup differences{"Differences of the pressures", "", {}};
  add(differences.figures, "pressure-difference",
      [&] { return difference_figures(entries); });
  groups.push_back(std::move(differences));
  FigureGroup cost{"Cost", "", {}};
  add(cost.figures, "cost",
      [&] { return cost_figure(series, figure_scales(entries)); });
  groups.push_back(std::move(cost));
  const FigureScales scales = figure_scales(entries);
  for (FigureGroup& group : groups) {
    leave_out_empty_panels(group.figures);
    for (Figure& figure : group.figures)
      put_units(figure, scales);
  }
  std::erase_if(groups,
                [](const FigureGroup& group) { return group.figures.empty(); });
  return groups;
}

} // namespace asperity::reports
