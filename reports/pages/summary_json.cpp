#include "base/json.hpp"
#include "reports/analysis/claims.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/numbers/determined.hpp"
#include "reports/pages/published_json.hpp"

#include <cmath>
#include <initializer_list>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Estimate& estimate) {
  return {{"value", estimate.value},
          {"half_width_95", estimate.half_width},
          {"realizations", estimate.realizations},
          {"remark", estimate.remark}};
}

Json to_json(const Window& window) {
  return {{"mean_gap_low [m]", window.gap_low},
          {"mean_gap_high [m]", window.gap_high},
          {"nominal_pressure_low [Pa]", window.pressure_low},
          {"nominal_pressure_high [Pa]", window.pressure_high},
          {"largest_deviation [h_rms]", window.largest_deviation},
          {"tolerance [h_rms]", window.tolerance},
          {"points", window.points}};
}

// A number that is not a result is represented by its reason only, as a fit is.
Json to_json(const FittedValue& fitted, const MeaningfulRange& range) {
  const FittedValue shown = determined(fitted, range);
  if (!std::isfinite(shown.value))
    return {{"value", nullptr}, {"reason", shown.reason}};
  return {{"value", shown.value},
          {"standard_error", shown.standard_error},
          {"degrees_of_freedom", shown.degrees_of_freedom}};
}

struct Named {
  const char* name;
  const FittedValue& fitted;
  MeaningfulRange range;
};

// A fit without a result is represented by its reason only.
template <class Fit>
Json fit_json(const Fit& fit, std::initializer_list<Named> numbers) {
  if (!fit.reason.empty())
    return {{"reason", fit.reason}};
  Json json;
  for (const Named& one : numbers)
    json[one.name] = to_json(one.fitted, one.range);
  json["window"] = to_json(fit.window);
  return json;
}

Json to_json(const RealizationFits& fits, bool is_theory) {
  Json json = {
      {"rms_height [m]", fits.scales.rms_height},
      {"rms_slope [1]", fits.scales.rms_slope},
      {"asymptotic_slope (18)", fits.asymptotic_slope},
      {"slope", fit_json(fits.slope,
                         {{"gamma_slope", fits.slope.gamma_slope, gamma_range},
                          {"beta", fits.slope.beta, positive_range}})},
      {"area", fit_json(fits.area, {{"kappa", fits.area.kappa, positive_range},
                                    {"kappa_counted", fits.area.kappa_counted,
                                     positive_range}})}};
  if (!is_theory) {
    json["matched"] = fit_json(
        fits.matched, {{"gamma_matched", fits.matched.gamma, gamma_range}});
    json["curve"] =
        fit_json(fits.curve, {{"gamma_curve", fits.curve.gamma, gamma_range}});
    json["energy"] = fit_json(
        fits.energy, {{"gamma_energy", fits.energy.gamma, gamma_range}});
  }
  return json;
}

Json to_json(const Cost& cost) {
  return {{"steps", cost.steps},
          {"failed_steps", cost.failed_steps},
          {"largest_iterations", cost.largest_iterations},
          {"cpu_time [s]", cost.cpu_time},
          {"setup_cpu_time [s]", cost.setup_cpu_time},
          {"median_step_cpu_time [s]", cost.step_cpu_time}};
}

Json to_json(const Certified& certified) {
  return {{"steps", certified.steps},
          {"certified_steps", certified.bounds.steps},
          {"largest_gap_error [h_rms]", certified.bounds.largest},
          {"at_nominal_pressure [Pa]", certified.bounds.pressure}};
}

Json to_json(const ErrorsOfSteps& estimates) {
  return {{"steps", estimates.steps},
          {"largest_gap_error_estimate [h_rms]", estimates.largest},
          {"at_nominal_pressure [Pa]", estimates.pressure}};
}

Json to_json(const MethodSummary& method) {
  Json json = {{"name", method.name},
               {"kind", method.kind},
               {"description", method.description},
               {"quantities", Json::object()},
               {"fits", Json::array()},
               {"cost", to_json(method.cost)},
               {"certified", to_json(method.certified)}};
  if (method.certified.estimates.steps > 0)
    json["estimated"] = to_json(method.certified.estimates);
  for (const auto& [name, estimate] : method.quantities)
    json["quantities"][name] = to_json(estimate);
  for (const RealizationFits& fits : method.fits)
    json["fits"].push_back(to_json(fits, method.kind == "theory"));
  if (!method.omissions.empty())
    json["omissions"] = method.omissions;
  if (!method.problems.empty())
    json["problems"] = method.problems;
  return json;
}

Json to_json(const Verdict& verdict) {
  return {{"quantity", verdict.quantity},
          {"method", verdict.method},
          {"value", verdict.estimate.value},
          {"half_width_95", verdict.estimate.half_width},
          {"low", verdict.low},
          {"high", verdict.high},
          {"verdict", outcome_word(verdict.outcome)},
          {"remark", verdict.estimate.remark},
          {"line", check_line(verdict)},
          {"band", band_text(verdict.low, verdict.high)},
          {"meaning", meaning_of(verdict.quantity)}};
}

} // namespace

std::string summary_json(const Summary& summary) {
  return text_of_json(summary_data(summary, {}), 2) + "\n";
}

Json summary_data(const Summary& summary, std::span<const Warning> warnings) {
  Json json = {{"format", "asperity-summary"},
               {"format_version", 1},
               {"case", summary.case_name},
               {"title", summary.case_title},
               {"case_hash", summary.case_hash},
               {"status", summary.status},
               {"reference_theory", summary.reference_method},
               {"all_ok", summary.all_ok()},
               {"answers", summary.answers},
               {"interval_parts", Json::array()},
               {"warnings", Json::array()},
               {"expectations", Json::array()},
               {"published", Json::array()},
               {"methods", Json::array()},
               {"provenance", Json::object()}};
  for (const IntervalPart& part : summary.interval_parts)
    json["interval_parts"].push_back({{"name", part.name},
                                      {"is_known", part.is_known},
                                      {"text", part.text}});
  for (const Warning& warning : warnings)
    json["warnings"].push_back({{"kind", warning.kind},
                                {"line", warning.line},
                                {"headline", warning.headline},
                                {"consequence", warning.consequence}});
  for (const Verdict& verdict : summary.verdicts)
    json["expectations"].push_back(to_json(verdict));
  for (const PublishedValue& published : summary.published)
    json["published"].push_back(published_json(published));
  for (const MethodSummary& method : summary.methods)
    json["methods"].push_back(to_json(method));
  for (const auto& [key, fact] : summary.provenance)
    json["provenance"][key] = fact;
  return json;
}

} // namespace asperity::reports
