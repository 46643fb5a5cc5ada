#include "results/validity.hpp"

#include "input/input_error.hpp"
#include "results/observables/height_numbers.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::results {
namespace {

constexpr std::size_t most_lines = 10;

/// Relative error of a number that follows from a map. It admits maps that
/// another program has stored in single precision.
constexpr double single_precision = 1e-4;
/// A map in single precision has 0 for what is smaller: the tension of faces
/// far apart.
constexpr double smallest_in_a_map = std::numeric_limits<float>::min();

/// Of the terms of a gap in full contact, which is a difference of heights and
/// displacements, relative to the rms height.
constexpr double rounding_of_a_gap = 1e-13;
constexpr ColumnRange finite{std::numeric_limits<double>::lowest(),
                             std::numeric_limits<double>::max()};

/// Collects the errors of one file.
class Findings {
public:
  explicit Findings(std::string file) : file_(std::move(file)) {}

  void add(const std::string& place, const std::string& what) {
    if (++count_ <= most_lines)
      lines_.push_back(fmt::format("{}: {}{}", file_, place, what));
  }

  /// Adds an invalid number with its range and unit.
  void add(const std::string& place, double number, const ColumnRange& range,
           std::string_view unit) {
    add(place, fmt::format(" = {}, but {} [{}]", number, range.text(), unit));
  }

  std::size_t count() const { return count_; }

  void throw_if_any() const {
    if (count_ == 0)
      return;
    std::string text = fmt::format("{}", fmt::join(lines_, "\n"));
    if (count_ > most_lines)
      text += fmt::format("\n{}: and {} more", file_, count_ - most_lines);
    throw input::InputError(text);
  }

private:
  std::string file_;
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

/// Checks a number, which is NaN if it is missing or not determined.
void check_number(const std::string& place, double number,
                  const ColumnRange& range, std::string_view unit,
                  Findings& findings) {
  if (!std::isnan(number) && !range.holds(number))
    findings.add(place, number, range, unit);
}

/// Reports the first value of a map that is not finite, and the number of such
/// values.
void check_map(const std::string& place, const MapView& map, const Grid& grid,
               std::string_view unit, Findings& findings) {
  std::size_t bad = 0;
  std::size_t first = 0;
  double first_value = 0.0;
  each_piece(std::array{map}, [&](std::size_t begin, const auto& values) {
    for (std::size_t i = 0; i < values[0].size(); ++i)
      if (!std::isfinite(values[0][i]) && bad++ == 0) {
        first = begin + i;
        first_value = values[0][i];
      }
  });
  if (bad == 0)
    return;
  const auto columns =
      static_cast<std::size_t>(std::max(1, grid.points_x)); // 0 if unknown
  findings.add(
      fmt::format("{}[{}, {}]", place, first / columns, first % columns),
      fmt::format(" = {}, but must be finite [{}]; {} of {} values are "
                  "not",
                  first_value, unit, bad, map.size()));
}

void check_point(const std::string& curve, const CurvePoint& point,
                 Findings& findings) {
  const bool has_converged = point.status == StepStatus::converged;
  for (const CurveColumn& column : curve_columns()) {
    const double number = column.get(point);
    const bool is_undetermined = std::isnan(number) && !column.range.is_needed;
    const bool has_diverged = !has_converged && !std::isfinite(number);
    if (!column.range.holds(number) && !is_undetermined && !has_diverged)
      findings.add(
          fmt::format("{}/{}, step {}", curve, column.name, point.step), number,
          column.range, column.unit);
  }
}

/// A number that a result states.
struct Stated {
  std::string place;
  double number = 0.0;
  std::string_view unit;
};

/// Adds a stated number that is not the one that follows from the maps.
void check_follows(const Stated& stated, const NumberBounds& bounds,
                   double tolerance, const char* source, Findings& findings) {
  if (std::isnan(stated.number) || (stated.number >= bounds.low - tolerance &&
                                    stated.number <= bounds.high + tolerance))
    return;
  findings.add(stated.place,
               fmt::format(" = {}, but {} {:.9g}{} [{}]", stated.number, source,
                           bounds.low,
                           bounds.low < bounds.high
                               ? fmt::format(" to {:.9g}", bounds.high)
                               : "",
                           stated.unit));
}

/// Checks what follows from saved heights.
/// The record of a map with free edges has the slope of its mirror images.
void check_height_numbers(const std::string& place,
                          const SurfaceRecord& surface, Findings& findings) {
  if (!surface.has_heights() || !(surface.grid.length_x > 0.0) ||
      !(surface.grid.length_y > 0.0))
    return;
  HeightNumbers found = height_numbers(surface);
  if (surface.rms_slope < (1.0 - single_precision) * found.rms_slope.low)
    found = height_numbers(surface, Continuation::mirrored);
  const auto check = [&](const char* name, double stated, NumberBounds bounds,
                         double size, const char* unit) {
    if (!std::isnan(bounds.low))
      check_follows({place + "/" + name, stated, unit}, bounds,
                    single_precision * size, "the heights have", findings);
  };
  const auto same = [](double number) { return NumberBounds{number, number}; };
  check("rms_height", surface.rms_height, same(found.rms_height),
        found.rms_height + found.roundoff, "m");
  if (!(found.rms_height > found.roundoff))
    return; // flat: nothing else is defined
  check("rms_slope", surface.rms_slope, found.rms_slope, found.rms_slope.high,
        "1");
  check("rms_curvature", surface.rms_curvature, same(found.rms_curvature),
        found.rms_curvature, "1/m");
  check("skewness", surface.skewness, same(found.skewness), found.kurtosis,
        "1");
  check("kurtosis", surface.kurtosis, same(found.kurtosis), found.kurtosis,
        "1");
  check("highest", surface.highest, same(found.highest), found.largest, "m");
}

/// Mean, and mean size, of a map.
struct MapMeans {
  double value = 0.0, size = 0.0;
};

MapMeans means_of(const MapView& map) {
  MapMeans sums;
  each_piece(std::array{map}, [&](std::size_t, const auto& values) {
    for (const double value : values[0]) {
      sums.value += value;
      sums.size += std::abs(value);
    }
  });
  const auto count = static_cast<double>(map.size());
  return {sums.value / count, sums.size / count};
}

/// Checks what a row and the attributes of a step state against its maps. Nodes
/// of a half-space have equal weights, so that their means are those of the
/// row; other methods have no rms_height here.
/// @param rms_height  of the surface, to whose roundoff a gap is known [m]
void check_step(const std::string& place, std::optional<double> rms_height,
                const Fields& fields, const CurvePoint& point,
                Findings& findings) {
  const std::string maps = fmt::format("{}/fields/{}", place, fields.step);
  const auto check = [&](const std::string& name, double stated, double found,
                         double size, const char* unit, const char* source) {
    if (std::isfinite(found))
      check_follows({name, stated, unit}, {found, found},
                    single_precision * size + smallest_in_a_map, source,
                    findings);
  };
  check(maps + "/nominal_pressure", fields.nominal_pressure,
        point.nominal_pressure, std::abs(point.nominal_pressure), "Pa",
        "the row of this step has");
  if (!rms_height || point.status != StepStatus::converged)
    return;
  const MapMeans pressure = means_of(fields.pressure_map());
  const MapMeans gap = means_of(fields.gap_map());
  const std::string row = fmt::format(", step {}", fields.step);
  check(place + "/curve/nominal_pressure" + row, point.nominal_pressure,
        pressure.value, 10.0 * pressure.size, "Pa", "its pressure map has");
  // An imprint is not in the map. Its mean depth is plastic_work/H, with H not
  // below p_0: equal to it where the whole surface yields, whose gap is 0.
  const bool is_imprinted = std::isfinite(point[columns::plastic_area]) &&
                            point[columns::plastic_work] > 0.0;
  const double deepest =
      is_imprinted ? point[columns::plastic_work] / point.nominal_pressure
                   : 0.0;
  if (std::isfinite(gap.value))
    check_follows({place + "/curve/mean_gap" + row, point.mean_gap, "m"},
                  {gap.value - deepest, gap.value},
                  single_precision * (gap.size + deepest) +
                      rounding_of_a_gap * *rms_height,
                  "its gap map has", findings);
}

void check_curve(const std::string& place, std::optional<double> rms_height,
                 const Curve& curve, Findings& findings) {
  check_number(place + "/setup_cpu_time", curve.setup_cpu_time, not_negative,
               "s", findings);
  std::set<int> steps;
  for (const CurvePoint& point : curve.points) {
    if (!steps.insert(point.step).second)
      findings.add(place + "/curve/step",
                   fmt::format(": step {} occurs twice", point.step));
    check_point(place + "/curve", point, findings);
  }
  for (const Fields& fields : curve.fields) {
    const std::string maps = fmt::format("{}/fields/{}", place, fields.step);
    check_number(maps + "/nominal_pressure", fields.nominal_pressure, finite,
                 "Pa", findings);
    check_map(maps + "/pressure", fields.pressure_map(), fields.grid, "Pa",
              findings);
    check_map(maps + "/gap", fields.gap_map(), fields.grid, "m", findings);
    const MapMeans load = means_of(fields.pressure_map());
    if (fields.nominal_pressure <= 0.0 &&
        load.value > 10.0 * single_precision * load.size)
      findings.add(maps + "/nominal_pressure",
                   fmt::format(" = {}, but its pressure map has {:.9g} [Pa]",
                               fields.nominal_pressure, load.value));
    const auto row =
        std::ranges::find(curve.points, fields.step, &CurvePoint::step);
    if (row != curve.points.end())
      check_step(place, rms_height, fields, *row, findings);
  }
}

void check_surface(const std::string& place, const SurfaceRecord& surface,
                   Findings& findings) {
  const std::size_t before = findings.count();
  const auto check = [&](const char* name, double number,
                         const ColumnRange& range, const char* unit) {
    check_number(place + "/" + name, number, range, unit, findings);
  };
  check("length_x", surface.grid.length_x, not_negative, "m");
  check("length_y", surface.grid.length_y, not_negative, "m");
  check("rms_height", surface.rms_height, not_negative, "m");
  check("rms_slope", surface.rms_slope, not_negative, "1");
  check("rms_curvature", surface.rms_curvature, not_negative, "1/m");
  check("skewness", surface.skewness, finite, "1");
  check("kurtosis", surface.kurtosis, not_negative, "1");
  check("highest", surface.highest, finite, "m");
  check_map(place + "/heights", surface.height_map(), surface.grid, "m",
            findings);
  if (findings.count() == before)
    check_height_numbers(place, surface, findings);
  for (const SpectrumPoint& point : surface.spectrum) {
    check("spectrum/wavevector", point.wavevector, not_negative, "rad/m");
    check("spectrum/height_spectrum", point.spectrum, not_negative, "m^4");
  }
}

/// Checks a table. Its values may be infinite, e.g. where a gap never opens.
void check_table(const Table& table, Findings& findings) {
  for (const Column& column : table.columns)
    if (const CurveColumn* known = find_curve_column(column.name))
      for (std::size_t row = 0; row < column.values.size(); ++row)
        if (std::isfinite(column.values[row]))
          check_number(
              fmt::format("/tables/{}/{}[{}]", table.name, column.name, row),
              column.values[row], known->range, column.unit, findings);
}

} // namespace

void require_valid(const Result& result) {
  Findings findings(result.path);
  if (!(result.contact_modulus > 0.0 && std::isfinite(result.contact_modulus)))
    findings.add("/contact_modulus",
                 fmt::format(" = {}, but must be finite and > 0 [Pa]",
                             result.contact_modulus));
  for (std::size_t r = 0; r < result.surfaces.size(); ++r)
    check_surface(fmt::format("/surfaces/{}", r), result.surfaces[r], findings);
  for (const MethodRecord& method : result.methods)
    for (std::size_t r = 0; r < method.realizations.size(); ++r) {
      const std::string place = fmt::format("/methods/{}/{}", method.name, r);
      const bool has_equal_weights =
          method.kind == "halfspace" || method.kind == "submission";
      const double height =
          r < result.surfaces.size() ? result.surfaces[r].rms_height : 0.0;
      check_curve(place,
                  has_equal_weights
                      ? std::optional(std::isfinite(height) ? height : 0.0)
                      : std::nullopt,
                  method.realizations[r], findings);
      if (method.realizations[r].own_surface)
        check_surface(place + "/surface", *method.realizations[r].own_surface,
                      findings);
    }
  for (const Table& table : result.tables)
    check_table(table, findings);
  findings.throw_if_any();
}

} // namespace asperity::results
