#include "reports/pages/agreement.hpp"

#include "base/json.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/numbers/fits.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity::reports {
namespace {

using results::MethodRecord;

/// The numbers of a row in comparison.json and comparison.csv.
constexpr std::array agreement_columns{
    std::pair("gap_difference [h_rms]", &AgreementRow::gap_difference),
    std::pair("area_difference [1]", &AgreementRow::area_difference),
    std::pair("pressure_difference [1]", &AgreementRow::pressure_difference),
    std::pair("certified_gap_error [h_rms]", &AgreementRow::certified_error),
    std::pair("estimated_gap_error [h_rms]", &AgreementRow::estimated_error)};

/// The record behind a series.
const MethodRecord& record_of(std::span<const ReportEntry> entries,
                              const Series& series) {
  const std::vector<MethodRecord>& methods =
      entries[series.entry].result->methods;
  return *std::ranges::find(methods, series.method->name, &MethodRecord::name);
}

bool is_equal(double one, double other) {
  return std::abs(one - other) <= 1e-6 * std::abs(other);
}

/// Says why two methods cannot be compared; empty if they can.
std::string obstacle(std::span<const ReportEntry> entries, const Series& one,
                     const Series& other) {
  const results::Result& mine = *entries[one.entry].result;
  const results::Result& theirs = *entries[other.entry].result;
  if (!is_equal(mine.contact_modulus, theirs.contact_modulus))
    return "another E*";
  const results::SurfaceRecord* const a =
      surface_of(mine, record_of(entries, one), 0);
  const results::SurfaceRecord* const b =
      surface_of(theirs, record_of(entries, other), 0);
  if (a == nullptr || b == nullptr)
    return "no surface is recorded";
  if (!is_equal(a->rms_height, b->rms_height))
    return "another surface";
  return "";
}

/// rms(p - p_ref)/rms(p_ref) of the fields at one load; NaN if there are none.
double difference_of_fields(const results::Curve& curve,
                            const results::Curve& reference,
                            const results::CurvePoint& point) {
  const auto at_step = [&](const results::Fields& fields) {
    return fields.step == point.step;
  };
  const auto mine = std::ranges::find_if(curve.fields, at_step);
  if (mine == curve.fields.end())
    return not_a_number;
  for (const results::Fields& fields : reference.fields) {
    if (!is_equal(fields.nominal_pressure, point.nominal_pressure) ||
        fields.pressure_map().size() != mine->pressure_map().size() ||
        !(fields.grid == mine->grid))
      continue;
    double difference = 0.0;
    double size = 0.0;
    results::each_piece(std::array{mine->pressure_map(), fields.pressure_map()},
                        [&](std::size_t, const auto& values) {
                          for (std::size_t i = 0; i < values[0].size(); ++i) {
                            const double apart = values[0][i] - values[1][i];
                            difference += apart * apart;
                            size += values[1][i] * values[1][i];
                          }
                        });
    return std::sqrt(difference / size);
  }
  return not_a_number;
}

/// @param area  of the reference, with which the counted or measured area of
///              the curve is compared
void add_rows(const results::Curve& curve, const results::Curve& reference,
              AreaColumn area, int realization, double rms_height,
              Agreement& agreement) {
  const CurveFunction function(reference.points, area);
  for (const results::CurvePoint& point : curve.points) {
    if (point.status != results::StepStatus::converged || point.is_unloading ||
        !(point.nominal_pressure > 0.0))
      continue;
    AgreementRow row;
    row.realization = realization;
    row.nominal_pressure = point.nominal_pressure;
    row.gap_difference =
        (point.mean_gap - function.gap(point.nominal_pressure)) / rms_height;
    row.area_difference =
        point.area_fraction / function.area_fraction(point.nominal_pressure) -
        1.0;
    row.pressure_difference = difference_of_fields(curve, reference, point);
    row.certified_error = point[columns::certified_gap_error] / rms_height;
    row.estimated_error = point[columns::estimated_gap_error] / rms_height;
    if (std::isfinite(row.gap_difference) || std::isfinite(row.area_difference))
      agreement.rows.push_back(row);
  }
}

Agreement agreement_of(std::span<const ReportEntry> entries,
                       const Series& series, const Series& reference) {
  Agreement agreement{
      series.label, reference.label, obstacle(entries, reference, series), {}};
  if (!agreement.problem.empty())
    return agreement;
  const MethodRecord& mine = record_of(entries, series);
  const MethodRecord& other = record_of(entries, reference);
  const std::size_t shared =
      std::min(mine.realizations.size(), other.realizations.size());
  for (std::size_t r = 0; r < shared; ++r) {
    const results::SurfaceRecord* const surface =
        surface_of(*entries[reference.entry].result, other, r);
    if (surface != nullptr)
      add_rows(mine.realizations[r], other.realizations[r],
               mine.kind == measured_kind ? best_area(other)
                                          : &columns::area_fraction,
               static_cast<int>(r), surface->rms_height, agreement);
  }
  if (agreement.rows.empty())
    agreement.problem = "no load lies within the loads of the reference";
  return agreement;
}

} // namespace

double Agreement::largest(double AgreementRow::*number) const {
  double found = not_a_number;
  for (const AgreementRow& row : rows)
    found = std::fmax(found, std::abs(row.*number));
  return found;
}

std::vector<Agreement> agreements_of(std::span<const ReportEntry> entries,
                                     std::span<const Series> series) {
  std::vector<Agreement> agreements;
  const auto reference = std::ranges::find_if(series, [](const Series& one) {
    return !one.is_theory() && one.entry == 0 && !one.rows.empty();
  });
  if (reference == series.end())
    return agreements;
  for (const Series& one : series)
    if (!one.is_theory() && &one != &*reference)
      agreements.push_back(agreement_of(entries, one, *reference));
  return agreements;
}

nlohmann::ordered_json agreement_json(std::span<const Agreement> agreements) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Agreement& agreement : agreements) {
    Json rows = Json::array();
    Json largest = Json::object();
    for (const AgreementRow& row : agreement.rows) {
      rows.push_back({{"realization", row.realization},
                      {"nominal_pressure [Pa]", row.nominal_pressure}});
      for (const auto& [name, number] : agreement_columns)
        rows.back()[name] = row.*number;
    }
    for (const auto& [name, number] : agreement_columns)
      largest[name] = agreement.largest(number);
    list.push_back({{"method", agreement.method},
                    {"reference", agreement.reference},
                    {"problem", agreement.problem},
                    {"rows", rows},
                    {"largest", largest}});
  }
  return list;
}

std::string agreement_csv(std::span<const Agreement> agreements) {
  std::vector<std::string> head{"method", "realization",
                                "nominal_pressure [Pa]"};
  for (const auto& [name, number] : agreement_columns)
    head.emplace_back(name);
  CsvTable table(head);
  for (const Agreement& agreement : agreements)
    for (const AgreementRow& row : agreement.rows) {
      std::vector<double> cells{static_cast<double>(row.realization),
                                row.nominal_pressure};
      for (const auto& [name, number] : agreement_columns)
        cells.push_back(row.*number);
      table.add(agreement.method, cells);
    }
  return table.text();
}

} // namespace asperity::reports
