#pragma once

// The flow through the gap of a load step, for [flow] of a case.

#include "cases/types/studies.hpp"
#include "methods/step_solver.hpp"
#include "theory/persson/persson.hpp"

namespace asperity::run {

/// Which nodes of a gap no fluid can pass.
struct ClosedNodes {
  double gap = 0.0;           ///< those with at most this gap [m] >= 0
  bool under_pressure = true; ///< those with a pressure; atoms press everywhere
};

/// Adds to the row of a step with maps the flow through its gap along x and y
/// (flow/reynolds.hpp). It is omitted if the step has not converged, and if it
/// fails the note of the row says why.
void add_flow(const cases::FlowStudy& study, const ClosedNodes& closed,
              methods::StepAnswer& answer);

/// Adds the flow of the theory to its row: that of the effective medium with
/// the distribution of u_1, Eq. (27) of Yang and Persson (2008), and u_1 where
/// the open area percolates (theory/persson/leakage.hpp). Where u_1 is not
/// determined, the note of the row says why.
void add_flow(const cases::FlowStudy& study,
              const theory::PerssonContact& contact, results::CurvePoint& row);

/// Sets the leak rates of a row with flow,
/// Q = K Dp/(12 eta) W/L, where K is the flow conductance of a square.
void set_leak_rates(const cases::FlowStudy& study, results::CurvePoint& row);

} // namespace asperity::run
