#pragma once

// The flow through the gap of a load step, for [flow] of a case.

#include "cases/types/case.hpp"
#include "methods/step_solver.hpp"
#include "theory/persson/persson.hpp"

#include <span>
#include <string>

namespace asperity::run {

/// Adds to the row of a step with maps the flow through its gap along x and y
/// (flow/reynolds.hpp). It is omitted if the step has not converged, and if it
/// fails the note of the row says why.
/// @param rms_height  of the surface of the method [m]
void add_flow(const cases::FlowStudy& study, const cases::MethodSpec& method,
              double rms_height, methods::StepAnswer& answer);

/// Adds the flow of the theory to its row: that of the effective medium with
/// the distribution of u_1, Eq. (27) of Yang and Persson (2008), and u_1 where
/// the open area percolates (theory/persson/leakage.hpp). Where u_1 is not
/// determined, the note of the row says why.
void add_flow(const cases::FlowStudy& study,
              const theory::PerssonContact& contact, results::CurvePoint& row);

/// Sets the leak rates of a row with flow,
/// Q = K Dp/(12 eta) W/L, where K is the flow conductance of a square.
void set_leak_rates(const cases::FlowStudy& study, results::CurvePoint& row);

/// The flux |q| over its mean and the narrowest place of one saved map, for
/// flow along x: averaged over squares of nodes if a side has more than 256.
/// @param nodes  grid.size(), with their gaps
/// @return  "flow-<method>" with the columns x, y [m], flux [1] and is_critical
///          [1]; without rows if the map is sealed
results::Table flow_map_table(const std::string& method, const Grid& grid,
                              const mechanics::ContactNodes& nodes,
                              mechanics::Border border);

} // namespace asperity::run
