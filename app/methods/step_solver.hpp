#pragma once

// What the run asks of any method that answers a load step with maps: a row of
// the curve, the maps behind it, and what the method is in words.

#include "cases/types/case.hpp"
#include "results/types/result.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::app {

/// One load step of the program.
struct StepTarget {
  cases::Control control = cases::Control::nominal_pressure;
  double amount = 0.0; ///< p_0 [Pa] or mean gap [m]
  int step = 0;        ///< index in the program
};

/// One load step solved. The row has all but the times, the step and the
/// stiffness, which are the curve's.
struct StepAnswer {
  results::CurvePoint row;
  Grid grid;                    ///< of the maps
  std::vector<double> pressure; ///< [Pa]
  std::vector<double> gap;      ///< [m]
  /// The method's own stress in a section, at step_with_section alone.
  std::optional<results::Table> section = {};
};

/// One method on one realisation.
class StepSolver {
public:
  virtual ~StepSolver() = default;
  virtual StepAnswer solve(const StepTarget& target) = 0;

  /// What only the solver that was set up knows, for the method's description;
  /// empty if there is nothing.
  virtual std::string found_at_setup() const { return {}; }

  /// Where the next step starts from, for another process to go on as this one
  /// would; empty for a method that cannot.
  virtual std::vector<double> state() const { return {}; }

  /// @param state  of an equal solver
  virtual void restore(std::span<const double> state) {
    static_cast<void>(state);
  }

  /// CPU time that set-up would have taken beyond what it took, because parts
  /// of it were kept by an earlier run [s].
  virtual double saved_setup_time() const { return 0.0; }
};

/// What a method is, in words for the report.
struct MethodDescription {
  std::string kind;        ///< theory | halfspace | fem | md
  std::string text;        ///< one line
  bool runs_alone = false; ///< its library allows one run at a time, or it
                           ///< uses every core by itself
};

} // namespace asperity::app
