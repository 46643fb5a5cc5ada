#include "reports/figures/shown_panels.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
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

} // namespace

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

} // namespace asperity::reports
