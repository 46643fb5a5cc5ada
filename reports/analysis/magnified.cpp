#include "reports/analysis/magnified.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

namespace asperity::reports {

namespace {

// Checks that the table has all the columns and that they have equal length.
bool has_columns(const results::Table* table,
                 std::initializer_list<const char*> names) {
  if (table == nullptr)
    return false;
  const std::size_t rows = table->values(*names.begin()).size();
  return rows > 0 &&
         std::all_of(names.begin(), names.end(), [&](const char* name) {
           return table->values(name).size() == rows;
         });
}

} // namespace

MagnifiedStudy study_of(const results::Result& result) {
  MagnifiedStudy study;
  const results::Table* loads = result.table("magnification");
  if (loads == nullptr)
    return study;
  const std::vector<double> pressures = loads->values("nominal_pressure");
  const std::vector<double> weights = loads->values("contact_weight");
  const std::vector<double> heights = loads->values("rms_height");
  if (heights.empty() || weights.size() < pressures.size())
    return study;
  study.rms_height = heights.front();
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const MagnifiedLoad load{
        i, pressures[i], weights[i],
        result.table(fmt::format("magnification-{}", i + 1)),
        result.table(fmt::format("gap-distribution-{}", i + 1))};
    if (has_columns(load.seen, {"magnification", "area_fraction", "rms_height",
                                "mean_gap", "opening_gap"}) &&
        has_columns(load.gaps, {"gap", "density"}))
      study.loads.push_back(load);
  }
  return study;
}

} // namespace asperity::reports
