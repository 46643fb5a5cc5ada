// Claim: the active set answers the problem of the other solvers, from few
// nodes in contact to nearly all, and thin slabs that stall both of them.
#include "contact/solvers/active_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "tests/contact/scenes.hpp"

namespace asperity::contact {
namespace {

const Grid grid{16, 16, 1.0, 1.0};

std::vector<double> heights() {
  return scenes::rough_heights(grid, {0.8, 2.0, 4.0, 3});
}

FourierOperator slab(double thickness) {
  return halfspace_operator(
      grid, {1.0, 0.3, thickness, mechanics::FarBoundary::pressure});
}

// Both answers are exact for heights that differ by the tolerance, and the
// mean gap follows the heights by no more: 2 tolerances.
TEST(ActiveSet, AgreesWithPolonskyAndKeer) {
  const std::vector<double> surface = heights();
  const double tolerance = 1e-9 * scenes::rms(surface);
  FourierOperator elasticity = slab(0.2);
  for (const double compliance : {0.0, 0.02})
    for (const double load : {0.01, 0.3, 2.0, 20.0}) {
      SCOPED_TRACE(load);
      const ContactProblem problem{surface, compliance, tolerance, 5000};
      const mechanics::LoadTarget target{mechanics::Control::nominal_pressure,
                                         load};

      const ContactSolution found = active_set(elasticity, problem, target);
      const ContactSolution judge = polonsky_keer(elasticity, problem, target);

      ASSERT_TRUE(judge.converged);
      ASSERT_TRUE(found.converged) << found.note;
      EXPECT_NEAR(found.mean_gap, judge.mean_gap, 2.0 * tolerance);
      EXPECT_LE(scenes::complementarity_error(elasticity, problem, found),
                1.01 * tolerance);
      const mechanics::LoadTarget gap{mechanics::Control::mean_gap,
                                      judge.mean_gap};
      if (compliance > 0.0) {
        const ContactSolution by_gap = active_set(elasticity, problem, gap);
        ASSERT_TRUE(by_gap.converged) << by_gap.note;
        // A softer contact than the springs alone moves the load by less.
        EXPECT_NEAR(by_gap.nominal_pressure, load,
                    4.0 * tolerance / compliance);
      }
    }
}

/// Leaves numbers that are not finite in the memory that is allocated next. The
/// blocks are smaller than those that malloc takes from the system, where
/// memory is zero, and what is returned keeps their memory from being given
/// back.
std::unique_ptr<double> dirty_memory() {
  std::vector<std::vector<double>> blocks(
      64, std::vector<double>(16000, std::numeric_limits<double>::infinity()));
  return std::make_unique<double>();
}

// Claim: no answer depends on what the memory held before. Once the upper
// triangle of a matrix, of which only the lower was set, decided whether it has
// a factor.
TEST(ActiveSet, ReadsNoMemoryThatItDidNotSet) {
  const std::vector<double> surface = heights();
  FourierOperator elasticity = slab(0.2);
  for (const double load : {0.01, 0.3, 2.0}) {
    SCOPED_TRACE(load);
    const ContactProblem problem{surface, 0.0, 1e-9 * scenes::rms(surface),
                                 5000};
    const std::unique_ptr<double> above = dirty_memory();

    const ContactSolution found = active_set(
        elasticity, problem, {mechanics::Control::nominal_pressure, load});

    EXPECT_TRUE(found.converged) << found.note;
  }
}

// The conditions themselves, where nothing else converges, with less and with
// more than half of the nodes in contact.
TEST(ActiveSet, HoldsSlabsThatBendLikePlates) {
  const std::vector<double> surface = heights();
  const double tolerance = 1e-8 * scenes::rms(surface);
  for (const double thickness : {0.01, 0.03})
    for (const double load : {1e-4, 1e-2, 1.0, 10.0}) {
      SCOPED_TRACE(load);
      FourierOperator elasticity = slab(thickness);
      const ContactProblem problem{surface, 0.0, tolerance, 2000};

      const ContactSolution found = active_set(
          elasticity, problem, {mechanics::Control::nominal_pressure, load});

      ASSERT_TRUE(found.converged) << found.note;
      // 64 eps of the longest wave's 12 / (E* d^3 q^4), see active_set().
      const double peak =
          *std::max_element(found.pressure.begin(), found.pressure.end());
      const double rounding =
          64.0 * 2.3e-16 * peak * 12.0 /
          (std::pow(thickness, 3) * std::pow(2.0 * std::numbers::pi, 4));
      EXPECT_LE(scenes::complementarity_error(elasticity, problem, found),
                1.01 * tolerance + rounding);
      EXPECT_NEAR(found.nominal_pressure / load, 1.0, 1e-12);
    }
}

} // namespace
} // namespace asperity::contact
