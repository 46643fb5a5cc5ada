#include "reports/figures/series.hpp"

#include "reports/analysis/comparison.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/analysis/rough.hpp"
#include "reports/figures/gnuplot.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace asperity::reports {
namespace {

using results::CurvePoint;
using results::MethodRecord;

struct Sum {
  SeriesRow row;
  std::vector<FittedValue> gaps; ///< of the realisations
  std::vector<FittedValue> areas;
  int count = 0;
  int with_theory = 0;
  bool is_complete = true; ///< whether all realisations converged
};

void add_point(Sum& sum, const CurvePoint& point, const SurfaceScales& scales,
               const CurveFunction& theory, AreaColumn best) {
  const double theory_gap = theory.gap(point.nominal_pressure);
  const double gap = point.mean_gap / scales.rms_height;
  SeriesRow& row = sum.row;
  row.gap_low = sum.count == 0 ? gap : std::min(row.gap_low, gap);
  row.gap_high = sum.count == 0 ? gap : std::max(row.gap_high, gap);
  const double area = point.area_fraction == 0.0 ? 0.0 : point[*best];
  sum.gaps.push_back({.value = gap});
  sum.areas.push_back({.value = area});
  const double pressure = point.nominal_pressure / scales.contact_modulus;
  row.pressure += pressure;
  row.pressure_slope += pressure / scales.rms_slope;
  row.gap += gap;
  row.area += point.area_fraction;
  row.area_corrected += area;
  row.area_fit += point[columns::area_fraction_fit];
  row.theory_area += theory.area_fraction(point.nominal_pressure);
  row.iterations += point.iterations;
  row.cpu_time += point.cpu_time;
  ++sum.count;
  if (std::isfinite(theory_gap)) {
    row.theory_gap = (sum.with_theory == 0 ? 0.0 : row.theory_gap) +
                     theory_gap / scales.rms_height;
    ++sum.with_theory;
  }
}

SeriesRow mean_of(const Sum& sum) {
  SeriesRow row = sum.row;
  const double count = sum.count;
  for (double* number : {&row.pressure, &row.pressure_slope, &row.gap,
                         &row.area, &row.area_corrected, &row.area_fit,
                         &row.theory_area, &row.iterations, &row.cpu_time})
    *number /= count;
  row.gap_interval = mean_over_realizations(sum.gaps).half_width;
  row.area_interval = mean_over_realizations(sum.areas).half_width;
  row.theory_gap =
      sum.with_theory == sum.count ? row.theory_gap / count : not_a_number;
  return row;
}

bool is_near(double one, double other, double relative) {
  return std::abs(one - other) <= relative * std::abs(other);
}

/// Returns the theory with which a method is compared: that of its own result,
/// or, for a method of another program, that of the first result on the same
/// surface and modulus. Null if there is none.
const MethodRecord* theory_for(std::span<const ReportEntry> entries,
                               const ReportEntry& entry,
                               const MethodRecord& method) {
  if (const MethodRecord* const own =
          reference_theory(*entry.result, *entry.contact_case, method))
    return own;
  const SurfaceScales mine =
      scales_of(*entry.result, *entry.contact_case, method, 0);
  for (const ReportEntry& other : entries) {
    const MethodRecord* const theory =
        reference_theory(*other.result, *other.contact_case, method);
    if (theory == nullptr || other.result->surfaces.empty())
      continue;
    const double height = other.result->surfaces.front().rms_height;
    if (is_near(other.result->contact_modulus, mine.contact_modulus, 1e-6) &&
        is_near(height, mine.rms_height, 1e-6))
      return theory;
  }
  return nullptr;
}

std::vector<SeriesRow> rows_of(std::span<const ReportEntry> entries,
                               const ReportEntry& entry,
                               const MethodRecord& method) {
  const MethodRecord* reference = theory_for(entries, entry, method);
  const AreaColumn best = best_area(method);
  std::map<int, Sum> steps;
  for (std::size_t r = 0; r < method.realizations.size(); ++r) {
    const SurfaceScales scales =
        scales_of(*entry.result, *entry.contact_case, method, r);
    const CurveFunction theory(reference != nullptr
                                   ? std::span(curve_of(*reference, r).points)
                                   : std::span<const CurvePoint>());
    for (const CurvePoint& point : method.realizations[r].points) {
      Sum& sum = steps[point.step];
      if (point.status == results::StepStatus::converged)
        add_point(sum, point, scales, theory, best);
      else
        sum.is_complete = false;
    }
  }
  // The converged realisations alone, or those in contact, are another surface.
  std::vector<SeriesRow> rows;
  rows.reserve(steps.size());
  for (const auto& [step, sum] : steps)
    if (sum.is_complete && sum.row.pressure > 0.0)
      rows.push_back(mean_of(sum));
  return rows;
}

/// The mean over the realisations of a theory's curve between its loads.
std::vector<SeriesRow> fine_rows(const MethodSummary& method) {
  std::vector<Sum> sums;
  for (const RealizationFits& fits : method.fits) {
    if (fits.fine_curve.empty() ||
        (!sums.empty() && sums.size() != fits.fine_curve.size()))
      return {};
    sums.resize(fits.fine_curve.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
      add_point(sums[i], fits.fine_curve[i], fits.scales, CurveFunction({}),
                &columns::area_fraction);
  }
  std::vector<SeriesRow> rows;
  rows.reserve(sums.size());
  for (const Sum& sum : sums)
    rows.push_back(mean_of(sum));
  return rows;
}

bool would_lie_on(const Series& variant, const Series& method) {
  return variant.rows.size() == method.rows.size() &&
         std::equal(variant.rows.begin(), variant.rows.end(),
                    method.rows.begin(),
                    [](const SeriesRow& a, const SeriesRow& b) {
                      return std::abs(a.gap - b.gap) <= 0.002 &&
                             is_near(a.pressure, b.pressure, 0.005) &&
                             is_near(a.area, b.area, 0.01) &&
                             is_near(a.area_corrected, b.area_corrected, 0.01);
                    });
}

void join_variants(std::vector<Series>& all) {
  for (Series& variant : all) {
    const std::string& name = variant.method->name;
    const std::size_t dot = name.find('.');
    if (variant.is_theory() || dot == std::string::npos)
      continue;
    for (Series& method : all)
      if (method.entry == variant.entry &&
          method.method->name == name.substr(0, dot) &&
          would_lie_on(variant, method)) {
        variant.is_drawn = false;
        method.legend += ", " + name;
      }
  }
}

/// Adds to the legend of a measured curve how far it is from the first method
/// of the first result, with the gap in h_rms and the area relative to that.
void add_deviations(std::span<const ReportEntry> entries,
                    std::vector<Series>& all) {
  const auto reference = std::ranges::find_if(all, [](const Series& one) {
    return !one.is_theory() && one.entry == 0 && !one.rows.empty();
  });
  if (reference == all.end())
    return;
  const results::Result& result = *entries.front().result;
  const auto& record = *std::ranges::find(
      result.methods, reference->method->name, &MethodRecord::name);
  for (Series& series : all) {
    if (series.kind != measured_kind)
      continue;
    const results::Result& mine = *entries[series.entry].result;
    const CurveDistance distance =
        distance_from(mine.methods.front().realizations.front().points, record);
    const double gap = distance.gap / mine.surfaces.front().rms_height;
    const double area = distance.area;
    if (std::isfinite(gap))
      series.legend += fmt::format(", |Δu| ≤ {:.2g} h_rms", gap);
    if (std::isfinite(area))
      series.legend += fmt::format(", |ΔA|/A ≤ {:.3g} %", 100.0 * area);
  }
}

} // namespace

std::vector<Series> series_of(std::span<const ReportEntry> entries) {
  std::vector<Series> all;
  std::size_t colors = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ReportEntry& entry = entries[i];
    for (std::size_t m = 0; m < entry.result->methods.size(); ++m) {
      const MethodRecord& record = entry.result->methods[m];
      Series series;
      series.kind = record.kind;
      const bool is_measured = record.kind == measured_kind;
      series.label = entries.size() == 1 ? record.name
                     : is_measured
                         ? entry.summary.case_name
                         : entry.summary.case_name + ": " + record.name;
      series.legend = series.label;
      series.entry = i;
      series.color = series.is_theory() ? i : colors++;
      series.method = &entry.summary.methods[m];
      series.rows = rows_of(entries, entry, record);
      series.fine = fine_rows(*series.method);
      all.push_back(std::move(series));
    }
  }
  join_variants(all);
  add_deviations(entries, all);
  std::stable_partition(all.begin(), all.end(),
                        [](const Series& s) { return s.is_theory(); });
  return all;
}

const char* series_color(const Series& series) {
  return series.is_theory() ? "#222222" : method_color(series.color);
}

CurveStyle line_style(const Series& series) {
  return series.is_theory()
             ? line("#222222", 1.8, static_cast<int>(series.color) + 1)
             : line(method_color(series.color));
}

CurveStyle point_style(const Series& series) {
  // Later ones are smaller and lie on the others.
  static constexpr std::array<std::pair<int, double>, 6> signs{
      {{7, 0.95}, {5, 0.8}, {9, 0.85}, {13, 0.8}, {11, 0.7}, {7, 0.5}}};
  const auto [marker, size] = signs[series.color % signs.size()];
  if (series.kind == measured_kind) // the same symbols, open
    return markers(method_color(series.color), marker - 1, size + 0.15, 1.3);
  return markers(method_color(series.color), marker, size, 1.3);
}

} // namespace asperity::reports
