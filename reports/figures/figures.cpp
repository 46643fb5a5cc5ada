#include "reports/figures/figures.hpp"

#include "reports/analysis/warnings.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/study_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

// Adds the figures that `build` returns. If it throws, a placeholder figure
// that states the reason is added instead, so that the report continues.
template <class Build>
void add(std::vector<Figure>& figures, std::string name, const Build& build) {
  try {
    std::ranges::move(build(), std::back_inserter(figures));
  } catch (const std::bad_alloc&) {
    throw; // a system error, not a property of the data
  } catch (const std::exception& error) {
    if (name.ends_with('-'))
      name.pop_back();
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
    for (const results::CurvePoint& row : method.rows())
      if (row.status == results::StepStatus::converged &&
          row.nominal_pressure < 0.0)
        return true;
  return false;
}

/// True if steps converged and none is pressed: a warning says so, or the
/// figure of the path with adhesion shows it.
bool is_never_pressed(std::span<const ReportEntry> entries,
                      std::span<const Series> series) {
  return std::ranges::all_of(series,
                             [](const Series& one) {
                               return one.rows.empty() || one.is_theory();
                             }) &&
         std::ranges::any_of(entries, [](const ReportEntry& entry) {
           return has_tension(*entry.result) ||
                  std::ranges::any_of(
                      warnings_of(*entry.result, *entry.contact_case),
                      [](const Warning& one) {
                        return one.kind == "no_contact";
                      });
         });
}

/// Returns the figures of a part of the page that the list has.
FigureGroup group_of(FigureSection section, const char* heading,
                     const FigureData& data) {
  FigureGroup group{heading, "", {}};
  for (const ReportFigure* const figure : report_figures())
    if (figure->section == section &&
        (figure->applies == nullptr || figure->applies(data)))
      add(group.figures, figure->names[0], [&] { return figure->draw(data); });
  return group;
}

/// Adds the two parts of the page of one result.
void add_groups_of_one(std::vector<FigureGroup>& groups, const FigureData& all,
                       std::size_t index) {
  const ReportEntry& entry = all.entries[index];
  const FigureData data{{&entry, 1}, all.series, all.scales};
  FigureGroup contact =
      group_of(FigureSection::contact, "Surface and contact", data);
  FigureGroup studies = group_of(FigureSection::studies, "", data);
  std::vector<std::string> names;
  if (!studies.figures.empty())
    names.emplace_back("adhesion");
  for (const StudyPages* const study : study_pages()) {
    const std::size_t before = studies.figures.size();
    if (study->figures != nullptr)
      add(studies.figures, study->name, [&] { return study->figures(data); });
    if (studies.figures.size() > before &&
        std::ranges::find(names, study->name) == names.end())
      names.push_back(study->name);
  }
  studies.heading = fmt::format("Studies: {}", fmt::join(names, ", "));
  for (FigureGroup* const group : {&contact, &studies}) {
    if (all.entries.size() > 1) {
      group->heading += ": " + entry.summary.case_name;
      group->folder = folder_name(index, entry.summary.case_name);
    }
    groups.push_back(std::move(*group));
  }
}

} // namespace

bool has_rough_contact(const FigureData& data) {
  return std::ranges::any_of(data.entries,
                             [](const ReportEntry& entry) {
                               return !is_exact_shape(*entry.contact_case);
                             }) &&
         !is_never_pressed(data.entries, data.series);
}

bool is_exact(const FigureData& data) {
  return is_exact_shape(*data.entries.front().contact_case);
}

bool is_rough(const FigureData& data) {
  return !is_exact(data);
}

std::vector<FigureGroup> figures_of(std::span<const ReportEntry> entries) {
  const std::vector<Series> series = series_of(entries);
  const FigureData data{entries, series, figure_scales(entries)};
  std::vector<FigureGroup> groups;
  groups.push_back(group_of(FigureSection::curves, "The curves", data));
  for (std::size_t i = 0; i < entries.size(); ++i)
    add_groups_of_one(groups, data, i);
  groups.push_back(group_of(FigureSection::differences,
                            "Differences of the pressures", data));
  groups.push_back(group_of(FigureSection::cost, "Cost", data));
  for (FigureGroup& group : groups) {
    leave_out_empty_panels(group.figures);
    for (Figure& figure : group.figures)
      put_units(figure, data.scales);
  }
  std::erase_if(groups,
                [](const FigureGroup& group) { return group.figures.empty(); });
  return groups;
}

} // namespace asperity::reports
