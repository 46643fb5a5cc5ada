#include "base/json.hpp"
#include "suite/bench/pages/bench_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace asperity::bench {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const BenchTime& time) {
  return {{"median [s]", time.median},
          {"least [s]", time.least},
          {"largest [s]", time.largest}};
}

Json to_json(const reports::PowerLaw& law) {
  return {{"exponent", law.determined_exponent()},
          {"standard_error", law.exponent_error},
          {"factor", law.factor},
          {"points", law.points}};
}

Json to_json(const BenchPhases& phases) {
  return {
      {"setup [s]", phases.setup},     {"transforms [s]", phases.transforms},
      {"solving [s]", phases.solving}, {"observation [s]", phases.observation},
      {"writing [s]", phases.writing}, {"rest [s]", phases.rest}};
}

Json to_json(const BenchAnswer& answer) {
  return {{"rms_height [m]", answer.rms_height},
          {"nominal_pressure [Pa]", answer.pressure},
          {"values", answer.values}};
}

Json to_json(const BenchPoint& point) {
  return {{"method", point.method},
          {"kind", point.kind},
          {"label", point.label},
          {"overrides", point.overrides},
          {"points", point.points},
          {"is_own", point.is_own},
          {"is_elastic", point.is_elastic},
          {"is_reference", point.is_reference},
          {"problem", point.problem},
          {"repeats", point.repeats},
          {"has_warm_up", point.has_warm_up},
          {"is_repeatable", point.is_repeatable},
          {"wall_time", to_json(point.wall)},
          {"cpu_time", to_json(point.cpu)},
          {"peak_memory [B]", point.peak_memory},
          {"unknowns", point.unknowns},
          {"steps", point.steps},
          {"failed_steps", point.failed_steps},
          {"iterations", point.iterations},
          {"transforms", point.transforms},
          {"phases", to_json(point.phases)},
          {"transform_pair [s]", point.transform_pair},
          {"errors", point.errors},
          {"own_errors", point.own_errors},
          {"answer", to_json(point.answer)}};
}

Json to_json(const std::map<std::string, reports::PowerLaw>& laws) {
  Json table = Json::object();
  for (const auto& [quantity, law] : laws)
    table[quantity] = to_json(law);
  return table;
}

Json to_json(const BenchSeries& series) {
  Json orders = Json::object();
  for (const auto& [quantity, order] : series.orders)
    orders[quantity] = {{"by_differences", order.by_differences},
                        {"error", to_json(order.error)}};
  return {{"method", series.method},
          {"axis", series.axis},
          {"title", series.title},
          {"points", series.points},
          {"coordinates", series.coordinates},
          {"theoretical_orders", series.theoretical_orders},
          {"order_source", series.order_source},
          {"orders", orders},
          {"cpu_time_against_points", to_json(series.cost)},
          {"step_time_against_points", to_json(series.step_cost)},
          {"error_against_unknowns", to_json(series.against_unknowns)},
          {"error_against_cpu_time", to_json(series.against_cpu_time)}};
}

Json to_json(const TargetOutcome& target) {
  Json checks = Json::array();
  for (const TargetCheck& check : target.checks)
    checks.push_back({{"quantity", check.quantity},
                      {"estimator", check.estimator},
                      {"method", check.method},
                      {"predicted", check.predicted},
                      {"found", check.found},
                      {"is_met", check.is_met}});
  return {{"target", target.target},
          {"overrides", target.overrides},
          {"chosen", target.chosen},
          {"finer", target.finer},
          {"problem", target.problem},
          {"is_met", target.is_met()},
          {"earlier", target.earlier},
          {"predicted_cpu_time [s]", target.predicted_cpu_time},
          {"cpu_time [s]", target.cpu_time},
          {"search_cpu_time [s]", target.search_cpu_time},
          {"checks", checks}};
}

template <class Item>
Json list_of(const std::vector<Item>& items) {
  Json list = Json::array();
  for (const Item& item : items)
    list.push_back(to_json(item));
  return list;
}

std::string quoted(const std::string& text) {
  std::string field = "\"";
  for (const char c : text)
    field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + "\"";
}

} // namespace

Json bench_json(const Bench& bench) {
  Json facts = Json::object();
  for (const auto& [key, fact] : bench.provenance)
    facts[key] = fact;
  return {{"format", "asperity-bench"},
          {"format_version", 1},
          {"case", bench.case_name},
          {"title", bench.case_title},
          {"case_hash", bench.case_hash},
          {"provenance", facts},
          {"remarks", bench.remarks},
          {"quantities", bench.quantities},
          {"reference",
           {{"words", bench.reference.words},
            {"answer", to_json(bench.reference.answer)},
            {"uncertainty", bench.reference.uncertainty},
            {"order", bench.reference.order},
            {"is_exact", bench.reference.is_exact}}},
          {"points", list_of(bench.points)},
          {"series", list_of(bench.series)},
          {"fronts", bench.fronts},
          {"targets", list_of(bench.targets)}};
}

std::string bench_csv(const Bench& bench) {
  std::string text =
      "method,kind,setting,points,is_own,is_reference,repeats,"
      "wall_time [s],least_wall_time [s],largest_wall_time [s],"
      "cpu_time [s],least_cpu_time [s],largest_cpu_time [s],peak_memory [B],"
      "unknowns,steps,failed_steps,iterations,transforms,setup [s],transforms "
      "[s],"
      "solving [s],observation [s],writing [s],rest [s],transform_floor [s]";
  for (const std::string& quantity : bench.quantities)
    text += "," + quoted("error of " + quantity) + "," +
            quoted("own error of " + quantity);
  text += "\r\n";
  for (const BenchPoint& point : bench.points) {
    const BenchPhases& phases = point.phases;
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{}\r\n", point.method, point.kind,
        quoted(point.label), point.points, int{point.is_own},
        int{point.is_reference}, point.repeats,
        fmt::join(
            std::vector<double>{
                point.wall.median, point.wall.least, point.wall.largest,
                point.cpu.median, point.cpu.least, point.cpu.largest,
                point.peak_memory, point.unknowns, double(point.steps),
                double(point.failed_steps), double(point.iterations),
                double(point.transforms), phases.setup, phases.transforms,
                phases.solving, phases.observation, phases.writing, phases.rest,
                point.transform_floor()},
            ","),
        [&] {
          std::vector<double> errors;
          for (const std::string& quantity : bench.quantities) {
            errors.push_back(number_of(point.errors, quantity));
            errors.push_back(number_of(point.own_errors, quantity));
          }
          return fmt::format("{}", fmt::join(errors, ","));
        }());
  }
  return text;
}

} // namespace asperity::bench
