// Tests of suite/exchange/answers/adhesive_answer.hpp: the energy of a gap, the
// state that a pressure leads to, and what is said of one that is no minimum.
#include "contact/solvers/adhesive.hpp"
#include "input/input_error.hpp"
#include "suite/exchange/answers/adhesive_answer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "problems.hpp"

namespace asperity::exchange::adhesive_answer_test {

class AdhesiveAnswerOf : public testing::Test {
protected:
  contact::ContactSolution solved(double mean_gap) {
    std::vector<double> start = problem.heights;
    for (double& gap : start)
      gap = std::ranges::max(problem.heights) - gap;
    return contact::solve_adhesive(
        *elasticity,
        {problem.heights, *problem.adhesion, 1e-10 * problem.rms_height, 20000,
         contact::adhesive_scale(*elasticity, problem.heights)},
        {mechanics::Control::mean_gap, mean_gap}, start);
  }

  AdhesiveAnswer answer_to(const std::vector<double>& pressure) {
    return adhesive_answer(
        *elasticity, problem,
        adhesive_state(*elasticity, problem, problem.loads[0], pressure));
  }

  /// How many claims hold, of all.
  std::pair<std::size_t, std::size_t> claims_of(const AdhesiveAnswer& answer,
                                                double energy) {
    CertifiedField field;
    add_adhesive_claims(answer, problem, 1e-3, energy, field);
    return {static_cast<std::size_t>(
                std::ranges::count_if(field.claims, &Claim::holds)),
            field.claims.size()};
  }

  Problem problem = problems::sticky_problem();
  std::unique_ptr<contact::SurfaceOperator> elasticity =
      problems::operator_of(problem);
};

// A wave A cos(q x) of the surface has E* q A^2/8 per area.
TEST_F(AdhesiveAnswerOf, HasTheEnergyOfAWaveAndOfTheLaw) {
  const double amplitude = 1e-7;
  const double q = 3.0 * 2.0 * std::numbers::pi / problem.grid.length_x;
  std::vector<double> gap(problem.heights.size());
  double law = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const double x = problem.grid.spacing_x() * static_cast<double>(i % 64);
    problem.heights[i] = amplitude * std::cos(q * x) - 3e-7;
    gap[i] = 5e-7 + 1e-12 * static_cast<double>(i % 7);
    law -= 0.05 * std::exp(-gap[i] / 3.2e-7) / static_cast<double>(gap.size());
  }

  EXPECT_NEAR(adhesive_energy(*elasticity, problem, gap),
              2e6 * q * amplitude * amplitude / 8.0 + law, 1e-9 * 0.05);
}

TEST_F(AdhesiveAnswerOf, HasTheGapOfAMinimum) {
  const contact::ContactSolution minimum = solved(problem.loads[0]);
  ASSERT_TRUE(minimum.converged) << minimum.note;
  std::vector<double> single = minimum.pressure;
  for (double& pressure : single)
    pressure = static_cast<float>(pressure);

  const contact::ContactSolution state =
      adhesive_state(*elasticity, problem, problem.loads[0], single);
  const AdhesiveAnswer answer = answer_to(single);

  std::size_t closed = 0;
  for (std::size_t i = 0; i < state.gap.size(); ++i) {
    EXPECT_NEAR(state.gap[i], minimum.gap[i], 1e-6 * problem.rms_height);
    EXPECT_EQ(state.gap[i] == 0.0, minimum.gap[i] == 0.0) << i;
    closed += state.gap[i] == 0.0 ? 1 : 0;
  }
  EXPECT_GT(closed, 100U);
  EXPECT_NEAR(mean(state.gap), problem.loads[0], 1e-14 * problem.loads[0]);
  EXPECT_LT(answer.distance, 1e-6 * problem.rms_height);
  EXPECT_LT(std::abs(answer.energy_left), 1e-10 * 0.05);
  const double energy = adhesive_energy(*elasticity, problem, minimum.gap);
  EXPECT_EQ(claims_of(answer, energy), std::pair(3UL, 3UL));
  EXPECT_EQ(claims_of(answer, energy + 2e-6 * 0.05), std::pair(2UL, 3UL));
}

TEST_F(AdhesiveAnswerOf, HasTheEnergyThatADescentSaves) {
  contact::ContactSolution minimum = solved(problem.loads[0]);
  const double energy = adhesive_energy(*elasticity, problem, minimum.gap);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(0.9, 1.1);
  for (double& pressure : minimum.pressure)
    pressure *= noise(random);

  const AdhesiveAnswer answer = answer_to(minimum.pressure);

  EXPECT_GT(answer.energy, energy + 1e-8);
  EXPECT_NEAR(answer.energy - answer.energy_left, energy, 1e-10);
  EXPECT_GT(answer.distance, 1e-4 * problem.rms_height);
}

TEST_F(AdhesiveAnswerOf, IsNotSoundFarFromAMinimumOrWithAnotherLoad) {
  contact::ContactSolution minimum = solved(problem.loads[0]);
  const std::vector<double> nothing(minimum.pressure.size(), 0.0);
  EXPECT_EQ(claims_of(answer_to(nothing), not_a_number).first, 0U);
  EXPECT_EQ(
      claims_of(answer_to(solved(problem.loads[1]).pressure), not_a_number)
          .first,
      0U);

  for (double& pressure : minimum.pressure)
    pressure += 2e-3 * 0.05 / 3.2e-7;
  EXPECT_EQ(claims_of(answer_to(minimum.pressure), not_a_number),
            std::pair(1UL, 2UL));
}

TEST_F(AdhesiveAnswerOf, IsRefusedIfRoundoffIsItsGap) {
  std::vector<double> pressure(problem.heights.size(), 1e12);
  pressure[5] = -1e20;
  EXPECT_THROW(answer_to(pressure), input::InputError);
}

// Nothing is open in a field that presses everywhere.
TEST_F(AdhesiveAnswerOf, IsJudgedWhateverItIs) {
  for (const double pressure : {1e12, 1e9, -1e9, -1e12}) {
    const std::vector<double> uniform(problem.heights.size(), pressure);
    const contact::ContactSolution state =
        adhesive_state(*elasticity, problem, problem.loads[0], uniform);
    EXPECT_NEAR(mean(state.gap), problem.loads[0], 1e-12 * problem.loads[0]);
    EXPECT_GE(*std::ranges::min_element(state.gap), 0.0);
    EXPECT_LT(claims_of(answer_to(uniform), not_a_number).first, 2U);
  }
}

} // namespace asperity::exchange::adhesive_answer_test
