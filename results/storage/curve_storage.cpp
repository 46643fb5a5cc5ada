#include "results/storage/curve_storage.hpp"

#include "input/input_error.hpp"
#include "results/observables/contact_stiffness.hpp"
#include "results/storage/result_layout.hpp"
#include "results/types/curve_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::results {
namespace {

constexpr const char* note = "note";
constexpr const char* step = "step";
constexpr const char* stiffness = "contact_stiffness";
constexpr const char* length_column = "nominal_pressure";

bool is_integer_of(const CurveColumn& column, double number) {
  return number <= std::numeric_limits<int>::max() &&
         column.range.holds(number) && number == std::floor(number);
}

void read_column(const Hdf5Group& curve, const CurveColumn& column,
                 std::vector<CurvePoint>& points) {
  const std::string name(column.name);
  const std::vector<double> numbers = curve.column(name);
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Values of type double are validated once the whole row is known
    // (validity.hpp). A value that is not an integer, or not the number of a
    // status, must be rejected here, because the conversion would lose it.
    if (column.is_integer && !is_integer_of(column, numbers[i]))
      throw input::InputError(fmt::format(
          "{}[{}] = {}, but must be an integer "
          "{}",
          curve.place(name), i, numbers[i],
          column.range.highest == 1.0 ? "between 0 and 1" : ">= 0"));
    column.set(points[i], numbers[i]);
  }
}

/// Compares the lengths of all columns.
/// @return  the number of rows
std::size_t length_of(const Hdf5Group& curve) {
  std::vector<std::string> names{length_column};
  for (const CurveColumn& column : curve_columns())
    if (std::string name(column.name); curve.has(name) && name != names.front())
      names.push_back(std::move(name));
  if (curve.has(note))
    names.emplace_back(note);
  const std::size_t length = curve.common_length(names);
  if (length > layout::highest_index)
    throw input::InputError(
        fmt::format("{} has {} values, but must have at most {}",
                    curve.place(length_column), length, layout::highest_index));
  return length;
}

/// Returns a row with the default values of missing columns.
CurvePoint blank_point(int number) {
  CurvePoint point;
  for (const CurveColumn& column : curve_columns())
    column.set(point, column.blank());
  point.step = number;
  return point;
}

} // namespace

void append_points(Hdf5Group& curve, std::span<const CurvePoint> points) {
  const std::size_t length =
      curve.has(length_column) ? curve.extents(length_column).front() : 0;
  for (const CurveColumn& column : curve_columns()) {
    std::vector<double> numbers;
    numbers.reserve(points.size());
    if (!curve.has(std::string(column.name))) // the column is newer than the
                                              // file
      numbers.assign(length, column.get(blank_point(0)));
    for (const CurvePoint& point : points)
      numbers.push_back(column.get(point));
    curve.append(std::string(column.name), numbers,
                 column.is_integer ? Hdf5Number::int32 : Hdf5Number::float64,
                 std::string(column.unit));
  }
  std::vector<std::string> notes;
  for (const CurvePoint& point : points)
    notes.push_back(point.note);
  curve.append(note, notes);
}

std::vector<CurvePoint> read_points(const Hdf5Group& curve) {
  for (const char* needed : {length_column, "mean_gap"})
    if (!curve.has(needed))
      throw input::InputError(
          fmt::format("{} is missing", curve.place(needed)));

  std::vector<CurvePoint> points;
  const std::size_t length = length_of(curve);
  for (std::size_t i = 0; i < length; ++i)
    points.push_back(blank_point(static_cast<int>(i)));
  for (const CurveColumn& column : curve_columns())
    if (curve.has(std::string(column.name)))
      read_column(curve, column, points);
  if (curve.has(note)) {
    const std::vector<std::string> notes = curve.texts(note);
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i].note = notes[i];
  }
  std::stable_sort(
      points.begin(), points.end(),
      [](const CurvePoint& a, const CurvePoint& b) { return a.step < b.step; });
  return points;
}

void complete_rows(Hdf5Group& curve) {
  const std::vector<double> stored = curve.numbers(step);
  std::vector<CurvePoint> points = read_points(curve);
  fill_contact_stiffness(points);
  if (std::ranges::is_sorted(stored)) {
    std::vector<double> numbers;
    numbers.reserve(points.size());
    for (const CurvePoint& point : points)
      numbers.push_back(point.contact_stiffness);
    curve.overwrite(stiffness, numbers);
    return;
  }
  for (const std::string& column : curve.children())
    curve.remove(column);
  append_points(curve, points);
}

} // namespace asperity::results
