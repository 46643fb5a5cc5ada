#pragma once

// What coarse runs of a method promise of finer ones: error and cost at any
// number of points. Owns the prediction, runs nothing.

#include "reports/bench.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace asperity::app {

/// What is predicted of one method with one element from its coarse runs.
struct Forecast {
  /// Of one quantity:
  /// error = c (n_0/n)^order + floor (ln g/ln g_0)^2 + bias.
  struct Term {
    double error = 0.0; ///< of the finest coarse run, without the floor
    double order = 1.0;
    double floor = 0.0; ///< of the layers' growth; 0 where there are none
    double bias = 0.0;  ///< of an estimator of the area whose limit is another
                        ///< than the corrected count's
  };

  std::string method;
  std::string element; ///< "" where the method has none
  int finest = 0;      ///< points a side of the finest coarse run
  double growth = 1.0; ///< of the case
  std::map<std::string, Term> terms = {};
  reports::PowerLaw step_time = {}; ///< [s] against points a side
  double fixed_time = 0.0;          ///< the rest of a run [s]

  /// @param growth_share  of ln g: 1 as it is, 0.5 half of it
  double error(const std::string& quantity, int points,
               double growth_share) const;
  double cpu_time(int points) const; ///< [s]
};

/// The quantities that an asked error is of: those that the case's [expect]
/// stands on ("gap_deviation" on the mean gap, "area_error" on the area), else
/// mean gap and area. "area_fraction" stands for whichever estimator errs
/// least.
std::vector<std::string> asked_quantities(const cases::Case& contact_case);

/// The name that stands for whichever estimator of the area errs least.
inline constexpr const char* any_area = "area_fraction";

/// Error and order of a quantity from the two or three finest of some runs.
/// The order is observed where there are three that have one, 1 otherwise, and
/// never taken above 2: a lucky pair promises no more.
/// @param coarse  runs with answers, coarse to fine, at least two
Forecast::Term term_of(std::span<const reports::BenchPoint> coarse,
                       const std::string& column);

/// Terms of every column that `quantities` mean, and cost, of those runs. An
/// estimator of the area is biased by what it differs from the corrected count
/// in the finest run beyond the errors of both.
void add_runs(Forecast& forecast, std::span<const reports::BenchPoint> coarse,
              std::span<const std::string> quantities);

/// Adds what the layers' growth costs, from one run with half its logarithm
/// beside one without: at second order a third of their difference is left in
/// the finer one.
void add_growth(Forecast& forecast, const reports::BenchPoint& as_it_is,
                const reports::BenchPoint& halved);

} // namespace asperity::app
