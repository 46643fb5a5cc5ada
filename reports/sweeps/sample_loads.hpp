#pragma once

// Area, mean gap and the answers of studies at the loads that all samples of a
// sweep share: one table of maps and loads, its statistics, and its figures.

#include "reports/figures/gnuplot.hpp"
#include "reports/sweeps/swept_results.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace asperity::reports {

/// The values of one column at one load.
struct SampleValues {
  std::vector<double> values; ///< of each sample, in SI; NaN: there is none
  Spread spread = {};         ///< of the samples that have one
  std::vector<std::size_t> outliers; ///< samples, by outliers_of()

  std::ptrdiff_t known() const; ///< samples with a value
  std::ptrdiff_t zeros() const; ///< samples with 0: a flow that is sealed
};

struct SampleLoad {
  double pressure = 0.0;             ///< [Pa]
  bool is_unloading = false;         ///< on the way back
  std::vector<SampleValues> columns; ///< of SampleLoads::columns
};

struct SampleColumn {
  std::string name; ///< of the column: "mean_gap"
  std::string unit; ///< SI
};

/// One method at the loads that all samples share.
struct SampleLoads {
  std::string method;               ///< the first one that is no theory, if any
  std::vector<std::string> samples; ///< names
  /// Contact area, corrected where it can be, and mean gap; then those of
  /// studies that any sample has.
  std::vector<SampleColumn> columns;
  std::vector<SampleLoad> loads; ///< in the order of the loading path
};

/// Returns the table; without loads if the sweep has no samples, or these were
/// not pressed with the same pressures.
SampleLoads sample_loads(const SweepRecord& record,
                         const SweptResults& results);

/// Returns one row per sample and load, and for each load the rows "mean",
/// "standard deviation", "outliers", which names them, "samples with a value"
/// and "samples with 0": loads.csv.
std::string sample_loads_csv(const SampleLoads& table);

/// Returns a line per load for a terminal: area and mean gap with their
/// standard deviations, and the outliers; "" without loads.
std::string sample_loads_text(const SampleLoads& table);

/// Returns the sentence on the load whose mean contact area is nearest to
/// 10 %; "" without loads.
std::string sample_sentence(const SampleLoads& table);

/// Returns area against pressure and pressure against mean gap: a line per
/// sample and their mean.
std::vector<Figure> sample_figures(const SampleLoads& table);

} // namespace asperity::reports
