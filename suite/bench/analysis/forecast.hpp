#pragma once

// Extrapolates from coarse runs of a method to finer ones: error and cost for
// any number of points. It owns the prediction and runs nothing.

#include "suite/bench/analysis/bench.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace asperity::bench {

/// The contributions to a predicted error.
struct ErrorParts {
  double refining = 0.0; ///< decreases with the number of points
  double growth = 0.0;   ///< decreases with the grading ratio of the layers
  double staying = 0.0;  ///< does not decrease under refinement

  double sum() const { return refining + growth + staying; }
};

/// The prediction for one method with one element type from its coarse runs.
struct Forecast {
  /// Prediction of one quantity, with n points per side and grading ratio g:
  /// error = c (n_0/n)^order + floor (ln g/ln g_0)^2 + bias.
  struct Term {
    double error = 0.0; ///< of the finest coarse run, without the floor
    double order = 1.0;
    double floor = 0.0; ///< from the grading of the layers; 0 if there are none
    /// Not reduced by any refinement: the bias of an area estimator whose limit
    /// differs from that of the corrected area, or of a model that differs from
    /// that of the exact solution.
    double bias = 0.0;
    bool is_corrected = false; ///< learn() has corrected the term once
  };

  std::string method;
  std::string element; ///< "" if the method has none
  int finest = 0;      ///< points per side of the finest coarse run
  double growth = 1.0; ///< grading ratio of the case
  std::map<std::string, Term> terms = {};
  reports::PowerLaw step_time = {}; ///< [s] against points per side
  double fixed_time = 0.0;          ///< remaining time of a run [s]

  /// Returns the column that provides a quantity with the smallest error; "" if
  /// there is none.
  /// @param growth_share  factor of ln g: 1 keeps the grading ratio, 0.5 halves
  ///     its logarithm
  std::string best_column(const std::string& quantity, int points,
                          double growth_share) const;

  /// Returns the contributions for one column; all infinite if it has no term.
  ErrorParts parts(const std::string& column, int points,
                   double growth_share) const;

  /// Returns the error of the best column; infinite if there is none.
  double error(const std::string& quantity, int points,
               double growth_share) const;
  double cpu_time(int points) const; ///< [s]

  /// Updates the prediction with the error `found` of a column at a setting.
  /// The first time, the excess over the prediction is taken to decrease with
  /// the number of points; from then on it is taken to be constant. A run with
  /// a smaller error than predicted changes nothing.
  void learn(const std::string& column, int points, double growth_share,
             double found);
};

/// Returns the quantities to which an error target applies: those on which the
/// case's [expect] depends ("gap_deviation" depends on the mean gap,
/// "area_error" on the area), otherwise mean gap and area. "area_fraction"
/// stands for the estimator with the smallest error.
std::vector<std::string> asked_quantities(const cases::Case& contact_case);

/// Name that stands for the area estimator with the smallest error.
inline constexpr const char* any_area = "area_fraction";

/// Adds the cost of runs with results, coarse to fine, at least two, and the
/// terms of every column to which
/// `quantities` refer. The bias of an area estimator is the part of its
/// difference from the corrected area in the finest run that exceeds the errors
/// of both.
void add_runs(Forecast& forecast, std::span<const BenchPoint> coarse,
              std::span<const std::string> quantities);

/// Adds the error due to the grading of the layers, from one run with half the
/// logarithm of the grading ratio and one without this change. At second order,
/// one third of their difference remains in the finer one.
void add_growth(Forecast& forecast, const BenchPoint& as_it_is,
                const BenchPoint& halved);

/// Compares the two finest runs with the exact solution, after add_growth().
/// Their errors e_1, e_2 at n_1 < n_2 points are b + c n^-order, so that
///
///     b = (e_2 w - e_1)/(w - 1),  w = (n_2/n_1)^order,  within 0..e_2
///
/// remains under refinement. The grading of the layers already accounts for its
/// part of b. Columns that `exact` does not provide keep their terms.
/// @param exact  one per entry of `coarse`, at the loads of that entry
void add_exact(Forecast& forecast, std::span<const BenchPoint> coarse,
               std::span<const BenchAnswer> exact);

} // namespace asperity::bench
