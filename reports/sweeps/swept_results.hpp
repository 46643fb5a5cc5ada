#pragma once

// Reads the results of the points of a sweep, one at a time and without their
// fields, and lists their quantities as a table.

#include "reports/figures/series.hpp"
#include "reports/study_pages.hpp"
#include "reports/sweeps/sweep_record.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::reports {

/// The spectrum and grid of a self-affine point.
struct SpectrumPoint {
  double hurst = 0.0;
  double ratio = 0.0;          ///< q_1/q_0
  double size = 0.0;           ///< L/lambda_0
  double nodes_per_wave = 0.0; ///< lambda_1/h
  double nayak = 0.0;          ///< m_0 m_4/m_2^2 of the formula [1]
};

/// The converged load steps of one method; none if it has several realisations,
/// of which one is no sample of its point.
struct SweptCurve {
  std::string method;
  double rms_height = not_a_number; ///< of its surface [m]
  std::vector<results::CurvePoint> rows = {};
};

/// What the report needs of one point. A point that has no result has a
/// problem, and neither summary nor series.
struct SweptResult {
  std::size_t point = 0;
  std::string status;  ///< of the result: complete | interrupted | running; or
                       ///< missing
  std::string problem; ///< why there is no complete result; "" if there is
  std::optional<SpectrumPoint> spectrum; ///< of a self-affine surface
  Summary summary;
  std::vector<Series> series;     ///< of this point, whose methods point into
                                  ///< `summary`
  std::vector<SweptCurve> curves; ///< of samples (has_samples()); else empty
  std::vector<AnswerColumn> answers;     ///< of samples: what the case asks
  double contact_modulus = not_a_number; ///< [Pa]

  bool has_result() const { return status != "missing"; }
};

/// One entry per point, at stable addresses.
using SweptResults = std::vector<std::unique_ptr<SweptResult>>;

/// Whether the points are samples of one surface: the only swept key is
/// surface.file or surface.seed.
bool has_samples(const SweepRecord& record);

/// Reads the results of all points. Each is read and evaluated by itself, so
/// that the fields of one point at most are in memory.
///
/// @param is_trusted  false: each file is read in a child process first
///                    (results/trial_read.hpp)
SweptResults read_swept_results(const SweepRecord& record,
                                const std::filesystem::path& folder,
                                bool is_trusted);

/// Returns the names of all quantities of all points and methods: first those
/// of which the case has expectations, then those that the figures show first,
/// then the others in alphabetical order.
std::vector<std::string> swept_quantities(const SweptResults& results);

/// Returns the names of all methods in the order of their first appearance.
std::vector<std::string> swept_methods(const SweptResults& results);

/// Returns the estimate of a quantity of a method, or null.
const Estimate* swept_estimate(const SweptResult& result,
                               const std::string& method,
                               const std::string& quantity);

/// Returns text as one cell of a CSV file, in quotes where it needs them.
std::string csv_cell(const std::string& text);

/// Likewise a number: ten digits, or "nan".
std::string csv_number(double number);

/// Returns one row per point, method and quantity: the values of the swept
/// keys, value, half_width_95, realizations, verdict and remark.
std::string sweep_csv(const SweepRecord& record, const SweptResults& results);

/// Returns sweep.json: the record with status, quantities and verdicts of each
/// point.
std::string sweep_json(const SweepRecord& record, const SweptResults& results);

} // namespace asperity::reports
