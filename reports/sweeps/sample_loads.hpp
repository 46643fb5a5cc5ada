#pragma once

// Area, mean gap and the answers of studies at the loads that all samples of a
// sweep share, nominal pressures or mean gaps over their rms heights: one table
// of maps and loads, its statistics, and its figures.

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
  double state = 0.0;                ///< by which it is SampleLoads::state
  bool is_unloading = false;         ///< on the way back
  std::vector<SampleValues> columns; ///< of SampleLoads::columns
};

struct SampleColumn {
  std::string name;       ///< of the column: "mean_gap"
  std::string unit;       ///< SI; "%": a share of 1 that is shown in per cent
  std::string words = {}; ///< AnswerColumn::words of a column that answers
  std::string zero = {};  ///< likewise
};

/// One method at the loads that all samples share.
struct SampleLoads {
  std::string method;               ///< the first one that is no theory, if any
  std::vector<std::string> samples; ///< names
  /// What all samples share: the nominal pressure, or else the mean gap over
  /// the rms height of each.
  SampleColumn state;
  /// Contact area, corrected where it can be, and mean gap; the nominal
  /// pressure if the samples share the gap; then those of studies that any
  /// sample has, first those that answer.
  std::vector<SampleColumn> columns;
  std::vector<SampleLoad> loads; ///< in the order of the loading path

  bool is_by_gap() const { return state.unit == "1"; }

  /// Number of the columns that are not of studies.
  std::size_t n_common() const { return is_by_gap() ? 3 : 2; }

  /// "1 MPa" or "0.5 h_rms", with what the way back is called.
  std::string state_text(const SampleLoad& load) const;

  /// "6.5 ± 4.4 %": mean and standard deviation of one sample.
  std::string column_text(const SampleLoad& load, std::size_t column) const;
};

/// The name of a sample: the value of the only swept key.
std::string sample_name(const SweepRecord& record, std::size_t point);

/// Returns the table; without loads if the sweep has no samples, or these share
/// neither pressures nor gaps.
SampleLoads sample_loads(const SweepRecord& record,
                         const SweptResults& results);

/// Returns one row per sample and load, and for each load the rows "mean",
/// "standard deviation", "outliers", which names them, "samples with a value"
/// and "samples with 0": loads.csv.
std::string sample_loads_csv(const SampleLoads& table);

/// Returns a line per load for a terminal: area and mean gap, or pressure, with
/// their standard deviations, and the outliers; "" without loads.
std::string sample_loads_text(const SampleLoads& table);

/// The load whose mean contact area is nearest to 10 %; null without loads.
const SampleLoad* usual_load(const SampleLoads& table);

/// Returns the sentence on the usual load; "" without loads.
std::string sample_sentence(const SampleLoads& table);

/// Returns a sentence for each column that answers: its median and range over
/// the samples at the usual load, and how many of them have 0, which a flow has
/// that is sealed; "" without such columns.
std::string sample_answers(const SampleLoads& table);

/// Returns area against pressure, or mean gap, and pressure against mean gap: a
/// line per sample and their mean.
std::vector<Figure> sample_figures(const SampleLoads& table);

} // namespace asperity::reports
