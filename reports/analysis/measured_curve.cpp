#include "reports/analysis/measured_curve.hpp"

#include "base/plain_text.hpp"
#include "cases/types/units.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/nearest.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

namespace asperity::reports {
namespace {

using cases::Dimension;
using results::CurvePoint;

constexpr const char* allowed_columns =
    "pressure [Pa, kPa, MPa or GPa] or load [N]; area [1, %, m^2, mm^2, um^2 "
    "or "
    "nm^2]; gap [m, mm, um or nm]";

/// A column: where its numbers go, and by what they are multiplied.
struct MeasuredColumn {
  double CurvePoint::*number;
  double factor; // to SI, or to a share of the nominal area
};

/// The SI value of one of this unit; nothing if it has another dimension.
std::optional<double> unit_in_si(const std::string& unit, Dimension dimension) {
  const auto read = cases::read_quantity("1 " + unit, dimension, {});
  return read.quantity ? std::optional(read.quantity->value) : std::nullopt;
}

std::optional<double> area_factor(const std::string& unit,
                                  double nominal_area) {
  if (unit == "1" || unit == "%")
    return unit == "1" ? 1.0 : 0.01;
  if (!unit.ends_with("^2"))
    return std::nullopt;
  const auto length =
      unit_in_si(unit.substr(0, unit.size() - 2), Dimension::length);
  return length ? std::optional(*length * *length / nominal_area)
                : std::nullopt;
}

/// @param place  of the header, "mine.csv:1"
MeasuredColumn measured_column(const std::string& head,
                               const std::string& place, double nominal_area) {
  const std::size_t open = head.find('[');
  const std::size_t close = head.find(']');
  const std::string name = trimmed(head.substr(0, open));
  const std::vector<std::string> names{"pressure", "load", "area", "gap"};
  if (std::ranges::find(names, name) == names.end())
    throw input::InputError(fmt::format(
        "{}: the column \"{}\" is unknown; allowed: {}; nearest: {}", place,
        printable(head), allowed_columns, input::nearest(name, names)));
  const std::string unit =
      open == head.npos || close == head.npos || close < open
          ? ""
          : trimmed(head.substr(open + 1, close - open - 1));
  const std::optional<double> factor =
      name == "pressure" ? unit_in_si(unit, Dimension::pressure)
      : name == "gap"    ? unit_in_si(unit, Dimension::length)
      : name == "area"   ? area_factor(unit, nominal_area)
                         : unit_in_si(unit, Dimension::force);
  if (!factor)
    throw input::InputError(
        fmt::format("{}: the column \"{}\" has no known unit; allowed: {}",
                    place, printable(head), allowed_columns));
  if (name == "gap")
    return {&CurvePoint::mean_gap, *factor};
  if (name == "area")
    return {&CurvePoint::area_fraction, *factor};
  return {&CurvePoint::nominal_pressure,
          name == "load" ? *factor / nominal_area : *factor};
}

std::vector<MeasuredColumn> measured_columns(const std::string& header,
                                             const std::string& place,
                                             double nominal_area) {
  const char separator = header.find(',') != header.npos   ? ','
                         : header.find(';') != header.npos ? ';'
                                                           : '\t';
  std::vector<MeasuredColumn> columns;
  std::istringstream heads(header);
  for (std::string head; std::getline(heads, head, separator);) {
    columns.push_back(measured_column(trimmed(head), place, nominal_area));
    if (std::ranges::count(columns, columns.back().number,
                           &MeasuredColumn::number) > 1)
      throw input::InputError(fmt::format(
          "{}: the column \"{}\" is there twice", place, printable(head)));
  }
  const auto has = [&](double CurvePoint::*number) {
    return std::ranges::find(columns, number, &MeasuredColumn::number) !=
           columns.end();
  };
  if (!has(&CurvePoint::nominal_pressure) ||
      !(has(&CurvePoint::mean_gap) || has(&CurvePoint::area_fraction)))
    throw input::InputError(
        fmt::format("{}: \"{}\" must name a pressure and an area or a gap: {}",
                    place, printable(header), allowed_columns));
  return columns;
}

std::vector<CurvePoint>
rows_of_table(const surfaces::NumberTable& table,
              const std::vector<MeasuredColumn>& columns,
              const std::string& file) {
  std::vector<CurvePoint> rows;
  rows.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.columns != columns.size())
      surfaces::refuse_line(
          file, table.lines[i],
          fmt::format("has {} numbers, but the first line names {} columns",
                      table.columns, columns.size()));
    CurvePoint row;
    row.step = static_cast<int>(i);
    row.mean_gap = row.area_fraction = results::not_given;
    row.contact_perimeter = row.elastic_energy = row.contact_energy =
        row.contact_stiffness = row.residual = row.cpu_time =
            results::not_given;
    for (std::size_t c = 0; c < columns.size(); ++c)
      row.*columns[c].number = table.number(i, c) * columns[c].factor;
    row.area_fraction_corrected = row.area_fraction;
    if (!(row.nominal_pressure > 0.0) || row.area_fraction < 0.0 ||
        row.area_fraction > 1.0)
      surfaces::refuse_line(file, table.lines[i],
                            "must have a pressure > 0 and an area from 0 to "
                            "the nominal area");
    rows.push_back(row);
  }
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
  std::string header = text.substr(0, text.find_first_of("\r\n"));
  if (header.starts_with('#'))
    header.erase(0, 1);
  const std::vector<MeasuredColumn> columns =
      measured_columns(header, file.string() + ":1", nominal_area(beside));
  results::MethodRecord method;
  method.name = file.stem().string();
  method.kind = measured_kind;
  method.description = "curve read from " + file.filename().string();
  method.realizations.emplace_back();
  method.realizations.front().points =
      rows_of_table(surfaces::read_number_text("#" + text, file.string()),
                    columns, file.string());
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
