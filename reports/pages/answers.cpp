#include "reports/pages/answers.hpp"

#include "base/json.hpp"
#include "base/special_numbers.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/exact.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/analysis/surface_theory.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/study_pages.hpp"
#include "results/types/method_columns.hpp"
#include "surfaces/analysis/contact_fitness.hpp"
#include "surfaces/inner_roughness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace asperity::reports {
namespace {

/// One load step over the realisations of a method.
struct PhysicalLoad {
  double pressure = 0.0; ///< mean of the realisations [Pa]
  Estimate area;         ///< A/A_0, corrected where the method corrects it
  Estimate gap;          ///< [m]
  double plastic = not_a_number; ///< share of A_0 at the hardness [1]
  HalfWidths errors = {};        ///< with the spread of the realisations
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
std::vector<PhysicalLoad> physical_loads(const results::MethodRecord& method,
                                         const AskedIntervals& intervals) {
  struct Step {
    std::vector<FittedValue> pressures, areas, gaps, plastic;
    std::vector<FittedValue> area_errors, gap_errors;
    bool is_complete = true; ///< whether all realisations converged
  };

  const AreaColumn area = best_area(method);
  std::map<int, Step> steps;
  for (const results::CurvePoint& row : method.rows()) {
    if (row.is_unloading)
      continue;
    Step& step = steps[row.step];
    step.is_complete = step.is_complete &&
                       row.status == results::StepStatus::converged &&
                       std::isfinite(row.nominal_pressure + row.mean_gap);
    step.pressures.push_back({.value = row.nominal_pressure});
    // Where a node has yielded, the area is only counted.
    const bool is_corrected =
        row.area_fraction > 0.0 && std::isfinite(row[*area]);
    step.areas.push_back(
        {.value = is_corrected ? row[*area] : row.area_fraction});
    step.gaps.push_back({.value = row.mean_gap});
    step.plastic.push_back({.value = row[columns::plastic_area]});
    const HalfWidths errors = intervals.of(row);
    step.area_errors.push_back({.value = errors.area});
    step.gap_errors.push_back({.value = errors.gap});
  }
  std::vector<PhysicalLoad> loads;
  for (const auto& [step, numbers] : steps) {
    const double pressure = mean_over_realizations(numbers.pressures).value;
    if (!numbers.is_complete || !(pressure > 0.0))
      continue;
    const auto mean = [](const std::vector<FittedValue>& values) {
      return mean_over_realizations(values);
    };
    const auto spread = [](const Estimate& one) {
      return one.has_interval() ? one.half_width : 0.0;
    };
    PhysicalLoad load{pressure, mean(numbers.areas), mean(numbers.gaps),
                      mean(numbers.plastic).value};
    load.errors = {mean(numbers.area_errors).value + spread(load.area),
                   mean(numbers.gap_errors).value + spread(load.gap)};
    loads.push_back(std::move(load));
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

/// Of the work of adhesion, that faces lose on the way in and back if they
/// stick: without a jump the way back is the way there.
constexpr double least_loss = 0.01;

/// Whether the faces stick, by what a closed path loses and otherwise by the
/// criterion: the sentence of a method with adhesion, else "".
std::string adhesive_sentence(const ReportEntry& entry,
                              const results::MethodRecord& method) {
  const cases::Case& contact_case = *entry.contact_case;
  const MethodSummary* const summary =
      method_called(entry.summary.methods, method.name);
  const results::SurfaceRecord* const surface =
      surface_of(*entry.result, method, 0);
  const auto law = adhesion_of(*entry.result, contact_case, method);
  if (!law || summary == nullptr)
    return "";
  const double modulus = entry.result->contact_modulus;
  const double criterion = stickiness(
      *law, modulus, judged_roughness(contact_case, method, *surface));
  const bool is_judged = std::isfinite(criterion) && criterion > 0.0;
  const Estimate* const tension = summary->quantity("pull_off_pressure");
  const Estimate* const loss = summary->quantity("dissipated_energy");
  const bool is_pulled = tension != nullptr && tension->has_value();
  std::string bound;
  for (const results::Curve& curve : method.realizations)
    bound = bound.empty() ? why_more_may_hold(converged_rows(curve)) : bound;
  // A path without tension comes back to the contact where it began, and one
  // that does not pass the largest tension has not parted the faces.
  double lost = is_pulled && loss != nullptr ? loss->value : not_a_number;
  if (!bound.empty() && !(lost >= least_loss))
    lost = not_a_number;
  std::string words =
      std::isfinite(lost)
          ? lost >= least_loss ? "It sticks" : "It does not stick"
      : !is_judged       ? "The faces attract"
      : criterion >= 1.0 ? "It does not stick"
                         : "It sticks";
  if (lost >= least_loss)
    words += fmt::format(": {} % of the work of adhesion is lost on the way in "
                         "and back",
                         digits_text(100.0 * lost, 2));
  const std::string joint = lost >= least_loss ? ", and" : ":";
  if (is_pulled)
    words += joint + " the largest tension is " +
             (bound.empty() ? "" : "at least ") +
             pressure_in_pascal(tension->value * modulus) +
             (bound.empty() ? "" : ", " + bound);
  else if (tension != nullptr)
    words +=
        joint + " the largest tension is not known, because " + tension->remark;
  words += fmt::format(" (adhesion of {} mJ/m² over {}",
                       digits_text(1e3 * law->work_of_adhesion, 3),
                       quantity_text(law->adhesion_range, "m", 3));
  if (is_judged)
    words +=
        fmt::format("; criterion of Pastewka and Robbins {}, below 1 where "
                    "faces stick",
                    digits_text(criterion, 3));
  return words + ").";
}

/// What has yielded under the heaviest load; "" without a hardness.
std::string plastic_sentence(const ReportEntry& entry,
                             const results::MethodRecord& method,
                             const PhysicalLoad& load) {
  const cases::MethodSpec* const spec = spec_of(*entry.contact_case, method);
  if (spec == nullptr || !spec->hardness() || !std::isfinite(load.plastic))
    return "";
  const std::string hardness = pressure_in_pascal(spec->hardness()->in_si(
      {.contact_modulus = entry.result->contact_modulus}));
  return load.plastic > 0.0
             ? fmt::format("Yields: {} % of the area at {}, under {}.",
                           digits_text(100.0 * load.plastic, 3), hardness,
                           pressure_in_pascal(load.pressure))
             : fmt::format("Nothing yields up to {}, by a hardness of {}.",
                           pressure_in_pascal(load.pressure), hardness);
}

/// "33 nm (32 to 34)". In complete contact the gap of the continuum is below
/// all that its atoms know.
std::string gap_text(const PhysicalLoad& load) {
  constexpr double least = 1e-12; // [m]
  const double gap = load.gap.value;
  return std::abs(gap) < least ? "below 0.001 nm"
                               : interval_text(gap, gap - load.errors.gap,
                                               gap + load.errors.gap, "m");
}

/// "At 1 MPa 2.3 % (2.1 to 2.5) of the area touches and the mean gap is 33 nm
/// (32 to 34)": the words of further loads are fewer.
std::string load_sentence(const PhysicalLoad& load, bool is_first) {
  const double area = load.area.value;
  const double area_error = load.errors.area;
  return fmt::format(
      fmt::runtime(is_first ? "At {} {} of the area touches and the mean gap "
                              "is {}"
                            : "at {} {} and {}"),
      pressure_in_pascal(load.pressure),
      interval_text(area, std::max(0.0, area - area_error),
                    std::min(1.0, area + area_error), "%"),
      gap_text(load));
}

/// The lightest, a middle and the heaviest load in one sentence.
std::string contact_sentence(const std::vector<PhysicalLoad>& loads,
                             const std::string& method) {
  std::string words = load_sentence(loads.front(), true);
  if (loads.size() > 2)
    words += "; " + load_sentence(loads[loads.size() / 2], false);
  if (loads.size() > 1)
    words += "; " + load_sentence(loads.back(), false);
  return words + method + ".";
}

/// "Nothing touches down to a mean gap of 25 nm." of gaps that reach no
/// contact;
/// "" where a load presses or pulls.
std::string open_sentence(const results::MethodRecord& method) {
  double smallest = infinity;
  for (const results::CurvePoint& row : method.rows()) {
    if (row.area_fraction > 0.0 || row.nominal_pressure != 0.0)
      return "";
    smallest = std::fmin(smallest, row.mean_gap);
  }
  return std::isfinite(smallest)
             ? fmt::format("Nothing touches down to a mean gap of {}.",
                           quantity_text(smallest, "m", 3))
             : "";
}

/// Whether a measured map is good enough; "" for other surfaces.
std::string map_sentence(const ReportEntry& entry) {
  const results::SurfaceRecord& surface = entry.result->surfaces.front();
  if (entry.result->case_text.empty() || surface.spectrum.empty() ||
      entry.contact_case->surface.kind != mechanics::SurfaceKind::measured)
    return "";
  const double area = nominal_area(*entry.result);
  const auto rings = spectrum_rings(surface, area);
  const auto floor = noise_floor_of(rings, surface.grid, area);
  const Grid grid = surface.map_grid();
  return surfaces::fitness_sentence(surfaces::contact_fitness(
      rings, floor ? std::optional(floor->wavevector) : std::nullopt,
      std::max(grid.spacing_x(), grid.spacing_y()),
      std::min(grid.length_x, grid.length_y)));
}

bool has_surface(const ReportEntry& entry) {
  return !entry.result->surfaces.empty();
}

} // namespace

nlohmann::ordered_json contact_against_load(const ReportEntry& entry) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const results::MethodRecord* const method = main_method(*entry.result);
  if (method == nullptr || !has_surface(entry))
    return rows;
  const double nominal = nominal_area(*entry.result);
  const AskedIntervals intervals(*entry.result, *entry.contact_case, *method);
  const auto number = [](const Estimate& estimate, double error, double scale) {
    return nlohmann::ordered_json{
        {"value", estimate.value * scale},
        {"half_width_95", estimate.half_width * scale},
        {"error", error * scale}};
  };
  for (const PhysicalLoad& load : physical_loads(*method, intervals))
    rows.push_back(
        {{"nominal_pressure [Pa]", load.pressure},
         {"load [N]", load.pressure * nominal},
         {"area_fraction", number(load.area, load.errors.area, 1.0)},
         {"area [m^2]", number(load.area, load.errors.area, nominal)},
         {"mean_gap [m]", number(load.gap, load.errors.gap, 1.0)}});
  return rows;
}

std::string method_in_words(const ReportEntry& entry,
                            const results::MethodRecord& method) {
  const auto computed =
      std::ranges::count_if(entry.result->methods, [](const auto& one) {
        return one.kind != "theory" && !one.realizations.empty();
      });
  return computed == 1 && method.kind != "theory" ? ""
                                                  : " (" + method.name + ")";
}

std::vector<std::string> answers_of(const ReportEntry& entry) {
  std::vector<std::string> answers;
  const auto add = [&answers](std::string sentence) {
    if (!sentence.empty())
      answers.push_back(std::move(sentence));
  };
  const results::MethodRecord* const method = main_method(*entry.result);
  if (method != nullptr && has_surface(entry)) {
    const AskedIntervals intervals(*entry.result, *entry.contact_case, *method);
    const std::vector<PhysicalLoad> loads = physical_loads(*method, intervals);
    if (!loads.empty()) {
      add(contact_sentence(loads, method_in_words(entry, *method)));
      add(plastic_sentence(entry, *method, loads.back()));
    }
    add(open_sentence(*method));
    add(adhesive_sentence(entry, *method));
  }
  for (const StudyPages* const study : study_pages())
    if (study->answer != nullptr)
      add(study->answer(entry));
  if (has_surface(entry))
    add(map_sentence(entry));
  return answers;
}

std::vector<std::string> curve_answers(const ReportEntry& curve,
                                       const ReportEntry& beside) {
  std::vector<std::string> answers;
  const MethodSummary& summary = curve.summary.methods.front();
  const Estimate* const by_curve = summary.quantity("gamma_curve");
  const Estimate* const by_slope = summary.quantity("gamma_matched");
  if (by_curve != nullptr && by_slope != nullptr &&
      (by_curve->has_value() || by_slope->has_value()))
    answers.push_back(
        fmt::format("On the surface of {}, γ of this curve is {} by the whole "
                    "curve and {} by its slope.",
                    beside.summary.case_name, number_text(*by_curve),
                    number_text(*by_slope)));
  const results::Curve& mine =
      curve.result->methods.front().realizations.front();
  const double height = curve.result->surfaces.front().rms_height;
  std::string words;
  for (const results::MethodRecord& method : beside.result->methods) {
    if (method.realizations.empty())
      continue;
    const CurveDistance distance = distance_from(mine.points, method);
    std::string far;
    if (std::isfinite(distance.gap))
      far = fmt::format("{} h_rms of the mean gap",
                        digits_text(distance.gap / height, 2));
    if (std::isfinite(distance.area))
      far += (far.empty() ? "" : " and ") +
             quantity_text(distance.area, "%", 2) + " of the area";
    if (!far.empty())
      words += (words.empty() ? "Its largest distance from " : "; from ") +
               method.name + " is " + far;
  }
  if (!words.empty())
    answers.push_back(words + ".");
  return answers;
}

std::vector<IntervalPart> interval_parts(const ReportEntry& entry) {
  const results::MethodRecord* const method = main_method(*entry.result);
  if (method == nullptr || !has_surface(entry))
    return {};
  const AskedIntervals intervals(*entry.result, *entry.contact_case, *method);
  return physical_loads(*method, intervals).empty()
             ? std::vector<IntervalPart>()
             : intervals.parts();
}

} // namespace asperity::reports
