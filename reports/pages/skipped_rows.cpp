// Lists what a run did not compute, as rows of the page.
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::reports {
namespace {

std::string time_text(double seconds) {
  if (std::isnan(seconds))
    return "–";
  if (seconds < 60.0)
    return fmt::format("{:.2g} s", seconds);
  return seconds < 3600.0 ? fmt::format("{:.1f} min", seconds / 60.0)
                          : fmt::format("{:.3g} h", seconds / 3600.0);
}

std::string size_text(double bytes) {
  return std::isnan(bytes) || bytes == 0.0 ? "–"
         : bytes < 1e9 ? fmt::format("{:.3g} MB", 1e-6 * bytes)
                       : fmt::format("{:.3g} GB", 1e-9 * bytes);
}

} // namespace

kainjow::mustache::list skipped_rows(const results::Result& result) {
  kainjow::mustache::list rows;
  for (const results::Skipped& one : result.skipped) {
    kainjow::mustache::data row;
    row.set("what", one.what);
    row.set("why", one.why);
    row.set("cpu_time", time_text(one.cpu_time));
    row.set("bytes", size_text(one.bytes));
    rows.push_back(row);
  }
  return rows;
}

} // namespace asperity::reports
