// Tests of fem/linear/solver_choice.hpp: why a linear solver is used or not,
// without a block.

#include "fem/linear/solver_choice.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::solver_choice_test {

/// A multigrid solver from 100 unknowns.
SolverNeeds needs_of(bool fits_mesh, bool fits_moduli) {
  return {.kind = LinearSolver::multigrid,
          .fewest_unknowns = 100,
          .fits_mesh = [fits_mesh] { return fits_mesh; },
          .fits_moduli = [fits_moduli] { return fits_moduli; }};
}

TEST(SolverChoice, NamesTheFirstReasonAgainstASolver) {
  const auto automatic = LinearSolver::automatic;

  EXPECT_EQ(choice_of(needs_of(true, true), LinearSolver::direct, 100),
            Choice::other_requested);
  EXPECT_EQ(choice_of(needs_of(true, true), automatic, 99),
            Choice::small_block);
  EXPECT_EQ(choice_of(needs_of(false, false), automatic, 100),
            Choice::unsuitable_mesh);
  EXPECT_EQ(choice_of(needs_of(true, false), automatic, 100),
            Choice::nearly_incompressible);
  EXPECT_EQ(choice_of(needs_of(true, true), automatic, 100), Choice::preferred);
}

TEST(SolverChoice, ARequestedSolverServesSmallBlocksOfItsMeshes) {
  const auto requested = LinearSolver::multigrid;
  SolverNeeds needs = needs_of(true, false);

  EXPECT_EQ(choice_of(needs_of(true, true), requested, 1), Choice::requested);
  EXPECT_EQ(choice_of(needs_of(false, true), requested, 1),
            Choice::unsuitable_mesh);
  EXPECT_EQ(choice_of(needs, requested, 1), Choice::nearly_incompressible);
  needs.ignores_moduli_if_requested = true;
  EXPECT_EQ(choice_of(needs, requested, 1), Choice::requested);
}

TEST(SolverChoice, LooksAtTheBlockOnlyIfTheSolverMayBeUsed) {
  SolverNeeds needs = needs_of(true, true);
  needs.fits_mesh = [] {
    ADD_FAILURE() << "expensive";
    return true;
  };

  EXPECT_FALSE(is_used(choice_of(needs, LinearSolver::fourier, 1000)));
  EXPECT_FALSE(is_used(choice_of(needs, LinearSolver::automatic, 99)));
}

} // namespace asperity::fem::solver_choice_test
