#include "reports/magnified.hpp"

#include <fmt/format.h>

namespace asperity::reports {

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
    if (load.seen != nullptr && load.gaps != nullptr)
      study.loads.push_back(load);
  }
  return study;
}

} // namespace asperity::reports
