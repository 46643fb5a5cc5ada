// Tests of fem/linear/solver_choice.hpp, the rules of
// docs/numerics/full-block.md: which linear solver is used, without a block.
#include "fem/linear/solver_choice.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::solver_choice_test {

using enum BlockSolverKind;

BlockTraits block(MeshStructure structure, double unknowns, int ranks = 1) {
  return {.unknowns = unknowns, .ranks = ranks, .structure = structure};
}

BlockTraits stiff(BlockTraits of) {
  of.is_compressible = false;
  return of;
}

BlockTraits requested(LinearSolver solver, BlockTraits of) {
  of.requested = solver;
  return of;
}

constexpr double small = most_direct_unknowns;
constexpr double least = small + 1.0;

TEST(SolverChoice, TakesMultigridWithoutAMatrixWhereItIsAvailable) {
  EXPECT_EQ(solver_of(block(MeshStructure::box_grid, least)), box_grid);
  EXPECT_EQ(solver_of(block(MeshStructure::halved, least)), halved);
  EXPECT_EQ(solver_of(block(MeshStructure::hexahedra, least, 2)), hexahedra);
  EXPECT_EQ(solver_of(block(MeshStructure::other, least)), algebraic);
}

TEST(SolverChoice, IsDirectForSmallBlocksButNotForABoxGridOnRanks) {
  EXPECT_EQ(solver_of(block(MeshStructure::box_grid, small)), direct);
  EXPECT_EQ(solver_of(block(MeshStructure::other, small, 2)), direct);
  EXPECT_EQ(solver_of(block(MeshStructure::box_grid, small, 2)), box_grid);
  EXPECT_EQ(solver_of(stiff(block(MeshStructure::box_grid, small, 2))), direct);
}

TEST(SolverChoice, AvoidsMultigridOfNearlyIncompressibleBlocks) {
  const double most = most_direct_stiff_unknowns;
  const double most_on_ranks = most_direct_stiff_unknowns_on_ranks;
  const auto refusal = [](const BlockTraits& of) {
    return tests::message_of<std::domain_error>([&] { solver_of(stiff(of)); });
  };

  EXPECT_EQ(solver_of(stiff(block(MeshStructure::box_grid, most))), direct);
  EXPECT_EQ(solver_of(stiff(block(MeshStructure::halved, most_on_ranks, 2))),
            direct);
  const std::string words = refusal(block(MeshStructure::box_grid, most + 1.0));
  EXPECT_NE(words.find("at most 12000"), std::string::npos) << words;
  EXPECT_NE(words.find("\"condensed\""), std::string::npos) << words;
  EXPECT_NE(words.find("poisson_ratio = 0.49"), std::string::npos) << words;
  EXPECT_NE(refusal(block(MeshStructure::halved, most_on_ranks + 1.0, 2))
                .find("at most 2000"),
            std::string::npos);
}

TEST(SolverChoice, ARequestedSolverServesBlocksOfAnySize) {
  const auto multigrid = LinearSolver::multigrid;
  const BlockTraits tiny = block(MeshStructure::halved, 1.0);
  const BlockTraits of_boxes = block(MeshStructure::box_grid, 1.0);

  EXPECT_EQ(solver_of(requested(LinearSolver::direct,
                                block(MeshStructure::box_grid, 1e6, 2))),
            direct);
  EXPECT_EQ(solver_of(requested(multigrid, tiny)), halved);
  EXPECT_EQ(solver_of(requested(multigrid, stiff(tiny))), algebraic);
  EXPECT_EQ(solver_of(requested(multigrid, stiff(of_boxes))), box_grid);
}

// The border is Poisson's ratio 0.49, where lambda = 49 mu.
TEST(SolverChoice, CallsAMaterialCompressibleUpToItsPoissonRatio) {
  EXPECT_TRUE(is_compressible({49.0, 1.0}));
  EXPECT_FALSE(is_compressible({49.1, 1.0}));
}

} // namespace asperity::fem::solver_choice_test
