#include "reports/analysis/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

namespace asperity::reports {
namespace {

// XML 1.0 does not allow control characters, not even escaped.
std::string without_controls(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](unsigned char c) {
        return c < 0x20 && c != '\n' && c != '\t' && c != '\r';
      },
      '?');
  return text;
}

void set(pugi::xml_node node, const char* name, const std::string& text) {
  node.append_attribute(name).set_value(without_controls(text).c_str());
}

long count(const Summary& summary, Outcome outcome) {
  return std::count_if(summary.verdicts.begin(), summary.verdicts.end(),
                       [outcome](const Verdict& verdict) {
                         return verdict.outcome == outcome &&
                                !verdict.is_passed();
                       });
}

void append_verdict(pugi::xml_node suite, const Summary& summary,
                    const Verdict& verdict) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", summary.case_name + "." + verdict.method);
  set(test, "name", verdict.quantity);
  if (verdict.outcome == Outcome::ok)
    return;
  if (verdict.outcome == Outcome::skipped) {
    test.append_child("skipped");
    return;
  }
  if (verdict.is_passed()) { // undecided, and accepted by the case
    test.append_child("system-out")
        .text()
        .set(without_controls(check_line(verdict)).c_str());
    return;
  }
  const bool is_missing = verdict.outcome == Outcome::missing;
  pugi::xml_node problem = test.append_child(is_missing ? "error" : "failure");
  set(problem, "message", check_line(verdict));
  set(problem, "type", outcome_word(verdict.outcome));
}

// Adds a skipped test case, because a server that hides empty suites would
// otherwise report success.
void append_nothing(pugi::xml_node suite, const Summary& summary) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", summary.case_name);
  set(test, "name", "expectations");
  set(test.append_child("skipped"), "message", why_nothing_checked(summary));
}

} // namespace

std::string junit_xml(std::span<const Summary> summaries) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node suites = document.append_child("testsuites");
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
