#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "reports/pages/page_data.hpp"
#include "suite/bench/analysis/bench_answer.hpp"
#include "suite/bench/bench_template.hpp"
#include "suite/bench/pages/bench_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace asperity::bench {
namespace {

using Json = nlohmann::ordered_json;

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
    return number_of(point.errors, quantity);
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

/// What the page answers, before its tables: one sentence per quantity.
Json answers(const Bench& bench) {
  constexpr std::size_t most_quantities = 3;
  Json list = Json::array();
  for (const std::string& quantity : bench.quantities) {
    std::string needs;
    std::set<std::string> seen;
    for (const BenchPoint& point : bench.points)
      if (seen.insert(point.method).second)
        if (const std::string need = need_of(bench, point.method, quantity);
            !need.empty())
          needs += (needs.empty() ? "" : "; ") + need;
    if (!needs.empty() && list.size() < most_quantities)
      list.push_back(fmt::format(
          "CPU time for an error of {} of at most 1 %: {}.", quantity, needs));
  }
  return list;
}

Json reference_rows(const Bench& bench) {
  Json rows = Json::array();
  for (const std::string& quantity : bench.quantities) {
    if (!bench.reference.answer.values.contains(quantity))
      continue;
    const auto exact = bench.reference.is_exact.find(quantity);
    const bool is_exact =
        exact != bench.reference.is_exact.end() && exact->second;
    const double order = number_of(bench.reference.order, quantity);
    rows.push_back(
        {{"quantity", quantity},
         {"meaning", error_words(quantity)},
         {"kind",
          is_exact ? "exact"
          : std::isfinite(order)
              ? "Richardson limit"
              : "the finest grid, because the series converges irregularly"},
         {"order", is_exact ? not_a_number : order},
         {"uncertainty",
          is_exact ? not_a_number
                   : number_of(bench.reference.uncertainty, quantity)}});
  }
  return rows;
}

Json series_rows(const Bench& bench) {
  Json rows = Json::array();
  for (const BenchSeries& series : bench.series) {
    bool is_first = true;
    for (const std::string& quantity : bench.quantities) {
      const auto order = series.orders.find(quantity);
      if (order == series.orders.end() ||
          (!std::isfinite(order->second.by_differences) &&
           !order->second.error.is_known()))
        continue;
      rows.push_back(
          {{"is_first", std::exchange(is_first, false)},
           {"method", series.method},
           {"axis", series.title},
           {"source", series.order_source},
           {"quantity", quantity},
           {"order", order->second.by_differences},
           {"slope", order->second.error.determined_exponent()},
           {"unknowns_slope", exponent_in(series.against_unknowns, quantity)},
           {"theory", number_of(series.theoretical_orders, quantity)},
           {"cost", series.cost.determined_exponent()},
           {"step_cost", series.step_cost.determined_exponent()}});
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

/// Adds to a setting of bench.json what the table of the page shows of it.
Json setting_row(const Bench& bench, const BenchPoint& point, Json row) {
  const double floor = point.transform_floor();
  row["remark"] = remark_of(point);
  row["memory [MiB]"] =
      point.repeats > 0 ? point.peak_memory / 1048576.0 : not_a_number;
  row["floor"] = floor > 0.0 ? point.phases.steps() / floor : not_a_number;
  if (point.repeats == 0)
    row["iterations"] = nullptr;
  if (point.transforms == 0)
    row["transforms"] = nullptr;
  row["cells"] = Json::array();
  for (const std::string& quantity : bench.quantities)
    row["cells"].push_back(
        {{"error", number_of(point.errors, quantity)},
         {"own_error", number_of(point.own_errors, quantity)}});
  return row;
}

Json method_tables(const Bench& bench, const Json& points) {
  std::vector<std::string> heads = bench.quantities;
  for (std::string& head : heads) // allows line breaks
    std::replace(head.begin(), head.end(), '_', ' ');
  Json tables = Json::array();
  for (std::size_t i = 0; i < bench.points.size(); ++i) {
    const BenchPoint& point = bench.points[i];
    auto table = std::ranges::find_if(
        tables, [&](const Json& one) { return one["name"] == point.method; });
    if (table == tables.end()) {
      tables.push_back(
          {{"name", point.method}, {"heads", heads}, {"rows", Json::array()}});
      table = std::prev(tables.end());
    }
    (*table)["is_elastic"] = point.is_elastic;
    (*table)["rows"].push_back(setting_row(bench, point, points[i]));
  }
  return tables;
}

} // namespace

std::string per_cent(double share) {
  return std::isfinite(share) ? fmt::format("{:.2g} %", 100.0 * share) : "–";
}

std::vector<std::string> write_bench_report(const Bench& bench,
                                            const std::filesystem::path& folder,
                                            const std::string& gnuplot) {
  std::filesystem::create_directories(folder);
  Json page = bench_json(bench);
  write_file_atomically(folder / "bench.json", text_of_json(page, 2) + "\n");
  write_file_atomically(folder / "bench.csv", bench_csv(bench));
  std::vector<std::string> problems;
  const std::vector<reports::FigureGroup> figures{
      {"Finite-element blocks", "", block_figures(bench)},
      {"Cost and error", "", bench_figures(bench)}};
  const std::vector<reports::DrawnGroup> groups =
      reports::drawn_groups_of(figures, folder, gnuplot, {}, problems);
  page["page_title"] = "Benchmark: " + bench.case_title;
  page["lead"] = fmt::format("Case {}, {}: {} settings of its methods, each "
                             "run as a separate process on one thread.",
                             bench.case_name, bench.case_hash.substr(0, 12),
                             bench.points.size());
  page["answers"] = answers(bench);
  page["references"] = reference_rows(bench);
  page["series"] = series_rows(bench);
  page["methods"] = method_tables(bench, page["points"]);
  page["facts"] = reports::items_of(page["provenance"]);
  page["case_text"] = bench.case_text;
  page["groups"] = reports::group_data(groups);
  reports::write_page(bench_template, page, groups, folder, false, problems);
  return problems;
}

} // namespace asperity::bench
