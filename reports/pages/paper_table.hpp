#pragma once

// The table of every published number of a collection: a row a number and
// method of ours. Internal to the report on a collection.

#include "reports/analysis/judgement.hpp"
#include "reports/pages/paper_report.hpp"

#include <kainjow/mustache.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

struct PaperRow {
  std::string part;
  cases::ReferenceValue reference;
  bool is_first = true;         ///< of its number: the others repeat it
  std::size_t n_methods = 1;    ///< rows of its number
  std::optional<OurValue> ours; ///< none: no method answers
  Judgement judgement;
};

/// Published numbers by the best that a method of ours does.
struct PaperCounts {
  int numbers = 0;
  int reproduced = 0;
  int inconclusive = 0;
  int differs = 0;
  int not_reproducible = 0;
  int input = 0;   ///< set by the case, or fitted to
  int missing = 0; ///< no number of ours
};

struct PaperTable {
  std::vector<PaperRow> rows;

  PaperCounts counts() const;

  /// "Of 9 published numbers and claims ...: reproduced 5, inconclusive ..."
  std::string banner() const;
};

/// In the order of the parts and of their reference.csv.
PaperTable paper_table(std::span<const PaperPart> parts);

kainjow::mustache::data row_data(const PaperRow& row);

/// paper.json: the table, the counts and the parts, for programs.
std::string paper_json(std::span<const PaperPart> parts,
                       const PaperTable& table, const std::string& title);

} // namespace asperity::reports
