// Tests of md/interface/interaction.hpp.
#include "md/interface/interaction.hpp"
#include "tests/md/small_interface.hpp"
#include "tests/message_of.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::md::interaction_test {

using problems::angstrom;
using problems::paper_atoms;
using problems::plane_repulsion_pressure;
using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;

class PairLaw : public ::testing::TestWithParam<double> {};

// Force = -dU/dr, in the power law, at both ends of the taper and within it.
// Tolerance: the difference over h = 1e-5 r has the relative error h^2 U'''/6
// U' = 13 14/6 1e-10 for the repulsion, 3e-9; where the taper ends it is h^2/3
// in a force that decreases as (the rest of the taper, 1 A)^2, 3e-9 of that at
// its start.
TEST_P(PairLaw, ForceIsMinusTheDerivativeOfTheEnergy) {
  const Interaction law = paper_atoms(GetParam());
  const auto force = [](const Interaction& any, double distance) {
    return pair_term(any, distance).force_over_distance * distance;
  };
  for (const double r : {2.2, 3.0, 3.28, 4.36, 6.0, 8.9, 8.9999, 9.0, 9.0001,
                         9.2, 9.5, 9.8, 9.99, 9.9999}) {
    const double distance = r * angstrom;
    const double step = 1e-5 * distance;

    const double slope = (pair_term(law, distance + step).energy -
                          pair_term(law, distance - step).energy) /
                         (2.0 * step);

    EXPECT_NEAR(force(law, distance), -slope,
                1e-6 * (force(paper_atoms(), distance) +
                        std::abs(force(law, law.taper_begin))))
        << "r = " << r << " A";
  }
}

// The energy is the integral of the force from the cut-off, by quadrature over
// the taper and over the rest. Tolerance: 100 eps of it.
TEST_P(PairLaw, EnergyIsTheIntegralOfTheForce) {
  const Interaction law = paper_atoms(GetParam());
  const auto force = [&](double r) {
    return pair_term(law, r).force_over_distance * r;
  };
  for (const double r : {2.5, 3.28, 4.3615, 7.0, 9.3}) {
    const double from = r * angstrom;
    const double middle = std::max(from, law.taper_begin);
    const double integral =
        Quadrature::integrate(force, middle, law.cutoff, 10, 1e-15) +
        (from < middle ? Quadrature::integrate(force, from, middle, 10, 1e-15)
                       : 0.0);

    EXPECT_NEAR(pair_term(law, from).energy / integral, 1.0, 1e-13);
  }
}

TEST_P(PairLaw, IsZeroFromTheCutOffOn) {
  const Interaction law = paper_atoms(GetParam());
  for (const double distance : {law.cutoff, 1.001 * law.cutoff, 1.0}) {
    EXPECT_EQ(pair_term(law, distance).energy, 0.0);
    EXPECT_EQ(pair_term(law, distance).force_over_distance, 0.0);
  }
  const double inside = law.cutoff * (1.0 - 1e-6);
  EXPECT_NE(pair_term(law, inside).force_over_distance, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Attraction, PairLaw, ::testing::Values(0.0, 0.4, 1.0));

// With a distant cut-off, (r_0/r)^12 - 2 (r_0/r)^6 has its minimum -1 at r_0.
// Tolerance: the cut-off at 100 r_0 removes 2e-12.
TEST(PairLaw, IsLennardJonesWithFullAttraction) {
  Interaction law = paper_atoms(1.0);
  law.cutoff = 100.0 * law.distance;
  law.taper_begin = 99.0 * law.distance;

  EXPECT_NEAR(pair_term(law, law.distance).energy / law.energy, -1.0, 3e-12);
  EXPECT_EQ(pair_term(law, law.distance).force_over_distance, 0.0);
  EXPECT_NEAR(pair_term(law, 0.5 * law.distance).energy / law.energy,
              4096.0 - 128.0, 1e-11);
}

// The pressure of the paper's continuous wall at d_c is 0.6139 GPa (DESIGN.md,
// 4 digits), a = 2.6 A, b = 104 nm/648. The closed form is the integral of the
// pair force over the plane, except for what a cut-off at r_c removes:
// (d/r_c)^12 where the cut is sharp, more where it is tapered. Tolerance:
// quadrature.
TEST(WallPressure, IsTheIntegralOverAPlane) {
  const double atom_area = std::pow(problems::layer_spacing, 2);
  const double substrate_area = std::pow(104e-9 / 648.0, 2);
  const double height = problems::contact_distance;
  Interaction law = paper_atoms();
  EXPECT_NEAR(plane_repulsion_pressure(law, atom_area, substrate_area, height),
              0.6139e9, 0.5e5);

  law.taper_begin = law.cutoff * (1.0 - 1e-9);
  const auto ring = [&](double distance) { // rho d rho = r dr
    return 2.0 * std::numbers::pi * distance * height *
           pair_term(law, distance).force_over_distance;
  };
  const double pressure =
      Quadrature::integrate(ring, height, law.taper_begin, 15, 1e-14) /
      (atom_area * substrate_area);

  const double lost =
      1.0 - pressure / plane_repulsion_pressure(law, atom_area, substrate_area,
                                                height);
  EXPECT_NEAR(lost / std::pow(height / law.cutoff, 12), 1.0, 1e-6);
}

std::string message_of(const Interaction& law, double distance = angstrom) {
  return tests::message_of<std::domain_error>(
      [&] { pair_term(law, distance); });
}

TEST(PairLaw, RefusesAnInvalidLaw) {
  Interaction law = paper_atoms();
  law.cutoff = law.taper_begin;
  EXPECT_EQ(message_of(law),
            "cutoff = 9e-10, but must be > taper_begin = 9e-10 m");
  law = paper_atoms(1.1);
  EXPECT_EQ(message_of(law),
            "attraction = 1.1, but must be between 0 and 1 [1]");
  law = paper_atoms();
  law.energy = 0.0;
  EXPECT_EQ(message_of(law), "energy = 0, but must be finite and > 0 [J]");
  EXPECT_EQ(message_of(paper_atoms(), 0.0),
            "distance = 0, but must be finite and > 0 [m]");
}

} // namespace asperity::md::interaction_test
