#pragma once

// What is read off an answer, and what a result file says of it, held against
// the ranges that physics gives: independent of the program's own checks.

#include "base/grid.hpp"
#include "contact/solvers/solver.hpp"
#include "results/types/result.hpp"

#include "robustness/verify.hpp"

namespace asperity::robustness {

/// Every observable of an answer exists and lies in its range: areas in 0..1
/// (the fitted ones may be NaN, not determined), perimeters and energies >= 0.
/// An exception is a failure too: an observable never ends a run.
/// @param contact_modulus  E* [Pa] > 0
/// @return  the first that fails; empty if all hold
std::optional<Failure>
verify_observables(const Grid& grid, const AskedContact& asked,
                   const contact::ContactSolution& solution,
                   double contact_modulus);

/// The same of a row of a result file, which also must have converged.
std::optional<Failure> verify_row(const results::CurvePoint& row);

} // namespace asperity::robustness
