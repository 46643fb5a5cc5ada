// Says what a user of the surface asks for first: the contact against the load,
// as a table and in one sentence.
#include "base/json.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/page_data.hpp"
#include "surfaces/inner_roughness.hpp"

#include <fmt/format.h>

#include <algorithm>
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

/// The loads that all realisations reach. Those without contact count: at a
/// prescribed gap the others alone would be another surface.
std::vector<PhysicalLoad> physical_loads(const results::MethodRecord& method) {
  struct Step {
    std::vector<FittedValue> pressures, areas, gaps;
    bool is_complete = true; ///< whether all realisations converged
  };

  const AreaColumn area = best_area(method);
  std::map<int, Step> steps;
  for (const results::Curve& curve : method.realizations)
    for (const results::CurvePoint& row : curve.points) {
      if (row.is_unloading)
        continue;
      Step& step = steps[row.step];
      step.is_complete = step.is_complete &&
                         row.status == results::StepStatus::converged &&
                         std::isfinite(row.nominal_pressure + row.mean_gap);
      step.pressures.push_back({.value = row.nominal_pressure});
      step.areas.push_back(
          {.value = row.area_fraction == 0.0 ? 0.0 : row[*area]});
      step.gaps.push_back({.value = row.mean_gap});
    }
  std::vector<PhysicalLoad> loads;
  for (const auto& [step, numbers] : steps) {
    const double pressure = mean_over_realizations(numbers.pressures).value;
    if (numbers.is_complete && pressure > 0.0)
      loads.push_back({pressure, mean_over_realizations(numbers.areas),
                       mean_over_realizations(numbers.gaps)});
  }
  std::ranges::stable_sort(loads, {}, &PhysicalLoad::pressure);
  return loads;
}

/// "2.3 MPa": three digits with the prefix that suits them.
std::string pressure_in_pascal(double value) {
  return quantity_text(value, "Pa", 3);
}

/// The roughness by which the adhesion of a method is judged.
mechanics::Roughness judged_roughness(const cases::Case& contact_case,
                                      const results::MethodRecord& method,
                                      const results::SurfaceRecord& surface) {
  if (const auto exact = surfaces::exact_roughness(
          contact_case.surface, surface.grid.length_x, surface.grid.length_y))
    return *exact;
  if (!surfaces::is_judged_inside(contact_case.surface,
                                  has_free_boundaries(contact_case, method)))
    return {surface.rms_slope, surface.rms_curvature};
  if (!surface.has_heights())
    return {surface.rms_slope, not_a_number};
  const results::StoredMap heights = surface.heights_of_map();
  return {surface.rms_slope,
          surfaces::inner_curvature(
              {surface.map_grid(), results::MapView(heights).whole()})};
}

/// Pull-off and stickiness of a method with adhesion; otherwise nothing.
std::string adhesive_sentence(const ReportEntry& entry,
                              const results::MethodRecord& method) {
  const cases::Case& contact_case = *entry.contact_case;
  const auto summary = std::ranges::find(entry.summary.methods, method.name,
                                         &MethodSummary::name);
  const results::SurfaceRecord* const surface =
      surface_of(*entry.result, method, 0);
  const auto law = adhesion_of(*entry.result, contact_case, method);
  if (!law || summary == entry.summary.methods.end())
    return "";
  const double modulus = entry.result->contact_modulus;
  const auto tension = summary->quantities.find("pull_off_pressure");
  std::string words =
      fmt::format(" Adhesion of {:.3g} mJ/m² acts over {:.3g} "
                  "nm",
                  1e3 * law->work_of_adhesion, 1e9 * law->adhesion_range);
  if (tension != summary->quantities.end() && tension->second.has_value())
    words += fmt::format(": the largest tension of the path is {}",
                         pressure_in_pascal(tension->second.value * modulus));
  const double criterion = stickiness(
      *law, modulus, judged_roughness(contact_case, method, *surface));
  if (std::isfinite(criterion) && criterion > 0.0)
    words += fmt::format("; the criterion of Pastewka and Robbins (2014) is "
                         "{:.3g}, below 1 where faces stick",
                         criterion);
  return words + ".";
}

} // namespace

nlohmann::ordered_json contact_against_load(const ReportEntry& entry) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const results::MethodRecord* const method = main_method(*entry.result);
  if (method == nullptr || entry.result->surfaces.empty())
    return rows;
  const double nominal = nominal_area(*entry.result);
  const auto number = [](const Estimate& estimate, double scale) {
    return nlohmann::ordered_json{
        {"value", estimate.value * scale},
        {"half_width_95", estimate.half_width * scale}};
  };
  for (const PhysicalLoad& load : physical_loads(*method))
    rows.push_back({{"nominal_pressure [Pa]", load.pressure},
                    {"load [N]", load.pressure * nominal},
                    {"area_fraction", number(load.area, 1.0)},
                    {"area [m^2]", number(load.area, nominal)},
                    {"mean_gap [m]", number(load.gap, 1.0)}});
  return rows;
}

std::string physical_sentence(const ReportEntry& entry) {
  const results::MethodRecord* const method = main_method(*entry.result);
  if (method == nullptr)
    return "";
  const std::vector<PhysicalLoad> loads = physical_loads(*method);
  if (loads.empty())
    return adhesive_sentence(entry, *method);
  const auto at = [&](std::size_t i, const char* format) {
    return fmt::format(fmt::runtime(format),
                       pressure_in_pascal(loads[i].pressure),
                       100.0 * loads[i].area.value, 1e9 * loads[i].gap.value);
  };
  std::string words = at(0, "At {}, {:.3g} % of the nominal area is in contact "
                            "and the mean gap is {:.3g} nm");
  if (loads.size() > 2)
    words += at(loads.size() / 2, "; at {}, {:.3g} % and {:.3g} nm");
  if (loads.size() > 1)
    words += at(loads.size() - 1, "; at {}, {:.3g} % and {:.3g} nm");
  return fmt::format("{} ({}).{}", words, method->name,
                     adhesive_sentence(entry, *method));
}

} // namespace asperity::reports
