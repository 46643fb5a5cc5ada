// Tests of md/contact/explicit_system.hpp: forces, loads, and the comparison
// with the Green's function block.
#include "base/field_sums.hpp"
#include "md/contact/explicit_system.hpp"
#include "md/contact/green_system.hpp"
#include "md/minimise/relaxation.hpp"
#include "tests/md/rough_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

namespace asperity::md::explicit_system_test {

using problems::angstrom;
using problems::RoughContact;

RelaxationSettings tight() {
  RelaxationSettings settings;
  settings.tolerance = 1e-6;
  return settings;
}

GreenSystem green_of(const RoughContact& problem, int cells) {
  return {SurfaceStiffness(problems::paper_crystal(), problem.layer(), cells,
                           mechanics::AtomModes::vector),
          problem.interface()};
}

RoughContact rough_contact(int levels, int layers) {
  RoughContact problem{32};
  problem.levels = levels;
  problem.layers = layers;
  problem.rms_height = 3.0 * angstrom;
  return problem;
}

double mean_height(const System& system, std::span<const double> state) {
  return mean(layer_of(system, state).z);
}

double mean_force(const System& system, std::span<const double> state) {
  return mean(normal_forces(system, state));
}

struct Balance {
  Relaxation relaxation;
  double mean_height = 0.0; // [m]
  double elastic_energy = 0.0;
};

/// Starting above the surface, under a nominal pressure.
Balance press(System& system, const RoughContact& problem, double pressure) {
  system.set_load({Load::Kind::nominal_pressure, pressure});
  std::vector<double> state =
      system.undeformed(problem.highest() + 4.0 * angstrom);
  const Relaxation relaxation = relax(system, state, tight());
  EXPECT_TRUE(relaxation.converged) << relaxation.note;
  EXPECT_NEAR(mean_force(system, state) /
                  (pressure * problem.layer().cell_area()),
              1.0, 1e-4);
  return {relaxation, mean_height(system, state), system.elastic_energy(state)};
}

// Forces are minus the gradient of the energy of block, interface and load
// together, along directions that the load allows. Tolerance: the third-order
// term of a central difference with a step of 1e-14 m, and roundoff of the
// energy over its change.
TEST(ExplicitSystem, ForcesAreMinusTheGradient) {
  const RoughContact problem{16, 2, 2};
  ExplicitSystem system = problem.system();
  for (const Load& load : {Load{Load::Kind::nominal_pressure, 3e9},
                           Load{Load::Kind::height, 4.0 * angstrom}}) {
    system.set_load(load);
    const std::vector<double> state =
        problems::disturbed(system.undeformed(4.0 * angstrom), 3e-12, 1);
    std::vector<double> direction =
        problems::random_numbers(state.size(), -1.0, 1.0, 2);
    system.hold(direction);
    std::vector<double> forces(state.size());
    system.energy_and_forces(state, forces);
    const double slope = dot(forces, direction);

    const auto energy_at = [&](double step) {
      std::vector<double> moved = state;
      std::vector<double> unused(state.size());
      for (std::size_t i = 0; i < state.size(); ++i)
        moved[i] += step * direction[i];
      return system.energy_and_forces(moved, unused).energy;
    };

    EXPECT_NEAR((energy_at(-1e-14) - energy_at(1e-14)) / (2e-14 * slope), 1.0,
                1e-6);
  }
}

// Components that the load prescribes have no force and no step.
TEST(ExplicitSystem, PrescribedMeansHaveNoForce) {
  const RoughContact problem{16, 2, 2};
  ExplicitSystem system = problem.system();
  system.set_load({Load::Kind::height, 4.0 * angstrom});
  const std::vector<double> state = system.undeformed(4.0 * angstrom);
  std::vector<double> forces(state.size());
  std::vector<double> step(state.size());

  const Evaluation evaluation = system.energy_and_forces(state, forces);
  system.precondition(forces, 1.2, step);

  EXPECT_GT(evaluation.contact_force, 0.0);
  const std::size_t n = system.layer().size();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(mean(std::span(forces).subspan(axis * n, n)), 0.0,
                1e-12 * evaluation.contact_force);
    EXPECT_NEAR(mean(std::span(step).subspan(axis * n, n)), 0.0,
                1e-12 * angstrom);
  }
}

// One level equals the Green's function block of the same depth: the same
// height under the same pressure, and the same elastic energy without the
// uniform compression, which only one of them has. Tolerance: the residuals,
// 1e-6 of the mean force, times the compliance of the curve in units of the
// height, below 1e-5.
TEST(ExplicitSystem, OneLevelAgreesWithTheGreenBlock) {
  const RoughContact problem = rough_contact(1, 12);
  ExplicitSystem system = problem.system();
  GreenSystem green = green_of(problem, 12);
  for (const double pressure : {1e8, 3e9}) {
    const Balance ours = press(system, problem, pressure);
    const Balance theirs = press(green, problem, pressure);

    RecordProperty("evaluations", ours.relaxation.evaluations);
    RecordProperty("evaluations_of_green", theirs.relaxation.evaluations);
    EXPECT_NEAR(ours.mean_height / theirs.mean_height, 1.0, 1e-5);
    EXPECT_NEAR(ours.elastic_energy / theirs.elastic_energy, 1.0, 1e-4);
  }
}

/// Pressure of the multiscale block over that of the Green's function block of
/// the same depth, both at the height of the latter under `pressure`.
double stiffening(int levels, int layers, double pressure) {
  const RoughContact problem = rough_contact(levels, layers);
  ExplicitSystem system = problem.system();
  GreenSystem green = green_of(problem, layers * ((1 << levels) - 1));
  green.set_load({Load::Kind::nominal_pressure, pressure});
  system.set_load({Load::Kind::nominal_pressure, pressure});
  std::vector<double> of_green =
      green.undeformed(problem.highest() + 4.0 * angstrom);
  std::vector<double> state =
      system.undeformed(problem.highest() + 4.0 * angstrom);
  EXPECT_TRUE(relax(green, of_green, tight()).converged);
  EXPECT_TRUE(relax(system, state, tight()).converged);
  const double height = mean_height(green, of_green);
  const double lift = height - mean_height(system, state);
  const std::size_t n = problem.layer().size();
  system.set_load({Load::Kind::height, height});
  for (std::size_t i = 0; i < n; ++i)
    state[2 * n + i] += lift;
  EXPECT_TRUE(relax(system, state, tight()).converged);
  // L-BFGS stores its steps in single precision.
  EXPECT_NEAR(mean_height(system, state), height, 1e-9 * height);
  return mean_force(system, state) / (pressure * problem.layer().cell_area()) -
         1.0;
}

// Verifies the error of p(u) from levels (DESIGN.md, section 9): below 1 % with
// six layers per level, 3 to 6 % with two, where long waves carry the load.
// Under a tenth of the load a few atoms carry it, and the error is smaller.
TEST(ExplicitSystem, LevelsCostLittleStiffness) {
  for (const double pressure : {1e9, 3e9}) {
    const double six = stiffening(3, 6, pressure);
    const double two = stiffening(4, 2, pressure);
    RecordProperty("six_" + std::to_string(pressure), std::to_string(six));
    RecordProperty("two_" + std::to_string(pressure), std::to_string(two));
    EXPECT_GT(six, 0.0);
    EXPECT_LT(six, 0.01);
    EXPECT_GT(two, 0.03);
    EXPECT_LT(two, 0.06);
  }
}

TEST(ExplicitSystem, RefusesAnInterfaceOfAnotherLayer) {
  RoughContact problem{16, 1, 2};
  EXPECT_THROW(ExplicitSystem(problems::paper_crystal(),
                              {RoughContact{24}.layer(), 1, 2},
                              problem.interface(), 1.0),
               std::domain_error);
}

} // namespace asperity::md::explicit_system_test
