#pragma once

// The common interface of all methods that solve load steps and produce fields:
// a row of the curve, the fields behind it and a description of the method.

#include "input/types/case.hpp"
#include "results/types/result.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asperity::methods {

/// One step of the loading path.
struct StepTarget {
  mechanics::LoadTarget load;
  int step = 0;           ///< index in the loading path
  bool needs_maps = true; ///< otherwise the answer may be without fields
};

/// What the fields of a step have of what a step prescribes, and by how much
/// they may miss it.
struct Reached {
  double nominal_pressure = results::not_given; ///< [Pa]
  double mean_gap = results::not_given;         ///< [m]
  /// The load, over the nominal area, that the bodies carry and the contact law
  /// does not [Pa].
  double imbalance = results::not_given;
  double pressure_tolerance = 0.0; ///< of load and imbalance [Pa]
  double gap_tolerance = 0.0;      ///< [m]
  /// A tensile load parted the faces, as the note says: none is reached.
  bool is_detached = false;
};

/// Marks a row as not converged if what was reached is not what was asked for,
/// to the tolerances, and notes both numbers. Every method passes it; a number
/// that a method does not give is not reached.
void check_reached(const mechanics::LoadTarget& asked, const Reached& reached,
                   results::CurvePoint& row);

/// The solution of one load step. The row is complete except for the times, the
/// step and the stiffness, which are set with the curve.
struct StepAnswer {
  results::CurvePoint row;
  Grid grid;                    ///< grid of the fields
  std::vector<double> pressure; ///< [Pa]
  std::vector<double> gap;      ///< [m]
  /// Stress section computed by the method itself, only at step_with_section().
  std::optional<results::Table> section = {};
  Reached reached = {};
};

/// Solves the load steps of one method on one realisation.
class StepSolver {
public:
  virtual ~StepSolver() = default;

  /// Solves a load step. The row is not converged if it has a number that is
  /// not finite (distrust_non_finite()) or misses what is prescribed
  /// (check_reached()), whatever the method reports.
  StepAnswer solve(const StepTarget& target);

  /// Returns details for the description of the method that are known only
  /// after set-up; empty if there are none.
  virtual std::string found_at_setup() const { return {}; }

  /// Returns the state from which the next step starts, so that another process
  /// can continue with identical results. It is empty for a method that cannot
  /// be continued.
  virtual std::vector<double> state() const { return {}; }

  /// Restores the state of an equal solver.
  /// @param state  read on rank 0 only
  /// @return  false if it cannot, because the state is that of other ranks;
  ///          nothing has then changed
  virtual bool restore(const std::vector<double>& state) {
    return state.empty();
  }

  /// Returns the additional CPU time that set-up would have taken without the
  /// cached parts of an earlier run [s].
  virtual double saved_setup_time() const { return 0.0; }

private:
  /// The solution by the method, with what it reached.
  virtual StepAnswer find(const StepTarget& target) = 0;
};

/// The description of a method for the report.
struct MethodDescription {
  std::string kind;        ///< theory | halfspace | fem | md
  std::string text;        ///< one line
  bool runs_alone = false; ///< the library of the method allows only one run at
                           ///< a time, or the method uses all cores
};

} // namespace asperity::methods
