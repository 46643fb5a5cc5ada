#include "base/json.hpp"
#include "base/shown_number.hpp"
#include "reports/numbers/determined.hpp"
#include "reports/pages/html_report.hpp"
#include "reports/pages/methods_text.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

// Sets the cell of one fitted number. If there is none, the reason is added to
// `reasons`.
void set_fitted(Json& row, const char* column, const char* name,
                const FittedValue& fitted, const MeaningfulRange& range,
                std::vector<std::string>& reasons) {
  const FittedValue shown = determined(fitted, range);
  const bool has_value = std::isfinite(shown.value);
  row[column] =
      has_value ? fmt::format("{:.3g}", Shown{shown.value}) : undetermined_word;
  if (!has_value && !shown.reason.empty())
    reasons.push_back(fmt::format("{}: {}", name, shown.reason));
}

Json fit_row(const Series& series, std::size_t realization,
             const RealizationFits& fits) {
  const Window& window = fits.slope.window;
  Json row = {{"method", series.label}, {"realization", realization}};
  std::vector<std::string> reasons;
  for (const std::string& reason :
       {fits.slope.reason, fits.matched.reason, fits.curve.reason,
        fits.energy.reason, fits.area.reason})
    if (!reason.empty() &&
        std::find(reasons.begin(), reasons.end(), reason) == reasons.end())
      reasons.push_back(reason);
  set_fitted(row, "slope", "u₀/h_rms", fits.slope.gamma_slope, gamma_range,
             reasons);
  set_fitted(row, "beta", "β", fits.slope.beta, positive_range, reasons);
  set_fitted(row, "kappa", "κ", fits.area.kappa, positive_range, reasons);
  set_fitted(row, "kappa_counted", "κ, counted", fits.area.kappa_counted,
             positive_range, reasons);
  if (series.is_theory())
    for (const char* name : {"gamma_matched", "gamma", "gamma_energy"})
      row[name] = "–"; // prescribed by the case
  else {
    set_fitted(row, "gamma_matched", "γ by the slope", fits.matched.gamma,
               gamma_range, reasons);
    set_fitted(row, "gamma", "γ by the curve", fits.curve.gamma, gamma_range,
               reasons);
    set_fitted(row, "gamma_energy", "γ by the energy", fits.energy.gamma,
               gamma_range, reasons);
  }
  row["asymptote"] = fits.asymptotic_slope;
  const double height = fits.scales.rms_height;
  if (window.points > 0)
    row["window"] = {
        {"words", fmt::format("{:.2f} … {:.2f}", Shown{window.gap_low / height},
                              Shown{window.gap_high / height})},
        {"rows", window.points},
        {"deviation",
         fmt::format("{:.2g} of {:.2g}", 100.0 * window.largest_deviation,
                     100.0 * window.tolerance)}};
  else
    row["window"] = {{"words", "–"}, {"rows", "–"}, {"deviation", "–"}};
  row["reason"] = fmt::format("{}", fmt::join(reasons, "; "));
  return row;
}

/// Splits the note of a load step into its parts.
std::vector<std::string> parts_of(const std::string& note) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start < note.size();) {
    const std::size_t end = std::min(note.find("; ", start), note.size());
    parts.push_back(note.substr(start, end - start));
    start = end + 2;
  }
  return parts;
}

/// True if the part is listed in the table of quantities that are not
/// determined.
bool is_of_observable(const std::string& part) {
  return part.find(" is not determined: ") != std::string::npos;
}

/// Lists the observables that are NaN, with the reason and the number of steps.
Json undetermined_rows(std::span<const ReportEntry> entries) {
  std::map<std::pair<std::string, std::string>, int> steps;
  for (const ReportEntry& entry : entries)
    for (const results::MethodRecord& method : entry.result->methods)
      for (const results::CurvePoint& point : method.rows())
        for (const std::string& part : parts_of(point.note))
          if (is_of_observable(part))
            ++steps[{method.name, part}];
  Json rows = Json::array();
  for (const auto& [key, count] : steps)
    rows.push_back(
        {{"method", key.first}, {"what", key.second}, {"steps", count}});
  return rows;
}

Json fit_rows(std::span<const Series> series) {
  Json rows = Json::array();
  for (const Series& one : series)
    for (std::size_t r = 0; r < one.method->fits.size(); ++r)
      rows.push_back(fit_row(one, r, one.method->fits[r]));
  return rows;
}

/// Lists the steps that did not converge, or those that converged but have a
/// note, because a fallback of the method produced the solution.
Json noted_step_rows(std::span<const ReportEntry> entries, bool converged) {
  Json rows = Json::array();
  for (const ReportEntry& entry : entries)
    for (const results::MethodRecord& method : entry.result->methods)
      for (std::size_t r = 0; r < method.realizations.size(); ++r)
        for (const results::CurvePoint& point : method.realizations[r].points) {
          const bool has_converged =
              point.status == results::StepStatus::converged;
          const std::vector<std::string> parts = parts_of(point.note);
          const bool says_more =
              !std::all_of(parts.begin(), parts.end(), is_of_observable);
          if (has_converged != converged || (converged && !says_more))
            continue;
          rows.push_back({{"method", method.name},
                          {"realization", r},
                          {"step", point.step},
                          {"pressure", point.nominal_pressure /
                                           entry.result->contact_modulus},
                          {"residual", point.residual},
                          {"note", point.note}});
        }
  return rows;
}

std::vector<std::string> names_of(std::span<const ReportEntry> entries) {
  std::vector<std::string> names;
  names.reserve(entries.size());
  for (const ReportEntry& entry : entries)
    names.push_back(entry.summary.case_name);
  return names;
}

} // namespace

Json report_page(std::span<const ReportEntry> entries,
                 std::span<const Json> summaries,
                 std::span<const DrawnGroup> groups) {
  const std::vector<Series> series = series_of(entries);
  const bool has_many = entries.size() > 1;
  Json page = {{"page_title",
                has_many
                    ? fmt::format("{} results compared: {}", entries.size(),
                                  fmt::join(names_of(entries), "; "))
                    : entries.front().summary.case_title},
               {"is_one_of_many", has_many},
               {"entries", Json::array()},
               {"methods_text", methods_text(entries).paragraphs},
               {"fits", fit_rows(series)},
               {"failed_steps", noted_step_rows(entries, false)},
               {"undetermined", undetermined_rows(entries)},
               {"noted_steps", noted_step_rows(entries, true)}};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    page["entries"].push_back(entry_page(entries[i], summaries[i], series));
    if (has_many)
      page["entries"][i]["suffix"] = fmt::format("-{}", i + 1);
  }
  set_groups(page, groups);
  if (has_many)
    page["agreements"] = agreement_json(agreements_of(entries, series));
  for (Json& agreement : page["agreements"]) { // of none: null
    page["agreement_reference"] = agreement["reference"];
    agreement["loads"] = agreement["rows"].size();
  }
  page["contents"] = contents_of(page);
  return page;
}

} // namespace asperity::reports
