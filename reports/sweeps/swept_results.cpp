#include "reports/sweeps/swept_results.hpp"

#include "base/json.hpp"
#include "input/input_error.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"
#include "results/trial_read.hpp"
#include "results/types/method_columns.hpp"
#include "surfaces/build.hpp"
#include "theory/persson/height_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <string_view>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

/// The quantities that figures show first.
constexpr std::array<std::string_view, 10> first_quantities{
    "pull_off_pressure",
    "dissipated_energy",
    "gamma_matched",
    "gamma_slope",
    "kappa",
    "area_scale",
    "area_scale_corrected",
    "beta",
    "gamma_curve",
    "gamma_energy"};

std::optional<SpectrumPoint>
spectrum_point(const mechanics::SurfaceSpec& surface) {
  if (surface.kind != mechanics::SurfaceKind::self_affine || !surface.length ||
      !surface.points)
    return std::nullopt;
  const surfaces::IsotropicSpectrum formula =
      surfaces::formula_spectrum(surface);
  const theory::ProfileMoments& moments =
      theory::HeightSpectrum(
          theory::SpectrumFormula{formula.density, formula.kinks})
          .profile_moments();
  const double cycle = 2.0 * std::numbers::pi;
  return SpectrumPoint{
      surface.hurst, surface.wavevector_high / surface.wavevector_roll_off,
      *surface.length * surface.wavevector_roll_off / cycle,
      cycle * *surface.points / (surface.wavevector_high * *surface.length),
      moments.height * moments.curvature / (moments.slope * moments.slope)};
}

std::vector<SweptCurve> curves_of(const results::Result& result) {
  std::vector<SweptCurve> curves;
  for (const results::MethodRecord& method : result.methods) {
    SweptCurve& curve = curves.emplace_back(SweptCurve{.method = method.name});
    if (const auto* const surface = surface_of(result, method, 0))
      curve.rms_height = surface->rms_height;
    if (method.realizations.size() == 1)
      for (const results::CurvePoint& row : method.realizations.front().points)
        if (row.status == results::StepStatus::converged)
          curve.rows.push_back(row);
  }
  return curves;
}

std::vector<AnswerColumn> answer_columns(const cases::Case& contact_case) {
  std::vector<AnswerColumn> found;
  if (std::ranges::any_of(contact_case.methods, [](const auto& method) {
        return method.hardness().has_value();
      }))
    found.push_back({&columns::plastic_area, "Area that yields", "elastic"});
  for (const StudyPages* const study : study_pages())
    if (study->answer_columns != nullptr)
      std::ranges::move(study->answer_columns(contact_case),
                        std::back_inserter(found));
  return found;
}

std::unique_ptr<SweptResult> read_point(const SweepRecord& record,
                                        std::size_t point,
                                        const std::filesystem::path& folder,
                                        bool is_trusted) {
  auto swept = std::make_unique<SweptResult>();
  swept->point = point;
  swept->status = "missing";
  swept->problem = record.points[point].problem;
  const std::filesystem::path file = folder / "result.h5";
  if (!std::filesystem::exists(file)) {
    if (swept->problem.empty())
      swept->problem = "has not run yet";
    return swept;
  }
  try {
    if (!is_trusted)
      results::require_readable(file);
    const results::Result result =
        results::read_result(file, results::MapsInFile::large);
    if (result.case_hash != record.points[point].case_hash) {
      swept->problem = "its folder has the result of another case";
      return swept;
    }
    const cases::Case contact_case = case_of(result);
    ReportEntry entry = entry_of(result, contact_case);
    swept->spectrum = spectrum_point(contact_case.surface);
    swept->series = series_of({&entry, 1});
    swept->contact_modulus = result.contact_modulus;
    if (has_samples(record)) {
      swept->curves = curves_of(result);
      swept->answers = answer_columns(contact_case);
    }
    swept->summary = std::move(entry.summary);
    for (Series& series : swept->series) // the methods moved with the summary
      series.method = method_called(swept->summary.methods, series.label);
    swept->status = result.status;
    if (result.status != "complete" && swept->problem.empty())
      swept->problem = "is not complete (" + result.status + ")";
  } catch (const input::InputError& error) {
    swept->problem = error.what();
  }
  return swept;
}

/// Returns the verdict on a quantity of a method; "" if nothing is expected of
/// it.
std::string verdict_word(const Summary& summary, const std::string& method,
                         const std::string& quantity) {
  for (const Verdict& verdict : summary.verdicts)
    if (verdict.method == method && verdict.quantity == quantity)
      return outcome_word(verdict.outcome);
  return "";
}

Json quantities_json(const Summary& summary) {
  Json methods = Json::object();
  for (const MethodSummary& method : summary.methods)
    for (const auto& [name, estimate] : method.quantities)
      methods[method.name][name] = {{"value", estimate.value},
                                    {"half_width_95", estimate.half_width},
                                    {"realizations", estimate.realizations},
                                    {"remark", estimate.remark}};
  return methods;
}

} // namespace

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == text.npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"')
      quoted += '"';
    quoted += letter == '\n' || letter == '\r' ? ' ' : letter;
  }
  return quoted + "\"";
}

std::string csv_number(double number) {
  return std::isfinite(number) ? fmt::format("{:.10g}", number) : "nan";
}

bool has_samples(const SweepRecord& record) {
  return record.keys.size() == 1 &&
         (record.keys.front().key == "surface.file" ||
          record.keys.front().key == "surface.seed");
}

SweptResults read_swept_results(const SweepRecord& record,
                                const std::filesystem::path& folder,
                                bool is_trusted) {
  SweptResults all;
  for (std::size_t i = 0; i < record.points.size(); ++i)
    all.push_back(read_point(record, i, folder / point_folder(i), is_trusted));
  return all;
}

std::vector<std::string> swept_quantities(const SweptResults& results) {
  std::set<std::string> found;
  for (const auto& result : results)
    for (const MethodSummary& method : result->summary.methods)
      for (const auto& [name, estimate] : method.quantities)
        found.insert(name);
  std::vector<std::string> ordered;
  const auto put = [&](const std::string& name) {
    if (found.erase(name) > 0)
      ordered.push_back(name);
  };
  for (const auto& result : results)
    for (const Verdict& verdict : result->summary.verdicts)
      put(verdict.quantity);
  for (const std::string_view name : first_quantities)
    put(std::string(name));
  ordered.insert(ordered.end(), found.begin(), found.end());
  return ordered;
}

std::vector<std::string> swept_methods(const SweptResults& results) {
  std::vector<std::string> names;
  for (const auto& result : results)
    for (const MethodSummary& method : result->summary.methods)
      if (std::ranges::find(names, method.name) == names.end())
        names.push_back(method.name);
  return names;
}

const Estimate* swept_estimate(const SweptResult& result,
                               const std::string& method,
                               const std::string& quantity) {
  const MethodSummary* const found =
      method_called(result.summary.methods, method);
  return found == nullptr ? nullptr : found->quantity(quantity);
}

std::string sweep_csv(const SweepRecord& record, const SweptResults& results) {
  std::string text = "point";
  for (const cases::SweptKey& key : record.keys)
    text += "," + csv_cell(key.key);
  text += ",status,method,quantity,value,half_width_95,realizations,verdict,"
          "remark\n";
  for (const auto& result : results) {
    std::string head = std::to_string(result->point);
    for (std::size_t k = 0; k < record.keys.size(); ++k)
      head +=
          "," +
          csv_cell(value_label(
              record.keys[k].values[record.points[result->point].choice[k]]));
    head += "," + result->status;
    if (!result->has_result())
      text += head + ",,,nan,nan,0,," + csv_cell(result->problem) + "\n";
    for (const MethodSummary& method : result->summary.methods)
      for (const auto& [name, estimate] : method.quantities)
        text += fmt::format(
            "{},{},{},{},{},{},{},{}\n", head, csv_cell(method.name),
            csv_cell(name), csv_number(estimate.value),
            csv_number(estimate.half_width), estimate.realizations,
            verdict_word(result->summary, method.name, name),
            csv_cell(estimate.remark));
  }
  return text;
}

std::string sweep_json(const SweepRecord& record, const SweptResults& results) {
  Json json = record_json(record);
  for (const auto& result : results) {
    Json& point = json["points"][result->point];
    point["status"] = result->status;
    point["all_ok"] = result->has_result() && result->summary.all_ok();
    point["methods"] = quantities_json(result->summary);
    Json verdicts = Json::array();
    for (const Verdict& verdict : result->summary.verdicts)
      verdicts.push_back({{"quantity", verdict.quantity},
                          {"method", verdict.method},
                          {"verdict", outcome_word(verdict.outcome)},
                          {"line", check_line(verdict)}});
    point["expectations"] = verdicts;
  }
  return text_of_json(json, 2) + "\n";
}

} // namespace asperity::reports
