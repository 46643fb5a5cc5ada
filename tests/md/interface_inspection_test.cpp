// Tests of the inspection by md/interface/interface.hpp, and of refused
// arguments.
#include "base/special_numbers.hpp"
#include "md/interface/interface.hpp"
#include "tests/md/small_interface.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::md::interface_inspection_test {

using problems::angstrom;
using problems::InterfaceProblem;
using problems::lattice;
using problems::paper_atoms;
using problems::Planes;

constexpr double close = 2.2 * angstrom;

/// A commensurate flat surface with every atom over one of the substrate's, out
/// of range at 20 A: 3.9 A from column to column.
struct FlatSurface {
  Grid grid = lattice(8, 31.2 * angstrom);
  std::vector<double> heights = std::vector<double>(64);
  Planes atoms = Planes(64);

  FlatSurface() { std::fill(atoms.z.begin(), atoms.z.end(), 20.0 * angstrom); }

  Inspection inspect() const {
    return Interface(paper_atoms(), grid, grid, heights)
        .inspect(atoms.view(), close, problems::contact_distance);
  }
};

TEST(Inspection, FindsNothingOutOfReach) {
  const Inspection found = FlatSurface().inspect();

  EXPECT_EQ(found.below_substrate, 0);
  EXPECT_EQ(found.close_pairs, 0);
  EXPECT_EQ(found.in_contact, 0);
  EXPECT_EQ(found.shortest_distance, infinity);
}

// Each of four atoms is counted in its category; the height of an atom over its
// partner is the shortest distance. Tolerance: eps of it, times 4.
TEST(Inspection, CountsAnArtificialState) {
  FlatSurface flat;
  flat.atoms.z[3] = 4.3 * angstrom;   // in contact
  flat.atoms.z[20] = 4.4 * angstrom;  // not in contact
  flat.atoms.z[21] = -1.5 * angstrom; // through the substrate: near one atom
  flat.atoms.x[40] = 1.95 * angstrom; // halfway between two, near both
  flat.atoms.z[40] = 0.9 * angstrom;

  const Inspection found = flat.inspect();

  EXPECT_EQ(found.below_substrate, 1);
  EXPECT_EQ(found.close_pairs, 3);
  EXPECT_EQ(found.in_contact, 3);
  EXPECT_NEAR(found.shortest_distance / angstrom, 1.5, 1e-14);
}

TEST(Inspection, CountsAnAtomAtAnInfinitePositionAsThrough) {
  FlatSurface flat;
  flat.atoms.y[5] = std::numeric_limits<double>::quiet_NaN();

  EXPECT_EQ(flat.inspect().below_substrate, 1);
}

// The counts are those of a loop over all pairs; the number of threads changes
// nothing.
TEST(Inspection, CountsAsAllPairsOneByOne) {
  const InterfaceProblem problem(10, 16, 40.0 * angstrom, 21, 2.0 * angstrom);
  std::vector<double> shortest(problem.layer.size(), infinity);
  int close_pairs = 0;
  for_all_pairs(problem, [&](std::size_t i, double dx, double dy, double dz) {
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    shortest[i] = std::min(shortest[i], distance);
    close_pairs += distance < close ? 1 : 0;
  });
  const auto in_contact =
      std::count_if(shortest.begin(), shortest.end(), [](double distance) {
        return distance < problems::contact_distance;
      });

  for (const int threads : {1, 3}) {
    const Inspection found =
        problem.interface(paper_atoms(), threads)
            .inspect(problem.atoms.view(), close, problems::contact_distance);

    EXPECT_GT(close_pairs, 0);
    EXPECT_EQ(found.close_pairs, close_pairs);
    EXPECT_EQ(found.in_contact, in_contact);
    EXPECT_NEAR(found.shortest_distance /
                    *std::min_element(shortest.begin(), shortest.end()),
                1.0, 1e-12);
  }
}

// The height below is that of the node at a node and bilinear between nodes,
// also across the periodic boundary. Tolerance: eps of the heights, times 10.
TEST(HeightsBelow, AreBilinear) {
  const InterfaceProblem problem(10, 10, 0.0, 2);
  const Interface interface = problem.interface(paper_atoms());
  const auto height = [&](int ix, int iy) {
    return problem.heights[problem.substrate.index(ix % 10, iy % 10)];
  };
  Planes atoms(100);
  const std::vector<double> at_nodes = interface.heights_below(atoms.view());
  const double spacing = problem.substrate.spacing_x();
  for (std::size_t i = 0; i < 100; ++i) {
    atoms.x[i] = 0.25 * spacing;
    atoms.y[i] = 0.5 * spacing - 2.0 * problem.layer.length_y;
  }

  const std::vector<double> between = interface.heights_below(atoms.view());

  for (int iy = 0; iy < 10; ++iy)
    for (int ix = 0; ix < 10; ++ix) {
      const std::size_t i = problem.layer.index(ix, iy);
      EXPECT_NEAR(at_nodes[i], height(ix, iy), 1e-25);
      EXPECT_NEAR(between[i],
                  0.375 * (height(ix, iy) + height(ix, iy + 1)) +
                      0.125 * (height(ix + 1, iy) + height(ix + 1, iy + 1)),
                  1e-24);
    }
}

TEST(InterfaceRefusal, NamesTheArgument) {
  const Grid layer = lattice(10, 26.0 * angstrom);
  const Grid substrate = lattice(16, 26.0 * angstrom);
  const std::vector<double> heights(substrate.size());
  const auto build = [&](const Interaction& law, const Grid& upper,
                         const Grid& lower, std::span<const double> given,
                         int threads) {
    return tests::message_of<std::domain_error>(
        [&] { Interface(law, upper, lower, given, threads); });
  };
  const Interaction law = paper_atoms();

  EXPECT_EQ(build(law, layer, lattice(16, 26.1 * angstrom), heights, 1),
            "length of the substrate = 2.6100000000000003e-09, but must be "
            "2.6e-09 m, the "
            "length of the layer");
  Interaction far = law;
  far.cutoff = 13.1 * angstrom;
  EXPECT_EQ(build(far, layer, substrate, heights, 1),
            "cutoff = 1.31e-09, but must be at most half of the period "
            "2.6e-09 m");
  far.energy = -1.0;
  EXPECT_EQ(build(far, layer, substrate, heights, 1),
            "energy = -1, but must be finite and > 0 [J]");
  EXPECT_EQ(build(law, layer, substrate, std::vector<double>(5), 1),
            "size of heights = 5, but must be 256, one value per site");
  EXPECT_EQ(build(law, layer, substrate, heights, 0),
            "threads = 0, but must be finite and > 0 [1]");
  EXPECT_NE(build(law, {10, 8, 2.6e-9, 2.6e-9}, substrate, heights, 1),
            "accepted");
  EXPECT_NE(build(law, layer, {16, 16, 2.6e-9, 2e-9}, heights, 1), "accepted");
  std::vector<double> bad = heights;
  bad[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(build(law, layer, substrate, bad, 1), "accepted");

  const Interface good(law, layer, substrate, heights);
  Planes few(99);
  Planes forces(100);
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [&] { good.energy_and_forces(few.view(), forces.forces()); }),
            "size of atoms = 99, but must be 100, one value per site");
  EXPECT_THROW(good.energy_and_forces(forces.view(), few.forces()),
               std::domain_error);
  EXPECT_THROW(good.heights_below(few.view()), std::domain_error);
  EXPECT_THROW(good.inspect(forces.view(), close, 11.0 * angstrom),
               std::domain_error);
}

} // namespace asperity::md::interface_inspection_test
