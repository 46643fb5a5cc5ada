#pragma once

// What coarse runs of a method promise of finer ones: error and cost at any
// number of points. Owns the prediction, runs nothing.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "bench/analysis/bench.hpp"

namespace asperity::app {

/// What a predicted error is made of.
struct ErrorParts {
  double refining = 0.0; ///< falls with the points
  double growth = 0.0;   ///< falls with the layers' growth
  double staying = 0.0;  ///< falls with neither

  double sum() const { return refining + growth + staying; }
};

/// What is predicted of one method with one element from its coarse runs.
struct Forecast {
  /// Of one quantity:
  /// error = c (n_0/n)^order + floor (ln g/ln g_0)^2 + bias.
  struct Term {
    double error = 0.0; ///< of the finest coarse run, without the floor
    double order = 1.0;
    double floor = 0.0; ///< of the layers' growth; 0 where there are none
    double bias = 0.0;  ///< what no refinement takes away: of an estimator of
                        ///< the area with another limit than the corrected
                        ///< count, of a model that is not the exact solution's
    bool is_corrected = false; ///< by learn(), once
  };

  std::string method;
  std::string element; ///< "" where the method has none
  int finest = 0;      ///< points a side of the finest coarse run
  double growth = 1.0; ///< of the case
  std::map<std::string, Term> terms = {};
  reports::PowerLaw step_time = {}; ///< [s] against points a side
  double fixed_time = 0.0;          ///< the rest of a run [s]

  /// The column that answers a quantity with the least error; "" if none does.
  /// @param growth_share  of ln g: 1 as it is, 0.5 half of it
  std::string best_column(const std::string& quantity, int points,
                          double growth_share) const;

  /// Of one column; all infinite if it has no term.
  ErrorParts parts(const std::string& column, int points,
                   double growth_share) const;

  /// Of the best column; infinite if there is none.
  double error(const std::string& quantity, int points,
               double growth_share) const;
  double cpu_time(int points) const; ///< [s]

  /// Takes in that a column erred by `found` at a setting. What exceeds the
  /// prediction counts as falling with the points the first time, as staying
  /// from then on; a lucky run changes nothing.
  void learn(const std::string& column, int points, double growth_share,
             double found);
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

/// Holds the two finest runs against the exact solution, after add_growth().
/// Their errors e_1, e_2 at n_1 < n_2 points are b + c n^-order, so that
///
///     b = (e_2 w - e_1)/(w - 1),  w = (n_2/n_1)^order,  within 0..e_2
///
/// stays under refinement; of it the layers' growth has its part already.
/// Columns that `exact` does not answer keep their terms.
/// @param exact  at the loads of each of `coarse`, and as many
void add_exact(Forecast& forecast, std::span<const reports::BenchPoint> coarse,
               std::span<const reports::BenchAnswer> exact);

} // namespace asperity::app
