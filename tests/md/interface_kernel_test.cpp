// Tests of md/interface/interface_kernel.hpp and md/interface/substrate.hpp.
#include "md/interface/interface_kernel.hpp"
#include "md/interface/substrate.hpp"
#include "tests/md/small_interface.hpp"
#include "tests/narrower_vectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::md::interface_kernel_test {

/// Windows at random points and heights, a third of them beyond the reach or
/// hardly within it.
std::vector<Window> some_windows(const Substrate& substrate) {
  const std::vector<double> places =
      problems::random_numbers(300, 0.0, 16.0, 4);
  std::vector<Window> windows;
  std::size_t empty = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    const double z = i % 3 == 0 ? 2.9 + 0.04 * places[3 * i + 2]
                                : 1.0 + 0.1 * places[3 * i + 2];
    windows.push_back(substrate.window({places[3 * i], places[3 * i + 1]}, z));
    empty += windows.back().tiles.empty() ? 1 : 0;
  }
  EXPECT_GT(empty, 5U);
  EXPECT_LT(empty, 30U);
  return windows;
}

// Every processor gives the same bits, also where atoms without tiles and with
// few stand between the others, at the beginning and at the end. (A processor
// without AVX2 has one width only, and then this verifies nothing.)
TEST(SumWindows, GivesTheSameBitsForEveryWidth) {
  const problems::InterfaceProblem problem(10, 16, 0.0, 1);
  for (const double attraction : {0.0, 0.7}) {
    const Interaction law = problems::paper_atoms(attraction);
    const Substrate substrate(problem.substrate, problem.heights, law.cutoff,
                              law.distance);
    const std::vector<Window> windows = some_windows(substrate);

    std::vector<AtomForce> forces(windows.size());
    std::vector<SymmetricBlock> blocks(windows.size());
    const auto compute = [&] {
      sum_second_derivatives(reduced(law), windows, substrate.spacing(),
                             blocks);
      return sum_windows(reduced(law), windows, substrate.spacing(), forces);
    };
    const double energy = compute();
    const std::vector<AtomForce> expected = forces;
    const std::vector<SymmetricBlock> expected_blocks = blocks;
    EXPECT_NE(energy, 0.0);

    tests::on_narrower_vectors([&] {
      EXPECT_EQ(compute(), energy);
      for (std::size_t i = 0; i < windows.size(); ++i) {
        EXPECT_EQ(forces[i].x, expected[i].x);
        EXPECT_EQ(forces[i].y, expected[i].y);
        EXPECT_EQ(forces[i].z, expected[i].z);
        EXPECT_EQ(blocks[i].xz, expected_blocks[i].xz);
        EXPECT_EQ(blocks[i].zz, expected_blocks[i].zz);
      }
    });
  }
}

// The loop works on the tiles of the following atoms while it completes one:
// the force on an atom is the same, to the last bit, if the others are not
// there, and so is the curvature.
TEST(SumWindows, DoesNotMixAtoms) {
  const problems::InterfaceProblem problem(10, 16, 0.0, 1);
  const Interaction law = problems::paper_atoms(0.7);
  const Substrate substrate(problem.substrate, problem.heights, law.cutoff,
                            law.distance);
  const std::vector<Window> windows = some_windows(substrate);
  std::vector<AtomForce> forces(windows.size());
  std::vector<SymmetricBlock> blocks(windows.size());

  const double energy =
      sum_windows(reduced(law), windows, substrate.spacing(), forces);
  sum_second_derivatives(reduced(law), windows, substrate.spacing(), blocks);

  double sum = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    AtomForce force;
    SymmetricBlock block;
    const double alone = sum_windows(reduced(law), std::span(&windows[i], 1),
                                     substrate.spacing(), std::span(&force, 1));
    sum_second_derivatives(reduced(law), std::span(&windows[i], 1),
                           substrate.spacing(), std::span(&block, 1));
    sum += alone;
    size += std::abs(alone);
    EXPECT_EQ(force.x, forces[i].x) << i;
    EXPECT_EQ(force.y, forces[i].y) << i;
    EXPECT_EQ(force.z, forces[i].z) << i;
    EXPECT_EQ(block.zz, blocks[i].zz) << i;
    EXPECT_EQ(block.xy, blocks[i].xy) << i;
    EXPECT_TRUE(force.z == 0.0 || !windows[i].tiles.empty()) << i;
  }
  // 8 lanes of some 300 sums each: rounding
  EXPECT_NEAR(energy, sum, 1e-13 * size);
}

TEST(SumWindows, AreZeroWithoutTiles) {
  const ReducedLaw law = reduced(problems::paper_atoms());
  const std::vector<Window> windows(3);
  std::vector<AtomForce> forces(3, {1.0, 1.0, 1.0});
  std::vector<SymmetricBlock> blocks(3, {.xx = 1.0, .zz = 1.0});

  EXPECT_EQ(sum_windows(law, windows, 0.5, forces), 0.0);
  sum_second_derivatives(law, windows, 0.5, blocks);

  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(forces[i].x, 0.0);
    EXPECT_EQ(forces[i].z, 0.0);
    EXPECT_EQ(blocks[i].xx, 0.0);
    EXPECT_EQ(blocks[i].zz, 0.0);
  }
}

// An atom that is higher than the cut-off above everything within its range
// costs nothing, one at d_c hardly more than its circle: a quarter of a cell
// beyond it, an overhang of two per row for tiles of four columns, and the
// difference of the chords of the two rows of a tile, half of 4 r in all.
TEST(Substrate, ListsLittleBeyondTheReach) {
  const problems::InterfaceProblem problem(10, 16, 0.0, 1);
  const double spacing = problem.substrate.spacing_x();
  const Substrate substrate(problem.substrate, std::vector<double>(256),
                            10.0 * problems::angstrom, spacing);
  const double reach = 10.0 * problems::angstrom / spacing;
  const double height = problems::contact_distance / spacing;
  const double radius = std::sqrt(reach * reach - height * height);

  const std::size_t listed = substrate.window({3.3, 15.9}, height).tiles.size();

  EXPECT_TRUE(substrate.window({3.3, 15.9}, reach).tiles.empty());
  EXPECT_GE(8.0 * static_cast<double>(listed),
            std::numbers::pi * radius * radius);
  EXPECT_LE(8.0 * static_cast<double>(listed),
            std::numbers::pi * std::pow(radius + 0.25, 2) +
                2.0 * (2.0 * radius + 1.0) + 2.0 * radius);
}

} // namespace asperity::md::interface_kernel_test
