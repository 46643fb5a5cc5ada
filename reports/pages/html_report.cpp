#include "base/json.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/study_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

// A column of the table of methods.
struct Column {
  const char* quantity;
  const char* head;
  const char* unit;
  bool is_percent;
};

const std::vector<Column>& columns_of(bool is_exact) {
  static const std::vector<Column> rough{
      {"gamma_slope", "u₀/h_rms", "slope of ln p(u)", false},
      {"gamma_matched", "γ",
       "parameter of Eq. (10) of Yang and Persson (2008), by the slope", false},
      {"gamma_curve", "γ", "by the whole curve", false},
      {"gamma_energy", "γ", "by the energy", false},
      {"kappa", "κ", "of the corrected area", false},
      {"gap_deviation", "u against theory", "largest, in h_rms", true},
      {"area_excess", "area against theory", "counted, light load", true},
      {"pull_off_pressure", "pull-off", "largest tension, in E*", false},
      {"adhesive_difference", "load at equal gap",
       "largest difference from the first method, in its pull-off pressures",
       false},
      {"dissipated_energy", "dissipated", "over the work of adhesion", false},
      {"effective_work_approach", "γ_eff, approach",
       "without load, over the work of adhesion", false},
      {"effective_work_retraction", "γ_eff, retraction",
       "without load, over the work of adhesion", false},
      {"adhesive_wave_error", "load at equal area",
       "largest error, in p* of full contact", false},
      {"adhesive_sphere_error", "load at equal area",
       "largest error against Maugis, in pull-off forces", false}};
  static const std::vector<Column> exact{
      {"mean_gap_error", "mean gap", "largest error, in amplitudes", false},
      {"area_error", "contact fraction", "largest error", false},
      {"contact_radius_error", "contact radius", "largest relative", false},
      {"approach_error", "approach", "largest relative", false},
      {"von_mises_error", "von Mises", "largest relative", false},
      {"von_mises_depth_error", "depth of von Mises maximum",
       "largest relative", false},
      {"partial_slip_error", "partial slip",
       "largest, over sliding displacement or contact", false},
      {"moment_error", "moment", "largest relative", false},
      {"normal_stiffness_error", "normal stiffness", "largest relative", false},
      {"tangential_stiffness_error", "tangential stiffness", "largest relative",
       false}};
  return is_exact ? exact : rough;
}

// Returns the columns for which at least one method has an estimate.
std::vector<Column> answered(std::vector<Column> columns,
                             const Summary& summary) {
  std::erase_if(columns, [&](const Column& column) {
    return std::none_of(summary.methods.begin(), summary.methods.end(),
                        [&](const MethodSummary& method) {
                          return method.quantities.contains(column.quantity);
                        });
  });
  return columns;
}

// The first screen shows the key numbers, a later table the others.
struct Columns {
  static constexpr std::size_t n_key = 3;

  std::span<const Column> key() const {
    return std::span(all).first(std::min(n_key, all.size()));
  }

  std::span<const Column> others() const {
    return std::span(all).subspan(std::min(n_key, all.size()));
  }

  std::vector<Column> all;
};

std::string remark_of(const Estimate& estimate) {
  if (estimate.has_value() && estimate.realizations > 1 &&
      estimate.has_interval())
    return fmt::format("{} realisations", estimate.realizations);
  if (estimate.has_value() && estimate.has_interval())
    return "± of the single fit";
  return estimate.remark;
}

Json cell(const std::string& text, const std::string& small) {
  return {{"text", text}, {"small", small}};
}

std::string seconds_text(double seconds) {
  return std::isfinite(seconds) ? fmt::format("{:.2g} s", seconds) : "–";
}

/// Returns the estimates of a method. The reasons why one is not determined are
/// long; they are in the table of the fits as well.
Json cells_of(const MethodSummary& method, std::span<const Column> columns,
              bool has_reasons) {
  Json cells = Json::array();
  for (const Column& column : columns) {
    const Estimate* const found = method.quantity(column.quantity);
    if (found == nullptr)
      cells.push_back(cell("–", ""));
    else
      cells.push_back(
          cell(column.is_percent ? percent_text(*found) : number_text(*found),
               has_reasons || found->has_value() ? remark_of(*found) : ""));
  }
  return cells;
}

Json method_row(const MethodSummary& method, const char* color,
                const Columns& columns) {
  std::string description = method.description;
  for (const std::string& omission : method.omissions)
    description += "; " + omission;
  Json cells = cells_of(method, columns.others(), true);
  const Cost& cost = method.cost;
  cells.push_back(
      cell(seconds_text(cost.step_cpu_time),
           fmt::format("{} in total", seconds_text(cost.cpu_time))));
  cells.push_back(
      cell(fmt::format("{} of {}", cost.steps - cost.failed_steps, cost.steps),
           cost.largest_iterations > 0
               ? fmt::format("≤ {} iterations", cost.largest_iterations)
               : ""));
  return {{"name", method.name},
          {"description", description},
          {"color", color},
          {"key_cells", cells_of(method, columns.key(), false)},
          {"cells", cells}};
}

Json heads_of(std::span<const Column> columns) {
  Json heads = Json::array();
  for (const Column& column : columns)
    heads.push_back({{"head", column.head}, {"unit", column.unit}});
  return heads;
}

/// Whether an expectation or a published value of the case is one of these.
bool states_any(const Summary& summary, std::span<const Column> columns) {
  const auto is_shown = [&](const std::string& quantity) {
    return std::ranges::find(columns, quantity, &Column::quantity) !=
           columns.end();
  };
  return std::ranges::any_of(summary.verdicts, is_shown, &Verdict::quantity) ||
         std::ranges::any_of(summary.published, is_shown,
                             [](const PublishedValue& published) {
                               return published.reference.quantity;
                             });
}

/// "Constants of the theory: u₀/h_rms, γ".
std::string heading_of(std::span<const Column> columns) {
  std::vector<std::string> names;
  for (const Column& column : columns)
    if (names.empty() || names.back() != column.head)
      names.emplace_back(column.head);
  return names.empty() ? "The methods"
                       : fmt::format("The methods: {}", fmt::join(names, ", "));
}

Json published_rows(const Summary& summary) {
  Json rows = Json::array();
  for (const PublishedValue& published : summary.published) {
    Json row = {{"quantity", published.reference.quantity},
                {"source", published.reference.source},
                {"value", published_text(published.reference)},
                {"is_exact", !(published.reference.uncertainty > 0.0)},
                {"cells", Json::array()}};
    for (const MethodSummary& method : summary.methods)
      if (!published.ours.empty()) {
        const auto found = std::find_if(
            published.ours.begin(), published.ours.end(),
            [&](const OurValue& ours) { return ours.method == method.name; });
        row["cells"].push_back(found == published.ours.end()
                                   ? cell("–", "not computed")
                                   : cell(number_text(found->estimate),
                                          remark_of(found->estimate)));
      }
    if (published.ours.empty())
      row["not_computed"] = summary.methods.size();
    rows.push_back(row);
  }
  return rows;
}

std::vector<std::string> notices_of(const Summary& summary) {
  std::vector<std::string> notices;
  const auto add = [&notices](const std::string& text) {
    notices.push_back(text);
  };
  if (summary.status != "complete")
    add(fmt::format("The run is not complete (status: {}); the report shows "
                    "the completed part.",
                    summary.status));
  for (const MethodSummary& method : summary.methods)
    if (method.cost.failed_steps > 0)
      add(fmt::format("{}: {} of {} steps did not converge; they are listed "
                      "below and excluded from all fits.",
                      method.name, method.cost.failed_steps,
                      method.cost.steps));
  for (const MethodSummary& method : summary.methods)
    for (const std::string& problem : method.problems)
      add(fmt::format("{}: an analysis failed: {}.", method.name, problem));
  for (const auto& [key, fact] : summary.provenance)
    if (key.find("dirty") != std::string::npos &&
        (fact == "yes" || fact == "true" || fact == "1"))
      add("The program was built from sources with changes that were not "
          "committed: do not quote these numbers.");
  return notices;
}

/// Sets the notices. Of the disagreements with the theory, which can be many,
/// the first is a notice and the others are folded.
void set_notices(Json& page, const ReportEntry& entry) {
  page["notices"] = Json::array();
  page["disagreements"] = Json::array();
  bool is_first = true;
  for (const Warning& warning :
       warnings_of(*entry.result, *entry.contact_case)) {
    const bool is_folded =
        warning.kind.starts_with("theory_") && !std::exchange(is_first, false);
    const std::string more = warning.headline + " " + warning.consequence;
    if (is_folded)
      page["disagreements"].push_back(more);
    else
      page["notices"].push_back({{"line", warning.line}, {"more", more}});
  }
  for (const std::string& notice : notices_of(entry.summary))
    page["notices"].push_back({{"line", notice}, {"more", ""}});
  page["n_disagreements"] = page["disagreements"].size();
}

/// The verdicts on the expectations with typographic signs.
void set_verdicts(Json& page, const Summary& summary) {
  for (std::size_t i = 0; i < summary.verdicts.size(); ++i) {
    const Verdict& verdict = summary.verdicts[i];
    Json& row = page["expectations"][i];
    std::string band = row["band"];
    for (const auto& [plain, sign] :
         {std::pair("..", " … "), std::pair("<=", "≤"), std::pair(">=", "≥")})
      if (const std::size_t at = band.find(plain); at != std::string::npos)
        band.replace(at, 2, sign);
    row["band"] = band;
    row["sign"] = verdict.outcome == Outcome::ok          ? "✓"
                  : verdict.outcome == Outcome::skipped   ? "–"
                  : verdict.outcome == Outcome::undecided ? "?"
                                                          : "✗";
    if (verdict.outcome == Outcome::undecided)
      row["remark"] =
          fmt::format("the interval crosses a limit of the band, which the "
                      "case counts as {}; {}",
                      verdict.passes_if_undecided ? "passed" : "not passed",
                      verdict.estimate.remark);
  }
}

/// How many steps have an error, the largest one, and where it is.
Json errors_row(const ErrorsOfSteps& errors, int steps,
                double contact_modulus) {
  const bool has_any = errors.steps > 0;
  return {
      {"steps", has_any ? fmt::format("{} of {}", errors.steps, steps) : "–"},
      {"largest", has_any ? errors.largest : not_a_number},
      {"pressure", has_any ? errors.pressure / contact_modulus : not_a_number}};
}

/// The certified bounds and the estimates of each method but the theories;
/// empty if there is none.
Json certified_rows(const ReportEntry& entry) {
  Json rows = Json::array();
  bool has_any = false;
  for (const MethodSummary& method : entry.summary.methods) {
    if (method.kind == "theory")
      continue;
    const auto& [steps, bounds, estimates] = method.certified;
    const double modulus = entry.result->contact_modulus;
    rows.push_back({{"name", method.name},
                    {"bound", errors_row(bounds, steps, modulus)},
                    {"estimate", errors_row(estimates, steps, modulus)}});
    if (bounds.steps + estimates.steps == 0)
      rows.back()["bound"]["steps"] = "as submitted";
    else
      has_any = true;
  }
  return has_any ? rows : Json::array();
}

/// What tables of a single realisation begin with; "" if there is one alone.
std::string realization_words(const results::Result& result) {
  std::size_t count = 0;
  for (const results::MethodRecord& method : result.methods)
    count = std::max(count, method.realizations.size());
  return count > 1 ? fmt::format("Realisation 0 of {}. ", count) : "";
}

} // namespace

Json entry_page(const ReportEntry& entry, Json page,
                std::span<const Series> series) {
  const Summary& summary = entry.summary;
  const bool is_exact = is_exact_shape(*entry.contact_case);
  const Columns columns{answered(columns_of(is_exact), summary)};
  page["name"] = summary.case_name;
  page["sentence"] = case_sentence(entry);
  page["parts_words"] = parts_sentence(summary.interval_parts);
  for (Json& row : page["contact_against_load"])
    for (const char* const number :
         {"area_fraction", "area [m^2]", "mean_gap [m]"})
      if (row[number]["error"] > 0.0)
        row[number]["half_width_95"] = row[number]["error"];
  page["of_one"] = realization_words(*entry.result);
  set_notices(page, entry);
  page["banner_class"] = banner_class(summary);
  page["banner"] = banner_words(summary);
  page["leads_by_constants"] = is_exact || states_any(summary, columns.key());
  page["constants_heading"] = heading_of(columns.key());
  page["key_columns"] = heads_of(columns.key());
  page["columns"] = heads_of(columns.others());
  page["columns"].push_back(
      {{"head", "CPU time per step"}, {"unit", "median"}});
  page["columns"].push_back({{"head", "steps"}, {"unit", "converged"}});
  page["method_columns"] = columns.key().size() + 1;
  page["methods"] = Json::array();
  for (const MethodSummary& method : summary.methods)
    for (const Series& one : series)
      if (one.method == &method)
        page["methods"].push_back(
            method_row(method, series_color(one), columns));
  page["method_note"] =
      is_exact ? "Errors are the largest over the loads that have an exact "
                 "solution. Hertz' contact must fit into the square."
               : "± is the 95 % interval over realisations, or that of "
                 "the fit where there is a single realisation.";
  set_verdicts(page, summary);
  page["published"] = published_rows(summary);
  page["published_columns"] = summary.methods.size() + 2;
  Json facts = {{"case hash", summary.case_hash}, {"status", summary.status}};
  facts.update(page["provenance"]);
  page["facts"] = items_of(facts);
  page["certified"] = certified_rows(entry);
  page["case_text"] = entry.result->case_text;
  return page;
}

std::string banner_words(const Summary& summary) {
  const int all = summary.n_judged();
  if (all == 0)
    return summary.verdicts.empty()
               ? ""
               : "No expectation concerns a method that was run.";
  const auto count = [&](auto holds) {
    return std::count_if(summary.verdicts.begin(), summary.verdicts.end(),
                         holds);
  };
  const auto met =
      count([](const Verdict& v) { return v.outcome == Outcome::ok; });
  const auto passed = count([](const Verdict& v) { return v.is_passed(); });
  std::string words =
      passed < all
          ? fmt::format("{} of {} expectations are not met.", all - passed, all)
      : met < all ? fmt::format("{} of {} expectations are met.", met, all)
      : all == 1  ? std::string("The one expectation is met.")
                  : fmt::format("All {} expectations are met.", all);
  if (passed > met)
    words += fmt::format(" {} {} undecided, which the case counts as passed.",
                         passed - met, passed - met == 1 ? "is" : "are");
  return words;
}

std::string banner_class(const Summary& summary) {
  if (!summary.all_ok())
    return "bad";
  const bool is_all_met =
      std::all_of(summary.verdicts.begin(), summary.verdicts.end(),
                  [](const Verdict& verdict) {
                    return verdict.outcome == Outcome::ok ||
                           verdict.outcome == Outcome::skipped;
                  });
  return is_all_met && summary.n_judged() > 0 ? "good" : "none";
}

} // namespace asperity::reports
