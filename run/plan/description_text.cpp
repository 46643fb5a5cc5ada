// Formats the description of a case and its plan as text and as JSON.
#include "base/json.hpp"
#include "base/read_file.hpp"
#include "input/text/toml_text.hpp"
#include "run/plan/description.hpp"
#include "run/plan/needs.hpp"
#include "run/plan/plan.hpp"

#include <fmt/format.h>

namespace asperity::run {
namespace {

using OrderedJson = nlohmann::ordered_json;
using cases::Node;
using cases::NodeType;

constexpr std::size_t most_letters = 60; ///< of a value in the text

OrderedJson node_json(const Node& node) {
  OrderedJson value;
  switch (node.type) {
  case NodeType::boolean:
    return node.boolean;
  case NodeType::integer:
    return node.integer;
  case NodeType::floating:
    return node.floating;
  case NodeType::list:
    value = OrderedJson::array();
    for (const Node& one : node.list)
      value.push_back(node_json(one));
    return value;
  case NodeType::table:
    value = OrderedJson::object();
    for (const cases::NodeEntry& entry : node.entries)
      value[entry.key] = node_json(entry.node);
    return value;
  case NodeType::text:
  case NodeType::other:
    break;
  }
  return node.text;
}

std::string shortened(const std::string& text) {
  return text.size() <= most_letters ? text
                                     : text.substr(0, most_letters - 3) + "...";
}

/// Writes a value on one line; of a list of loads, the ends and the number.
std::string value_text(const cases::ResolvedKey& key) {
  const Node& value = key.value;
  const std::string unit = key.unit.empty() ? "" : " " + key.unit;
  if (value.type == NodeType::list && value.list.size() > 1 &&
      value.list.front().is_number())
    return fmt::format("{:.6g} ... {:.6g}{}, {} values",
                       value.list.front().number(), value.list.back().number(),
                       unit, value.list.size());
  if (value.type == NodeType::floating)
    return fmt::format("{:.10g}{}", value.floating, unit);
  return shortened(cases::toml_value(value) + unit);
}

std::string keys_text(const std::vector<cases::ResolvedKey>& keys) {
  std::string text;
  for (const cases::ResolvedKey& key : keys) {
    const std::string value = value_text(key);
    const bool is_converted = !key.written.empty() && !key.unit.empty() &&
                              key.value.type != NodeType::list;
    text += fmt::format("  {:<32} {}{}\n", key.path, value,
                        key.written.empty() ? "  (default)"
                        : is_converted ? "  (" + shortened(key.written) + ")"
                                       : "");
  }
  return text;
}

std::string loads_text(const CaseDescription& description) {
  const bool is_pressure =
      description.control == mechanics::Control::nominal_pressure;
  std::string text = fmt::format("load steps: {} in Pa (and E*)\n",
                                 is_pressure ? "nominal pressure" : "mean gap");
  if (!is_pressure)
    text = "load steps: mean gap in m (and h_rms)\n";
  constexpr std::size_t most_lines = 40;
  for (std::size_t step = 0; step < description.loads.size(); ++step) {
    if (step == most_lines) {
      text +=
          fmt::format("  ... {} steps in total\n", description.loads.size());
      break;
    }
    const DescribedLoad& load = description.loads[step];
    text += fmt::format("  {:>4}  {:.6g}  ({:.6g}){}\n", step, load.target,
                        load.reduced, load.is_unloading ? "  unloading" : "");
  }
  return text;
}

std::string grid_text(const Grid& grid) {
  return grid.points_x == 0
             ? "formula"
             : fmt::format("{} x {}", grid.points_x, grid.points_y);
}

} // namespace

std::string plan_text(const Plan& plan, const cases::Case& contact_case) {
  constexpr const char* row = "{:<18} {:>6} {:>6} {:>7} {:>13} {:>9} {:>9}\n";
  std::string text =
      fmt::format("{}: {}\n", contact_case.name, contact_case.title) +
      fmt::format(fmt::runtime(row), "method", "realis", "steps", "cached",
                  "grid", "unknowns", "memory");
  for (const PlannedMethod& method : plan.methods)
    text += fmt::format(fmt::runtime(row), method.name, method.realizations,
                        method.steps, method.kept_steps, grid_text(method.grid),
                        count_text(method.unknowns), bytes_text(method.memory));
  text += fmt::format("predicted: memory {} within a factor of {:g} on {} "
                      "thread{}, result {} (not including the report)\n",
                      bytes_text(plan.memory), memory_factor, plan.threads,
                      plan.threads == 1 ? "" : "s", bytes_text(plan.disk));
  if (const std::string refusal = refusal_of(plan); !refusal.empty())
    text += "the run would be refused: it " + refusal + "\n";
  if (!plan.skipped.empty())
    text += "skipped:\n";
  for (const results::Skipped& one : plan.skipped)
    text += fmt::format("  {}: {}\n", one.what, one.why);
  for (const std::string& warning : plan.warnings)
    text += fmt::format("warning: {}\n", warning);
  return text;
}

std::string shared_rows_text(const Plan& plan) {
  std::string text;
  for (const PlannedMethod& planned : plan.methods)
    if (planned.ranks > 1)
      text += fmt::format(
          "{}: {} ranks share the rows of the surface, {} on each\n",
          planned.name, planned.ranks,
          bytes_text(planned.rank_memory + base_memory(true)));
    else if (!planned.why_alone.empty())
      text += fmt::format("{}: rank 0 solves it alone, because {}\n",
                          planned.name, planned.why_alone);
  return text;
}

std::string description_text(const CaseDescription& description,
                             const cases::Case& contact_case) {
  std::string text =
      fmt::format("{}: {}\nfile {}\nhash {}\n", description.name,
                  description.title, description.file, description.hash);
  for (const auto& [key, hash] : description.inputs)
    text += fmt::format("{} has the SHA-256 {}\n", key, hash);
  text += "\nkeys, in SI units:\n" + keys_text(description.keys);
  text += "\nderived numbers:\n";
  for (const DerivedNumber& number : description.derived)
    text += fmt::format("  {:<32} {:.6g}{}  ({})\n", number.name, number.value,
                        number.unit == "1" ? "" : " " + number.unit,
                        number.meaning);
  text += "\n" + loads_text(description) + "\nmethods:\n";
  for (const DescribedMethod& method : description.methods)
    text += fmt::format("  {:<16} {}\n", method.name, method.text);
  return text + "\nplan:\n" + plan_text(description.plan, contact_case);
}

std::string plan_json(const Plan& plan, const cases::Case& contact_case) {
  OrderedJson answer = {
      {"case", contact_case.name},       {"threads", plan.threads},
      {"memory [bytes]", plan.memory},   {"result [bytes]", plan.disk},
      {"refusal", refusal_of(plan)},     {"methods", OrderedJson::array()},
      {"skipped", OrderedJson::array()}, {"warnings", plan.warnings}};
  for (const PlannedMethod& method : plan.methods)
    answer["methods"].push_back({{"name", method.name},
                                 {"realizations", method.realizations},
                                 {"steps", method.steps},
                                 {"cached_steps", method.kept_steps},
                                 {"points_x", method.grid.points_x},
                                 {"points_y", method.grid.points_y},
                                 {"unknowns", method.unknowns},
                                 {"memory [bytes]", method.memory}});
  for (const results::Skipped& one : plan.skipped)
    answer["skipped"].push_back({{"what", one.what}, {"why", one.why}});
  return text_of_json(answer, 2) + "\n";
}

std::string description_json(const CaseDescription& description,
                             const cases::Case& contact_case) {
  OrderedJson answer = {
      {"format", "asperity-description"},
      {"format_version", 1},
      {"case", description.name},
      {"title", description.title},
      {"file", description.file},
      {"case_hash", description.hash},
      {"inputs", description.inputs},
      {"keys", OrderedJson::object()},
      {"derived", OrderedJson::object()},
      {"control", description.control == mechanics::Control::nominal_pressure
                      ? "nominal_pressure"
                      : "mean_gap"},
      {"loads", OrderedJson::array()},
      {"methods", OrderedJson::array()}};
  for (const cases::ResolvedKey& key : description.keys)
    answer["keys"][key.path] = {{"value", node_json(key.value)},
                                {"unit", key.unit},
                                {"written", key.written.empty()
                                                ? OrderedJson(nullptr)
                                                : OrderedJson(key.written)}};
  for (const DerivedNumber& number : description.derived)
    answer["derived"][number.name] = {{"value", number.value},
                                      {"unit", number.unit},
                                      {"meaning", number.meaning}};
  for (const DescribedLoad& load : description.loads)
    answer["loads"].push_back({{"target", load.target},
                               {"reduced", load.reduced},
                               {"is_unloading", load.is_unloading}});
  for (const DescribedMethod& method : description.methods)
    answer["methods"].push_back({{"name", method.name},
                                 {"kind", method.kind},
                                 {"description", method.text}});
  answer["plan"] = json_of_text(plan_json(description.plan, contact_case));
  return text_of_json(answer, 2) + "\n";
}

} // namespace asperity::run
