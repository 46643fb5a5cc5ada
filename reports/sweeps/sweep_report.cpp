#include "reports/sweeps/sweep_report.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "base/read_file.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/explore/packed.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/html_report.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/report_template.hpp"
#include "reports/sweeps/sample_loads.hpp"
#include "reports/sweeps/sample_maps.hpp"
#include "reports/sweeps/sweep_figures.hpp"
#include "reports/sweeps/sweep_scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

/// Quantities that the table of the page shows; sweep.csv has all of them.
constexpr std::size_t most_columns = 5;

std::vector<std::string> shown_quantities(const SweptResults& results) {
  std::vector<std::string> names = swept_quantities(results);
  std::erase(names, "penetration");
  names.resize(std::min(names.size(), most_columns));
  return names;
}

/// Returns the verdicts on one point: "3 of 4 met".
std::string verdict_words(const SweptResult& result) {
  if (!result.has_result() || result.summary.n_judged() == 0)
    return "–";
  const auto met = std::ranges::count_if(
      result.summary.verdicts, [](const Verdict& verdict) {
        return verdict.outcome != Outcome::skipped && verdict.is_passed();
      });
  return fmt::format("{} of {} met", met, result.summary.n_judged());
}

/// A point by the values of its keys: "hurst = 0.3, points = 64".
std::string point_name(const SweepRecord& record, std::size_t point) {
  std::string name;
  for (std::size_t k = 0; k < record.keys.size(); ++k) {
    const std::string& key = record.keys[k].key;
    name += fmt::format(
        "{}{} = {}", name.empty() ? "" : ", ", key.substr(key.rfind('.') + 1),
        value_label(record.keys[k].values[record.points[point].choice[k]]));
  }
  return name;
}

/// One row per point and method.
/// @param out  of the page, from which a point's own report is linked
Json point_rows(const SweepRecord& record, const SweptResults& results,
                const std::vector<std::string>& quantities,
                const std::filesystem::path& out) {
  Json rows = Json::array();
  for (const auto& result : results) {
    const std::filesystem::path folder = point_folder(result->point);
    const auto add = [&](const std::string& method, const Json& cells) {
      rows.push_back(
          {{"point", point_name(record, result->point)},
           {"folder", folder.string()},
           {"has_report",
            std::filesystem::exists(out / folder / "report.html")},
           {"method", method},
           {"cells", cells},
           {"verdicts", verdict_words(*result)},
           {"is_failed", result->has_result() && !result->summary.all_ok()},
           {"problem", result->problem}});
    };
    for (const MethodSummary& method : result->summary.methods) {
      Json cells = Json::array();
      for (const std::string& name : quantities) {
        const Estimate* const estimate =
            swept_estimate(*result, method.name, name);
        cells.push_back(estimate == nullptr ? "–" : number_text(*estimate));
      }
      add(method.name, cells);
    }
    if (result->summary.methods.empty())
      add("–", std::vector<std::string>(quantities.size(), "–"));
  }
  return rows;
}

/// One row per method and quantity over all samples, of the quantities that
/// the figures show first and of the roughness.
Json scatter_rows(const SweepRecord& record, const SweptResults& results) {
  constexpr std::size_t most_rows = 8; // of a method
  Json rows = Json::array();
  std::vector<std::string> quantities = swept_quantities(results);
  quantities.resize(std::min(quantities.size(), most_rows));
  quantities.emplace_back("rms_height");
  for (const Scatter& scatter : scatter_of(results, quantities)) {
    const auto text = [&](double value, int digits) {
      return quantity_text(value, scatter.quantity == "rms_height" ? "m" : "1",
                           digits);
    };
    const auto named = [&](std::size_t point) {
      const Estimate* const estimate =
          swept_estimate(*results[point], scatter.method, scatter.quantity);
      return fmt::format("{}, {}", text(estimate->value, 4),
                         sample_name(record, point));
    };
    std::string outliers;
    for (const std::size_t point : scatter.outliers)
      outliers += (outliers.empty() ? "" : "; ") + named(point);
    rows.push_back({{"method", scatter.method},
                    {"quantity", scatter.quantity},
                    {"count", scatter.count},
                    {"mean", text(scatter.spread.mean, 4)},
                    {"deviation", text(scatter.spread.deviation, 2)},
                    {"lowest", named(scatter.lowest)},
                    {"highest", named(scatter.highest)},
                    {"outliers", outliers.empty() ? "–" : outliers}});
  }
  return rows;
}

/// Says which samples are not in a mean, and which are 0 in it: tight ones.
std::string counted_samples(const SampleColumn& head,
                            const SampleValues& column) {
  const auto all = std::ssize(column.values);
  std::string text;
  if (column.known() < all)
    text = fmt::format("; {} of {} have a value", column.known(), all);
  if (column.zeros() > 0)
    text += fmt::format("; {} of {} are {}", column.zeros(), all,
                        head.zero.empty() ? "0" : head.zero);
  return text;
}

/// Adds the tables at the loads that all samples share: their statistics, and
/// every sample.
void set_loads(Json& page, const SampleLoads& table) {
  page["is_by_gap"] = table.is_by_gap();
  page["has_outliers"] = false;
  page["state_head"] = table.is_by_gap() ? "Mean gap" : "Pressure";
  page["load_heads"] = Json::array();
  page["loads"] = Json::array();
  page["sample_rows"] = Json::array();
  for (const SampleColumn& column : table.columns) {
    std::string head =
        column.name == "area_fraction" ? "contact area" : column.name;
    std::ranges::replace(head, '_', ' '); // allows line breaks
    page["load_heads"].push_back(head);
  }
  for (const SampleLoad& load : table.loads) {
    const std::string state = table.state_text(load);
    Json cells = Json::array();
    std::string outliers;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const SampleValues& values = load.columns[c];
      cells.push_back(table.column_text(load, c) +
                      counted_samples(table.columns[c], values));
      if (c >= table.n_common()) // of studies in loads.csv
        continue;
      for (const std::size_t sample : values.outliers)
        if (outliers.find(table.samples[sample]) == outliers.npos)
          outliers += (outliers.empty() ? "" : ", ") + table.samples[sample];
    }
    if (!outliers.empty())
      page["has_outliers"] = true;
    page["loads"].push_back({{"state", state},
                             {"cells", cells},
                             {"outliers", outliers.empty() ? "–" : outliers}});
    for (std::size_t i = 0; i < table.samples.size(); ++i) {
      Json of_sample = Json::array();
      for (std::size_t c = 0; c < table.columns.size(); ++c)
        of_sample.push_back(
            quantity_text(load.columns[c].values[i], table.columns[c].unit));
      page["sample_rows"].push_back({{"state", state},
                                     {"sample", table.samples[i]},
                                     {"cells", of_sample}});
    }
  }
}

/// One row per spectrum.
Json limit_rows(const std::vector<SweepLimit>& limits) {
  Json rows = Json::array();
  for (const SweepLimit& limit : limits) {
    Json cells = Json::array();
    for (const char* quantity : quantities_with_limits) {
      const auto found = limit.limits.find(quantity);
      cells.push_back(found == limit.limits.end() ? "–"
                                                  : number_text(found->second));
    }
    rows.push_back({{"method", limit.method},
                    {"hurst", limit.hurst},
                    {"ratio", limit.ratio},
                    {"nayak", limit.nayak},
                    {"points", limit.points},
                    {"cells", cells}});
  }
  return rows;
}

/// The picture of a map without its axes, as in the figure of its report; ""
/// without one.
std::string thumbnail(const std::filesystem::path& point) {
  constexpr std::uintmax_t largest_picture = 4 << 20;
  constexpr std::string_view head = "data:image/png;base64,";
  const std::filesystem::path file = point / "figures" / "surface.svg";
  if (!std::filesystem::exists(file))
    return "";
  try {
    const std::string svg = read_file(file, largest_picture);
    const std::size_t begin = svg.find(head);
    return begin == svg.npos
               ? ""
               : svg.substr(begin, svg.find_first_of("'\"", begin) - begin);
  } catch (const FileError&) {
    return ""; // its report shows it
  }
}

/// The table of the maps, each with its picture.
void set_maps(Json& page, const SampleMaps& maps,
              const std::filesystem::path& out) {
  page["are_maps_first"] = !maps.sentence.empty();
  page["map_heads"] = maps.heads;
  page["maps"] = Json::array();
  for (const SampleMap& map : maps.rows) {
    const std::filesystem::path folder = point_folder(map.point);
    const bool has_report =
        !map.is_statistic &&
        std::filesystem::exists(out / folder / "report.html");
    page["maps"].push_back(
        {{"name", map.name},
         {"folder", has_report ? folder.string() : ""},
         {"picture", has_report ? thumbnail(out / folder) : ""},
         {"cells", map.cells}});
  }
}

/// The root mean square of the errors of a theory over the points, with the
/// smallest and the largest: "0.021 (0.012 to 0.034)".
std::string error_words(const SweptResults& results, const std::string& method,
                        const std::string& quantity) {
  std::vector<double> errors;
  double squares = 0.0;
  for (const auto& result : results)
    if (const Estimate* const estimate =
            swept_estimate(*result, method, quantity);
        estimate != nullptr && estimate->has_value()) {
      errors.push_back(estimate->value);
      squares += estimate->value * estimate->value;
    }
  if (errors.empty())
    return "–";
  const auto [low, high] = std::ranges::minmax(errors);
  return fmt::format("{:.3f} ({:.3f} to {:.3f})",
                     std::sqrt(squares / static_cast<double>(errors.size())),
                     low, high);
}

/// One row per theory that was compared with another method.
Json law_rows(const SweptResults& results) {
  Json rows = Json::array();
  for (const std::string& method : swept_methods(results)) {
    Json row = {{"method", method}, {"cells", Json::array()}};
    for (const auto& result : results)
      for (const MethodSummary& one : result->summary.methods)
        if (one.name == method)
          row["description"] = one.description;
    for (const char* quantity :
         {"law_area_error", "law_energy_error", "law_gap_error"})
      row["cells"].push_back(error_words(results, method, quantity));
    if (error_words(results, method, "law_gap_error") != "–")
      rows.push_back(row);
  }
  return rows;
}

/// Lists the expectations that a point does not meet.
Json failed_rows(const SweepRecord& record, const SweptResults& results) {
  Json rows = Json::array();
  for (const auto& result : results)
    for (const Verdict& verdict : result->summary.verdicts)
      if (verdict.outcome != Outcome::skipped && !verdict.is_passed())
        rows.push_back({{"label", record.label(result->point)},
                        {"line", check_line(verdict)}});
  return rows;
}

Json key_rows(const SweepRecord& record) {
  Json rows = Json::array();
  for (const cases::SweptKey& key : record.keys) {
    std::string values;
    for (const std::string& value : key.values)
      values += (values.empty() ? "" : ", ") + value_label(value);
    rows.push_back({{"key", key.key}, {"values", values}});
  }
  return rows;
}

/// @param answer  in the place of verdicts, if nothing is expected; may be ""
void set_banner(Json& page, const SweptResults& results,
                const std::string& answer) {
  std::size_t incomplete = 0;
  std::size_t judged = 0;
  std::size_t bad = 0;
  for (const auto& result : results) {
    incomplete += result->problem.empty() ? 0 : 1;
    if (result->has_result() && result->summary.n_judged() > 0) {
      ++judged;
      bad += result->summary.all_ok() ? 0 : 1;
    }
  }
  std::string words =
      judged == 0 && !answer.empty() ? answer
      : judged == 0                  ? "The case states no expectation."
      : bad == 0 ? fmt::format("All expectations are met at {} points.", judged)
                 : fmt::format("Expectations are not met at {} of {} points.",
                               bad, judged);
  if (incomplete > 0)
    words += fmt::format(" {} of {} points are not complete.", incomplete,
                         results.size());
  page["banner"] = words;
  page["banner_class"] = bad > 0 || incomplete > 0 ? "bad"
                         : judged == 0             ? "none"
                                                   : "";
}

/// ", E* = 2 GPa" of samples, which have one modulus; "" without a result.
std::string modulus_words(const SweptResults& results) {
  for (const auto& result : results)
    if (std::isfinite(result->contact_modulus))
      return ", E* = " + quantity_text(result->contact_modulus, "Pa");
  return "";
}

/// @param page  what the page says of limits and common loads
Json page_of(Json page, const SweepRecord& record, const SweptResults& results,
             const std::vector<DrawnGroup>& groups,
             const std::filesystem::path& out) {
  const std::vector<std::string> quantities = shown_quantities(results);
  std::vector<std::string> heads = quantities;
  for (std::string& head : heads) // allows line breaks
    std::ranges::replace(head, '_', ' ');
  const bool is_sampled = has_samples(record);
  page.update(record_json(record));
  page["page_title"] = "Sweep: " + record.title;
  const bool are_maps = is_sampled && record.keys.front().key == "surface.file";
  page["are_maps"] = are_maps;
  page["lead"] = fmt::format(
      "Case {}: {} {}{}.", record.case_name, record.points.size(),
      are_maps ? "maps" : "points",
      is_sampled               ? modulus_words(results)
      : record.keys.size() < 2 ? ""
      : record.combine == cases::Combine::zip
          ? ", the lists of values side by side"
          : ", every value of each key with every value of the others");
  page["keys"] = key_rows(record);
  page["quantity_heads"] = heads;
  page["rows"] = point_rows(record, results, quantities, out);
  page["scatter"] = is_sampled ? scatter_rows(record, results) : Json::array();
  const Json laws = law_rows(results);
  page["laws"] = laws.size() > 1 ? laws : Json::array();
  page["failed"] = failed_rows(record, results);
  page["groups"] = group_data(groups);
  return page;
}

} // namespace

SweepReport write_sweep_report(const SweepRecord& record,
                               const std::filesystem::path& folder,
                               const std::filesystem::path& out,
                               bool is_trusted, const ReportExtras& extras,
                               const std::string& gnuplot) {
  SweepReport report{read_swept_results(record, folder, is_trusted), {}};
  const SweptResults& results = report.results;
  std::filesystem::create_directories(out);
  write_file_atomically(out / "sweep.csv", sweep_csv(record, results));
  const std::vector<SweepLimit> limits = sweep_limits(record, results);
  const SampleLoads loads = sample_loads(record, results);
  const SampleMaps maps = sample_maps(record, results, loads);
  const std::string answers = sample_answers(loads);
  report.answer = sample_loads_text(loads) + sample_maps_text(maps) + answers +
                  (answers.empty() ? "" : "\n");
  if (!loads.loads.empty())
    write_file_atomically(out / "loads.csv", sample_loads_csv(loads));
  const std::vector<FigureGroup> figures{
      {"All maps", "", sample_figures(loads)},
      // Names of samples are no axis.
      {"Quantities", "",
       loads.loads.empty() ? sweep_trend_figures(record, results)
                           : std::vector<Figure>()},
      {"Maps over both keys", "", sweep_heat_maps(record, results)},
      {"Limits and spectrum", "", sweep_limit_figures(limits)},
      {"The curves", "",
       loads.loads.empty() ? sweep_curve_figures(record, results)
                           : std::vector<Figure>()}};
  const std::vector<DrawnGroup> groups =
      drawn_groups_of(figures, out, gnuplot, extras.journal, report.undrawn);
  Json page;
  page["limit_heads"] = quantities_with_limits;
  page["limits"] = limit_rows(limits);
  set_banner(page, results,
             (maps.sentence.empty() ? sample_sentence(loads) : maps.sentence) +
                 (answers.empty() ? "" : " " + answers));
  set_loads(page, loads);
  set_maps(page, maps, out);
  write_page(sweep_template,
             page_of(std::move(page), record, results, groups, out), groups,
             out, extras.has_pdf, report.undrawn);
  write_file_atomically(folder / sweep_file, sweep_json(record, results));
  return report;
}

} // namespace asperity::reports
