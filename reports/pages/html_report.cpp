#include "reports/analysis/verdict.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::reports {
namespace {

using Value = kainjow::mustache::data;
using List = kainjow::mustache::list;

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

Value cell(const std::string& text, const std::string& small) {
  Value value;
  value.set("text", text);
  value.set("small", small);
  return value;
}

std::string seconds_text(double seconds) {
  return std::isfinite(seconds) ? fmt::format("{:.2g} s", seconds) : "–";
}

/// Returns the estimates of a method. The reasons why one is not determined are
/// long; they are in the table of the fits as well.
List cells_of(const MethodSummary& method, std::span<const Column> columns,
              bool has_reasons) {
  List cells;
  for (const Column& column : columns) {
    const auto found = method.quantities.find(column.quantity);
    if (found == method.quantities.end())
      cells.push_back(cell("–", ""));
    else
      cells.push_back(cell(column.is_percent ? percent_text(found->second)
                                             : number_text(found->second),
                           has_reasons || found->second.has_value()
                               ? remark_of(found->second)
                               : ""));
  }
  return cells;
}

Value method_row(const MethodSummary& method, const char* color,
                 const Columns& columns) {
  Value row;
  row.set("name", method.name);
  std::string description = method.description;
  for (const std::string& omission : method.omissions)
    description += "; " + omission;
  row.set("description", description);
  row.set("color", color);
  row.set("key_cells", cells_of(method, columns.key(), false));
  List cells = cells_of(method, columns.others(), true);
  const Cost& cost = method.cost;
  cells.push_back(
      cell(seconds_text(cost.step_cpu_time),
           fmt::format("{} in total", seconds_text(cost.cpu_time))));
  cells.push_back(
      cell(fmt::format("{} of {}", cost.steps - cost.failed_steps, cost.steps),
           cost.largest_iterations > 0
               ? fmt::format("≤ {} iterations", cost.largest_iterations)
               : ""));
  row.set("cells", cells);
  return row;
}

Value head(const char* text, const char* unit) {
  Value value;
  value.set("head", text);
  value.set("unit", unit);
  return value;
}

List heads_of(std::span<const Column> columns) {
  List heads;
  for (const Column& column : columns)
    heads.push_back(head(column.head, column.unit));
  return heads;
}

// Formats a published number and its unit, with "±", for a page.
std::string typeset_published(const cases::ReferenceValue& reference) {
  std::string text = published_text(reference);
  if (const std::size_t at = text.find("+-"); at != std::string::npos)
    text.replace(at, 2, "±");
  return text;
}

List published_rows(const Summary& summary) {
  List rows;
  for (const PublishedValue& published : summary.published) {
    Value row;
    row.set("quantity", published.reference.quantity);
    row.set("source", published.reference.source);
    row.set("value", typeset_published(published.reference));
    row.set("exact", published.reference.uncertainty > 0.0 ? "" : "exact");
    List cells;
    for (const MethodSummary& method : summary.methods)
      if (!published.ours.empty()) {
        const auto found = std::find_if(
            published.ours.begin(), published.ours.end(),
            [&](const OurValue& ours) { return ours.method == method.name; });
        cells.push_back(found == published.ours.end()
                            ? cell("–", "not computed")
                            : cell(number_text(found->estimate),
                                   remark_of(found->estimate)));
      }
    row.set("cells", cells);
    if (published.ours.empty())
      row.set("not_computed", std::to_string(summary.methods.size()));
    rows.push_back(row);
  }
  return rows;
}

List notices_of(const ReportEntry& entry) {
  const Summary& summary = entry.summary;
  List notices;
  const auto add = [&notices](const std::string& text) {
    Value value;
    value.set("text", text);
    notices.push_back(value);
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
void set_notices(Value& page, const ReportEntry& entry) {
  List notices;
  List disagreements;
  bool is_first = true;
  for (const Warning& warning :
       warnings_of(*entry.result, *entry.contact_case)) {
    const bool is_folded =
        warning.kind.starts_with("theory_") && !std::exchange(is_first, false);
    (is_folded ? disagreements : notices)
        .push_back(text_item(warning.headline + " " + warning.consequence));
  }
  for (auto& notice : notices_of(entry))
    notices.push_back(notice);
  page.set("notices", notices);
  page.set("has_disagreements", !disagreements.empty());
  page.set("n_disagreements", std::to_string(disagreements.size()));
  page.set("disagreements", disagreements);
}

void add_fact(List& facts, const std::string& key, const std::string& fact) {
  Value value;
  value.set("key", key);
  value.set("fact", fact);
  facts.push_back(value);
}

List facts_of(const Summary& summary) {
  List facts;
  add_fact(facts, "case hash", summary.case_hash);
  add_fact(facts, "status", summary.status);
  for (const auto& [key, fact] : summary.provenance)
    add_fact(facts, key, fact);
  return facts;
}

/// The sentence with the numbers that a user asks for first, if there is one.
void set_answer(Value& page, const ReportEntry& entry) {
  const std::string answer =
      entry.result->surfaces.empty() ? "" : physical_sentence(entry);
  page.set("has_answer", !answer.empty());
  page.set("answer", answer);
}

void set_slips(Value& page, const ReportEntry& entry) {
  const List slips = slip_rows(entry);
  page.set("has_slips", !slips.empty());
  page.set("slips", slips);
  if (!slips.empty())
    page.set("slip_note", slip_note(entry));
}

} // namespace

Value entry_data(const ReportEntry& entry, std::span<const Series> series,
                 bool is_one_of_many) {
  const Summary& summary = entry.summary;
  const bool is_exact = is_exact_shape(*entry.contact_case);
  const Columns columns{answered(columns_of(is_exact), summary)};
  Value page;
  page.set("name", summary.case_name);
  page.set("title", summary.case_title);
  page.set("is_one_of_many", is_one_of_many);
  page.set("sentence", case_sentence(entry));
  set_answer(page, entry);
  const List physical = physical_rows(entry);
  page.set("has_physical", !physical.empty());
  page.set("physical", physical);
  set_notices(page, entry);
  page.set("banner_class", banner_class(summary));
  page.set("banner", banner_words(summary));
  List heads = heads_of(columns.others());
  heads.push_back(head("CPU time per step", "median"));
  heads.push_back(head("steps", "converged"));
  page.set("key_columns", heads_of(columns.key()));
  page.set("columns", heads);
  page.set("method_columns", std::to_string(columns.key().size() + 1));
  List methods;
  for (const MethodSummary& method : summary.methods)
    for (const Series& one : series)
      if (one.method == &method)
        methods.push_back(method_row(method, series_color(one), columns));
  page.set("methods", methods);
  page.set("method_note",
           is_exact
               ? "Errors are the largest over the loads that have an exact "
                 "solution. Hertz' contact must fit into the square."
               : "± is the 95 % interval over realisations, or that of "
                 "the fit where there is a single realisation.");
  page.set("has_verdicts", !summary.verdicts.empty());
  page.set("verdicts", verdict_rows(summary));
  page.set("has_published", !summary.published.empty());
  page.set("published", published_rows(summary));
  page.set("published_columns", std::to_string(summary.methods.size() + 2));
  page.set("facts", facts_of(summary));
  page.set("has_skipped", !entry.result->skipped.empty());
  page.set("skipped", skipped_rows(*entry.result));
  const List block_costs = block_cost_rows(*entry.result);
  page.set("has_full_block", !block_costs.empty());
  page.set("block_costs", block_costs);
  const List stiffnesses = stiffness_rows(*entry.result);
  page.set("has_stiffness", !stiffnesses.empty());
  page.set("stiffness", stiffnesses);
  set_slips(page, entry);
  const List boundaries = boundary_rows(entry);
  page.set("has_boundaries", !boundaries.empty());
  page.set("boundaries", boundaries);
  const List certified = certified_rows(entry);
  page.set("has_certified", !certified.empty());
  page.set("certified", certified);
  page.set("case_text", entry.result->case_text);
  return page;
}

} // namespace asperity::reports
