#pragma once

// Verifies the observables of a solution, and the rows of a result file,
// against physically admissible ranges, independently of the program's own
// checks.

#include "base/grid.hpp"
#include "contact/solvers/solver.hpp"
#include "results/types/result.hpp"
#include "robustness/verify.hpp"

namespace asperity::robustness {

/// Verifies that every observable of a solution exists and lies in its range:
/// areas in 0..1 (the fitted ones may be NaN, not determined), perimeters and
/// energies >= 0. An exception is also a failure, because an observable must
/// never terminate a run.
/// @param contact_modulus  E* [Pa] > 0
/// @return  the first check that fails; empty if all pass
std::optional<Failure>
verify_observables(const Grid& grid, const AskedContact& asked,
                   const contact::ContactSolution& solution,
                   double contact_modulus);

/// Verifies the same for a row of a result file, which must also have
/// converged.
std::optional<Failure> verify_row(const results::CurvePoint& row);

} // namespace asperity::robustness
