// Random full blocks that were once left without an answer: light loads on
// heterogeneous blocks, mean gaps without contact, and flat cells beside large
// contrasts of the moduli.
#include "robustness/run_instance.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace asperity::robustness::difficult_block_test {

/// Returns the Newton steps of all loads.
int expect_verified(std::uint64_t seed, int index) {
  const InstanceReport report = run_instance(draw_instance(seed, index));

  EXPECT_EQ(report.outcome, Outcome::verified)
      << index << ", " << report.check << ": " << report.reason;
  EXPECT_TRUE(report.has_pair) << index;
  return report.iterations;
}

// Under loads of 1e-6 E* h' the displacement of the softest cells is long for
// the pressure, so that its roundoff times the working penalty left up to
// 3.8e-8 of the largest force unbalanced. Second order on a lattice and in
// gmsh cells, first order in gmsh cells, by moduli that differ by up to 93^2.
TEST(DifficultBlock, UnderALightLoadIsSolvedByASofterWorkingPenalty) {
  expect_verified(12001, 16676);
  expect_verified(14001, 51164);
  expect_verified(14001, 93681);
}

// Mean gaps larger than that at which the highest point touches, which these
// blocks also have under a load: the smallest load, without contact, is taken.
TEST(DifficultBlock, AtAMeanGapWithoutContactIsLeftUndeformed) {
  expect_verified(14001, 25367);
  expect_verified(14001, 78601);
}

// A prescribed `multigrid` that needs 1000 to 1100 iterations for a solution,
// so that the direct solver goes on.
TEST(DifficultBlock, OfFlatCellsIsSolvedByTheDirectSolver) {
  expect_verified(14001, 37188);
  expect_verified(14001, 75655);
  expect_verified(14001, 79162);
  expect_verified(15002, 899384);
}

// A block under stiff springs on a cylinder of 0.03 times its modulus: with
// linear systems solved to 1e-3, the five loads took 129 steps in all.
TEST(DifficultBlock, OnASoftCylinderTakesFewStepsByAccurateSystems) {
  EXPECT_LT(expect_verified(14001, 41476), 80);
}

// Full contact of a plate of 25 layers of nodes: with each force balanced to
// 1e-8 of the largest, those of a column added up to a gap off by 2.2 times the
// tolerance.
TEST(DifficultBlock, OfManyLayersBalancesTheForcesOfAColumn) {
  expect_verified(3535, 4356);
}

} // namespace asperity::robustness::difficult_block_test
