// Tests of the number of iterations of contact/solvers/solver.hpp and of
// bitwise equality on one and two threads. Counts, unlike times, are the same
// on every machine up to roundoff.
#include "base/special_numbers.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "tests/contact/problems.hpp"
#include "tests/narrower_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity::contact::iterations_test {

enum class Borders { periodic, free };

std::unique_ptr<SurfaceOperator> half_space(const Grid& grid, Borders borders,
                                            int threads) {
  if (borders == Borders::free)
    return free_halfspace(grid, 1.0, threads).clone();
  return std::make_unique<FourierOperator>(
      problems::unit_halfspace(grid, threads));
}

ContactSolution step_on(int points, double pressure, int threads,
                        Borders borders = Borders::periodic) {
  const Grid grid{points, points, 1.0, 1.0};
  const std::vector<double> heights = problems::rough_heights(grid, {});
  LoadSequence sequence(half_space(grid, borders, threads), heights, {},
                        1e-8 * problems::rms(heights), 2000);
  return sequence.solve({mechanics::Control::nominal_pressure, pressure});
}

int most_iterations(int points, Borders borders) {
  int most = 0;
  for (const double pressure : {.003, .03, .1, .3, .6, 1.0}) {
    const ContactSolution solution = step_on(points, pressure, 1, borders);
    EXPECT_TRUE(solution.converged && solution.note.empty()) << solution.note;
    most = std::max(most, solution.iterations);
  }
  return most;
}

// Verifies that a load step without an initial guess, from light to nearly full
// contact (0.7 to 97 % of the nodes), to 1e-8 h_rms, takes no more than these
// iterations, whatever the number of nodes. Measured: 7, 7 and 7. Margin: a
// fifth, because roundoff changes a count by one or two.
TEST(Iterations, StayFewAtAnyLoadAndNumberOfNodes) {
  for (const int points : {128, 256, 512})
    EXPECT_LE(most_iterations(points, Borders::periodic), 9) << points;
}

// The same with free boundaries. Measured: 9, 10 and 11.
// Margin: a tenth.
TEST(Iterations, StayFewWithFreeBoundaries) {
  for (const int points : {128, 256, 512})
    EXPECT_LE(most_iterations(points, Borders::free), 12) << points;
}

// The same with 2 points in the shortest wave, H = 0.3 and no roll-off, where
// the next grid does not hold the shortest waves. Measured: 8, 9 and 9; without
// the pressure of these waves in the start 9, 11 and 11.
TEST(Iterations, StayFewWithWavesThatTheCoarseGridDoesNotHold) {
  const Grid grid{256, 256, 1.0, 1.0};
  const std::vector<double> heights =
      problems::rough_heights(grid, {0.3, 1.0, 2.0});
  for (const double pressure : {.025, .11, .35}) {
    LoadSequence sequence(half_space(grid, Borders::periodic, 1), heights, {},
                          1e-8 * problems::rms(heights), 2000);
    const ContactSolution solution =
        sequence.solve({mechanics::Control::nominal_pressure, pressure});
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(solution.iterations, 10) << pressure;
  }
}

// A step that is long for an extrapolation starts from the coarse grid: from
// the extrapolation these took 9, 11 and 10 iterations, now 7 at most.
TEST(Iterations, StayFewAlongAPathOfLongSteps) {
  const Grid grid{256, 256, 1.0, 1.0};
  const std::vector<double> heights = problems::rough_heights(grid, {});
  LoadSequence path(half_space(grid, Borders::periodic, 1), heights, {},
                    1e-8 * problems::rms(heights), 2000);
  for (const double first : {5e-4, 2.63e-3})
    path.solve({mechanics::Control::nominal_pressure, first});
  for (const double pressure : {.0138, .0725, .3807}) {
    const ContactSolution solution =
        path.solve({mechanics::Control::nominal_pressure, pressure});
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(solution.iterations, 8) << pressure;
  }
}

// The partition of every sum is fixed, so that the number of threads changes no
// bit.
TEST(Iterations, ThreadsChangeNoBit) {
  for (const Borders borders : {Borders::periodic, Borders::free}) {
    const ContactSolution one = step_on(128, 0.1, 1, borders);
    for (const int threads : {2, 3}) {
      const ContactSolution several = step_on(128, 0.1, threads, borders);

      EXPECT_EQ(several.iterations, one.iterations);
      EXPECT_EQ(several.pressure, one.pressure);
      EXPECT_EQ(several.gap, one.gap);
    }
  }
}

// The loops of the solver add in the same order with all vectors, so that a
// processor changes no bit either.
TEST(Iterations, WidthOfVectorsChangesNoBit) {
  const ContactSolution widest = step_on(128, 0.1, 1);
  tests::on_narrower_vectors([&] {
    const ContactSolution narrower = step_on(128, 0.1, 1);

    EXPECT_EQ(narrower.iterations, widest.iterations);
    EXPECT_EQ(narrower.pressure, widest.pressure);
    EXPECT_EQ(narrower.gap, widest.gap);
  });
}

} // namespace asperity::contact::iterations_test
