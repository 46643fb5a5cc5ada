#include "studies/answers.hpp"

#include "base/shown_number.hpp"
#include "reports/pages/answers.hpp"

#include <cmath>

namespace asperity::studies {

std::string AnsweredRow::place(const reports::ReportEntry& entry) const {
  return "at " + quantity_text(row->nominal_pressure, "Pa", 3) +
         reports::method_in_words(entry, *method);
}

AnsweredRow answered_row(const reports::ReportEntry& entry,
                         const results::CurveColumn& column) {
  AnsweredRow found;
  for (const bool is_theory : {false, true})
    for (const results::MethodRecord& method : entry.result->methods) {
      if ((method.kind == "theory") != is_theory || method.realizations.empty())
        continue;
      for (const results::CurvePoint& row : method.realizations.front().points)
        if (row.status == results::StepStatus::converged &&
            std::isfinite(row[column]) &&
            (found.row == nullptr ||
             row.nominal_pressure > found.row->nominal_pressure))
          found = {&method, &row};
      if (found.row != nullptr)
        return found;
    }
  return found;
}

} // namespace asperity::studies
