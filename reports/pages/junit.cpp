#include "base/plain_text.hpp"
#include "reports/analysis/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

namespace asperity::reports {
namespace {

// XML 1.0 does not allow control characters, not even escaped.
void set(pugi::xml_node node, const char* name, const std::string& text) {
  node.append_attribute(name).set_value(plain_text(text).c_str());
}

long count(const Summary& summary, Outcome outcome) {
  return std::count_if(summary.verdicts.begin(), summary.verdicts.end(),
                       [outcome](const Verdict& verdict) {
                         return verdict.outcome == outcome &&
                                !verdict.is_passed();
                       });
}

void append_property(pugi::xml_node properties, const char* name,
                     const std::string& text) {
  pugi::xml_node property = properties.append_child("property");
  set(property, "name", name);
  set(property, "value", text);
}

// Adds a number; one that is not finite is left out.
void append_number(pugi::xml_node properties, const char* name, double number) {
  if (std::isfinite(number))
    append_property(properties, name, fmt::format("{}", number));
}

// Adds the value with its interval, the band and the verdict as properties,
// which servers display and scripts read.
void append_numbers(pugi::xml_node test, const Verdict& verdict) {
  pugi::xml_node properties = test.append_child("properties");
  append_number(properties, "value", verdict.estimate.value);
  append_number(properties, "half_width_95", verdict.estimate.half_width);
  append_number(properties, "low", verdict.low);
  append_number(properties, "high", verdict.high);
  append_property(properties, "verdict", outcome_word(verdict.outcome));
}

double cpu_time_of(const Summary& summary, const std::string& method) {
  for (const MethodSummary& one : summary.methods)
    if (one.name == method && std::isfinite(one.cost.cpu_time))
      return one.cost.cpu_time;
  return 0.0;
}

// Returns the CPU time of the method of a verdict, divided by the number of its
// verdicts, so that the test cases of a suite add up to the time of its methods
// [s].
double time_of(const Summary& summary, const Verdict& verdict) {
  const auto same = std::count_if(
      summary.verdicts.begin(), summary.verdicts.end(),
      [&](const Verdict& v) { return v.method == verdict.method; });
  return cpu_time_of(summary, verdict.method) / static_cast<double>(same);
}

// Returns the line of a verdict; of a case that was not checked, the reason.
std::string line_of(const Verdict& verdict) {
  return verdict.method.empty() ? verdict.estimate.remark : check_line(verdict);
}

void append_verdict(pugi::xml_node suite, const Summary& summary,
                    const Verdict& verdict) {
  const bool is_problem = verdict.method.empty();
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname",
      summary.case_name + (is_problem ? "" : "." + verdict.method));
  set(test, "name", verdict.quantity);
  set(test, "time", fmt::format("{:.3f}", time_of(summary, verdict)));
  if (!is_problem)
    append_numbers(test, verdict);
  if (verdict.outcome == Outcome::skipped) {
    test.append_child("skipped");
  } else if (!verdict.is_passed()) {
    const bool is_missing = verdict.outcome == Outcome::missing;
    pugi::xml_node problem =
        test.append_child(is_missing ? "error" : "failure");
    set(problem, "message", line_of(verdict));
    set(problem, "type", outcome_word(verdict.outcome));
  }
  test.append_child("system-out")
      .text()
      .set(plain_text(line_of(verdict)).c_str());
}

// Adds a skipped test case, because a server that hides empty suites would
// otherwise report success.
void append_nothing(pugi::xml_node suite, const Summary& summary) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", summary.case_name);
  set(test, "name", "expectations");
  set(test.append_child("skipped"), "message", why_nothing_checked(summary));
}

// Returns the CPU time of the methods that have a verdict [s].
double cpu_time_of(const Summary& summary) {
  double time = 0.0;
  for (const Verdict& verdict : summary.verdicts)
    time += time_of(summary, verdict);
  return time;
}

// Adds what identifies case and program.
void append_facts(pugi::xml_node suite, const Summary& summary) {
  pugi::xml_node properties = suite.append_child("properties");
  append_property(properties, "title", summary.case_title);
  append_property(properties, "case_hash", summary.case_hash);
  for (const auto& [name, fact] : summary.provenance)
    if (name == "program" || name == "commit" || name == "started")
      append_property(properties, name.c_str(), fact);
}

} // namespace

std::string junit_xml(std::span<const Summary> summaries) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node suites = document.append_child("testsuites");
  set(suites, "name", "asperity");
  for (const Summary& summary : summaries) {
    pugi::xml_node suite = suites.append_child("testsuite");
    set(suite, "name", summary.case_name);
    const bool is_empty = summary.verdicts.empty();
    set(suite, "tests",
        std::to_string(summary.verdicts.size() + (is_empty ? 1 : 0)));
    set(suite, "failures",
        std::to_string(count(summary, Outcome::failed) +
                       count(summary, Outcome::undecided)));
    set(suite, "errors", std::to_string(count(summary, Outcome::missing)));
    set(suite, "skipped",
        std::to_string(count(summary, Outcome::skipped) + (is_empty ? 1 : 0)));
    set(suite, "time", fmt::format("{:.3f}", cpu_time_of(summary)));
    append_facts(suite, summary);
    if (is_empty)
      append_nothing(suite, summary);
    for (const Verdict& verdict : summary.verdicts)
      append_verdict(suite, summary, verdict);
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

} // namespace asperity::reports
