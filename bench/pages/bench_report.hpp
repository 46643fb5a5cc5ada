#pragma once

// A benchmark as files: bench.json, bench.csv, report.html with its figures.

#include "reports/figures/gnuplot.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include "bench/analysis/bench.hpp"

namespace asperity::reports {

/// Everything, numbers in SI, what is not known null.
std::string bench_json(const Bench& bench);

/// A row a setting: what it cost, what it was made of, each error; "nan" for
/// what is not known.
std::string bench_csv(const Bench& bench);

/// Cost against error with its front, a figure a quantity that has errors;
/// error and cost against points; the split of the CPU time.
std::vector<Figure> bench_figures(const Bench& bench);

/// Writes bench.json, bench.csv, report.html and figures/ into `folder`.
/// @return  what could not be drawn, a line each
std::vector<std::string>
write_bench_report(const Bench& bench, const std::filesystem::path& folder,
                   const std::string& gnuplot = "gnuplot");

/// "0.73 %", three digits at most; an en dash for what is not known.
std::string per_cent(double share);

} // namespace asperity::reports
