#include "reports/analysis/at_load.hpp"

#include "input/types/quantity_at_load.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/rough.hpp"
#include "reports/study_pages.hpp"
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

/// The row of the loading branch at a load, or null.
const CurvePoint* row_at(const results::Curve& curve, double pressure) {
  for (const CurvePoint& row : curve.points)
    if (!row.is_unloading &&
        std::abs(row.nominal_pressure / pressure - 1.0) < 1e-6)
      return &row;
  return nullptr;
}

/// The number that a study owns under this name, or null.
const NumberAtLoad* number_of_study(const std::string& quantity) {
  for (const StudyPages* const study : study_pages())
    for (const NumberAtLoad& number : study->at_load)
      if (number.name.name == quantity)
        return &number;
  return nullptr;
}

/// Returns NaN where the curve does not provide the quantity.
double number_at(const std::string& quantity, double pressure,
                 const results::Curve& curve, const results::Curve* theory,
                 const SurfaceScales& scales) {
  const CurvePoint* const row = row_at(curve, pressure);
  if (const NumberAtLoad* const number = number_of_study(quantity)) {
    const CurvePoint* const other =
        theory == nullptr ? nullptr : row_at(*theory, pressure);
    return row == nullptr || (number->name.needs_theory && other == nullptr)
               ? not_a_number
               : number->of({*row, other, scales.contact_modulus});
  }
  if (quantity == "plastic_area")
    return row == nullptr ? not_a_number : (*row)[columns::plastic_area];
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
    const NumberAtLoad* const number = number_of_study(asked.quantity);
    const auto infinite = std::ranges::count_if(
        values, [](const FittedValue& at) { return std::isinf(at.value); });
    if (infinite > 0 && number != nullptr && number->infinite != nullptr) {
      // The others alone are no mean.
      estimate.remark =
          fmt::format(fmt::runtime(number->infinite), infinite, values.size(),
                      pressure / result.contact_modulus);
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
