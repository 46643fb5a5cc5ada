// Tests of md/contact/green_system.hpp: forces are minus the gradient of the
// energy under every load, and what the load prescribes stays unchanged.
#include "base/field_sums.hpp"
#include "md/contact/green_system.hpp"
#include "tests/md/small_interface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace asperity::md::green_system_test {

using mechanics::AtomModes;

constexpr double spacing = 2.6e-10;
constexpr int points = 12;
constexpr Grid layer{points, points, points* spacing, points* spacing};
constexpr Grid substrate{20, 20, points* spacing, points* spacing};
constexpr Interaction interaction{1.192e-20, 3.28e-10, 10e-10, 8e-10, 0.0};
constexpr double height = 4e-10;

GreenSystem system_of(AtomModes modes, const Load& load) {
  std::vector<double> heights(substrate.size());
  for (int iy = 0; iy < 20; ++iy)
    for (int ix = 0; ix < 20; ++ix)
      heights[substrate.index(ix, iy)] =
          0.5e-10 * std::cos(0.1 * std::numbers::pi * (ix + 2 * iy));
  GreenSystem system(SurfaceStiffness({mechanics::AtomLattice::isotropic,
                                       spacing, 77.2e9, 0.42},
                                      layer, points, modes),
                     Interface(interaction, layer, substrate, heights));
  system.set_load(load);
  return system;
}

struct GreenProblem {
  AtomModes modes;
  Load load;
};

class EveryProblem : public ::testing::TestWithParam<GreenProblem> {
protected:
  EveryProblem()
      : system(system_of(GetParam().modes, GetParam().load)),
        state(system.undeformed(height)),
        forces(system.size()) {
    state = problems::disturbed(std::move(state), 3e-11, 1);
    if (GetParam().modes == AtomModes::normal)
      std::fill_n(state.begin(), 2 * layer.size(), 0.0);
  }

  /// Removes from a displacement what the load prescribes.
  std::vector<double> allowed(std::vector<double> displacement) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::span plane =
          std::span(displacement).subspan(axis * layer.size(), layer.size());
      const double shift =
          axis < 2 || GetParam().load.kind == Load::Kind::height ? mean(plane)
                                                                 : 0.0;
      for (double& value : plane)
        value = axis < 2 && GetParam().modes == AtomModes::normal
                    ? 0.0
                    : value - shift;
    }
    return displacement;
  }

  GreenSystem system;
  std::vector<double> state;
  std::vector<double> forces;
};

// The decrease of the energy along an allowed displacement is the work of the
// forces. Central difference over 2e-14 m: (2e-14 / r_0)^2 and the roundoff
// 1e-15 of the energy over its relative change of 1e-8 leave 1e-6.
TEST_P(EveryProblem, ForcesAreMinusTheGradient) {
  const double length = 1e-14;
  const std::vector<double> along =
      allowed(problems::random_numbers(state.size(), -1.0, 1.0, 2));
  std::vector<double> unused(forces.size());
  std::vector<double> ahead = state;
  std::vector<double> behind = state;
  for (std::size_t i = 0; i < state.size(); ++i) {
    ahead[i] += length * along[i];
    behind[i] -= length * along[i];
  }

  system.energy_and_forces(state, forces);
  const double fall = system.energy_and_forces(behind, unused).energy -
                      system.energy_and_forces(ahead, unused).energy;

  EXPECT_NEAR(0.5 * fall / length / dot(forces, along), 1.0, 1e-6);
}

TEST_P(EveryProblem, PrescribedComponentsHaveNoForce) {
  system.energy_and_forces(state, forces);

  const std::vector<double> expected = allowed(forces);
  for (std::size_t i = 0; i < forces.size(); ++i)
    EXPECT_NEAR(forces[i], expected[i], 1e-22); // roundoff of 1e-9 N
}

// P is symmetric and positive definite, and its results are allowed
// displacements.
TEST_P(EveryProblem, PreconditionerIsSymmetricAndPositive) {
  system.energy_and_forces(state, forces);
  const std::vector<double> first =
      allowed(problems::random_numbers(state.size(), -1e-10, 1e-10, 3));
  const std::vector<double> second =
      allowed(problems::random_numbers(state.size(), -1e-10, 1e-10, 4));
  std::vector<double> from_first(state.size());
  std::vector<double> from_second(state.size());

  system.precondition(first, 2.0, from_first);
  system.precondition(second, 2.0, from_second);

  const double size =
      std::sqrt(dot(first, from_first) * dot(second, from_second));
  EXPECT_NEAR(dot(first, from_second) / size, dot(second, from_first) / size,
              1e-13);
  EXPECT_GT(dot(first, from_first), 0.0);
  const std::vector<double> expected = allowed(from_first);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(from_first[i], expected[i], 1e-23);
}

INSTANTIATE_TEST_SUITE_P(
    Problems, EveryProblem,
    ::testing::Values(
        GreenProblem{AtomModes::vector, {Load::Kind::nominal_pressure, 1e9}},
        GreenProblem{AtomModes::vector, {Load::Kind::height, height}},
        GreenProblem{AtomModes::normal, {Load::Kind::nominal_pressure, 1e9}},
        GreenProblem{AtomModes::normal, {Load::Kind::height, height}}));

// Far from the substrate P is the inverse of the second derivatives for waves:
// after one step along P forces no force remains but the pressure.
TEST(GreenSystem, PreconditionerInvertsTheFreeBlock) {
  GreenSystem system =
      system_of(AtomModes::vector, {Load::Kind::height, 100e-10});
  std::vector<double> state =
      problems::disturbed(system.undeformed(100e-10), 1e-11, 5);
  std::vector<double> forces(state.size());
  std::vector<double> step(state.size());
  std::vector<double> after(state.size());
  const double negligible = 1e-9; // against the bulk's stiffness of 10 N/m

  system.energy_and_forces(state, forces);
  system.precondition(forces, negligible, step);
  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] += step[i];
  system.energy_and_forces(state, after);

  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_NEAR(after[i], 0.0, 1e-7 * 1e-10);
}

// Under pressure alone the block moves down uniformly, by the force per atom
// over the stiffness that represents its contact, where S is a uniform factor.
TEST(GreenSystem, PreconditionerLowersTheBlockUniformly) {
  const double stiffness = 2.0;
  GreenSystem system =
      system_of(AtomModes::vector, {Load::Kind::nominal_pressure, 1e9});
  std::vector<double> state = system.undeformed(100e-10);
  std::vector<double> forces(state.size());
  std::vector<double> step(state.size());

  system.energy_and_forces(state, forces);
  system.precondition(forces, stiffness, step);

  const double plain = -1e9 * spacing * spacing / stiffness;
  const double factor = step.back() / plain;
  EXPECT_GT(factor, 1.0); // (k_loc + k_c) / k_loc
  EXPECT_LT(factor, 1.5);
  for (std::size_t i = 2 * layer.size(); i < step.size(); ++i)
    EXPECT_NEAR(step[i] / step.back(), 1.0, 1e-12);
}

// The energy is the sum of those of bulk, pairs and load, each computed
// separately.
TEST(GreenSystem, SumsItsEnergies) {
  const double pressure = 2e9;
  GreenSystem system =
      system_of(AtomModes::vector, {Load::Kind::nominal_pressure, pressure});
  std::vector<double> state =
      problems::disturbed(system.undeformed(height), 1e-11, 6);
  std::vector<double> forces(state.size());
  std::vector<double> pairs(state.size());
  const std::size_t n = layer.size();
  const std::span all(pairs);

  const Evaluation evaluation = system.energy_and_forces(state, forces);

  const LayerView atoms = layer_of(system, state);
  const double interface_energy = system.interface().energy_and_forces(
      atoms, {all.subspan(0, n), all.subspan(n, n), all.subspan(2 * n, n)});
  const double load = pressure * layer.area() * mean(atoms.z);
  EXPECT_NEAR(evaluation.energy /
                  (system.elastic_energy(state) + interface_energy + load),
              1.0, 1e-14);
  EXPECT_NEAR(evaluation.contact_force / mean(all.subspan(2 * n, n)), 1.0,
              1e-14);
  EXPECT_GT(system.elastic_energy(state), 0.0);
  EXPECT_NEAR(system.elastic_energy(system.undeformed(height)), 0.0, 1e-40);
}

TEST(GreenSystem, RefusesTwoLayers) {
  const Grid other{10, 10, layer.length_x, layer.length_y};
  const std::vector<double> heights(substrate.size(), 0.0);

  EXPECT_THROW(GreenSystem(SurfaceStiffness({mechanics::AtomLattice::isotropic,
                                             spacing, 77.2e9, 0.42},
                                            layer, points, AtomModes::vector),
                           Interface(interaction, other, substrate, heights)),
               std::domain_error);
}

} // namespace asperity::md::green_system_test
