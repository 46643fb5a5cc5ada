// Tests of what follows in hard contact where the active set does not become
// stationary: the augmented Lagrangian method (fem/newton/contact_active_set).
#include "robustness/run_instance.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::robustness::hard_contact_test {

// A block on an adaptive mesh at a small mean gap. An active set that occurs
// on its coarse mesh has no solution; the augmented Lagrangian goes on, equal
// to the direct solver.
TEST(HardContact, ThatTheActiveSetCannotSolveIsSolvedByTheAugmentedLagrangian) {
  const InstanceReport report = run_instance(draw_instance(15002, 1935862));

  EXPECT_EQ(report.outcome, Outcome::verified)
      << report.check << ": " << report.reason;
  EXPECT_TRUE(report.has_pair);
}

// A heterogeneous block of nu = 0.4999 on a gmsh mesh, held at a mean gap below
// the least one. The active set finds no stationary set and cannot say why;
// the augmented Lagrangian states the mean gap that exists.
TEST(HardContact, WithoutAStationarySetIsRefusedByTheAugmentedLagrangian) {
  const InstanceReport report = run_instance(draw_instance(15002, 3260));

  EXPECT_EQ(report.outcome, Outcome::refused);
  for (const char* const words :
       {"the active set did not converge", "augmented Lagrangian",
        "its mean must be at least"})
    EXPECT_NE(report.reason.find(words), std::string::npos) << report.reason;
}

} // namespace asperity::robustness::hard_contact_test
