#pragma once

// Writes a benchmark to files: bench.json, bench.csv and report.html with its
// figures.

#include "reports/figures/gnuplot.hpp"
#include "suite/bench/analysis/bench.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::bench {

/// Returns all data as JSON, with numbers in SI units. NaN, which is null in
/// the file, is an unknown value.
nlohmann::ordered_json bench_json(const Bench& bench);

/// Returns one row per setting: its cost, the split of the cost, and each
/// error; "nan" for unknown values.
std::string bench_csv(const Bench& bench);

/// Returns the figures: cost against error with the Pareto front, one figure
/// per quantity that has errors; error and cost against points; the split of
/// the CPU time.
std::vector<reports::Figure> bench_figures(const Bench& bench);

/// Returns error against unknowns and against CPU time, a series for each
/// finite-element method, if one of them is a full 3-D block; otherwise none.
std::vector<reports::Figure> block_figures(const Bench& bench);

/// Writes bench.json, bench.csv, report.html and figures/ into `folder`.
/// @return  the figures that could not be drawn, one line each
std::vector<std::string>
write_bench_report(const Bench& bench, const std::filesystem::path& folder,
                   const std::string& gnuplot = "gnuplot");

/// Formats "0.73 %", with at most three digits; an en dash for unknown values.
std::string per_cent(double share);

} // namespace asperity::bench
