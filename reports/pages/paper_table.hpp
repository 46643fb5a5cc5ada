#pragma once

// Builds the table of all published numbers of a collection, with one row per
// number and computing method. It is internal to the report on a collection.

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
  bool is_first = true; ///< first row of its number, whose other rows repeat it
  std::size_t n_methods = 1;    ///< number of rows of its number
  std::optional<OurValue> ours; ///< none: no method provides it
  Judgement judgement;
};

/// Counts of published numbers by the best verdict of any method.
struct PaperCounts {
  int numbers = 0;
  int reproduced = 0;
  int inconclusive = 0;
  int differs = 0;
  int not_reproducible = 0;
  int input = 0;   ///< prescribed by the case, or fitted
  int missing = 0; ///< no computed number
};

struct PaperTable {
  std::vector<PaperRow> rows;

  PaperCounts counts() const;

  /// Returns "Of 9 published numbers and claims ...: reproduced 5, inconclusive
  /// ...".
  std::string banner() const;
};

/// Builds the table, in the order of the parts and of their reference.csv.
PaperTable paper_table(std::span<const PaperPart> parts);

kainjow::mustache::data row_data(const PaperRow& row);

/// Writes paper.json: the table, the counts and the parts, for use by programs.
std::string paper_json(std::span<const PaperPart> parts,
                       const PaperTable& table, const std::string& title);

} // namespace asperity::reports
