// Tests of md/interface/interface_kernel.hpp and md/interface/substrate.hpp.
#include "md/interface/interface_kernel.hpp"
#include "md/interface/substrate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/md/small_interface.hpp"

namespace asperity::md {
namespace {

// Every processor gives the same bits, for windows of an even and of an odd
// number of strips, also one that fills more than a bundle. (A processor
// without AVX2 has one width only, and then this verifies nothing.)
TEST(SumWindow, GivesTheSameBitsForEveryWidth) {
  const problems::InterfaceProblem problem(10, 16, 0.0, 1);
  int odd = 0;
  for (const double attraction : {0.0, 0.7}) {
    const Interaction law = problems::paper_atoms(attraction);
    const Substrate substrate(problem.substrate, problem.heights, law.cutoff,
                              law.distance);
    const std::vector<double> places =
        problems::random_numbers(300, 0.0, 16.0, 4);
    for (std::size_t i = 0; i < 100; ++i) {
      const double z = 1.0 + 0.1 * places[3 * i + 2];
      const Window window =
          substrate.window({places[3 * i], places[3 * i + 1]}, z);
      odd += window.strips.size() % 2 == 1 ? 1 : 0;

      const std::vector<AtomSum> sums =
          sums_of_all_widths(reduced(law), window, substrate.spacing(), z);

      const AtomSum any =
          sum_window(reduced(law), window, substrate.spacing(), z);
      EXPECT_NE(any.energy, 0.0);
      for (const AtomSum& sum : sums) {
        EXPECT_EQ(any.energy, sum.energy);
        EXPECT_EQ(any.x, sum.x);
        EXPECT_EQ(any.y, sum.y);
        EXPECT_EQ(any.z, sum.z);
      }
    }
  }
  EXPECT_GT(odd, 20);
  EXPECT_LT(odd, 180);
}

// An atom that is higher than the cut-off above everything within its range
// costs nothing, one at d_c hardly more than its circle: strips of four, an
// overhang of two per row and a quarter of a cell.
TEST(Substrate, ListsLittleBeyondTheReach) {
  const problems::InterfaceProblem problem(10, 16, 0.0, 1);
  const double spacing = problem.substrate.spacing_x();
  const Substrate substrate(problem.substrate, std::vector<double>(256),
                            10.0 * problems::angstrom, spacing);
  const double reach = 10.0 * problems::angstrom / spacing;
  const double height = problems::contact_distance / spacing;
  const double radius = std::sqrt(reach * reach - height * height);

  const std::size_t listed =
      substrate.window({3.3, 15.9}, height).strips.size();

  EXPECT_TRUE(substrate.window({3.3, 15.9}, reach).strips.empty());
  EXPECT_GE(4.0 * static_cast<double>(listed),
            std::numbers::pi * radius * radius);
  EXPECT_LE(4.0 * static_cast<double>(listed),
            std::numbers::pi * std::pow(radius + 0.25, 2) +
                2.0 * (2.0 * radius + 1.0));
}

} // namespace
} // namespace asperity::md
