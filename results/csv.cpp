#include "results/csv.hpp"

#include "results/types/curve_columns.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace asperity::results {
namespace {

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos)
    return field;
  std::string text = "\"";
  for (const char letter : field)
    text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return text + '"';
}

/// Whether a row of the result has a number in a column.
bool has_number(const Result& result, const CurveColumn& column) {
  for (const MethodRecord& method : result.methods)
    for (const CurvePoint& point : method.rows())
      if (std::isfinite(column.get(point)))
        return true;
  return false;
}

/// The columns of curves.csv: those of every method, and of the others the
/// answers that some row has. A status is a word.
std::vector<const CurveColumn*> shown_columns(const Result& result) {
  std::vector<const CurveColumn*> shown;
  for (const CurveColumn& column : curve_columns())
    if (column.use != ColumnUse::cost && &column != &columns::status &&
        (column.owner().empty() || !column.is_integer) &&
        (column.owner().empty() || has_number(result, column)))
      shown.push_back(&column);
  return shown;
}

/// The CPU times after the number of the step.
std::vector<const CurveColumn*> time_columns() {
  std::vector<const CurveColumn*> times;
  for (const CurveColumn& column : curve_columns())
    if (column.use == ColumnUse::cost && column.unit == "s")
      times.push_back(&column);
  return times;
}

/// "mean_gap [m]"; a count or a residual has no unit.
std::string heading(const CurveColumn& column) {
  const bool is_bare = column.unit == "1" &&
                       (column.is_integer || column.use == ColumnUse::solution);
  return is_bare ? std::string(column.name)
                 : fmt::format("{} [{}]", column.name, column.unit);
}

} // namespace

std::string curves_csv(const Result& result) {
  const std::vector<const CurveColumn*> shown = shown_columns(result);
  std::string text = "method,realization";
  for (const CurveColumn* const column : shown)
    text += "," + heading(*column);
  text += ",status\r\n";

  for (const MethodRecord& method : result.methods)
    for (std::size_t i = 0; i < method.realizations.size(); ++i)
      for (const CurvePoint& point : method.realizations[i].points) {
        text += fmt::format("{},{}", quoted(method.name), i);
        for (const CurveColumn* const column : shown)
          text += fmt::format(",{}", column->get(point));
        text += fmt::format(",{}\r\n", status_word(point.status));
      }
  return text;
}

std::string times_csv(const Result& result) {
  const std::vector<const CurveColumn*> times = time_columns();
  std::string text = "method,realization,step";
  for (const CurveColumn* const column : times)
    text += "," + heading(*column);
  text += "\r\n";
  for (const MethodRecord& method : result.methods)
    for (std::size_t i = 0; i < method.realizations.size(); ++i) {
      const Curve& curve = method.realizations[i];
      text += fmt::format("{},{},,{},nan,nan\r\n", quoted(method.name), i,
                          curve.setup_cpu_time);
      for (const CurvePoint& point : curve.points) {
        text += fmt::format("{},{},{}", quoted(method.name), i, point.step);
        for (const CurveColumn* const column : times)
          text += fmt::format(",{}", column->get(point));
        text += "\r\n";
      }
    }
  return text;
}

} // namespace asperity::results
