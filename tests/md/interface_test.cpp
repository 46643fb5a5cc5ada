// Tests of md/interface/interface.hpp: energy and forces, compared with a loop
// over all pairs.
#include "base/maximum.hpp"
#include "md/interface/interface.hpp"
#include "tests/base/fields.hpp"
#include "tests/md/small_interface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::md::interface_test {

using problems::angstrom;
using problems::InterfaceProblem;
using problems::paper_atoms;
using problems::Planes;

struct Answer {
  double energy = 0.0;
  Planes forces;
};

Answer answer_of(const Interface& interface, const Planes& atoms) {
  Answer answer{0.0, Planes(atoms.x.size())};
  answer.energy =
      interface.energy_and_forces(atoms.view(), answer.forces.forces());
  return answer;
}

Answer plain_answer(const InterfaceProblem& problem,
                    const Interaction& interaction) {
  Answer answer{0.0, Planes(problem.layer.size())};
  for_all_pairs(problem, [&](std::size_t i, double dx, double dy, double dz) {
    const PairTerm term =
        pair_term(interaction, std::sqrt(dx * dx + dy * dy + dz * dz));
    answer.energy += term.energy;
    answer.forces.x[i] += term.force_over_distance * dx;
    answer.forces.y[i] += term.force_over_distance * dy;
    answer.forces.z[i] += term.force_over_distance * dz;
  });
  return answer;
}

/// The largest difference of any force, in units of the largest force.
double force_difference(const Planes& a, const Planes& b) {
  double largest = 0.0, scale = 0.0;
  for (const auto plane : {&Planes::x, &Planes::y, &Planes::z}) {
    largest = maximum(largest, tests::largest_difference(a.*plane, b.*plane));
    scale = maximum(scale, largest_magnitude(b.*plane));
  }
  return largest / scale;
}

struct Lattices {
  int layer = 0;
  int substrate = 0;
};

class InterfaceKernel : public ::testing::TestWithParam<Lattices> {};

// The kernel is the sum over all pairs, for small displacements and for some
// that exceed two periods. Tolerance: 12 eps L/r_0 for the position of an atom
// and some 200 pairs, 1e-13; 1e-12 leaves a margin.
TEST_P(InterfaceKernel, IsTheSumOverAllPairs) {
  const auto [layer, substrate] = GetParam();
  unsigned seed = 1;
  for (const double attraction : {0.0, 1.0, 0.3})
    for (const double displacement : {0.0, 1.5, 70.0}) {
      const InterfaceProblem problem(layer, substrate, displacement * angstrom,
                                     seed++);
      const Interaction law = paper_atoms(attraction);

      const Answer answer = answer_of(problem.interface(law), problem.atoms);

      const Answer plain = plain_answer(problem, law);
      EXPECT_NEAR(answer.energy / plain.energy, 1.0, 1e-12);
      EXPECT_LT(force_difference(answer.forces, plain.forces), 1e-12);
    }
}

// 8 atoms are 20.8 A: the window is nearly the entire cell.
INSTANTIATE_TEST_SUITE_P(Lattices, InterfaceKernel,
                         ::testing::Values(Lattices{8, 8}, Lattices{8, 12},
                                           Lattices{10, 16}, Lattices{9, 5},
                                           Lattices{12, 30}));

// The same where the cut-off just fits the period, and where it is so short
// that many atoms have no partner.
TEST(InterfaceKernel, IsTheSumOverAllPairsForAnyCutOff) {
  for (const double cutoff : {4.0, 5.5, 10.4}) {
    const InterfaceProblem problem(8, 14, 3.0 * angstrom, 17);
    Interaction law = paper_atoms(0.5);
    law.cutoff = cutoff * angstrom;
    law.taper_begin = 0.8 * law.cutoff;

    const Answer answer = answer_of(problem.interface(law), problem.atoms);

    const Answer plain = plain_answer(problem, law);
    EXPECT_NEAR(answer.energy / plain.energy, 1.0, 1e-12);
    EXPECT_LT(force_difference(answer.forces, plain.forces), 1e-12);
  }
}

// An atom at the largest position that a double can represent is at its
// remainder modulo the period, and one at an infinite position gives NaN.
TEST(InterfaceKernel, TakesAnyDisplacement) {
  const InterfaceProblem problem(10, 16, 0.0, 3);
  const Interface interface = problem.interface(paper_atoms());
  Planes atoms = problem.atoms;
  atoms.x[7] = 1e250;
  atoms.y[8] = -1e9 * problem.layer.length_y;
  EXPECT_TRUE(std::isfinite(answer_of(interface, atoms).energy));

  atoms.z[7] = std::numeric_limits<double>::quiet_NaN();
  const Answer answer = answer_of(interface, atoms);
  EXPECT_TRUE(std::isnan(answer.energy));
  EXPECT_TRUE(std::isnan(answer.forces.x[7]));
  EXPECT_TRUE(std::isfinite(answer.forces.x[8]));
}

TEST(InterfaceKernel, GivesTheSameBitsForAnyNumberOfThreads) {
  const InterfaceProblem problem(24, 38, angstrom, 11);
  const Answer one =
      answer_of(problem.interface(paper_atoms(), 1), problem.atoms);
  for (const int threads : {2, 3, 40}) {
    const Answer many =
        answer_of(problem.interface(paper_atoms(), threads), problem.atoms);

    EXPECT_EQ(many.energy, one.energy);
    EXPECT_EQ(many.forces.x, one.forces.x);
    EXPECT_EQ(many.forces.y, one.forces.y);
    EXPECT_EQ(many.forces.z, one.forces.z);
  }
}

// Atoms beyond the cut-off of all others have exactly zero force, and so has
// one for which only the window contains another atom.
TEST(InterfaceKernel, IsZeroBeyondTheCutOff) {
  InterfaceProblem problem(12, 20, 0.0, 13);
  std::fill(problem.heights.begin(), problem.heights.end(), 0.0);
  problem.heights[problem.substrate.index(10, 10)] = 4.0 * angstrom;
  std::fill(problem.atoms.z.begin(), problem.atoms.z.end(), 10.1 * angstrom);
  const Interaction law = paper_atoms(1.0);

  const Answer answer = answer_of(problem.interface(law), problem.atoms);

  const Answer plain = plain_answer(problem, law);
  int touched = 0;
  for (std::size_t i = 0; i < problem.layer.size(); ++i) {
    EXPECT_EQ(answer.forces.z[i] == 0.0, plain.forces.z[i] == 0.0);
    touched += answer.forces.z[i] != 0.0 ? 1 : 0;
  }
  EXPECT_GT(touched, 20);
  EXPECT_LT(touched, 100);
  std::fill(problem.atoms.z.begin(), problem.atoms.z.end(), 14.1 * angstrom);
  EXPECT_EQ(answer_of(problem.interface(law), problem.atoms).energy, 0.0);
}

} // namespace asperity::md::interface_test
