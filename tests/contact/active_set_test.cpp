// Tests of contact/solvers/active_set.hpp: the active set finds the solution of
// the other solvers, from few nodes in contact to nearly all of them, and
// converges for thin slabs for which both other solvers stagnate.
#include "contact/solvers/active_set.hpp"
#include "contact/solvers/polonsky_keer.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace asperity::contact::active_set_test {

const Grid grid{16, 16, 1.0, 1.0};

std::vector<double> heights() {
  return problems::rough_heights(grid, {0.8, 2.0, 4.0, 3});
}

FourierOperator slab(double thickness) {
  return halfspace_operator(
      grid, {1.0, 0.3, thickness, mechanics::FarBoundary::pressure});
}

// Each solution is exact for heights that differ from the given ones by no more
// than the tolerance, and the mean gap changes by no more than the heights: 2
// tolerances.
TEST(ActiveSet, AgreesWithPolonskyAndKeer) {
  const std::vector<double> surface = heights();
  const double tolerance = 1e-9 * problems::rms(surface);
  FourierOperator elasticity = slab(0.2);
  for (const double compliance : {0.0, 0.02})
    for (const double load : {0.01, 0.3, 2.0, 20.0}) {
      SCOPED_TRACE(load);
      const ContactProblem problem{surface, compliance, tolerance, 5000};
      const mechanics::LoadTarget target{mechanics::Control::nominal_pressure,
                                         load};

      const ContactSolution found = active_set(elasticity, problem, target);
      const ContactSolution reference =
          polonsky_keer(elasticity, problem, target);

      ASSERT_TRUE(reference.converged);
      ASSERT_TRUE(found.converged) << found.note;
      EXPECT_NEAR(found.mean_gap, reference.mean_gap, 2.0 * tolerance);
      EXPECT_LE(problems::complementarity_error(elasticity, problem, found),
                1.01 * tolerance);
      const mechanics::LoadTarget gap{mechanics::Control::mean_gap,
                                      reference.mean_gap};
      if (compliance > 0.0) {
        const ContactSolution by_gap = active_set(elasticity, problem, gap);
        ASSERT_TRUE(by_gap.converged) << by_gap.note;
        // A contact that is softer than the springs alone changes the load by
        // less.
        EXPECT_NEAR(by_gap.nominal_pressure, load,
                    4.0 * tolerance / compliance);
      }
    }
}

/// Writes numbers that are not finite into the memory that is allocated next.
/// The blocks are smaller than those for which malloc asks the system, whose
/// memory is zero, and the returned block prevents that their memory is
/// released.
std::unique_ptr<double> dirty_memory() {
  std::vector<std::vector<double>> blocks(
      64, std::vector<double>(16000, std::numeric_limits<double>::infinity()));
  return std::make_unique<double>();
}

// Verifies that no result depends on the previous content of the memory. An
// earlier version read the upper triangle of a matrix of which only the lower
// had been set, and so decided whether the matrix had a factor.
TEST(ActiveSet, ReadsNoMemoryThatItDidNotSet) {
  const std::vector<double> surface = heights();
  FourierOperator elasticity = slab(0.2);
  for (const double load : {0.01, 0.3, 2.0}) {
    SCOPED_TRACE(load);
    const ContactProblem problem{surface, 0.0, 1e-9 * problems::rms(surface),
                                 5000};
    const std::unique_ptr<double> above = dirty_memory();

    const ContactSolution found = active_set(
        elasticity, problem, {mechanics::Control::nominal_pressure, load});

    EXPECT_TRUE(found.converged) << found.note;
  }
}

// Verifies the conditions of the contact problem, with less and with more than
// half of the nodes in contact, where no other solver converges.
TEST(ActiveSet, SolvesSlabsThatBendLikePlates) {
  const std::vector<double> surface = heights();
  const double tolerance = 1e-8 * problems::rms(surface);
  for (const double thickness : {0.01, 0.03})
    for (const double load : {1e-4, 1e-2, 1.0, 10.0}) {
      SCOPED_TRACE(load);
      FourierOperator elasticity = slab(thickness);
      const ContactProblem problem{surface, 0.0, tolerance, 2000};

      const ContactSolution found = active_set(
          elasticity, problem, {mechanics::Control::nominal_pressure, load});

      ASSERT_TRUE(found.converged) << found.note;
      // The tolerance is 64 eps of 12 / (E* d^3 q^4) at the longest wave, see
      // active_set().
      const double peak =
          *std::max_element(found.pressure.begin(), found.pressure.end());
      const double rounding =
          64.0 * 2.3e-16 * peak * 12.0 /
          (std::pow(thickness, 3) * std::pow(2.0 * std::numbers::pi, 4));
      EXPECT_LE(problems::complementarity_error(elasticity, problem, found),
                1.01 * tolerance + rounding);
      EXPECT_NEAR(found.nominal_pressure / load, 1.0, 1e-12);
    }
}

} // namespace asperity::contact::active_set_test
