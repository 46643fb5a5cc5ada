// Tests of md/minimise/relaxation.hpp with systems whose balance is known in
// closed form: it is found, within the allowed step, and non-convergence is
// reported.
#include "md/minimise/relaxation.hpp"
#include "tests/md/separate_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace asperity::md::relaxation_test {

using problems::Separate;

/// Springs of stiffness 1 .. 1e4 in balance at x_i = i.
Separate springs(std::size_t count) {
  const auto stiffness = [count](std::size_t i) {
    return std::pow(10.0, 4.0 * static_cast<double>(i) /
                              static_cast<double>(count - 1));
  };
  return {count,
          [=](std::size_t i, double x) {
            const double away = x - static_cast<double>(i);
            return 0.5 * stiffness(i) * away * away;
          },
          [=](std::size_t i, double x) {
            return -stiffness(i) * (x - static_cast<double>(i));
          }};
}

/// A weight i + 1 against a repulsive force 12 x^-13: balance at
/// (12/(i+1))^(1/13).
Separate repulsive(std::size_t count) {
  return {count,
          [](std::size_t i, double x) {
            return std::pow(x, -12.0) + static_cast<double>(i + 1) * x;
          },
          [](std::size_t i, double x) {
            return 12.0 * std::pow(x, -13.0) - static_cast<double>(i + 1);
          }};
}

RelaxationSettings unit_settings() {
  RelaxationSettings settings;
  settings.tolerance = 1e-9;
  settings.largest_step = 1e3;
  settings.contact_stiffness = 1.0;
  return settings;
}

// A residual of 1e-9 leaves each spring of stiffness >= 1 within 1e-9 sqrt(50)
// of its balance.
TEST(Relax, FindsTheBalanceOfSprings) {
  const Separate system = springs(50);
  std::vector<double> state = system.undeformed(0.0);

  const Relaxation answer = relax(system, state, unit_settings());

  ASSERT_TRUE(answer.converged) << answer.note;
  EXPECT_TRUE(answer.note.empty());
  EXPECT_LE(answer.residual, 1e-9);
  EXPECT_LE(answer.largest_residual, 1e-9 * std::sqrt(50.0));
  for (std::size_t i = 0; i < state.size(); ++i)
    EXPECT_NEAR(state[i], static_cast<double>(i), 1e-8);
}

// A preconditioner that is the exact inverse needs one step.
TEST(Relax, TakesTheStepOfAnExactInverse) {
  const Separate system(
      5, [](std::size_t, double x) { return 1.5 * (x - 1.0) * (x - 1.0); },
      [](std::size_t, double x) { return -3.0 * (x - 1.0); });
  RelaxationSettings settings = unit_settings();
  settings.contact_stiffness = 3.0;
  std::vector<double> state = system.undeformed(0.0);

  const Relaxation answer = relax(system, state, settings);

  EXPECT_TRUE(answer.converged);
  EXPECT_EQ(answer.evaluations, 2);
}

// The approach from a distance to the repulsive force, whose stiffness
// increases by 1e9 on the way, ends in balance. The curvature there is 156
// x^-14 > 10.
TEST(Relax, ConvergesAtASteepRepulsion) {
  const Separate system = repulsive(20);
  RelaxationSettings settings = unit_settings();
  settings.largest_step = 0.3;
  settings.max_evaluations = 1000;
  std::vector<double> state = system.undeformed(5.0);

  const Relaxation answer = relax(system, state, settings);

  ASSERT_TRUE(answer.converged) << answer.note;
  for (std::size_t i = 0; i < state.size(); ++i)
    EXPECT_NEAR(state[i],
                std::pow(12.0 / static_cast<double>(i + 1), 1.0 / 13.0), 1e-9);
}

// The first state that is tried lies within the allowed step.
TEST(Relax, KeepsToTheLargestStep) {
  const Separate system = springs(50);
  RelaxationSettings settings = unit_settings();
  settings.largest_step = 0.01;
  settings.max_evaluations = 2;
  std::vector<double> state = system.undeformed(0.0);

  relax(system, state, settings);

  ASSERT_EQ(system.evaluated.size(), 2U);
  double longest = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i)
    longest = std::max(
        longest, std::abs(system.evaluated[1][i] - system.evaluated[0][i]));
  EXPECT_NEAR(longest, 0.01, 1e-12);
}

TEST(Relax, ReportsWhenItsEvaluationsAreExhausted) {
  const Separate system = springs(50);
  RelaxationSettings settings = unit_settings();
  settings.max_evaluations = 7;
  std::vector<double> state = system.undeformed(0.0);

  const Relaxation answer = relax(system, state, settings);

  EXPECT_FALSE(answer.converged);
  EXPECT_EQ(answer.evaluations, 7);
  EXPECT_NE(answer.note.find("not converged after 7 evaluations"),
            std::string::npos)
      << answer.note;
}

// Forces that point uphill are detected, and the initial state is returned.
TEST(Relax, ReportsWhenNoStepDecreasesTheEnergy) {
  const Separate system(
      5, [](std::size_t, double x) { return 0.5 * x * x; },
      [](std::size_t, double x) { return x; });
  std::vector<double> state = system.undeformed(1.0);

  const Relaxation answer = relax(system, state, unit_settings());

  EXPECT_FALSE(answer.converged);
  EXPECT_NE(answer.note.find("line search failed"), std::string::npos)
      << answer.note;
  EXPECT_EQ(state, system.undeformed(1.0));
}

TEST(Relax, ReportsAStartWithoutEnergy) {
  const Separate system = repulsive(3);
  std::vector<double> state = system.undeformed(0.0);

  const Relaxation answer = relax(system, state, unit_settings());

  EXPECT_FALSE(answer.converged);
  EXPECT_NE(answer.note.find("not finite"), std::string::npos) << answer.note;
}

TEST(Relax, StopsOnRequest) {
  const Separate system = springs(50);
  std::vector<double> state = system.undeformed(0.0);
  std::vector<Progress> seen;

  const Relaxation answer =
      relax(system, state, unit_settings(), [&](const Progress& progress) {
        seen.push_back(progress);
        return seen.size() < 4;
      });

  EXPECT_FALSE(answer.converged);
  EXPECT_EQ(answer.note, "stopped by the caller");
  ASSERT_EQ(seen.size(), 4U);
  EXPECT_GT(seen[3].evaluations, seen[0].evaluations);
  EXPECT_LT(seen[3].energy, seen[0].energy);
}

TEST(ResidualOf, IsTheRootMeanSquareOverTheContactForce) {
  const std::vector<double> forces{3.0, -4.0, 0.0, 0.0};

  EXPECT_DOUBLE_EQ(residual_of({0.0, 5.0}, forces), 0.5);
}

TEST(Relax, IsNotInBalanceWithoutContact) {
  Separate system(
      3, [](std::size_t, double) { return 0.0; },
      [](std::size_t, double) { return 0.0; });
  system.contact_force = 0.0;
  std::vector<double> state = system.undeformed(0.0);

  const Relaxation answer = relax(system, state, unit_settings());

  EXPECT_FALSE(answer.converged);
  EXPECT_EQ(answer.residual, std::numeric_limits<double>::infinity());
}

TEST(Relax, RefusesInvalidSettings) {
  const Separate system = springs(5);
  std::vector<double> state = system.undeformed(0.0);
  RelaxationSettings settings = unit_settings();
  settings.contact_stiffness = 0.0;
  EXPECT_THROW(relax(system, state, settings), std::domain_error);
  state.pop_back();
  EXPECT_THROW(relax(system, state, unit_settings()), std::domain_error);
}

} // namespace asperity::md::relaxation_test
