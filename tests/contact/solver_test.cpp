// Tests of contact/solvers/solver.hpp with problems whose solution is known
// independently.
#include "base/special_numbers.hpp"
#include "contact/solvers/polonsky_keer.hpp"
#include "contact/solvers/solver.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace asperity::contact::solver_test {

using std::numbers::pi;
using Kind = mechanics::Control;

class RoughSurface : public ::testing::Test {
protected:
  static constexpr Grid grid{64, 64, 1.0, 1.0};
  std::vector<double> heights = problems::rough_heights(grid, {});
  double rms_height = problems::rms(heights);
  FourierOperator elasticity = problems::unit_halfspace(grid);

  ContactProblem problem(double local_compliance = 0.0) const {
    return {heights, local_compliance, 1e-9 * rms_height, 1000};
  }
};

// The products of residuals and pressures of the small problem are below the
// smallest number in single precision. Tolerance: that of the gap.
TEST_F(RoughSurface, SmallNumbersTakeTheSameIterations) {
  const double factor = std::ldexp(1.0, -40);
  std::vector<double> low = heights;
  for (double& height : low)
    height *= factor;
  FourierOperator soft = halfspace_operator(grid, {factor, 0.0, infinity, {}});

  const ContactSolution expected =
      solve_contact(elasticity, problem(), {Kind::nominal_pressure, 0.1});
  const ContactSolution found =
      solve_contact(soft, {low, 0.0, factor * problem().gap_tolerance, 1000},
                    {Kind::nominal_pressure, factor * factor * 0.1});

  EXPECT_TRUE(found.converged && found.note.empty()) << found.note;
  EXPECT_EQ(found.iterations, expected.iterations);
  EXPECT_NEAR(found.mean_gap / factor, expected.mean_gap,
              problem().gap_tolerance);
}

// Verifies that the unpreconditioned method, implemented independently, finds
// the same pressures. Tolerance: a gap error of 1e-9 h_rms changes a pressure
// by at most that times the stiffness of the shortest wave of the grid, pi
// E*/(2 h) = 100 E*/L.
TEST_F(RoughSurface, AgreesWithTheUnpreconditionedMethod) {
  for (const double pressure : {0.002, 0.05, 0.4, 1.0}) {
    for (const double compliance : {0.0, 1e-3}) {
      const mechanics::LoadTarget target{Kind::nominal_pressure, pressure};
      const ContactSolution fast =
          solve_contact(elasticity, problem(compliance), target);
      const ContactSolution plain =
          polonsky_keer(elasticity, problem(compliance), target);

      ASSERT_TRUE(fast.converged && plain.converged);
      EXPECT_TRUE(fast.note.empty()) << fast.note;
      EXPECT_LT(fast.iterations, plain.iterations);
      EXPECT_NEAR(fast.mean_gap, plain.mean_gap, 2e-9 * rms_height);
      for (std::size_t i = 0; i < heights.size(); ++i)
        ASSERT_NEAR(fast.pressure[i], plain.pressure[i],
                    100.0 * 2e-9 * rms_height * 10.0);
    }
  }
}

// Verifies that the unpreconditioned method states the error of the pressure
// that it returns, also after an iteration in which overlapping nodes entered
// the contact, where the displacement cannot be updated by recurrence.
// Tolerance: the roundoff of the recurrence over these iterations.
TEST_F(RoughSurface, UnpreconditionedMethodStatesItsError) {
  std::vector<double> start(heights.size(), 0.0);
  start[static_cast<std::size_t>(
      std::max_element(heights.begin(), heights.end()) - heights.begin())] =
      1.0;
  for (int iterations = 1; iterations <= 12; ++iterations) {
    ContactProblem unfinished = problem();
    unfinished.max_iterations = iterations;

    const ContactSolution solution = polonsky_keer(
        elasticity, unfinished, {Kind::nominal_pressure, 0.05}, start);

    EXPECT_EQ(solution.iterations, iterations);
    EXPECT_NEAR(
        problems::complementarity_error(elasticity, unfinished, solution) /
            solution.gap_error,
        1.0, 1e-10);
  }
}

// Verifies that the mean gap that follows from a pressure, once prescribed,
// gives this pressure again.
TEST_F(RoughSurface, GapControlInvertsPressureControl) {
  for (const double compliance : {0.0, 1e-3}) {
    for (const double pressure : {0.002, 0.05, 0.4, 1.0}) {
      const ContactSolution by_pressure = solve_contact(
          elasticity, problem(compliance), {Kind::nominal_pressure, pressure});
      const ContactSolution by_gap =
          solve_contact(elasticity, problem(compliance),
                        {Kind::mean_gap, by_pressure.mean_gap});

      ASSERT_TRUE(by_gap.converged) << pressure;
      EXPECT_NEAR(by_gap.mean_gap, by_pressure.mean_gap, 1e-12 * rms_height);
      EXPECT_NEAR(by_gap.nominal_pressure / pressure, 1.0, 1e-6) << pressure;
    }
  }
}

// Verifies -dU/du = p0, where U is the energy in the block and in the penalty
// springs. Tolerance: central difference over 2 %, third derivative of the
// exponential: (0.02)^2/6 relative = 7e-5, and jumps of the active set of the
// same size.
TEST_F(RoughSurface, PressureIsTheDerivativeOfTheEnergy) {
  for (const double compliance : {0.0, 5e-3}) {
    const auto energy_and_gap = [&](double pressure) {
      const ContactSolution s = solve_contact(
          elasticity, problem(compliance), {Kind::nominal_pressure, pressure});
      double energy = 0.0;
      for (std::size_t i = 0; i < heights.size(); ++i)
        energy += 0.5 * s.pressure[i] *
                  (s.displacement[i] + compliance * s.pressure[i]);
      return std::pair(energy / static_cast<double>(heights.size()),
                       s.mean_gap);
    };
    const double pressure = 0.05;

    const auto [energy_low, gap_low] = energy_and_gap(pressure * 0.98);
    const auto [energy_high, gap_high] = energy_and_gap(pressure * 1.02);

    const double slope = (energy_high - energy_low) / (gap_low - gap_high);
    EXPECT_NEAR(slope / pressure, 1.0, 2e-4);
  }
}

TEST_F(RoughSurface, ReportsNonConvergence) {
  ContactProblem hurried = problem();
  hurried.max_iterations = 3;

  const ContactSolution solution =
      solve_contact(elasticity, hurried, {Kind::nominal_pressure, 0.1});

  EXPECT_FALSE(solution.converged);
  EXPECT_EQ(solution.note, "not converged in 3 iterations");
}

TEST_F(RoughSurface, RefusesBadArgumentsByName) {
  const auto message = [&](const ContactProblem& bad,
                           const mechanics::LoadTarget& target,
                           std::span<const double> start = {}) {
    try {
      solve_contact(elasticity, bad, target, start);
    } catch (const std::domain_error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const mechanics::LoadTarget light{Kind::nominal_pressure, 0.1};
  std::vector<double> broken = heights;
  broken[7] = std::nan("");
  const std::vector<double> unloaded(heights.size(), 0.0);

  EXPECT_NE(message({broken, 0.0, 1e-9, 10}, light).find("heights = nan"),
            std::string::npos);
  EXPECT_NE(message(problem(), {Kind::nominal_pressure, 0.0}).find("nominal"),
            std::string::npos);
  EXPECT_NE(message(problem(), {Kind::mean_gap, -1.0}).find("hard contact"),
            std::string::npos);
  EXPECT_NE(message(problem(-1.0), light).find("local_compliance"),
            std::string::npos);
  EXPECT_NE(message(problem(), light, unloaded).find("initial_pressure"),
            std::string::npos);
}

} // namespace asperity::contact::solver_test
