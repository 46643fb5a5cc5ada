#include "cases/types/expectations.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::reports {
namespace {

using Value = kainjow::mustache::data;
using List = kainjow::mustache::list;

// Formats "0.35 … 0.45" and "≤ 0.05" for a page.
std::string with_typographic_signs(std::string band) {
  for (const auto& [plain, sign] :
       {std::pair("..", " … "), std::pair("<=", "≤"), std::pair(">=", "≥")})
    if (const std::size_t at = band.find(plain); at != std::string::npos)
      band.replace(at, 2, sign);
  return band;
}

std::string undecided_words(const Verdict& verdict) {
  return fmt::format("the interval crosses a limit of the band, which the "
                     "case counts as {}; {}",
                     verdict.passes_if_undecided ? "passed" : "not passed",
                     verdict.estimate.remark);
}

} // namespace

List verdict_rows(const Summary& summary) {
  List rows;
  for (const Verdict& verdict : summary.verdicts) {
    Value row;
    row.set("word", outcome_word(verdict.outcome));
    row.set("sign", verdict.outcome == Outcome::ok          ? "✓"
                    : verdict.outcome == Outcome::skipped   ? "–"
                    : verdict.outcome == Outcome::undecided ? "?"
                                                            : "✗");
    row.set("method", verdict.method);
    row.set("quantity", verdict.quantity);
    const cases::ExpectationName* known =
        cases::expectation_called(verdict.quantity);
    row.set("meaning", known == nullptr ? "" : known->description);
    row.set("value", number_text(verdict.estimate));
    row.set("band",
            with_typographic_signs(band_text(verdict.low, verdict.high)));
    row.set("remark", verdict.outcome == Outcome::undecided
                          ? undecided_words(verdict)
                          : verdict.estimate.remark);
    rows.push_back(row);
  }
  return rows;
}

std::string banner_words(const Summary& summary) {
  const int all = summary.n_judged();
  if (all == 0)
    return summary.verdicts.empty()
               ? "The case states no expectations."
               : "No expectation concerns a method that was run.";
  const auto count = [&](auto holds) {
    return std::count_if(summary.verdicts.begin(), summary.verdicts.end(),
                         holds);
  };
  const auto met =
      count([](const Verdict& v) { return v.outcome == Outcome::ok; });
  const auto passed = count([](const Verdict& v) { return v.is_passed(); });
  std::string words =
      passed < all
          ? fmt::format("{} of {} expectations are not met.", all - passed, all)
      : met < all ? fmt::format("{} of {} expectations are met.", met, all)
      : all == 1  ? std::string("The one expectation is met.")
                  : fmt::format("All {} expectations are met.", all);
  if (passed > met)
    words += fmt::format(" {} {} undecided, which the case counts as passed.",
                         passed - met, passed - met == 1 ? "is" : "are");
  return words;
}

std::string banner_class(const Summary& summary) {
  if (!summary.all_ok())
    return "bad";
  const bool is_all_met =
      std::all_of(summary.verdicts.begin(), summary.verdicts.end(),
                  [](const Verdict& verdict) {
                    return verdict.outcome == Outcome::ok ||
                           verdict.outcome == Outcome::skipped;
                  });
  return is_all_met && summary.n_judged() > 0 ? "good" : "none";
}

} // namespace asperity::reports
