// Tests of mechanics/md_settings.hpp.
#include "mechanics/md_settings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::mechanics {
namespace {

// The number is the paper's 648 for 400, and follows the golden ratio for other
// lattices.
TEST(IncommensurateAtoms, AreTheNearestEvenNumber) {
  EXPECT_EQ(incommensurate_atoms(400), 648);
  EXPECT_EQ(incommensurate_atoms(100), 162);
  EXPECT_EQ(incommensurate_atoms(1), 2);
  EXPECT_THROW(incommensurate_atoms(0), std::domain_error);
}

// W = pi n_1 n_2 eps r_0^2 [(r_0/d)^10/5 - (r_0/d)^4] of two layers with 100
// and 162 atoms per side. Tolerance: rounding of powers.
TEST(FlatLaw, IsTheSumOverTwoLayers) {
  MdSettings md;
  md.atoms = 100;
  md.interaction_energy = 3e-21;
  md.interaction_distance = 3.28e-10;
  EXPECT_FALSE(md.flat_law(26e-9, 162));
  md.potential = AtomPotential::lennard_jones;

  const ContactInterface law = md.flat_law(26e-9, 162).value();

  const double atoms = 100.0 * 100.0 * 162.0 * 162.0 / std::pow(26e-9, 4);
  for (const double distance : {2.7e-10, 3.28e-10, 5e-10}) {
    const double ratio = md.interaction_distance / distance;
    EXPECT_NEAR(law.energy(distance - law.adhesion_range) /
                    (std::numbers::pi * atoms * md.interaction_energy *
                     std::pow(md.interaction_distance, 2) *
                     (std::pow(ratio, 10) / 5.0 - std::pow(ratio, 4))),
                1.0, 1e-13);
  }
}

} // namespace
} // namespace asperity::mechanics
