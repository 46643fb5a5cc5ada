#include "base/atomic_file.hpp"
#include "bench/analysis/bench_answer.hpp"
#include "bench/analysis/scaling.hpp"
#include "bench/bench_template.hpp"
#include "bench/pages/bench_report.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace asperity::bench {
namespace {

using Value = kainjow::mustache::data;
using List = kainjow::mustache::list;

std::string short_number(double value, const char* format = "{:.2f}") {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "–";
}

double in(const std::map<std::string, double>& table, const std::string& key) {
  const auto found = table.find(key);
  return found == table.end() ? not_a_number : found->second;
}

/// Returns the order of an error in a cost: minus the fitted exponent.
double exponent_in(const std::map<std::string, reports::PowerLaw>& laws,
                   const std::string& quantity) {
  const auto found = laws.find(quantity);
  return found == laws.end() ? not_a_number
                             : -found->second.determined_exponent();
}

/// What a method needs for errors of at most 1 % of a quantity: "halfspace
/// 0.17 s (64 points)".
std::string need_of(const Bench& bench, const std::string& method,
                    const std::string& quantity) {
  constexpr double wanted = 0.01;
  const BenchPoint* cheapest = nullptr;
  const BenchPoint* best = nullptr;
  const auto error = [&](const BenchPoint& point) {
    return in(point.errors, quantity);
  };
  for (const BenchPoint& point : bench.points) {
    if (point.method != method || !std::isfinite(error(point)))
      continue;
    if (best == nullptr || error(point) < error(*best))
      best = &point;
    if (error(point) <= wanted &&
        (cheapest == nullptr || point.cpu.median < cheapest->cpu.median))
      cheapest = &point;
  }
  if (cheapest != nullptr)
    return fmt::format("{} {:.2g} s ({})", method, cheapest->cpu.median,
                       cheapest->label);
  return best == nullptr ? ""
                         : fmt::format("{} has {} at best ({:.2g} s, {})",
                                       method, per_cent(error(*best)),
                                       best->cpu.median, best->label);
}

/// What the page answers, before its tables: one sentence per scaling series,
/// or per quantity.
List answers(const Bench& bench) {
  constexpr std::size_t most_quantities = 3;
  List list;
  for (const ScalingSeries& series : bench.scaling)
    if (const std::vector<ScalingRow> rows = scaling_rows(bench, series);
        rows.size() > 1)
      list.push_back(reports::text_item(fmt::format(
          "{}: {:.2g} times as fast on {} {} as on {}, {:.0f} % of the ideal.",
          series.method, rows.back().speed_up, rows.back().workers,
          series.has_ranks ? "ranks" : "threads", rows.front().workers,
          100.0 * rows.back().efficiency)));
  for (const std::string& quantity : bench.quantities) {
    std::string needs;
    std::set<std::string> seen;
    for (const BenchPoint& point : bench.points)
      if (seen.insert(point.method).second)
        if (const std::string need = need_of(bench, point.method, quantity);
            !need.empty())
          needs += (needs.empty() ? "" : "; ") + need;
    if (!needs.empty() && list.size() < most_quantities)
      list.push_back(reports::text_item(fmt::format(
          "CPU time for an error of {} of at most 1 %: {}.", quantity, needs)));
  }
  return list;
}

List text_list(const std::vector<std::string>& texts) {
  List list;
  for (const std::string& text : texts)
    list.push_back(reports::text_item(text));
  return list;
}

Value target_data(const TargetOutcome& target) {
  Value value;
  value.set("target", per_cent(target.target));
  if (!target.problem.empty()) {
    value.set("problem", target.problem);
    return value;
  }
  value.set("banner_class", target.is_met() ? "" : "bad");
  value.set("banner",
            fmt::format("{}: {}",
                        target.is_met() ? "The error target is met"
                                        : "The error target is missed",
                        target.chosen));
  List earlier;
  for (const std::string& words : target.earlier) {
    Value row;
    row.set("words", words);
    earlier.push_back(row);
  }
  value.set("earlier", earlier);
  value.set("chosen",
            fmt::format(
                "The predicted CPU time is {} s and the measured one {} s; the "
                "coarse runs of the search took {} s. Verified against {}.",
                short_number(target.predicted_cpu_time, "{:.3g}"),
                short_number(target.cpu_time, "{:.3g}"),
                short_number(target.search_cpu_time, "{:.3g}"), target.finer));
  List checks;
  for (const TargetCheck& check : target.checks) {
    Value row;
    row.set("quantity", check.quantity);
    row.set("method", check.method);
    row.set("estimator", check.estimator);
    row.set("target", per_cent(target.target));
    row.set("predicted", per_cent(check.predicted));
    row.set("found", per_cent(check.found));
    row.set("class", check.is_met ? "met" : "missed");
    row.set("word", check.is_met ? "yes" : "no");
    checks.push_back(row);
  }
  value.set("checks", checks);
  return value;
}

List reference_rows(const Bench& bench) {
  List rows;
  for (const std::string& quantity : bench.quantities) {
    if (!bench.reference.answer.values.contains(quantity))
      continue;
    const auto exact = bench.reference.is_exact.find(quantity);
    const bool is_exact =
        exact != bench.reference.is_exact.end() && exact->second;
    const double order = in(bench.reference.order, quantity);
    Value row;
    row.set("quantity", quantity);
    row.set("meaning", error_words(quantity));
    row.set("kind",
            is_exact ? "exact"
            : std::isfinite(order)
                ? "Richardson limit"
                : "the finest grid, because the series converges irregularly");
    row.set("order", is_exact ? "–" : short_number(order));
    row.set("uncertainty",
            is_exact ? "–"
                     : per_cent(in(bench.reference.uncertainty, quantity)));
    rows.push_back(row);
  }
  return rows;
}

List series_rows(const Bench& bench) {
  List rows;
  for (const BenchSeries& series : bench.series) {
    bool is_first = true;
    for (const std::string& quantity : bench.quantities) {
      const auto order = series.orders.find(quantity);
      if (order == series.orders.end() ||
          (!std::isfinite(order->second.by_differences) &&
           !order->second.error.is_known()))
        continue;
      Value row;
      row.set("method", is_first ? series.method : "");
      row.set("axis", is_first ? series.title : "");
      row.set("source", is_first ? series.order_source : "");
      row.set("quantity", quantity);
      row.set("order", short_number(order->second.by_differences));
      row.set("slope", short_number(order->second.error.determined_exponent()));
      row.set("unknowns_slope",
              short_number(exponent_in(series.against_unknowns, quantity)));
      row.set("theory",
              short_number(in(series.theoretical_orders, quantity), "{:g}"));
      row.set("cost",
              is_first ? short_number(series.cost.determined_exponent()) : "");
      row.set("step_cost",
              is_first ? short_number(series.step_cost.determined_exponent())
                       : "");
      rows.push_back(row);
      is_first = false;
    }
  }
  return rows;
}

std::string remark_of(const BenchPoint& point) {
  std::string remark = point.problem;
  const auto add = [&](const std::string& more) {
    remark += (remark.empty() ? "" : "; ") + more;
  };
  if (point.is_own)
    add("the case's own setting");
  if (point.is_reference)
    add("for the reference solution");
  if (!point.is_repeatable)
    add("numbers differ from run to run");
  if (point.failed_steps > 0)
    add(fmt::format("{} of {} steps did not converge", point.failed_steps,
                    point.steps));
  return remark;
}

Value setting_row(const Bench& bench, const BenchPoint& point) {
  const double floor = point.transform_floor();
  Value row;
  row.set("class", point.is_own         ? "own"
                   : point.is_reference ? "reference"
                                        : "");
  row.set("label", point.label);
  row.set("remark", remark_of(point));
  row.set("cpu", short_number(point.cpu.median, "{:.3g}"));
  row.set("cpu_range", fmt::format("{} … {}, n = {}",
                                   short_number(point.cpu.least, "{:.3g}"),
                                   short_number(point.cpu.largest, "{:.3g}"),
                                   point.repeats));
  row.set("wall", short_number(point.wall.median, "{:.3g}"));
  row.set("wall_range",
          fmt::format("{} … {}", short_number(point.wall.least, "{:.3g}"),
                      short_number(point.wall.largest, "{:.3g}")));
  const bool has_run = point.repeats > 0;
  row.set("memory",
          has_run ? fmt::format("{:.0f}", point.peak_memory / 1048576.0) : "–");
  row.set("unknowns", short_number(point.unknowns, "{:.0f}"));
  row.set("iterations", has_run ? std::to_string(point.iterations) : "–");
  row.set("transforms",
          point.transforms > 0 ? std::to_string(point.transforms) : "–");
  row.set("floor",
          floor > 0.0 ? short_number(point.phases.steps() / floor) : "–");
  List cells;
  for (const std::string& quantity : bench.quantities) {
    Value cell;
    cell.set("text", per_cent(in(point.errors, quantity)));
    cell.set("small", per_cent(in(point.own_errors, quantity)));
    cells.push_back(cell);
  }
  row.set("cells", cells);
  return row;
}

List method_tables(const Bench& bench) {
  std::vector<std::string> names;
  for (const BenchPoint& point : bench.points)
    if (std::find(names.begin(), names.end(), point.method) == names.end())
      names.push_back(point.method);
  List tables;
  for (const std::string& name : names) {
    List rows;
    bool is_elastic = true;
    for (const BenchPoint& point : bench.points)
      if (point.method == name) {
        rows.push_back(setting_row(bench, point));
        is_elastic = point.is_elastic;
      }
    Value table;
    table.set("name", name);
    table.set(
        "own_note",
        is_elastic
            ? "Errors are with respect to the reference solution; in small "
              "print, with respect to the limit of this method's own series."
            : "This method does not solve the elastic continuum: the large "
              "figure is its difference from the reference solution, shown, "
              "not counted as an error; in small print is its error with "
              "respect to the limit of its own series.");
    std::vector<std::string> heads = bench.quantities;
    for (std::string& head : heads) // allows line breaks
      std::replace(head.begin(), head.end(), '_', ' ');
    table.set("heads", text_list(heads));
    table.set("rows", rows);
    tables.push_back(table);
  }
  return tables;
}

List scaling_tables(const Bench& bench) {
  List tables;
  for (const ScalingSeries& series : bench.scaling) {
    List rows;
    for (const ScalingRow& run : scaling_rows(bench, series)) {
      const BenchPoint& point = bench.points[run.point];
      Value row;
      row.set("label", point.label);
      row.set("bits", run.has_same_bits ? "" : "other numbers");
      row.set("wall", short_number(point.wall.median, "{:.3g}"));
      row.set("cpu", short_number(point.cpu.median, "{:.3g}"));
      row.set("speed_up", short_number(run.speed_up));
      row.set("efficiency", short_number(run.efficiency));
      row.set("cpu_ratio", short_number(run.cpu_ratio));
      rows.push_back(row);
    }
    Value table;
    table.set("heading", fmt::format("{}: {} scaling over {}", series.method,
                                     series.is_weak ? "weak" : "strong",
                                     series.has_ranks ? "ranks" : "threads"));
    table.set("rows", rows);
    tables.push_back(table);
  }
  return tables;
}

reports::DrawnGroup drawn(const std::string& heading,
                          const std::vector<reports::Figure>& figures,
                          const std::filesystem::path& folder,
                          const std::string& gnuplot,
                          std::vector<std::string>& problems) {
  reports::DrawnGroup group{heading, {}};
  for (const reports::Figure& figure : figures) {
    group.figures.push_back(reports::draw(figure, folder / "figures", gnuplot));
    if (!group.figures.back().problem.empty())
      problems.push_back(
          fmt::format("{}: {}", figure.name, group.figures.back().problem));
  }
  return group;
}

} // namespace

std::string per_cent(double share) {
  return std::isfinite(share) ? fmt::format("{:.2g} %", 100.0 * share) : "–";
}

std::vector<std::string> write_bench_report(const Bench& bench,
                                            const std::filesystem::path& folder,
                                            const std::string& gnuplot) {
  std::filesystem::create_directories(folder);
  write_file_atomically(folder / "bench.json", bench_json(bench));
  write_file_atomically(folder / "bench.csv", bench_csv(bench));
  std::vector<std::string> problems;
  std::vector<reports::DrawnGroup> groups;
  const auto draw_group = [&](const std::string& heading,
                              const std::vector<reports::Figure>& figures) {
    if (!figures.empty())
      groups.push_back(drawn(heading, figures, folder, gnuplot, problems));
  };
  draw_group("Scaling", scaling_figures(bench));
  if (bench.scaling.empty()) {
    draw_group("Finite-element blocks", block_figures(bench));
    draw_group("Cost and error", bench_figures(bench));
  }
  Value page;
  page.set("title", bench.case_title);
  page.set("page_title", "Benchmark: " + bench.case_title);
  page.set("lead", fmt::format("Case {}, {}: {} settings of its methods, each "
                               "run as a separate process{}.",
                               bench.case_name, bench.case_hash.substr(0, 12),
                               bench.points.size(),
                               bench.scaling.empty() ? " on one thread" : ""));
  page.set("answers", answers(bench));
  page.set("remarks", text_list(bench.remarks));
  List targets;
  for (const TargetOutcome& target : bench.targets)
    targets.push_back(target_data(target));
  page.set("targets", targets);
  page.set("reference",
           bench.reference.words.empty()
               ? "No reference solution is known for this case."
               : "Errors are with respect to " + bench.reference.words + ".");
  page.set("references", reference_rows(bench));
  page.set("has_errors", bench.scaling.empty());
  page.set("scaling", scaling_tables(bench));
  reports::set_figures(page, groups, false);
  page.set("series", series_rows(bench));
  page.set("timing_note",
           "CPU and wall time are medians of n timed runs, with the smallest "
           "and the largest below. A preceding warm-up run is not counted "
           "unless it is the only run (n = 1). Iterations and transforms are "
           "summed over all load steps.");
  page.set("methods", method_tables(bench));
  List facts;
  for (const auto& [key, fact] : bench.provenance) {
    Value value;
    value.set("key", key);
    value.set("fact", fact);
    facts.push_back(value);
  }
  page.set("facts", facts);
  page.set("case_text", bench.case_text);
  write_file_atomically(
      folder / "report.html",
      reports::rendered_page(bench_template, std::move(page)));
  return problems;
}

} // namespace asperity::bench
