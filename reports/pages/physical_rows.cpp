// Shows the contact against the load in the units of a laboratory: rows of the
// page, and one sentence.
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/numbers/fits.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace asperity::reports {
namespace {

/// One load step over the realisations of a method.
struct PhysicalLoad {
  double pressure = 0.0; ///< mean of the realisations [Pa]
  Estimate area;         ///< A/A_0, corrected where the method corrects it
  Estimate gap;          ///< [m]
};

/// The method that a user of the surface asks for: the first that computes, and
/// is no theory.
const results::MethodRecord* main_method(const results::Result& result) {
  for (const results::MethodRecord& method : result.methods)
    if (method.kind != "theory" && method.kind != measured_kind &&
        !method.realizations.empty())
      return &method;
  return nullptr;
}

std::vector<PhysicalLoad> physical_loads(const results::MethodRecord& method) {
  struct Step {
    std::vector<FittedValue> pressures, areas, gaps;
  };

  const AreaColumn area = best_area(method);
  std::map<int, Step> steps;
  for (const results::Curve& curve : method.realizations)
    for (const results::CurvePoint& row : loading_rows(curve.points)) {
      steps[row.step].pressures.push_back({.value = row.nominal_pressure});
      steps[row.step].areas.push_back({.value = row.*area});
      steps[row.step].gaps.push_back({.value = row.mean_gap});
    }
  std::vector<PhysicalLoad> loads;
  loads.reserve(steps.size());
  for (const auto& [step, numbers] : steps)
    loads.push_back({mean_over_realizations(numbers.pressures).value,
                     mean_over_realizations(numbers.areas),
                     mean_over_realizations(numbers.gaps)});
  return loads;
}

/// "2.3 MPa": three digits with the prefix that suits them.
std::string in_unit(double value, const char* unit) {
  constexpr std::array prefixes{std::pair(1e9, "G"),  std::pair(1e6, "M"),
                                std::pair(1e3, "k"),  std::pair(1.0, ""),
                                std::pair(1e-3, "m"), std::pair(1e-6, "µ"),
                                std::pair(1e-9, "n")};
  for (const auto& [size, prefix] : prefixes)
    if (value >= 0.9995 * size)
      return fmt::format("{:.3g} {}{}", value / size, prefix, unit);
  return fmt::format("{:.3g} {}", value, unit);
}

std::string with_interval(const Estimate& number, double scale) {
  return fmt::format("{:.4g}{}", number.value * scale,
                     number.has_interval()
                         ? fmt::format(" ± {:.2g}", number.half_width * scale)
                         : "");
}

} // namespace

kainjow::mustache::list physical_rows(const ReportEntry& entry) {
  kainjow::mustache::list rows;
  const results::MethodRecord* const method = main_method(*entry.result);
  if (method == nullptr || entry.result->surfaces.empty())
    return rows;
  const double nominal = nominal_area(*entry.result, *entry.contact_case);
  for (const PhysicalLoad& load : physical_loads(*method)) {
    kainjow::mustache::data row;
    row.set("pressure", in_unit(load.pressure, "Pa"));
    row.set("load", in_unit(load.pressure * nominal, "N"));
    row.set("share", with_interval(load.area, 100.0));
    row.set("area", with_interval(load.area, nominal * 1e12));
    row.set("gap", with_interval(load.gap, 1e9));
    rows.push_back(row);
  }
  return rows;
}

std::string physical_sentence(const ReportEntry& entry) {
  const results::MethodRecord* const method = main_method(*entry.result);
  if (method == nullptr)
    return "";
  const std::vector<PhysicalLoad> loads = physical_loads(*method);
  if (loads.empty())
    return "";
  const auto at = [&](std::size_t i, const char* format) {
    return fmt::format(fmt::runtime(format), in_unit(loads[i].pressure, "Pa"),
                       100.0 * loads[i].area.value, 1e9 * loads[i].gap.value);
  };
  std::string words = at(0, "At {}, {:.3g} % of the nominal area is in contact "
                            "and the mean gap is {:.3g} nm");
  if (loads.size() > 2)
    words += at(loads.size() / 2, "; at {}, {:.3g} % and {:.3g} nm");
  if (loads.size() > 1)
    words += at(loads.size() - 1, "; at {}, {:.3g} % and {:.3g} nm");
  return fmt::format("{} ({}).", words, method->name);
}

} // namespace asperity::reports
