#include "reports/analysis/verdict.hpp"

#include "base/shown_number.hpp"
#include "reports/numbers/determined.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

Outcome outcome_of(const Estimate& estimate, double low, double high) {
  const double half = estimate.has_interval() ? estimate.half_width : 0.0;
  const double least = estimate.value - half;
  const double largest = estimate.value + half;
  if (least >= low && largest <= high)
    return Outcome::ok;
  return largest < low || least > high ? Outcome::failed : Outcome::undecided;
}

// Explains why a method lacks a quantity.
std::string why_missing(const MethodSummary& method) {
  return method.problems.empty()
             ? "the method does not compute this quantity"
             : fmt::format("{}", fmt::join(method.problems, "; "));
}

Verdict verdict_on(const cases::Expectation& expectation,
                   const std::string& method_name,
                   std::span<const MethodSummary> methods, bool is_complete) {
  Verdict verdict;
  verdict.quantity = expectation.quantity;
  verdict.method = method_name;
  verdict.low = expectation.low;
  verdict.high = expectation.high;
  verdict.passes_if_undecided = expectation.passes_if_undecided;
  const MethodSummary* method = method_called(methods, method_name);
  if (method == nullptr) {
    // A run lists all its methods at its start, so a complete result lacks only
    // those that were deliberately omitted.
    if (is_complete)
      verdict.outcome = Outcome::skipped;
    verdict.estimate.remark = "the method is not in the result";
    return verdict;
  }
  const Estimate* const found = method->quantity(expectation.quantity);
  if (found == nullptr) {
    verdict.estimate.remark = why_missing(*method);
    return verdict;
  }
  verdict.estimate = *found;
  if (verdict.estimate.has_value())
    verdict.outcome =
        outcome_of(verdict.estimate, expectation.low, expectation.high);
  return verdict;
}

std::string value_text(const Estimate& estimate) {
  if (!estimate.has_value())
    return undetermined_word;
  std::string text = fmt::format("{:.4g}", estimate.value);
  if (estimate.has_interval())
    text += fmt::format(" ± {:.2g}", estimate.half_width);
  return text;
}

std::string ours_text(const OurValue& ours, const std::string& unit) {
  return ours.estimate.has_value()
             ? ours.method + " " + quantity_text(ours.estimate.value, unit, 4)
             : fmt::format("{} {} ({})", ours.method, undetermined_word,
                           ours.estimate.remark);
}

} // namespace

std::vector<Verdict> judge(std::span<const cases::Expectation> expectations,
                           std::span<const MethodSummary> methods,
                           bool is_complete) {
  std::vector<Verdict> verdicts;
  for (const cases::Expectation& expectation : expectations)
    for (const std::string& method : expectation.methods)
      verdicts.push_back(verdict_on(expectation, method, methods, is_complete));
  return verdicts;
}

const char* outcome_word(Outcome outcome) {
  switch (outcome) {
  case Outcome::ok:
    return "ok";
  case Outcome::failed:
    return "failed";
  case Outcome::undecided:
    return "undecided";
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

bool Verdict::is_passed() const {
  return outcome == Outcome::ok ||
         (outcome == Outcome::undecided && passes_if_undecided);
}

bool Summary::all_ok() const {
  return std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) {
    return v.is_passed() || v.outcome == Outcome::skipped;
  });
}

int Summary::n_judged() const {
  return static_cast<int>(
      std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) {
        return v.outcome != Outcome::skipped;
      }));
}

std::string why_nothing_checked(const Summary& summary) {
  if (summary.n_judged() > 0)
    return "";
  if (summary.verdicts.empty())
    return "nothing was checked: the case states no expectation; put one under "
           "[expect], such as gamma_slope = { value = 0.4, within = 0.05 }";
  std::vector<std::string> methods;
  for (const Verdict& verdict : summary.verdicts)
    if (std::find(methods.begin(), methods.end(), verdict.method) ==
        methods.end())
      methods.push_back(verdict.method);
  return fmt::format("nothing was checked: the expectations concern {}, which "
                     "the result does not have; run the case with them",
                     fmt::join(methods, ", "));
}

std::string check_line(const Verdict& verdict) {
  const bool has_value = verdict.estimate.has_value();
  const std::string band = band_text(verdict.low, verdict.high);
  const bool is_range =
      std::isfinite(verdict.low) && std::isfinite(verdict.high);
  std::string remark = has_value ? "" : "; " + verdict.estimate.remark;
  if (verdict.outcome == Outcome::undecided)
    remark = verdict.passes_if_undecided
                 ? "; its interval crosses a limit of the band, which the case "
                   "counts as passed"
                 : "; its interval crosses a limit of the band: not passed";
  return fmt::format("{:<9}  {:<14} {:<20} {} {}{}{}",
                     outcome_word(verdict.outcome), verdict.method,
                     verdict.quantity, value_text(verdict.estimate),
                     is_range ? "in " : "", band, remark);
}

std::vector<PublishedValue>
beside_ours(std::span<const cases::ReferenceValue> references,
            std::span<const MethodSummary> methods) {
  std::vector<PublishedValue> published;
  for (const cases::ReferenceValue& reference : references) {
    PublishedValue one{reference, {}};
    for (const MethodSummary& method : methods)
      if (const Estimate* const found = method.quantity(reference.quantity))
        one.ours.push_back({method.name, *found});
    published.push_back(std::move(one));
  }
  return published;
}

std::string published_text(const cases::ReferenceValue& reference) {
  if (reference.unit != "1")
    return uncertain_text(reference.value, reference.uncertainty,
                          reference.unit);
  std::string text = fmt::format("{:.6g}", reference.value);
  if (reference.uncertainty > 0.0)
    text += fmt::format(" ± {:.2g}", reference.uncertainty);
  return text;
}

std::string published_line(const PublishedValue& published) {
  const cases::ReferenceValue& reference = published.reference;
  std::string line = fmt::format(
      "{:<9}  {:<20} {}", reference.uncertainty > 0.0 ? "paper" : "exact",
      reference.quantity, published_text(reference));
  for (std::size_t i = 0; i < published.ours.size(); ++i)
    line +=
        (i == 0 ? ": " : ", ") + ours_text(published.ours[i], reference.unit);
  return published.ours.empty() ? line + ": not computed" : line;
}

} // namespace asperity::reports
