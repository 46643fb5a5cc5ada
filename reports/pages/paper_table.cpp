#include "reports/pages/paper_table.hpp"

#include "reports/analysis/claims.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/numbers/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::reports {
namespace {

std::string remark_of(const Estimate& estimate, Reproduction verdict) {
  if (!estimate.has_value()) // a verdict on the published number replaces it
    return verdict == Reproduction::missing ? "" : estimate.remark;
  return estimate.realizations > 1
             ? fmt::format("{} realisations", estimate.realizations)
             : "";
}

std::string with_plus_minus_sign(std::string text) {
  if (const std::size_t at = text.find("+-"); at != std::string::npos)
    text.replace(at, 2, "±");
  return text;
}

} // namespace

PaperTable paper_table(std::span<const PaperPart> parts) {
  PaperTable table;
  for (const PaperPart& part : parts)
    for (const PublishedValue& published : part.entry.summary.published) {
      PaperRow row{
          part.name,    published.reference,
          true,         std::max<std::size_t>(published.ours.size(), 1),
          std::nullopt, {}};
      if (published.ours.empty()) {
        Estimate none;
        none.remark = "no method of the case computes this";
        row.judgement = compare_with_published(published.reference, none);
        table.rows.push_back(row);
      }
      for (const OurValue& ours : published.ours) {
        row.ours = ours;
        row.judgement =
            compare_with_published(published.reference, ours.estimate);
        table.rows.push_back(row);
        row.is_first = false;
      }
    }
  return table;
}

PaperCounts PaperTable::counts() const {
  PaperCounts counts;
  for (std::size_t i = 0; i < rows.size();) {
    Reproduction best = rows[i].judgement.reproduction;
    for (++i; i < rows.size() && !rows[i].is_first; ++i)
      best = std::min(best, rows[i].judgement.reproduction);
    ++counts.numbers;
    switch (best) {
    case Reproduction::reproduced:
      ++counts.reproduced;
      break;
    case Reproduction::inconclusive:
      ++counts.inconclusive;
      break;
    case Reproduction::differs:
      ++counts.differs;
      break;
    case Reproduction::not_reproducible:
      ++counts.not_reproducible;
      break;
    case Reproduction::input:
      ++counts.input;
      break;
    case Reproduction::missing:
      ++counts.missing;
      break;
    }
  }
  return counts;
}

std::string PaperTable::banner() const {
  const PaperCounts n = counts();
  return fmt::format(
      "Of {} published numbers and claims, each compared with the method that "
      "comes nearest: reproduced {}, inconclusive because our own interval is "
      "too wide {}, different by the amount stated {}, not reproducible for "
      "the reason stated {}, set by the case or fitted to it {}, without a "
      "computed value {}.",
      n.numbers, n.reproduced, n.inconclusive, n.differs, n.not_reproducible,
      n.input, n.missing);
}

kainjow::mustache::data row_data(const PaperRow& row) {
  kainjow::mustache::data value;
  value.set("class", row.is_first ? "first" : "more");
  value.set("is_first", row.is_first);
  if (row.is_first) {
    value.set("n_methods", std::to_string(row.n_methods));
    value.set("quantity", row.reference.quantity);
    value.set("meaning", meaning_of(row.reference.quantity));
    value.set("source", row.reference.source);
    value.set("published", with_plus_minus_sign(published_text(row.reference)));
    value.set("part", row.part);
    value.set("section", section_of(row.part));
  }
  value.set("method", row.ours ? row.ours->method : "–");
  value.set("value", row.ours ? number_text(row.ours->estimate) : "–");
  value.set("remark",
            row.ours ? remark_of(row.ours->estimate, row.judgement.reproduction)
                     : "");
  value.set("verdict_class", reproduction_word(row.judgement.reproduction));
  value.set("verdict", row.judgement.words);
  return value;
}

} // namespace asperity::reports
