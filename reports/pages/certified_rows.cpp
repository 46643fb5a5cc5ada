// Shows what is certified about each method, as rows of the page.
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::reports {
namespace {

kainjow::mustache::data certified_row(const MethodSummary& method,
                                      double contact_modulus) {
  const Certified& found = method.certified;
  const bool has_bound = found.certified > 0;
  kainjow::mustache::data row;
  row.set("name", method.name);
  row.set("steps", has_bound
                       ? fmt::format("{} of {}", found.certified, found.steps)
                       : "as submitted");
  row.set("largest", has_bound ? fmt::format("{:.1e}", found.largest) : "–");
  row.set("pressure",
          has_bound ? fmt::format("{:.3g}", found.pressure / contact_modulus)
                    : "–");
  return row;
}

} // namespace

kainjow::mustache::list certified_rows(const ReportEntry& entry) {
  kainjow::mustache::list rows;
  const std::vector<MethodSummary>& methods = entry.summary.methods;
  if (std::ranges::none_of(methods, [](const MethodSummary& method) {
        return method.certified.certified > 0;
      }))
    return rows;
  for (const MethodSummary& method : methods)
    if (method.kind != "theory")
      rows.push_back(certified_row(method, entry.result->contact_modulus));
  return rows;
}

} // namespace asperity::reports
