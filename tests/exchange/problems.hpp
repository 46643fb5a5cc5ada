#pragma once

// A small problem with its solutions, for the tests of the exchange of problems
// and answers.

#include "base/field_sums.hpp"
#include "contact/solvers/solver.hpp"
#include "suite/exchange/problem.hpp"
#include "surfaces/maps/statistics.hpp"
#include "tests/contact/problems.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::exchange::problems {

/// A rough surface without symmetry on 64 x 64 nodes of 1 um, E* 1 GPa.
inline Problem rough_problem() {
  Problem problem;
  problem.name = "rough";
  problem.title = "A rough surface";
  problem.grid = {64, 64, 64e-6, 64e-6};
  problem.heights = contact::problems::rough_heights(
      problem.grid, {.roll_off = 2.0, .seed = 5});
  for (double& height : problem.heights)
    height *= 0.1;
  problem.body.contact_modulus = 1e9;
  problem.body.poisson_ratio = 0.3;
  problem.body.thickness = infinity;
  problem.loads = {2e6, 5e6, 2e7};
  problem.rms_height = rms_height(problem.heights);
  problem.rms_slope =
      surfaces::statistics({problem.grid, problem.heights}).rms_slope;
  return problem;
}

/// The same surface on a softer block with attraction, of a range that the grid
/// resolves, led to 2.5 and 1.5 h_rms.
inline Problem sticky_problem() {
  Problem problem = rough_problem();
  problem.body.contact_modulus = 2e6;
  problem.adhesion =
      mechanics::ContactInterface{mechanics::ContactLaw::exponential};
  problem.adhesion->work_of_adhesion = 0.05;
  problem.adhesion->adhesion_range = 3.2e-7;
  problem.loads = {2.5 * problem.rms_height, 1.5 * problem.rms_height};
  return problem;
}

inline std::unique_ptr<contact::SurfaceOperator>
operator_of(const Problem& problem) {
  return surface_operator(problem, problem.grid);
}

/// The pressure at a load, on given heights or with another modulus.
inline std::vector<double> solved(const Problem& problem, double load,
                                  double tolerance = 1e-9) {
  return contact::solve_contact(
             *operator_of(problem),
             {problem.heights, 0.0, tolerance * problem.rms_height, 2000},
             {mechanics::Control::nominal_pressure, load})
      .pressure;
}

inline ProblemAnswer example_of(const Problem& problem) {
  return {problem.loads[0], 1e-6, 1e-12, 0.1, 2.0, 3e7};
}

} // namespace asperity::exchange::problems
