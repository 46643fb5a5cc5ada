#pragma once

// The table of every published number of a collection: a row a number and
// method of ours. Internal to the report on a collection.

#include "reports/judgement.hpp"
#include "reports/paper_report.hpp"

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

struct PaperTable {
  std::vector<PaperRow> rows;

  /// "Of 9 published numbers 5 are reproduced by a method at least, ..."
  std::string banner() const;
};

/// In the order of the parts and of their reference.csv.
PaperTable paper_table(std::span<const PaperPart> parts);

kainjow::mustache::data row_data(const PaperRow& row);

} // namespace asperity::reports
