#include "reports/analysis/at_load.hpp"

#include "input/types/quantity_at_load.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/rough.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

using results::CurvePoint;
using results::MethodRecord;

constexpr const char* excess_prefix = "area_excess";

/// Returns the column from which the area of a quantity is read.
AreaColumn area_column(const std::string& quantity) {
  if (quantity.ends_with("_fit"))
    return &columns::area_fraction_fit;
  if (quantity.ends_with("_moment"))
    return &columns::area_fraction_moment;
  if (quantity.ends_with("_corrected"))
    return &columns::area_fraction_corrected;
  return &columns::area_fraction;
}

/// A column of a study.
const results::CurveColumn* column(const char* name) {
  return &results::curve_column(name);
}

/// Mean over both directions of log10 of two columns of the step at a load;
/// minus infinity if a direction is sealed, and NaN without a step.
double log_flow(const results::Curve& curve, double pressure,
                const results::CurveColumn* in_x,
                const results::CurveColumn* in_y) {
  for (const CurvePoint& row : curve.points)
    if (std::abs(row.nominal_pressure / pressure - 1.0) < 1e-6 &&
        row[*in_x] >= 0.0 && row[*in_y] >= 0.0)
      return 0.5 * (std::log10(row[*in_x]) + std::log10(row[*in_y]));
  return not_a_number;
}

/// The row of the loading branch at a load, or null.
const CurvePoint* row_at(const results::Curve& curve, double pressure) {
  for (const CurvePoint& row : curve.points)
    if (!row.is_unloading &&
        std::abs(row.nominal_pressure / pressure - 1.0) < 1e-6)
      return &row;
  return nullptr;
}

/// Another stiffness over that of the standing contact; NaN without a step at
/// this load.
double stiffness_ratio(const std::string& quantity, double pressure,
                       const results::Curve& curve,
                       const results::Curve* theory, double contact_modulus) {
  const CurvePoint* const own = row_at(curve, pressure);
  const CurvePoint* const other =
      quantity.starts_with("theory") ? row_at(*theory, pressure) : own;
  if (own == nullptr || other == nullptr)
    return not_a_number;
  return quantity.starts_with("spot")
             ? 2.0 * (*own)[*column("spot_radii")] /
                   (*own)[*column("relative_conductance")]
             : other->contact_stiffness / contact_modulus /
                   (*own)[*column("relative_conductance")];
}

/// The plastic area of the first step at a load; NaN without one.
double plastic_area(const results::Curve& curve, double pressure) {
  const CurvePoint* const row = row_at(curve, pressure);
  return row == nullptr ? not_a_number : (*row)[columns::plastic_area];
}

/// Returns NaN where the curve does not provide the quantity.
double number_at(const std::string& quantity, double pressure,
                 const results::Curve& curve, const results::Curve* theory,
                 const SurfaceScales& scales) {
  if (quantity == "log10_flow_factor")
    return log_flow(curve, pressure, column("flow_factor_x"),
                    column("flow_factor_y"));
  if (quantity == "leak_departure")
    return log_flow(curve, pressure, column("leak_rate_x"),
                    column("leak_rate_y")) -
           log_flow(*theory, pressure, column("leak_rate_x"),
                    column("leak_rate_y"));
  if (quantity.ends_with("stiffness_ratio"))
    return stiffness_ratio(quantity, pressure, curve, theory,
                           scales.contact_modulus);
  if (quantity == "plastic_area")
    return plastic_area(curve, pressure);
  const CurveFunction function(curve.points, area_column(quantity));
  if (quantity == "reduced_mean_gap")
    return function.gap(pressure) / scales.rms_height;
  const double area = function.area_fraction(pressure);
  if (!quantity.starts_with(excess_prefix))
    return area;
  return area / CurveFunction(theory->points).area_fraction(pressure) - 1.0;
}

bool is_answered(const cases::ExpectationName& known,
                 const MethodRecord& method, const MethodRecord* reference) {
  return (method.kind == "theory" ? known.theory_answers
                                  : !known.theory_only) &&
         (!known.needs_theory || reference != nullptr);
}

} // namespace

std::vector<std::string>
names_at_load(std::span<const cases::Expectation> expectations,
              std::span<const cases::ReferenceValue> references) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (cases::read_quantity_at_load(name).at_load &&
        std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  };
  for (const cases::Expectation& expectation : expectations)
    add(expectation.quantity);
  for (const cases::ReferenceValue& reference : references)
    add(reference.quantity);
  return names;
}

void add_quantities_at_load(const results::Result& result,
                            const cases::Case& contact_case,
                            const MethodRecord& method,
                            const MethodRecord* reference,
                            std::span<const std::string> names,
                            MethodSummary& summary) {
  for (const std::string& name : names) {
    if (!is_answered(*cases::expectation_called(name), method, reference))
      continue;
    const cases::QuantityAtLoad asked =
        *cases::read_quantity_at_load(name).at_load;
    if (asked.magnification)
      continue; // handled by the studies
    const double pressure =
        asked.nominal_pressure.in_si({result.contact_modulus, 0.0, 0.0, 0.0});
    std::vector<FittedValue> values;
    for (std::size_t r = 0; r < method.realizations.size(); ++r)
      values.push_back(
          {number_at(asked.quantity, pressure, method.realizations[r],
                     reference == nullptr ? nullptr : &curve_of(*reference, r),
                     scales_of(result, contact_case, method, r)),
           not_a_number, 0});
    Estimate& estimate = summary.quantities[name];
    if (const auto sealed = std::ranges::count_if(
            values, [](const FittedValue& at) { return std::isinf(at.value); });
        sealed > 0) { // the others alone are no mean
      estimate.remark = fmt::format(
          "{} of {} realisations are sealed at p/E* = {:.4g} in a direction, "
          "where the leak rate is 0 and has no logarithm",
          sealed, values.size(), pressure / result.contact_modulus);
      continue;
    }
    estimate = mean_over_realizations(values);
    if (!estimate.has_value())
      estimate.remark =
          fmt::format("no {} at p/E* = {:.4g}, nor at two loads within a "
                      "decade around it",
                      asked.quantity, pressure / result.contact_modulus);
  }
}

} // namespace asperity::reports
