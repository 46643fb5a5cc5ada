// Shows what is certified and estimated about the errors of each method, as
// rows of the page.
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace asperity::reports {
namespace {

/// Sets how many steps have an error, the largest one, and where it is, under
/// names that begin with `which`.
void set_errors(kainjow::mustache::data& row, const std::string& which,
                const ErrorsOfSteps& errors, int steps,
                double contact_modulus) {
  const bool has_any = errors.steps > 0;
  row.set(which + "_steps",
          has_any ? fmt::format("{} of {}", errors.steps, steps) : "–");
  row.set(which + "_largest",
          has_any ? fmt::format("{:.1e}", errors.largest) : "–");
  row.set(which + "_pressure",
          has_any ? fmt::format("{:.3g}", errors.pressure / contact_modulus)
                  : "–");
}

kainjow::mustache::data certified_row(const MethodSummary& method,
                                      double contact_modulus) {
  const Certified& found = method.certified;
  kainjow::mustache::data row;
  row.set("name", method.name);
  set_errors(row, "bound", found.bounds, found.steps, contact_modulus);
  set_errors(row, "estimate", found.estimates, found.steps, contact_modulus);
  if (found.bounds.steps + found.estimates.steps == 0)
    row.set("bound_steps", "as submitted");
  return row;
}

} // namespace

kainjow::mustache::list certified_rows(const ReportEntry& entry) {
  kainjow::mustache::list rows;
  const std::vector<MethodSummary>& methods = entry.summary.methods;
  if (std::ranges::none_of(methods, [](const MethodSummary& method) {
        return method.certified.bounds.steps +
                   method.certified.estimates.steps >
               0;
      }))
    return rows;
  for (const MethodSummary& method : methods)
    if (method.kind != "theory")
      rows.push_back(certified_row(method, entry.result->contact_modulus));
  return rows;
}

} // namespace asperity::reports
