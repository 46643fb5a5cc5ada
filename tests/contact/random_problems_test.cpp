// Verifies that the solver converges in hundreds of random problems over
// kernels, roughness, penalty and load. Each solution must be complementary and
// in balance by a check that is independent of the solver.
#include "contact/solvers/solver.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace asperity::contact::random_problems_test {

constexpr int n_problems = 600;

struct RandomProblem {
  Grid grid;
  mechanics::ElasticBlock block;
  problems::Roughness roughness;
  double local_compliance;
  double nominal_pressure;
};

double log_uniform(std::mt19937_64& random, double low, double high) {
  std::uniform_real_distribution<double> exponent(std::log(low),
                                                  std::log(high));
  return std::exp(exponent(random));
}

RandomProblem random_problem(unsigned number) {
  std::mt19937_64 random(number);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const std::array<int, 3> sizes{16, 32, 64};
  const int points = sizes[random() % 3];
  RandomProblem drawn;
  drawn.grid = {points, points, 1.0, 1.0};
  drawn.block = {1.0, 0.3, std::numeric_limits<double>::infinity(),
                 mechanics::FarBoundary::clamped};
  if (random() % 2 == 0) {
    drawn.block.thickness = log_uniform(random, 0.02, 2.0);
    drawn.block.far_boundary = std::array{
        mechanics::FarBoundary::clamped, mechanics::FarBoundary::sliding,
        mechanics::FarBoundary::pressure}[random() % 3];
    // With a free far boundary the thinnest blocks are plates: see
    // solve_contact.
    drawn.block.thickness = log_uniform(
        random,
        drawn.block.far_boundary == mechanics::FarBoundary::pressure ? 0.01
                                                                     : 0.02,
        2.0);
  }
  drawn.roughness.hurst = 0.2 + 0.7 * unit(random);
  drawn.roughness.roll_off = 1.0 + 3.0 * unit(random);
  drawn.roughness.shortest_wave = log_uniform(random, 2.0, 16.0);
  drawn.roughness.seed = number;
  const bool is_hard = random() % 3 == 0;
  // 1/k in units of h/E*, k from 1e-3 to 1e12 E*/h.
  drawn.local_compliance =
      is_hard ? 0.0 : drawn.grid.spacing_x() / log_uniform(random, 1e-3, 1e12);
  drawn.nominal_pressure = log_uniform(random, 1e-6, 5.0); // E* h' = 1
  return drawn;
}

TEST(RandomProblems, AllConvergeAndSatisfyTheirConditions) {
  for (unsigned number = 1; number <= n_problems; ++number) {
    SCOPED_TRACE(number);
    const RandomProblem drawn = random_problem(number);
    const std::vector<double> heights =
        problems::rough_heights(drawn.grid, drawn.roughness);
    const double rms_height = problems::rms(heights);
    if (rms_height == 0.0)
      continue; // no wave fits between roll-off and shortest
    FourierOperator elasticity = halfspace_operator(drawn.grid, drawn.block);
    const ContactProblem problem{heights, drawn.local_compliance,
                                 1e-8 * rms_height, 3000};

    const ContactSolution solution = solve_contact(
        elasticity, problem,
        {mechanics::Control::nominal_pressure, drawn.nominal_pressure});

    ASSERT_TRUE(solution.converged) << solution.note;
    // Only a block that bends like a plate may need the active set.
    const bool is_plate =
        drawn.block.far_boundary == mechanics::FarBoundary::pressure &&
        drawn.block.thickness < 0.1;
    EXPECT_TRUE(solution.note.empty() || is_plate) << solution.note;
    // Roundoff of C p and c p: 1e-15 of the larger one.
    const double rounding =
        1e-14 * drawn.nominal_pressure *
        (drawn.local_compliance + elasticity.short_wave_compliance()) *
        static_cast<double>(heights.size());
    EXPECT_LE(problems::complementarity_error(elasticity, problem, solution),
              problem.gap_tolerance * 1.01 + rounding);
    EXPECT_NEAR(solution.nominal_pressure / drawn.nominal_pressure, 1.0, 1e-12);
  }
}

} // namespace asperity::contact::random_problems_test
