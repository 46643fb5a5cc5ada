#include "reports/analysis/study_quantities.hpp"

#include "cases/types/quantity_at_load.hpp"
#include "theory/persson/persson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace asperity::reports {
namespace {

using results::Result;
using results::Table;

// Loads that a case writes in two units are equal within this relative
// tolerance.
constexpr double unit_rounding = 1e-9;

Estimate without(const std::string& reason) {
  Estimate estimate;
  estimate.remark = reason;
  return estimate;
}

Estimate number(double value, const std::string& reason_if_none) {
  Estimate estimate;
  estimate.value = value;
  estimate.realizations = 1;
  estimate.remark = estimate.has_value() ? "from the formula" : reason_if_none;
  return estimate;
}

/// Interpolates y at x between rows, linearly in the logarithms; NaN outside
/// the rows, and between rows whose y are not positive.
double between_rows(const std::vector<double>& x, const std::vector<double>& y,
                    double at) {
  for (std::size_t i = 0; i < x.size() && i < y.size(); ++i) {
    if (x[i] == at)
      return y[i];
    if (i + 1 < y.size() && x[i] < at && at < x[i + 1]) {
      const double part = std::log(at / x[i]) / std::log(x[i + 1] / x[i]);
      return y[i] * std::pow(y[i + 1] / y[i], part);
    }
  }
  return not_a_number;
}

const Table* magnification_table(const Result& result, std::size_t load) {
  return result.table(fmt::format("magnification-{}", load + 1));
}

Estimate at_magnification(const Result& result,
                          const cases::QuantityAtLoad& asked) {
  const Table* loads = result.table("magnification");
  if (loads == nullptr)
    return without("the study of magnifications was not run");
  const double pressure =
      asked.nominal_pressure.in_si({result.contact_modulus, 0.0, 0.0, 0.0});
  const std::vector<double> pressures = loads->values("nominal_pressure");
  const auto found =
      std::find_if(pressures.begin(), pressures.end(), [&](double one) {
        return std::abs(one - pressure) <= unit_rounding * pressure;
      });
  const auto load = static_cast<std::size_t>(found - pressures.begin());
  const Table* rows =
      found == pressures.end() ? nullptr : magnification_table(result, load);
  if (rows == nullptr)
    return without(fmt::format("p = {:.6g} Pa is not a load of [magnification]",
                               pressure));
  const bool is_area = asked.quantity == "area_fraction";
  const double value =
      between_rows(rows->values("magnification"),
                   rows->values(is_area ? "area_fraction" : "mean_gap"),
                   *asked.magnification);
  const double scale = is_area ? 1.0
                       : asked.quantity == "reduced_mean_gap"
                           ? loads->values("rms_height").at(load)
                           : loads->values("mean_gap").at(load);
  return number(value / scale,
                fmt::format("zeta = {:g} lies outside the computed range",
                            *asked.magnification));
}

/// Returns the largest |u/u' - 1| between the rows of two loads, for
/// magnifications of at least `from`.
double largest_difference(const Table& light, const Table& heavy, double from) {
  const std::vector<double> zeta = light.values("magnification");
  const std::vector<double> gap = light.values("mean_gap");
  const std::vector<double> other = heavy.values("mean_gap");
  double largest = not_a_number;
  for (std::size_t i = 0; i < zeta.size() && i < other.size(); ++i)
    if (zeta[i] >= from && other[i] > 0.0)
      largest = std::fmax(largest, std::abs(gap[i] / other[i] - 1.0));
  return largest;
}

Estimate gap_pressure_dependence(const Result& result) {
  const Table* loads = result.table("magnification");
  const std::vector<double> pressures = loads == nullptr
                                            ? std::vector<double>{}
                                            : loads->values("nominal_pressure");
  if (pressures.size() < 2)
    return without("the study of magnifications has fewer than two loads");
  std::vector<std::size_t> order(pressures.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return pressures[a] < pressures[b];
  });
  const Table* light = magnification_table(result, order[0]);
  const Table* heavy = magnification_table(result, order[1]);
  if (light == nullptr || heavy == nullptr)
    return without("a table of magnifications is missing");
  const double begin = loads->values("lowest_magnification").at(order[0]);
  return number(largest_difference(*light, *heavy, 2.0 * begin),
                "no computed magnification is high enough");
}

Estimate of_flip(const Result& result, const std::string& column,
                 const std::string& reason_if_none) {
  const Table* flip = result.table("adhesion-flip");
  if (flip == nullptr || flip->values(column).empty())
    return without("the study of adhesion was not run");
  return number(flip->values(column).front(), reason_if_none);
}

} // namespace

void add_study_quantities(const Result& result, const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          std::span<const std::string> names,
                          MethodSummary& summary) {
  auto& quantities = summary.quantities;
  if (const auto* const theory =
          settings_of<mechanics::TheorySettings>(contact_case, method);
      theory != nullptr &&
      theory->loss_factor == mechanics::LossFactor::yang_persson)
    quantities["epsilon"] = number(theory::persson_epsilon(theory->gamma), "");
  const cases::MethodSpec* studied =
      cases::study_theory(contact_case.surface, contact_case.methods);
  if (studied == nullptr || studied->name != method.name)
    return;
  if (contact_case.magnification_study) {
    quantities["gap_pressure_dependence"] = gap_pressure_dependence(result);
    for (const std::string& name : names) {
      const auto asked = cases::read_quantity_at_load(name).at_load;
      if (asked && asked->magnification)
        quantities[name] = at_magnification(result, *asked);
    }
  }
  if (contact_case.adhesion_study) {
    const std::string no_flip = "no flip between two ratios of the study";
    quantities["adhesion_flip"] = of_flip(result, "height_ratio", no_flip);
    quantities["adhesion_flip_area"] =
        of_flip(result, "area_fraction", no_flip);
    quantities["complete_contact_binding"] =
        of_flip(result, "complete_contact_binding", "not a number");
    if (const Table* const rows = result.table("adhesion")) {
      const auto here = [&](const char* column) {
        return number(between_rows(rows->values("height_ratio"),
                                   rows->values(column), 1.0),
                      "no partial contact at h_rms/h_rms0 = 1");
      };
      quantities["effective_work_approach"] = here("binding_partial");
      quantities["unloaded_area_approach"] = here("area_fraction_partial");
      quantities["effective_work_retraction"] = here("binding_complete");
      quantities["unloaded_area_retraction"] = here("area_fraction_complete");
    }
  }
}

} // namespace asperity::reports
