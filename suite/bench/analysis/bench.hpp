#pragma once

// The benchmark of one case: the settings, the cost and the results of each,
// and the error with respect to the reference solution. It owns these terms and
// runs nothing.

#include "input/types/case.hpp"
#include "reports/analysis/refinement.hpp"
#include "results/types/result.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::bench {

/// The results of one run by name: "mean_gap", "elastic_energy" and each
/// estimator "area_fraction..." with one value per loading step (realisations
/// one after another), and fits such as "kappa" with a single value. If the
/// case prescribes the gap, "nominal_pressure" replaces "mean_gap".
struct BenchAnswer {
  std::map<std::string, std::vector<double>> values;
  std::vector<double> pressure;     ///< nominal pressure of the steps [Pa]
  double rms_height = not_a_number; ///< of realisation 0 [m]
  double highest = not_a_number;    ///< highest point above the mean plane [m]
};

/// Times of the repeats, without the warm-up run [s].
struct BenchTime {
  double median = not_a_number;
  double least = not_a_number;
  double largest = not_a_number;
};

/// CPU time of one run by phase [s], of the repeat with the median CPU time.
struct BenchPhases {
  double setup = 0.0;      ///< set-up of the method
  double transforms = 0.0; ///< the elastic operator and its inverse
  /// Projections, search directions, initial guesses; the entire step if there
  /// is no such operator.
  double solving = 0.0;
  double observation = 0.0; ///< areas, fits, energy
  double writing = 0.0;     ///< of the result file
  double rest = 0.0;        ///< start-up of the program, surface

  double steps() const { return transforms + solving + observation; }
};

/// What one run of a setting has found.
struct BenchRun {
  std::string problem; ///< why there is no result; empty if there is one
  /// Unknowns of a full block, the most of all steps; nodes of the grid for the
  /// condensed block and the half-space; NaN for other methods.
  double unknowns = not_a_number;
  int steps = 0;
  int failed_steps = 0;
  int iterations = 0; ///< total over all steps
  int transforms = 0; ///< total over all steps, on the method's grid
  BenchPhases phases;
  BenchAnswer answer;
};

/// One setting of one method that has been run: its run with the median CPU
/// time, and what all of its runs have taken.
struct BenchPoint : BenchRun {
  std::string method;
  std::string kind;
  std::string label; ///< "256 points, growth 1.1"
  /// Overrides that define it relative to the case.
  std::vector<std::string> overrides;
  int points = 0;      ///< points per side of the surface
  bool is_own = false; ///< the case's own setting
  /// True: converges to the reference solution; false: the difference from it
  /// is not an error (atoms, theory).
  bool is_elastic = true;
  /// Belongs to the series that defines the reference solution.
  bool is_reference = false;

  int repeats = 0;           ///< number of timed runs
  bool has_warm_up = false;  ///< an untimed run came first
  bool is_repeatable = true; ///< all runs gave bitwise identical results
  BenchTime wall;
  BenchTime cpu;
  double peak_memory = 0.0; ///< maximum over the runs [B]
  /// CPU time of a real forward and inverse transform in single precision, as
  /// the contact solver computes it, on this grid and one thread [s]
  double transform_pair = not_a_number;
  /// With respect to the reference solution.
  std::map<std::string, double> errors;
  /// With respect to the limit of the method's own series.
  std::map<std::string, double> own_errors;

  /// Lower bound of the CPU time of the transforms [s], at one pair per
  /// transform.
  double transform_floor() const { return transforms * transform_pair; }
};

/// The convergence of a quantity along a series.
struct BenchOrder {
  double by_differences = not_a_number; ///< from the three finest settings
  /// Error with respect to the reference solution as a power of the coordinate.
  reports::PowerLaw error;
};

/// The axis of a series that varies the points per side.
inline constexpr const char* points_axis = "surface.points";

/// Settings of one method that differ in one key, coarse to fine.
struct BenchSeries {
  std::string method;
  std::string axis;  ///< the key: "surface.points", "fem.growth"
  std::string title; ///< "points", "growth of the layers" (grading ratio)
  std::vector<std::size_t> points = {};
  /// Decreases to 0 towards the limit; empty: keyword values without an order.
  std::vector<double> coordinates = {};
  std::map<std::string, double> theoretical_orders = {}; ///< by quantity
  std::string order_source = {}; ///< source of these orders
  std::map<std::string, BenchOrder> orders = {};
  /// CPU time against points per side; only for the axis over points
  reports::PowerLaw cost = {};
  reports::PowerLaw step_cost = {}; ///< the same for the steps alone
  /// Error with respect to the reference solution against unknowns, and against
  /// the CPU time of set-up and steps, by quantity; only for the axis over
  /// points
  std::map<std::string, reports::PowerLaw> against_unknowns = {};
  std::map<std::string, reports::PowerLaw> against_cpu_time = {};
};

struct ReferenceSolution {
  std::string words;
  BenchAnswer answer;
  std::map<std::string, double> uncertainty; ///< in the norm of the errors
  /// Observed order; absent for exact quantities.
  std::map<std::string, double> order;
  std::map<std::string, bool> is_exact;
  /// Index into Bench::series; out of range if there is none.
  std::size_t series = 0;
};

/// One quantity for which an error target was set.
struct TargetCheck {
  std::string quantity;
  std::string estimator; ///< the column that is used: "area_fraction_fit"
  std::string method;
  double predicted = not_a_number;
  /// With respect to the exact solution or a finer run.
  double found = not_a_number;
  bool is_met = false;
};

/// The outcome of a request for an error target.
struct TargetOutcome {
  double target = 0.0;                ///< relative
  std::vector<std::string> overrides; ///< overrides of the chosen setting
  std::string chosen;                 ///< description of the chosen setting
  std::string finer;   ///< description of the run used for verification
  std::string problem; ///< why no setting could be chosen; empty if one could
  double predicted_cpu_time = not_a_number; ///< for the chosen setting [s]
  double cpu_time = not_a_number; ///< measured for the chosen setting [s]
  double search_cpu_time = 0.0;   ///< of the coarse runs [s]
  std::vector<TargetCheck> checks;
  /// Settings tried before that missed the target, and why there was no other.
  std::vector<std::string> earlier;

  bool is_met() const; ///< true if every quantity meets the target
};

struct Bench {
  std::string case_name;
  std::string case_title;
  std::string case_hash;
  std::string case_text;
  /// Quantities whose errors are given, in order.
  std::vector<std::string> quantities;
  std::vector<std::string> remarks; ///< what was shortened or omitted, and why
  results::Provenance provenance;
  std::vector<BenchPoint> points;
  std::vector<BenchSeries> series;
  ReferenceSolution reference;
  /// For each quantity, the Pareto front: the points for which no cheaper point
  /// has a smaller error.
  std::map<std::string, std::vector<std::size_t>> fronts;
  std::vector<TargetOutcome> targets; ///< zero or one entry
};

/// The number of a quantity, such as its error; NaN if there is none.
double number_of(const std::map<std::string, double>& numbers,
                 const std::string& quantity);

/// Describes the error of a quantity and its norm for the reader.
std::string error_words(const std::string& quantity);

/// True for an estimator of the contact area.
bool is_area(const std::string& quantity);

} // namespace asperity::bench
