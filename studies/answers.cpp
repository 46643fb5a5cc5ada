#include "studies/answers.hpp"

#include "base/shown_number.hpp"
#include "reports/figures/load_spread.hpp"
#include "reports/pages/answers.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace asperity::studies {

double AnsweredLoad::median(const results::CurveColumn& column) const {
  return reports::converged_spread(*method, column).at(step).median();
}

std::string AnsweredLoad::place(const reports::ReportEntry& entry) const {
  const std::size_t count = method->realizations.size();
  return "at " + quantity_text(pressure, "Pa", 3) +
         (count > 1 ? fmt::format(", median of {} realisations", count) : "") +
         reports::method_in_words(entry, *method);
}

AnsweredLoad answered_load(const reports::ReportEntry& entry,
                           const results::CurveColumn& column) {
  AnsweredLoad found;
  for (const bool is_theory : {false, true})
    for (const results::MethodRecord& method : entry.result->methods) {
      if ((method.kind == "theory") != is_theory)
        continue;
      for (const auto& [step, at] : reports::converged_spread(method, column))
        if (at.pressure > found.pressure)
          found = {&method, step, at.pressure};
      if (found.method != nullptr)
        return found;
    }
  return found;
}

} // namespace asperity::studies
