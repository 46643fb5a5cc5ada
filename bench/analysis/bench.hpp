#pragma once

// What a benchmark of one case is: settings, what each cost, what it answered,
// and how far that is from the truth. Owns these terms and nothing that runs.

#include "cases/types/case.hpp"
#include "reports/analysis/refinement.hpp"
#include "results/types/result.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::reports {

/// The numbers of one run by name: "mean_gap", "elastic_energy" and each
/// estimator "area_fraction..." with a value a loading step (realisations one
/// after another), fits such as "kappa" with one value. Where the case
/// prescribes the gap, "nominal_pressure" stands for "mean_gap".
struct BenchAnswer {
  std::map<std::string, std::vector<double>> values;
  std::vector<double> pressure;     ///< of the steps [Pa]
  double rms_height = not_a_number; ///< of realisation 0 [m]
  double highest = not_a_number;    ///< over the mean plane [m]
};

/// Of the repeats, without the warm-up [s].
struct BenchTime {
  double median = not_a_number;
  double least = not_a_number;
  double largest = not_a_number;
};

/// CPU time of one run by what it went into [s]; of the repeat with the median
/// CPU time.
struct BenchPhases {
  double setup = 0.0;       ///< of the method
  double transforms = 0.0;  ///< the elastic operator and its inverse
  double solving = 0.0;     ///< projections, directions, starts; all of the
                            ///< step where there is no such operator
  double observation = 0.0; ///< areas, fits, energy
  double writing = 0.0;     ///< of the result file
  double rest = 0.0;        ///< start of the program, the surface

  double steps() const { return transforms + solving + observation; }
};

/// One setting of one method, run.
struct BenchPoint {
  std::string method;
  std::string kind;
  std::string label;                  ///< "256 points, growth 1.1"
  std::vector<std::string> overrides; ///< that make it of the case
  int points = 0;                     ///< a side of the surface
  bool is_own = false;                ///< the case's own setting
  bool is_elastic = true; ///< the truth is its limit too; else its distance
                          ///< from that is no error (atoms, theory)
  bool is_truth = false;  ///< of the series that makes the truth

  int repeats = 0;           ///< timed
  bool has_warm_up = false;  ///< a run before them that does not count
  bool is_repeatable = true; ///< all runs gave the same numbers, bit for bit
  BenchTime wall;
  BenchTime cpu;
  double peak_memory = 0.0; ///< largest of the runs [B]
  int steps = 0;
  int failed_steps = 0;
  int iterations = 0; ///< of all steps
  int transforms = 0; ///< of all steps, on the method's grid
  BenchPhases phases;
  double transform_pair = not_a_number; ///< CPU time of a real transform there
                                        ///< and back on this grid [s]
  std::string problem; ///< why there is no answer; empty if there is
  BenchAnswer answer;
  std::map<std::string, double> errors;     ///< against the truth
  std::map<std::string, double> own_errors; ///< against the limit of its own
                                            ///< method's series

  /// The transforms' least CPU time [s]: a pair each.
  double transform_floor() const { return transforms * transform_pair; }
};

/// How a quantity goes along a series.
struct BenchOrder {
  double by_differences = not_a_number; ///< of the three finest
  PowerLaw error; ///< error against the truth as a power of the coordinate
};

/// Settings of one method that differ in one key, coarse to fine.
struct BenchSeries {
  std::string method;
  std::string axis;  ///< the key: "surface.points", "fem.growth"
  std::string title; ///< "points", "growth of the layers"
  std::vector<std::size_t> points = {};
  std::vector<double> coordinates = {}; ///< falls to 0 towards the limit;
                                        ///< empty: words, without an order
  std::map<std::string, double> theoretical_orders = {}; ///< by quantity
  std::string order_source = {};                         ///< where that is from
  std::map<std::string, BenchOrder> orders = {};
  PowerLaw cost = {};      ///< CPU time against points a side; points axis only
  PowerLaw step_cost = {}; ///< the same of the steps alone
};

struct BenchTruth {
  std::string words;
  BenchAnswer answer;
  std::map<std::string, double> uncertainty; ///< in the measure of the errors
  std::map<std::string, double> order;       ///< observed; none where exact
  std::map<std::string, bool> is_exact;
  std::size_t series = 0; ///< of Bench::series; out of range if there is none
};

/// One quantity of a promised error.
struct Promise {
  std::string quantity;
  std::string estimator; ///< the column that serves: "area_fraction_fit"
  std::string method;
  double predicted = not_a_number;
  double found = not_a_number; ///< against the exact solution or a finer run
  bool is_kept = false;
};

/// What came of asking for an error.
struct TargetOutcome {
  double target = 0.0;                ///< relative
  std::vector<std::string> overrides; ///< of the chosen setting
  std::string chosen;                 ///< in words
  std::string finer;                  ///< the run that verified, in words
  std::string problem; ///< why nothing could be chosen; empty if it could
  double predicted_cpu_time = not_a_number; ///< of the chosen setting [s]
  double cpu_time = not_a_number;           ///< that it took [s]
  double search_cpu_time = 0.0;             ///< of the coarse runs [s]
  std::vector<Promise> promises;
  std::vector<std::string> earlier; ///< settings tried before that did not keep
                                    ///< it, and why there was no other

  bool is_kept() const; ///< every promise
};

struct Bench {
  std::string case_name;
  std::string case_title;
  std::string case_hash;
  std::string case_text;
  std::vector<std::string> quantities; ///< errors are given of, in order
  std::vector<std::string> remarks;    ///< what was cut or left out, and why
  results::Provenance provenance;
  std::vector<BenchPoint> points;
  std::vector<BenchSeries> series;
  BenchTruth truth;
  /// Of each quantity, the points whose error no cheaper one undercuts.
  std::map<std::string, std::vector<std::size_t>> fronts;
  std::vector<TargetOutcome> targets; ///< none or one
};

/// What a quantity's error is and how it is measured, for readers.
std::string error_words(const std::string& quantity);

/// True for an estimator of the contact area.
bool is_area(const std::string& quantity);

} // namespace asperity::reports
