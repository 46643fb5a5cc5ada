// Tests of md/dynamics/dynamics_run.hpp: damped motion converges to the state
// of L-BFGS.
#include "md/dynamics/dynamics_run.hpp"
#include "tests/base/fields.hpp"
#include "tests/md/rough_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::md::dynamics_run_agreement_test {

using problems::angstrom;
using problems::RoughContact;

constexpr double tolerance = 1e-7;

RelaxationSettings tight() {
  RelaxationSettings settings;
  settings.tolerance = tolerance;
  return settings;
}

/// Largest difference of the normal forces, in units of their mean.
double force_difference(const System& system, std::span<const double> a,
                        std::span<const double> b) {
  const std::vector<double> first = normal_forces(system, a);
  const std::vector<double> second = normal_forces(system, b);
  double mean = 0.0;
  for (const double force : first)
    mean += std::abs(force) / static_cast<double>(first.size());
  return tests::largest_difference(first, second) / mean;
}

class TwoMinimizers : public ::testing::TestWithParam<Load> {
protected:
  TwoMinimizers() : system(problem().system()) {
    system.set_load(GetParam());
    start = system.undeformed(GetParam().kind == Load::Kind::height
                                  ? GetParam().amount
                                  : problem().highest() + 4.0 * angstrom);
  }

  static RoughContact problem() {
    RoughContact problem{16};
    problem.levels = 2;
    problem.layers = 3;
    return problem;
  }

  ExplicitSystem system;
  std::vector<double> start;
};

INSTANTIATE_TEST_SUITE_P(
    Loads, TwoMinimizers,
    ::testing::Values(Load{Load::Kind::nominal_pressure, 1e9},
                      Load{Load::Kind::height, 5.0 * angstrom}));

// Damped motion converges to the state of L-BFGS, and ends early. Tolerance:
// both leave a residual of 1e-7 of the mean force, root mean square over all
// unknowns; the error of the largest force of a layer may be sqrt(unknowns)
// times the range of the softest wave, 1e-4. The
// damping is near critical for the block on its contact: 9 m per surface atom
// on some 0.5 N/m.
TEST_P(TwoMinimizers, DampedMotionEndsWhereLbfgsDoes) {
  std::vector<double> by_lbfgs = start;
  const Relaxation lbfgs = relax(system, by_lbfgs, tight());
  ASSERT_TRUE(lbfgs.converged) << lbfgs.note;
  // The start is close, since falling from 4 A takes the block a long time.
  std::vector<double> by_motion = by_lbfgs;
  for (std::size_t i = 0; i < by_motion.size(); ++i)
    by_motion[i] += 0.2 * (start[i] - by_lbfgs[i]);
  if (GetParam().kind == Load::Kind::height)
    by_motion = start;
  const DynamicsRun run{
      {10e-15, 6e11, 0.0, 0, 1}, 100e-12, tolerance, {}, 1000, {}};

  const DynamicsOutcome outcome =
      run_dynamics(system, GetParam(), by_motion, run);

  ASSERT_TRUE(outcome.relaxation.converged) << outcome.relaxation.note;
  RecordProperty("steps", outcome.relaxation.evaluations);
  EXPECT_LT(outcome.relaxation.evaluations, 10000);
  EXPECT_EQ(outcome.average.samples, 0);
  EXPECT_NEAR(outcome.relaxation.energy / lbfgs.energy, 1.0, 1e-9);
  EXPECT_LT(force_difference(system, by_lbfgs, by_motion), 1e-4);
}

} // namespace asperity::md::dynamics_run_agreement_test
