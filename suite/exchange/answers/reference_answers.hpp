#pragma once

// Makes a problem of a case and answers it: on the grid of the case with
// certified bounds, and for infinitely fine grids with estimated errors.

#include "input/types/case.hpp"
#include "mechanics/fem_settings.hpp"
#include "suite/exchange/problem.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::exchange {

/// A load at which the problem has no solution, or none was found.
struct NoAnswer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A problem with its reference answers.
struct AnsweredProblem {
  Problem problem;
  std::string method; ///< of the case, whose block is that of the problem
  /// How it is meshed: as the method does, a half-space by Q1 in the same way.
  mechanics::BlockSettings block;
  std::vector<ProblemAnswer> answers;         ///< one per load
  std::vector<std::vector<double>> pressures; ///< of these answers [Pa]
  std::vector<ContinuumAnswer> continuum;     ///< one per load
};

/// The problem is the first realisation of the surface, pressed on the block of
/// one method in hard contact, or with exponential attraction along the path of
/// mean gaps of the case; there is no estimate of the continuum then. Loads
/// given as mean gaps become the pressures of
/// the answers. The continuum is estimated from this grid and up to two finer
/// ones of at most 1024 points per side, or is the exact solution of the shape
/// on a half-space (a wave, or a single shape with free boundaries); a measured
/// map is refined by interpolation.
/// @param method_name  of a half-space or condensed finite-element method;
///                     empty: the first one
/// @throws input::InputError   no such method, or a block that is not layered
/// @throws NoAnswer           there is no contact at a load, or a solution did
///                            not converge
AnsweredProblem answered_problem(const cases::Case& contact_case,
                                 const std::string& method_name);

} // namespace asperity::exchange
