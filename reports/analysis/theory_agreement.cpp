#include "reports/analysis/theory_agreement.hpp"

#include "base/shown_number.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/rough.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity::reports {
namespace {

using results::CurvePoint;
using results::MethodRecord;

/// Sums over the realisations of a method at one step of the loading path.
struct ComparedLoad {
  double pressure = 0.0; // [Pa]
  double area = 0.0;     // A/A_0
  double theory_area = 0.0;
  double gap = 0.0; // u/h_rms
  double theory_gap = 0.0;
  double contact_nodes = 0.0;
  int count = 0;

  double area_ratio() const { return area / theory_area; }

  double gap_difference() const { return std::abs(gap - theory_gap) / count; }

  bool is_outside() const {
    const double ratio = area_ratio(); // NaN: one of them is not known
    return ratio > largest_area_scale || ratio < 1.0 / largest_area_scale;
  }

  bool has_other_gap() const {
    return gap >= comparison_gap_low * count &&
           gap <= comparison_gap_high * count &&
           gap_difference() > largest_gap_difference;
  }
};

/// What is compared: a method with the theory of its surface.
struct Comparison {
  const results::Result& result;
  const cases::Case& contact_case;
  const MethodRecord& method;
  const MethodRecord& theory;
};

std::vector<ComparedLoad> compared_loads(const Comparison& compared) {
  const AreaColumn area = best_area(compared.method);
  std::map<int, ComparedLoad> loads;
  for (std::size_t r = 0; r < compared.method.realizations.size(); ++r) {
    const CurveFunction theory(curve_of(compared.theory, r).points);
    const double height =
        scales_of(compared.result, compared.contact_case, compared.method, r)
            .rms_height;
    const results::SurfaceRecord* const surface =
        surface_of(compared.result, compared.method, r);
    for (const CurvePoint& row :
         loading_rows(compared.method.realizations[r].points)) {
      ComparedLoad& load = loads[row.step];
      load.pressure += row.nominal_pressure;
      load.area += row[*area];
      load.theory_area += theory.area_fraction(row.nominal_pressure);
      load.gap += row.mean_gap / height;
      load.theory_gap += theory.gap(row.nominal_pressure) / height;
      load.contact_nodes +=
          surface == nullptr
              ? not_a_number
              : row.area_fraction * static_cast<double>(surface->grid.size());
      ++load.count;
    }
  }
  std::vector<ComparedLoad> list;
  list.reserve(loads.size());
  for (const auto& [step, load] : loads)
    list.push_back(load);
  return list;
}

std::string pressure_text(const ComparedLoad& load, double contact_modulus) {
  const double pressure = load.pressure / load.count;
  return fmt::format("p = {} ({} E*)", quantity_text(pressure, "Pa", 3),
                     digits_text(pressure / contact_modulus, 3));
}

/// Sentences on what the block has and the theory's half-space has not.
std::string block_causes(const Comparison& compared) {
  const cases::MethodSpec* const spec =
      spec_of(compared.contact_case, compared.method);
  if (spec == nullptr)
    return "";
  const auto* const halfspace =
      std::get_if<mechanics::HalfspaceSettings>(&spec->settings);
  const auto* const fem = std::get_if<mechanics::FemSettings>(&spec->settings);
  const mechanics::MaterialSpec& material = compared.contact_case.material;
  std::string causes;
  if (!material.layers.empty() && spec->uses_layers())
    causes += " The theory assumes the uniform material below the layers, "
              "which this method takes into account.";
  if (fem != nullptr && (material.inclusion || material.variation))
    causes += " The theory assumes a uniform material, which this block is "
              "not.";
  if (halfspace != nullptr && !halfspace->block().is_infinite())
    causes += " The theory assumes a half-space, but this block has a finite "
              "thickness.";
  if (std::holds_alternative<mechanics::WinklerSettings>(spec->settings))
    causes += " The theory assumes an elastic half-space, not independent "
              "springs.";
  if (has_free_boundaries(compared.contact_case, compared.method))
    causes += " The theory assumes an endless surface, but this one is pressed "
              "once, without its continuation.";
  return causes;
}

std::string causes_of(const Comparison& compared, const ComparedLoad& load,
                      std::span<const Warning> others) {
  std::string causes = block_causes(compared);
  const auto has = [&](const char* kind) {
    return std::ranges::find(others, kind, &Warning::kind) != others.end();
  };
  if (has("not_gaussian"))
    causes += " The theory assumes Gaussian heights, which this surface does "
              "not have.";
  if (has("scan_lines"))
    causes += " The theory assumes the same roughness in all directions, which "
              "this map does not have.";
  if (has("not_resolved"))
    causes += " The shortest waves, which determine the area, are not resolved "
              "by the points of the surface.";
  if (load.contact_nodes < fewest_contact_nodes)
    causes += fmt::format(" Only about {:.0f} points touch at this load: few "
                          "asperities of a finite surface, instead of the "
                          "theory's mean over an endless one.",
                          load.contact_nodes);
  return causes.empty() ? " None of the assumptions that a report tests is "
                          "violated (docs/numerics/surfaces.md)."
                        : causes;
}

void add_area(const Comparison& compared,
              const std::vector<ComparedLoad>& loads,
              std::span<const Warning> others, std::vector<Warning>& warnings) {
  const auto furthest =
      std::ranges::max_element(loads, {}, [](const ComparedLoad& load) {
        return load.is_outside() ? std::abs(std::log(load.area_ratio())) : 0.0;
      });
  if (furthest == loads.end() || !furthest->is_outside())
    return;
  warnings.push_back(
      {"theory_area",
       fmt::format(
           "The contact area of {} is {:.3g} times the theory's at {}: {:.3g} "
           "% instead of {:.3g} %. It is outside {:.2f} to {:.2f} times the "
           "theory's at {} of {} loads.",
           compared.method.name, furthest->area_ratio(),
           pressure_text(*furthest, compared.result.contact_modulus),
           100.0 * furthest->area / furthest->count,
           100.0 * furthest->theory_area / furthest->count,
           1.0 / largest_area_scale, largest_area_scale,
           std::ranges::count_if(loads, &ComparedLoad::is_outside),
           loads.size()),
       "The theory does not describe the contact area there." +
           causes_of(compared, *furthest, others),
       fmt::format(
           "The theory does not describe this contact: the area of {} "
           "is {} times as large at {}.",
           compared.method.name, digits_text(furthest->area_ratio(), 2),
           quantity_text(furthest->pressure / furthest->count, "Pa", 3))});
}

void add_gap(const Comparison& compared, const std::vector<ComparedLoad>& loads,
             std::span<const Warning> others, std::vector<Warning>& warnings) {
  const auto furthest =
      std::ranges::max_element(loads, {}, [](const ComparedLoad& load) {
        return load.has_other_gap() ? load.gap_difference() : 0.0;
      });
  if (furthest == loads.end() || !furthest->has_other_gap())
    return;
  warnings.push_back(
      {"theory_gap",
       fmt::format(
           "The mean gap of {} differs from the theory's by {:.2g} h_rms at "
           "{}: {:.3g} h_rms instead of {:.3g} h_rms (limit: {:g} where {:g} < "
           "u/h_rms < {:g}).",
           compared.method.name, furthest->gap_difference(),
           pressure_text(*furthest, compared.result.contact_modulus),
           furthest->gap / furthest->count,
           furthest->theory_gap / furthest->count, largest_gap_difference,
           comparison_gap_low, comparison_gap_high),
       "The theory does not describe the separation there." +
           causes_of(compared, *furthest, others),
       fmt::format(
           "The theory does not describe this mean gap: that of {} "
           "differs by {} h_rms at {}.",
           compared.method.name, digits_text(furthest->gap_difference(), 2),
           quantity_text(furthest->pressure / furthest->count, "Pa", 3))});
}

} // namespace

std::vector<Warning> theory_disagreements(const results::Result& result,
                                          const cases::Case& contact_case,
                                          std::span<const Warning> others) {
  std::vector<Warning> warnings;
  if (is_exact_shape(contact_case))
    return warnings;
  for (const MethodRecord& method : result.methods) {
    const MethodRecord* const theory =
        reference_theory(result, contact_case, method);
    if (theory == nullptr || method.kind == "theory" ||
        is_adhesive(contact_case, method) || method.realizations.empty() ||
        theory->realizations.empty())
      continue;
    const Comparison compared{result, contact_case, method, *theory};
    const std::vector<ComparedLoad> loads = compared_loads(compared);
    add_area(compared, loads, others, warnings);
    add_gap(compared, loads, others, warnings);
  }
  return warnings;
}

} // namespace asperity::reports
