#pragma once

// The common interface of all methods that solve load steps and produce fields:
// a row of the curve, the fields behind it and a description of the method.

#include "cases/types/case.hpp"
#include "results/types/map_rows.hpp"
#include "results/types/result.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::app {

/// One step of the loading path.
struct StepTarget {
  mechanics::LoadTarget load;
  int step = 0;           ///< index in the loading path
  bool needs_maps = true; ///< otherwise the answer may be without fields
};

/// The solution of one load step. The row is complete except for the times, the
/// step and the stiffness, which are set with the curve.
struct StepAnswer {
  results::CurvePoint row;
  Grid grid;                    ///< grid of the fields
  std::vector<double> pressure; ///< [Pa]
  std::vector<double> gap;      ///< [m]
  /// The same fields by rows, if ranks hold them and the vectors are empty.
  /// Valid until the solver is called again.
  std::optional<results::FieldRows> rows = {};
  /// Whether the fields are finite, also those that the answer is without.
  bool has_finite_fields = true;
  /// Stress section computed by the method itself, only at step_with_section().
  std::optional<results::Table> section = {};
};

/// Solves the load steps of one method on one realisation.
class StepSolver {
public:
  virtual ~StepSolver() = default;
  virtual StepAnswer solve(const StepTarget& target) = 0;

  /// Returns details for the description of the method that are known only
  /// after set-up; empty if there are none.
  virtual std::string found_at_setup() const { return {}; }

  /// Returns the state from which the next step starts, so that another process
  /// can continue with identical results. It is empty for a method that cannot
  /// be continued.
  virtual std::vector<double> state() const { return {}; }

  /// Returns the size of state() at most, if ranks would have to gather it on
  /// rank 0; 0 if this process has it [B].
  virtual std::size_t gathered_state_bytes() const { return 0; }

  /// Restores the state of an equal solver.
  virtual void restore(std::span<const double> state) {
    static_cast<void>(state);
  }

  /// Returns the additional CPU time that set-up would have taken without the
  /// cached parts of an earlier run [s].
  virtual double saved_setup_time() const { return 0.0; }
};

/// The description of a method for the report.
struct MethodDescription {
  std::string kind;        ///< theory | halfspace | fem | md
  std::string text;        ///< one line
  bool runs_alone = false; ///< the library of the method allows only one run at
                           ///< a time, or the method uses all cores
};

} // namespace asperity::app
