#include "run/difference.hpp"

#include "input/reader/resolved_keys.hpp"
#include "input/text/toml_text.hpp"
#include "results/types/curve_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

namespace asperity::run {
namespace {

using results::CurveColumn;
using results::CurvePoint;
using results::MethodRecord;
using results::Result;

/// Facts of the provenance that differ between two runs of one build.
const std::set<std::string> facts_of_a_run{
    "started",
    "finished",
    "wall time",
    "CPU time",
    "threads",
    "peak memory",
    "writing CPU time",
    "seed",
    "realizations",
    "steps computed",
    "steps from the cache",
    "steps computed again for what follows them",
    "window"};

/// Returns the values of the reference units that the text of the case states
/// and, on request, those of the surface of the result.
mechanics::Scales known_scales(const ComparedSide& side, bool uses_surface) {
  const cases::Case& contact_case = *side.contact_case;
  mechanics::Scales scales;
  scales.contact_modulus = contact_case.material.contact_modulus;
  scales.length = contact_case.surface.length.value_or(0.0);
  if (contact_case.surface.points)
    scales.spacing = scales.length / *contact_case.surface.points;
  if (!uses_surface || side.result->surfaces.empty())
    return scales;
  const results::SurfaceRecord& surface = side.result->surfaces.front();
  scales.length = surface.grid.length_x;
  scales.spacing = surface.grid.spacing_x();
  scales.rms_height = surface.rms_height;
  scales.rms_slope = surface.rms_slope;
  return scales;
}

using Texts = std::map<std::string, std::string>;

Texts keys_of(const ComparedSide& side, bool uses_surface) {
  Texts keys;
  if (side.contact_case)
    for (const cases::ResolvedKey& key : cases::resolved_keys(
             *side.contact_case, known_scales(side, uses_surface)))
      keys[key.path] = cases::toml_value(key.value) +
                       (key.unit.empty() ? "" : " " + key.unit);
  return keys;
}

Texts build_of(const ComparedSide& side) {
  Texts facts;
  if (side.result)
    for (const auto& [name, fact] : side.result->provenance)
      if (!facts_of_a_run.contains(name) &&
          (!name.starts_with("input ") || name == "input program"))
        facts[name] = fact;
  return facts;
}

std::vector<TextDifference> differences(const Texts& one, const Texts& other) {
  std::set<std::string> names;
  for (const Texts* texts : {&one, &other})
    for (const auto& [name, text] : *texts)
      names.insert(name);
  const auto text_in = [](const Texts& texts, const std::string& name) {
    const auto found = texts.find(name);
    return found == texts.end() ? std::string() : found->second;
  };
  std::vector<TextDifference> list;
  for (const std::string& name : names)
    if (text_in(one, name) != text_in(other, name))
      list.push_back({name, text_in(one, name), text_in(other, name)});
  return list;
}

/// @param least  the difference is relative to at least this number
double relative_difference(double one, double other, double least) {
  if (one == other || (std::isnan(one) && std::isnan(other)))
    return 0.0;
  const double difference =
      std::abs(one - other) / std::max({std::abs(one), std::abs(other), least});
  return std::isfinite(difference) ? difference
                                   : std::numeric_limits<double>::infinity();
}

/// Compares the curves and surfaces of two results.
class NumberComparison {
public:
  NumberComparison(const Result& one, const Result& other, double tolerance,
                   Difference& difference)
      : one_(one),
        other_(other),
        tolerance_(tolerance),
        difference_(difference) {}

  void compare() {
    compare_surfaces();
    for (const MethodRecord& method : one_.methods)
      if (const MethodRecord* same = other_.method(method.name))
        compare_method(method, *same);
      else
        difference_.missing.push_back({method.name, "present", ""});
    for (const MethodRecord& method : other_.methods)
      if (one_.method(method.name) == nullptr)
        difference_.missing.push_back({method.name, "", "present"});
  }

private:
  void note(MethodDifference& method, const NumberDifference& row) const {
    ++method.rows;
    if (row.relative > method.largest.relative)
      method.largest = row;
    if (row.relative > tolerance_) {
      ++method.rows_that_differ;
      method.rows_listed.push_back(row);
    }
  }

  void compare_surfaces() {
    MethodDifference surfaces{"surface"};
    const std::size_t n =
        std::min(one_.surfaces.size(), other_.surfaces.size());
    for (std::size_t r = 0; r < n; ++r) {
      const results::SurfaceRecord& a = one_.surfaces[r];
      const results::SurfaceRecord& b = other_.surfaces[r];
      NumberDifference row{"surface", static_cast<int>(r), 0, "", 0, 0, 0};
      const auto column = [&](const char* name, double mine, double theirs) {
        take_larger(row, name, mine, theirs, 0.0);
      };
      column("points_x", a.grid.points_x, b.grid.points_x);
      column("points_y", a.grid.points_y, b.grid.points_y);
      column("length_x", a.grid.length_x, b.grid.length_x);
      column("length_y", a.grid.length_y, b.grid.length_y);
      column("rms_height", a.rms_height, b.rms_height);
      column("rms_slope", a.rms_slope, b.rms_slope);
      column("rms_curvature", a.rms_curvature, b.rms_curvature);
      column("highest", a.highest, b.highest);
      note(surfaces, row);
    }
    if (one_.surfaces.size() != other_.surfaces.size())
      difference_.missing.push_back({"surfaces",
                                     std::to_string(one_.surfaces.size()),
                                     std::to_string(other_.surfaces.size())});
    if (n > 0)
      difference_.methods.push_back(std::move(surfaces));
  }

  static void take_larger(NumberDifference& row, std::string_view name,
                          double one, double other, double least) {
    const double relative = relative_difference(one, other, least);
    if (relative <= row.relative)
      return;
    row.column = std::string(name);
    row.one = one;
    row.other = other;
    row.relative = relative;
  }

  bool is_compared(const CurveColumn& column) const {
    return column.use == results::ColumnUse::answer ||
           (column.use == results::ColumnUse::solution && tolerance_ == 0.0);
  }

  /// Returns h_rms [m] of the first side, 0 if it is not known.
  double rms_height(std::size_t realization) const {
    const bool is_known = realization < one_.surfaces.size();
    const double height =
        is_known ? one_.surfaces[realization].rms_height : 0.0;
    return std::isfinite(height) ? height : 0.0;
  }

  void compare_method(const MethodRecord& one, const MethodRecord& other) {
    MethodDifference method{one.name};
    const std::size_t n =
        std::max(one.realizations.size(), other.realizations.size());
    for (std::size_t r = 0; r < n; ++r) {
      const auto rows_of = [r](const MethodRecord& record) {
        std::map<int, const CurvePoint*> rows;
        if (r < record.realizations.size())
          for (const CurvePoint& point : record.realizations[r].points)
            rows[point.step] = &point;
        return rows;
      };
      compare_rows(method, r, rows_of(one), rows_of(other));
    }
    difference_.methods.push_back(std::move(method));
  }

  void compare_rows(MethodDifference& method, std::size_t realization,
                    const std::map<int, const CurvePoint*>& one,
                    const std::map<int, const CurvePoint*>& other) {
    for (const auto& [step, row] : one)
      if (const auto same = other.find(step); same != other.end())
        note(method, compared(method.method, realization, *row, *same->second));
      else
        difference_.missing.push_back(
            {row_name(method.method, realization, step), "present", ""});
    for (const auto& [step, row] : other)
      if (!one.contains(step))
        difference_.missing.push_back(
            {row_name(method.method, realization, step), "", "present"});
  }

  static std::string row_name(const std::string& method,
                              std::size_t realization, int step) {
    return method + ", realization " + std::to_string(realization) + ", step " +
           std::to_string(step);
  }

  NumberDifference compared(const std::string& method, std::size_t realization,
                            const CurvePoint& one,
                            const CurvePoint& other) const {
    NumberDifference row{
        method, static_cast<int>(realization), one.step, "", 0.0, 0.0, 0.0};
    for (const CurveColumn& column : results::curve_columns())
      if (is_compared(column))
        take_larger(row, column.name, column.get(one), column.get(other),
                    column.name == "mean_gap" ? rms_height(realization) : 0.0);
    return row;
  }

  const Result& one_;
  const Result& other_;
  double tolerance_;
  Difference& difference_;
};

} // namespace

bool Difference::is_any() const {
  return !keys.empty() || !inputs.empty() || !missing.empty() ||
         std::ranges::any_of(methods, [](const MethodDifference& method) {
           return method.rows_that_differ > 0;
         });
}

Difference difference_of(const ComparedSide& one, const ComparedSide& other,
                         double tolerance) {
  Difference difference;
  difference.has_numbers = one.result && other.result;
  const bool uses_surface = difference.has_numbers;
  difference.keys =
      differences(keys_of(one, uses_surface), keys_of(other, uses_surface));
  difference.inputs = differences(one.inputs, other.inputs);
  if (!difference.has_numbers)
    return difference;
  difference.build = differences(build_of(one), build_of(other));
  NumberComparison(*one.result, *other.result, tolerance, difference).compare();
  return difference;
}

} // namespace asperity::run
