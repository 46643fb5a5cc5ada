#include "reports/analysis/measured_curve.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/nearest.hpp"
#include "input/units.hpp"
#include "reports/analysis/surface_theory.hpp"
#include "results/types/method_columns.hpp"
#include "surfaces/formats/text/column_heads.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace asperity::reports {
namespace {

using input::Dimension;
using results::CurvePoint;

constexpr const char* column_names[] = {"pressure", "load", "area", "gap"};

std::string allowed_columns() {
  const auto units = [](Dimension dimension) {
    return fmt::format("{}", fmt::join(input::usual_units(dimension), ", "));
  };
  return fmt::format("pressure [{}] or load [{}]; area [{}, {}]; gap [{}]",
                     units(Dimension::pressure), units(Dimension::force),
                     units(Dimension::none), units(Dimension::area),
                     units(Dimension::length));
}

/// A column: where its numbers go, and by what they are multiplied.
struct MeasuredColumn {
  const results::CurveColumn* number; ///< null: a column without a head
  double factor; // to SI, or to a share of the nominal area
};

/// What one of the unit of a head is in the numbers of a row; nothing if the
/// unit is not one of the column.
std::optional<double> factor_of(const surfaces::ColumnHead& head,
                                double nominal_area) {
  const auto in_si = [&](Dimension dimension) {
    return input::unit_in_si(head.unit, dimension);
  };
  if (head.name == "pressure")
    return in_si(Dimension::pressure);
  if (head.name == "gap")
    return in_si(Dimension::length);
  const bool is_load = head.name == "load";
  if (const auto share = in_si(Dimension::none); share && !is_load)
    return share;
  const auto whole = in_si(is_load ? Dimension::force : Dimension::area);
  return whole ? std::optional(*whole / nominal_area) : std::nullopt;
}

Dimension dimension_of(const surfaces::ColumnHead& head) {
  return head.name == "pressure" ? Dimension::pressure
         : head.name == "load"   ? Dimension::force
         : head.name == "area"   ? Dimension::area
                                 : Dimension::length;
}

/// @param place  of the header, "mine.csv:1"
MeasuredColumn measured_column(const surfaces::ColumnHead& head,
                               const std::string& place, double nominal_area) {
  if (head.name.empty() && head.unit.empty()) // as the index of pandas
    return {nullptr, 1.0};
  if (std::ranges::find(column_names, head.name) == std::end(column_names))
    throw input::InputError(fmt::format(
        "{}: the column \"{}\" is unknown; allowed: {}; nearest: {}", place,
        printable(head.name), allowed_columns(),
        input::nearest(head.name,
                       {std::begin(column_names), std::end(column_names)})));
  const std::optional<double> factor = factor_of(head, nominal_area);
  if (!factor)
    throw input::InputError(
        head.unit.empty()
            ? fmt::format("{}: the column \"{}\" has no unit; allowed: {}",
                          place, printable(head.name), allowed_columns())
            : fmt::format(
                  "{}: the column \"{}\" {}", place, printable(head.name),
                  input::unit_mistake(head.unit, dimension_of(head),
                                      input::usual_units(dimension_of(head)))));
  return {head.name == "gap"    ? &columns::mean_gap
          : head.name == "area" ? &columns::area_fraction
                                : &columns::nominal_pressure,
          *factor};
}

/// The last line above the numbers that has the head of a known column, else
/// the last one.
surfaces::CommentLine line_of_heads(const surfaces::NumberTable& table) {
  const std::vector<surfaces::CommentLine> lines =
      surfaces::lines_above_numbers(table);
  for (const surfaces::CommentLine& line : lines)
    for (const surfaces::ColumnHead& head :
         surfaces::column_heads(line.text, table.columns))
      if (std::ranges::find(column_names, head.name) != std::end(column_names))
        return line;
  return lines.empty() ? surfaces::CommentLine{table.lines.front(), ""}
                       : lines.front();
}

std::vector<MeasuredColumn> measured_columns(const surfaces::NumberTable& table,
                                             double nominal_area) {
  const surfaces::CommentLine line = line_of_heads(table);
  const std::string place = fmt::format("{}:{}", table.name, line.line);
  std::vector<MeasuredColumn> columns;
  for (const surfaces::ColumnHead& head :
       surfaces::column_heads(line.text, table.columns)) {
    columns.push_back(measured_column(head, place, nominal_area));
    if (columns.back().number != nullptr &&
        std::ranges::count(columns, columns.back().number,
                           &MeasuredColumn::number) > 1)
      throw input::InputError(fmt::format(
          "{}: the column \"{}\" is there twice", place, printable(head.name)));
  }
  const auto has = [&](const results::CurveColumn* number) {
    return std::ranges::find(columns, number, &MeasuredColumn::number) !=
           columns.end();
  };
  if (!has(&columns::nominal_pressure) ||
      !(has(&columns::mean_gap) || has(&columns::area_fraction)))
    throw input::InputError(
        fmt::format("{}: \"{}\" must name a pressure and an area or a gap: {}",
                    place, printable(line.text), allowed_columns()));
  if (table.columns != columns.size())
    surfaces::refuse_line(
        table.name, table.lines.front(),
        fmt::format("has {} numbers, but line {} names {} columns; if 1,5 is "
                    "one number, separate the columns by semicolons",
                    table.columns, line.line, columns.size()));
  return columns;
}

/// Whether the surfaces of a result attract each other, so that it has
/// tensions.
bool has_attraction(const results::Result& result) {
  for (const results::MethodRecord& method : result.methods)
    for (const CurvePoint& point : method.rows())
      if (point.nominal_pressure < 0.0 ||
          std::isfinite(point[columns::adhesive_energy]))
        return true;
  return false;
}

/// @return  a row without a number, which only its step is known of
CurvePoint empty_point(int step) {
  CurvePoint row;
  row.step = step;
  row.nominal_pressure = row.mean_gap = row.area_fraction = results::not_given;
  row.contact_perimeter = row.elastic_energy = row.contact_energy =
      row.contact_stiffness = row.residual = row.cpu_time = results::not_given;
  return row;
}

/// @param row           of the table
/// @param may_be_tension  whether the pressure may be 0 or less
void require_sound_point(const CurvePoint& point,
                         const surfaces::NumberTable& table, std::size_t row,
                         bool may_be_tension) {
  for (const double number :
       {point.nominal_pressure, point.mean_gap, point.area_fraction})
    if (std::isinf(number))
      surfaces::refuse_line(table.name, table.lines[row],
                            "has a number that is infinite in SI units");
  if (std::isnan(point.nominal_pressure) ||
      (!may_be_tension && !(point.nominal_pressure > 0.0)))
    surfaces::refuse_line(
        table.name, table.lines[row],
        may_be_tension ? "must have a pressure"
                       : "must have a pressure > 0: the result beside it has "
                         "no adhesion, so that there is no tension");
  if (point.area_fraction < 0.0 || point.area_fraction > 1.0)
    surfaces::refuse_line(table.name, table.lines[row],
                          "must have an area from 0 to the nominal area");
}

std::vector<CurvePoint>
rows_of_table(const surfaces::NumberTable& table,
              const std::vector<MeasuredColumn>& columns, bool may_be_tension) {
  std::vector<CurvePoint> rows;
  rows.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    CurvePoint row = empty_point(static_cast<int>(rows.size()));
    bool is_empty = true;
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c].number != nullptr) {
        row[*columns[c].number] = table.number(i, c) * columns[c].factor;
        is_empty = is_empty && std::isnan(table.number(i, c));
      }
    if (is_empty) // below the table of a spreadsheet
      continue;
    row.area_fraction_corrected = row.area_fraction;
    require_sound_point(row, table, i, may_be_tension);
    rows.push_back(row);
  }
  if (rows.empty())
    throw input::InputError(table.name + ": contains no numbers");
  return rows;
}

} // namespace

double nominal_area(const results::Result& result) {
  return result.surfaces.front().map_grid().area();
}

results::Result read_measured_curve(const std::filesystem::path& file,
                                    const results::Result& beside) {
  if (beside.surfaces.empty())
    throw input::InputError(
        fmt::format("{}: is to be compared with {}, which has no surface",
                    file.string(), beside.path));
  const Grid& grid = beside.surfaces.front().grid;
  const std::string text =
      input::read_input_file(file, input::largest_text_file);
  const surfaces::NumberTable table = surfaces::read_number_text(
      text, file.string(), surfaces::NumberStyle::instrument);
  results::MethodRecord method;
  method.name = file.stem().string();
  method.kind = measured_kind;
  method.description = "curve read from " + file.filename().string();
  method.realizations.emplace_back();
  method.realizations.front().points =
      rows_of_table(table, measured_columns(table, nominal_area(beside)),
                    has_attraction(beside));
  // Of its heights only the gamma of the curve is asked.
  if (!has_spectrum_of_images(beside.surfaces.front()))
    method.realizations.front().own_surface = beside.surfaces.front();
  results::Result result;
  result.path = file.string();
  result.case_name = method.name;
  result.case_title = method.description;
  result.status = "complete";
  result.contact_modulus = beside.contact_modulus;
  results::SurfaceRecord surface;
  surface.grid = grid;
  surface.rms_height = beside.surfaces.front().rms_height;
  surface.rms_slope = beside.surfaces.front().rms_slope;
  surface.skewness = surface.kurtosis = results::not_given;
  result.surfaces.push_back(std::move(surface));
  result.methods.push_back(std::move(method));
  return result;
}

} // namespace asperity::reports
