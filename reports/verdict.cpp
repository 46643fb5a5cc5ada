#include "reports/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

const MethodSummary* find_method(std::span<const MethodSummary> methods,
                                 const std::string& name) {
  const auto found =
      std::find_if(methods.begin(), methods.end(),
                   [&](const MethodSummary& m) { return m.name == name; });
  return found == methods.end() ? nullptr : &*found;
}

Verdict judge_one(const cases::Expectation& expectation,
                  const std::string& method_name,
                  std::span<const MethodSummary> methods, bool is_complete) {
  Verdict verdict;
  verdict.quantity = expectation.quantity;
  verdict.method = method_name;
  verdict.low = expectation.low;
  verdict.high = expectation.high;
  const MethodSummary* method = find_method(methods, method_name);
  if (method == nullptr) {
    // A run names all its methods at its start, so a complete result lacks
    // only what was left out on purpose.
    if (is_complete)
      verdict.outcome = Outcome::skipped;
    verdict.estimate.remark = "the method is not in the result";
    return verdict;
  }
  const auto found = method->quantities.find(expectation.quantity);
  if (found == method->quantities.end()) {
    verdict.estimate.remark = "the method does not answer this";
    return verdict;
  }
  verdict.estimate = found->second;
  if (!verdict.estimate.has_value())
    return verdict;
  const double value = verdict.estimate.value;
  verdict.outcome = value >= expectation.low && value <= expectation.high
                        ? Outcome::ok
                        : Outcome::failed;
  return verdict;
}

std::string value_text(const Estimate& estimate) {
  if (!estimate.has_value())
    return "none";
  std::string text = fmt::format("{:.4g}", estimate.value);
  if (estimate.has_interval())
    text += fmt::format(" +- {:.2g}", estimate.half_width);
  return text;
}

} // namespace

std::vector<Verdict> judge(std::span<const cases::Expectation> expectations,
                           std::span<const MethodSummary> methods,
                           bool is_complete) {
  std::vector<Verdict> verdicts;
  for (const cases::Expectation& expectation : expectations)
    for (const std::string& method : expectation.methods)
      verdicts.push_back(judge_one(expectation, method, methods, is_complete));
  return verdicts;
}

const char* outcome_word(Outcome outcome) {
  switch (outcome) {
  case Outcome::ok:
    return "ok";
  case Outcome::failed:
    return "failed";
  case Outcome::skipped:
    return "skipped";
  case Outcome::missing:
    break;
  }
  return "missing";
}

std::string band_text(double low, double high) {
  if (std::isfinite(low) && std::isfinite(high))
    return fmt::format("{:.4g}..{:.4g}", low, high);
  if (std::isfinite(high))
    return fmt::format("<= {:.4g}", high);
  if (std::isfinite(low))
    return fmt::format(">= {:.4g}", low);
  return "any value";
}

bool Summary::all_ok() const {
  return std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) {
    return v.outcome == Outcome::ok || v.outcome == Outcome::skipped;
  });
}

std::string check_line(const Verdict& verdict) {
  const bool has_value = verdict.estimate.has_value();
  const std::string band = band_text(verdict.low, verdict.high);
  const bool is_range =
      std::isfinite(verdict.low) && std::isfinite(verdict.high);
  return fmt::format("{:<7}  {:<14} {:<20} {} {}{}{}",
                     outcome_word(verdict.outcome), verdict.method,
                     verdict.quantity, value_text(verdict.estimate),
                     is_range ? "in " : "", band,
                     has_value ? "" : "; " + verdict.estimate.remark);
}

} // namespace asperity::reports
