// Claims about md/interface/interface.hpp: energy and forces, against all pairs
// one by one.
#include "base/maximum.hpp"
#include "md/interface/interface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/base/fields.hpp"
#include "tests/md/small_interface.hpp"

namespace asperity::md {
namespace {

using scenes::angstrom;
using scenes::paper_atoms;
using scenes::Planes;
using scenes::Scene;

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

Answer plain_answer(const Scene& scene, const Interaction& interaction) {
  Answer answer{0.0, Planes(scene.layer.size())};
  for_all_pairs(scene, [&](std::size_t i, double dx, double dy, double dz) {
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

// Claim: the kernel is the sum over all pairs, for small displacements and for
// some that go twice through the period. Tolerance: 12 eps L/r_0 for the place
// of an atom and some 200 pairs, 1e-13; 1e-12 leaves room.
TEST_P(InterfaceKernel, IsTheSumOverAllPairs) {
  const auto [layer, substrate] = GetParam();
  unsigned seed = 1;
  for (const double attraction : {0.0, 1.0, 0.3})
    for (const double displacement : {0.0, 1.5, 70.0}) {
      const Scene scene(layer, substrate, displacement * angstrom, seed++);
      const Interaction law = paper_atoms(attraction);

      const Answer answer = answer_of(scene.interface(law), scene.atoms);

      const Answer plain = plain_answer(scene, law);
      EXPECT_NEAR(answer.energy / plain.energy, 1.0, 1e-12);
      EXPECT_LT(force_difference(answer.forces, plain.forces), 1e-12);
    }
}

// 8 atoms are 20.8 A: the window is nearly the whole cell.
INSTANTIATE_TEST_SUITE_P(Lattices, InterfaceKernel,
                         ::testing::Values(Lattices{8, 8}, Lattices{8, 12},
                                           Lattices{10, 16}, Lattices{9, 5},
                                           Lattices{12, 30}));

// Claim: the same where the cut-off just fits the period, and where it is
// so short that many atoms have no partner.
TEST(InterfaceKernel, IsTheSumOverAllPairsForAnyCutOff) {
  for (const double cutoff : {4.0, 5.5, 10.4}) {
    const Scene scene(8, 14, 3.0 * angstrom, 17);
    Interaction law = paper_atoms(0.5);
    law.cutoff = cutoff * angstrom;
    law.taper_begin = 0.8 * law.cutoff;

    const Answer answer = answer_of(scene.interface(law), scene.atoms);

    const Answer plain = plain_answer(scene, law);
    EXPECT_NEAR(answer.energy / plain.energy, 1.0, 1e-12);
    EXPECT_LT(force_difference(answer.forces, plain.forces), 1e-12);
  }
}

// Claim: one atom as far out as a double can hold it is where its remainder is,
// and one that is nowhere makes no number.
TEST(InterfaceKernel, TakesAnyDisplacement) {
  const Scene scene(10, 16, 0.0, 3);
  const Interface interface = scene.interface(paper_atoms());
  Planes atoms = scene.atoms;
  atoms.x[7] = 1e250;
  atoms.y[8] = -1e9 * scene.layer.length_y;
  EXPECT_TRUE(std::isfinite(answer_of(interface, atoms).energy));

  atoms.z[7] = std::numeric_limits<double>::quiet_NaN();
  const Answer answer = answer_of(interface, atoms);
  EXPECT_TRUE(std::isnan(answer.energy));
  EXPECT_TRUE(std::isnan(answer.forces.x[7]));
  EXPECT_TRUE(std::isfinite(answer.forces.x[8]));
}

// Claim: force = -grad U. Tolerance: steps of 1e-4 A are right to 13 14/6
// (1e-4/2)^2 = 8e-8 of the steepest pair; rounding is eps U/step, 1e-10.
TEST(InterfaceKernel, ForceIsMinusTheGradient) {
  for (const double attraction : {0.0, 1.0}) {
    const Scene scene(10, 16, 2.0 * angstrom, 5);
    const Interface interface = scene.interface(paper_atoms(attraction));
    const Answer answer = answer_of(interface, scene.atoms);
    Planes slopes(scene.layer.size());
    const double step = 1e-4 * angstrom;

    for (const auto plane : {&Planes::x, &Planes::y, &Planes::z})
      for (std::size_t i = 0; i < scene.layer.size(); ++i) {
        Planes moved = scene.atoms;
        (moved.*plane)[i] += step;
        const double up = answer_of(interface, moved).energy;
        (moved.*plane)[i] -= 2.0 * step;
        const double down = answer_of(interface, moved).energy;
        (slopes.*plane)[i] = (down - up) / (2.0 * step);
      }

    EXPECT_LT(force_difference(answer.forces, slopes), 1e-6);
  }
}

// Claim: over a flat wall nothing changes when the layer moves by a period of
// the substrate. Tolerance: 12 eps L/r_0, as above.
TEST(InterfaceKernel, KnowsThePeriodOfAFlatWall) {
  Scene scene(10, 16, angstrom, 9);
  std::fill(scene.heights.begin(), scene.heights.end(), 0.0);
  const Interface interface = scene.interface(paper_atoms());
  const Answer before = answer_of(interface, scene.atoms);
  Planes moved = scene.atoms;
  for (std::size_t i = 0; i < scene.layer.size(); ++i) {
    moved.x[i] += 3.0 * scene.substrate.spacing_x();
    moved.y[i] -= scene.substrate.spacing_y();
  }

  const Answer after = answer_of(interface, moved);

  EXPECT_NEAR(after.energy / before.energy, 1.0, 1e-12);
  EXPECT_LT(force_difference(after.forces, before.forces), 1e-12);
}

TEST(InterfaceKernel, GivesTheSameBitsForAnyNumberOfThreads) {
  const Scene scene(24, 38, angstrom, 11);
  const Answer one = answer_of(scene.interface(paper_atoms(), 1), scene.atoms);
  for (const int threads : {2, 3, 40}) {
    const Answer many =
        answer_of(scene.interface(paper_atoms(), threads), scene.atoms);

    EXPECT_EQ(many.energy, one.energy);
    EXPECT_EQ(many.forces.x, one.forces.x);
    EXPECT_EQ(many.forces.y, one.forces.y);
    EXPECT_EQ(many.forces.z, one.forces.z);
  }
}

// Claim: what is beyond the cut-off of all feels exactly nothing, and so does
// an atom of which only the window holds something near.
TEST(InterfaceKernel, IsNothingBeyondTheCutOff) {
  Scene scene(12, 20, 0.0, 13);
  std::fill(scene.heights.begin(), scene.heights.end(), 0.0);
  scene.heights[scene.substrate.index(10, 10)] = 4.0 * angstrom;
  std::fill(scene.atoms.z.begin(), scene.atoms.z.end(), 10.1 * angstrom);
  const Interaction law = paper_atoms(1.0);

  const Answer answer = answer_of(scene.interface(law), scene.atoms);

  const Answer plain = plain_answer(scene, law);
  int touched = 0;
  for (std::size_t i = 0; i < scene.layer.size(); ++i) {
    EXPECT_EQ(answer.forces.z[i] == 0.0, plain.forces.z[i] == 0.0);
    touched += answer.forces.z[i] != 0.0 ? 1 : 0;
  }
  EXPECT_GT(touched, 20);
  EXPECT_LT(touched, 100);
  std::fill(scene.atoms.z.begin(), scene.atoms.z.end(), 14.1 * angstrom);
  EXPECT_EQ(answer_of(scene.interface(law), scene.atoms).energy, 0.0);
}

/// Share of the smeared wall's pressure that the sum over pairs shows at a
/// height, on 34 over 55 atoms: neighbours of Fibonacci, so that every atom
/// finds itself over another place of the substrate's cell.
double shown_pressure(const Interaction& law, double height) {
  Scene scene(34, 55, 0.0, 1);
  std::fill(scene.heights.begin(), scene.heights.end(), 0.0);
  std::fill(scene.atoms.z.begin(), scene.atoms.z.end(), height);
  const Answer answer = answer_of(scene.interface(law), scene.atoms);
  double force = 0.0;
  for (const double each : answer.forces.z)
    force += each;
  return force / scene.layer.area() /
         plane_repulsion_pressure(law, scene.layer.cell_area(),
                                  scene.substrate.cell_area(), height);
}

// Claim: the mean pressure on a flat incommensurate wall is the smeared one at
// d_c. Tolerance: what a sharp cut at the begin of the taper would take.
TEST(InterfaceKernel, PressesAsASmearedWall) {
  for (const double cutoff : {8.0, 10.0}) {
    Interaction law = paper_atoms();
    law.cutoff = cutoff * angstrom;
    law.taper_begin = 0.9 * law.cutoff;

    const double lost = 1.0 - shown_pressure(law, scenes::contact_distance);

    EXPECT_GT(lost, std::pow(scenes::contact_distance / law.cutoff, 12));
    EXPECT_LT(lost, std::pow(scenes::contact_distance / law.taper_begin, 12));
  }
  EXPECT_NEAR(shown_pressure(paper_atoms(), scenes::contact_distance), 1.0,
              1e-3);
}

} // namespace
} // namespace asperity::md
