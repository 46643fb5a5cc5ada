#pragma once

// The samples of a sweep one by one: what each is, and what was asked of it.

#include "reports/sweeps/sample_loads.hpp"

#include <string>
#include <vector>

namespace asperity::reports {

/// A row of the table.
struct SampleMap {
  std::string name;
  std::size_t point = 0;
  bool is_statistic = false;           ///< "mean" or "standard deviation"
  std::vector<std::string> cells = {}; ///< numbers with their units
};

struct SampleMaps {
  std::vector<std::string> heads; ///< of the cells
  std::vector<SampleMap> rows;    ///< in the order of the points, then mean and
                                  ///< standard deviation
  /// On the largest tension; "" if fewer than two samples have one.
  std::string sentence;
};

/// Returns a row per sample that has a result of the method of the table: rms
/// height, and with adhesion the largest tension, gap and area there and the
/// lost work, otherwise area and gap at the usual load.
SampleMaps sample_maps(const SweepRecord& record, const SweptResults& results,
                       const SampleLoads& loads);

/// Returns the table of tensions and the sentence on them for a terminal; ""
/// without tensions.
std::string sample_maps_text(const SampleMaps& maps);

} // namespace asperity::reports
