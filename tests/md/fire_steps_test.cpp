// Tests of the single steps of md/minimise/fire.hpp, with one unknown each.
#include "md/minimise/fire.hpp"
#include "tests/md/separate_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity::md::fire_steps_test {

using problems::Separate;

/// A spring in balance at 0; with contact_stiffness 1 the preconditioner is 1.
Separate spring(double stiffness) {
  return {1, [=](std::size_t, double x) { return 0.5 * stiffness * x * x; },
          [=](std::size_t, double x) { return -stiffness * x; }};
}

RelaxationSettings settings_with(double largest_step) {
  RelaxationSettings settings;
  settings.tolerance = 1e-9;
  settings.max_evaluations = 2000;
  settings.largest_step = largest_step;
  settings.contact_stiffness = 1.0;
  return settings;
}

// A first step that increases the energy is treated like any other. The first
// time step is 0.1, so that from 1 the spring of 500 next has the position 1 -
// 0.01 * 500 = -4, where motion with the same time step diverges.
TEST(FireSteps, AnIncreaseAfterTheFirstStepShortensTheTimeStep) {
  const Separate system = spring(500.0);
  std::vector<double> state{1.0};

  const Relaxation answer = relax_by_fire(system, state, settings_with(1e3));

  ASSERT_TRUE(answer.converged) << answer.note;
  EXPECT_NEAR(state[0], 0.0, 1e-9 / 500.0);
  ASSERT_GE(system.evaluated.size(), 3U);
  EXPECT_DOUBLE_EQ(system.evaluated[1][0], -4.0);
  // Half of the step of -5 back, then half of the time step with force 2000.
  EXPECT_DOUBLE_EQ(system.evaluated[2][0], -1.5 + 0.05 * 0.05 * 2000.0);
}

// After an increase half of the step that was taken is reverted, which
// largest_step may have shortened: no state is further from the previous one
// than half a step back and one step forward.
TEST(FireSteps, AnIncreaseRevertsHalfOfTheStep) {
  const Separate system = spring(30.0);
  const double largest_step = 0.01;
  std::vector<double> state{1.003}; // not an integer number of steps away

  const Relaxation answer =
      relax_by_fire(system, state, settings_with(largest_step));

  ASSERT_TRUE(answer.converged) << answer.note;
  for (std::size_t i = 1; i < system.evaluated.size(); ++i)
    ASSERT_LE(std::abs(system.evaluated[i][0] - system.evaluated[i - 1][0]),
              1.5 * largest_step * (1.0 + 1e-12))
        << "step " << i;
}

// Every state is that of the algorithm of Bitzek et al. (2006) with half of the
// last step reverted at an increase: after each increase the time step grows
// after five steps downhill. With one unknown the mixing has no effect.
// Tolerance: roundoff, which the damped motion does not amplify.
TEST(FireSteps, EachIncreaseRestartsTheCountOfStepsDownhill) {
  const Separate system = spring(1.0);
  std::vector<double> state{1.0};

  const Relaxation answer = relax_by_fire(system, state, settings_with(1e3));

  ASSERT_TRUE(answer.converged) << answer.note;
  double x = 1.0, velocity = 0.0, time_step = 0.1;
  int downhill = 0, rises = 0;
  for (std::size_t i = 0; i < system.evaluated.size(); ++i) {
    ASSERT_NEAR(system.evaluated[i][0], x, 1e-13) << "step " << i;
    if (x * velocity < 0.0) {
      if (++downhill > 5)
        time_step = std::min(1.1 * time_step, 1.0);
    } else if (i > 0) {
      x -= 0.5 * time_step * velocity;
      velocity = 0.0;
      downhill = 0;
      time_step *= 0.5;
      ++rises;
    }
    velocity -= time_step * system.evaluated[i][0];
    x += time_step * velocity;
  }
  EXPECT_GE(rises, 2);
}

// Forces that are not finite end the relaxation at once, for any energy.
TEST(FireSteps, ReportsAForceThatIsNotFinite) {
  const Separate system(
      2, [](std::size_t, double x) { return x; },
      [](std::size_t i, double) {
        return i == 1 ? std::numeric_limits<double>::quiet_NaN() : -1.0;
      });
  std::vector<double> state = system.undeformed(0.0);

  const Relaxation answer = relax_by_fire(system, state, settings_with(1.0));

  EXPECT_FALSE(answer.converged);
  EXPECT_EQ(answer.evaluations, 1);
  EXPECT_NE(answer.note.find("not finite"), std::string::npos) << answer.note;
  EXPECT_TRUE(std::isnan(answer.largest_residual));
}

} // namespace asperity::md::fire_steps_test
