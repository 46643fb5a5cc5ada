#pragma once

// Evaluates the observables of a load step. No observable can end a run: one
// that cannot be computed is NaN with a reason.

#include "results/observables/observables.hpp"
#include "results/types/curve_columns.hpp"

#include <exception>

namespace asperity::results {

/// Fills columns of a row. An observable that throws an exception or is not
/// finite is set to NaN, and the note of the row names it with the reason.
class RowObserver {
public:
  /// @param row  must outlive the observer
  explicit RowObserver(CurvePoint& row) : row_(row) {}

  /// @param compute  () -> double or Observed; may throw any std::exception
  template <class Compute>
  void operator()(const CurveColumn& column, Compute compute) {
    try {
      record(column, compute());
    } catch (const std::exception& error) {
      record(column, {Observed::none, error.what()});
    }
  }

private:
  void record(const CurveColumn& column, const Observed& observed);

  CurvePoint& row_;
};

} // namespace asperity::results
