// Tests of md/dynamics/dynamics.hpp: energy, temperature and spread.
#include "base/field_sums.hpp"
#include "base/maximum.hpp"
#include "base/physical_constants.hpp"
#include "md/dynamics/dynamics.hpp"
#include "md/dynamics/thermal_noise.hpp"
#include "tests/md/rough_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace asperity::md::dynamics_test {

using problems::angstrom;
using problems::RoughContact;

constexpr double femtosecond = 1e-15;

/// Mean and its standard error from independent values.
struct Estimate {
  double mean = 0.0;
  double error = 0.0;
};

Estimate estimate(const std::vector<double>& values) {
  return {mean(values),
          rms_height(values) /
              std::sqrt(static_cast<double>(values.size()) - 1.0)};
}

/// Independent oscillators about 0, each with its own stiffness and mass.
class Oscillators : public InertialSystem {
public:
  Oscillators() : interface_(RoughContact{16}.interface()) {
    for (std::size_t i = 0; i < size(); ++i) {
      const double slowness = 1.0 + static_cast<double>(i % 3);
      stiffnesses_.push_back(40.0 / slowness);
      masses_.push_back(problems::atom_mass * slowness);
    }
  }

  const Grid& layer() const override { return interface_.layer(); }

  std::size_t size() const override { return 3 * layer().size(); }

  void set_load(const Load&) override {}

  std::vector<double> undeformed(double) const override {
    return std::vector<double>(size(), 0.0);
  }

  Evaluation energy_and_forces(std::span<const double> state,
                               std::span<double> forces) const override {
    Evaluation evaluation;
    for (std::size_t i = 0; i < size(); ++i) {
      forces[i] = -stiffnesses_[i] * state[i];
      evaluation.energy -= 0.5 * forces[i] * state[i];
    }
    return evaluation;
  }

  void precondition(std::span<const double>, double,
                    std::span<double>) const override {}

  double elastic_energy(std::span<const double>) const override { return 0.0; }

  const Interface& interface() const override { return interface_; }

  std::span<const double> masses() const override { return masses_; }

  void hold(std::span<double>) const override {}

  double stiffness(std::size_t i) const { return stiffnesses_[i]; }

private:
  Interface interface_;
  std::vector<double> stiffnesses_;
  std::vector<double> masses_;
};

// BAOAB gives oscillators the canonical spread of positions exactly, at a time
// step of w h = 0.33 to 1, and velocities that are too small by w^2 h^2 / 4, as
// its author derives. Tolerance: three standard errors over 768 independent
// oscillators, some 0.5 %.
TEST(Dynamics, GivesOscillatorsTheCanonicalSpread) {
  const Oscillators system;
  const double step = std::sqrt(problems::atom_mass / 40.0); // w h = 1
  const DynamicsSettings settings{step, 1.0 / step, 300.0, 5, 1};
  Dynamics dynamics(
      system, settings,
      {0, system.undeformed(0.0), thermal_velocities(system, settings)});
  for (int i = 0; i < 30; ++i)
    dynamics.step();

  constexpr int n_steps = 600;
  std::vector<double> potential(system.size());
  std::vector<double> kinetic(system.size());
  const double unit = boltzmann * 300.0 * n_steps;
  for (int i = 0; i < n_steps; ++i) {
    dynamics.step();
    for (std::size_t k = 0; k < system.size(); ++k) {
      const double omega_square = system.stiffness(k) / system.masses()[k];
      const double shortfall = 1.0 - 0.25 * omega_square * step * step;
      const auto& [at, state, velocities] = dynamics.motion();
      potential[k] += system.stiffness(k) * state[k] * state[k] / unit;
      kinetic[k] += system.masses()[k] * velocities[k] * velocities[k] /
                    (unit * shortfall);
    }
  }

  const Estimate of_positions = estimate(potential);
  const Estimate of_velocities = estimate(kinetic);
  EXPECT_LT(of_positions.error, 0.006);
  EXPECT_NEAR(of_positions.mean, 1.0, 3.0 * of_positions.error);
  EXPECT_LT(of_velocities.error, 0.006);
  EXPECT_NEAR(of_velocities.mean, 1.0, 3.0 * of_velocities.error);
}

// In a block of two levels every layer has the same temperature, light atoms
// and heavy ones, and on average so has the plate. Tolerance: three standard
// errors over 40 pieces of the run, each longer than 1 / gamma. The error of
// the time step, w^2 h^2 / 4 < 0.002 at 2 fs, is smaller.
TEST(Dynamics, SharesTheEnergyAmongAllLayers) {
  RoughContact problem{8};
  problem.levels = 2;
  problem.layers = 2;
  ExplicitSystem system = problem.system();
  system.set_load({Load::Kind::height, 40.0 * angstrom}); // no contact
  const DynamicsSettings settings{2.0 * femtosecond, 1e13, 300.0, 6, 1};
  Dynamics dynamics(system, settings,
                    {0, system.undeformed(40.0 * angstrom),
                     thermal_velocities(system, settings)});
  const MultiscaleBlock& block = system.block();
  const auto kinetic = [&](std::size_t begin, std::size_t end,
                           std::size_t n_held) {
    double energy = 0.0;
    for (std::size_t i = begin; i < end; ++i)
      energy += system.masses()[i] * dynamics.motion().velocities[i] *
                dynamics.motion().velocities[i];
    return energy /
           (boltzmann * 300.0 * static_cast<double>(end - begin - n_held));
  };

  std::vector<double> lowest, inside, coarse;
  for (int piece = 0; piece < 40; ++piece) {
    double sums[3] = {0.0, 0.0, 0.0};
    constexpr int n_steps = 100;
    for (int i = 0; i < n_steps; ++i) {
      dynamics.step();
      sums[0] += kinetic(0, block.begin_of(0, 1), 3) / n_steps;
      sums[1] +=
          kinetic(block.begin_of(0, 1), block.begin_of(1, 0), 0) / n_steps;
      sums[2] += kinetic(block.begin_of(1, 0), block.size(), 0) / n_steps;
    }
    lowest.push_back(sums[0]);
    inside.push_back(sums[1]);
    coarse.push_back(sums[2]);
  }

  for (const auto* temperatures : {&lowest, &inside, &coarse}) {
    const Estimate temperature = estimate(*temperatures);
    EXPECT_LT(temperature.error, 0.02);
    EXPECT_NEAR(temperature.mean, 1.0, 3.0 * temperature.error);
  }
}

/// Largest |E(t) - E(0)| over the mean kinetic energy in 1 ps of an undamped
/// contact at finite temperature.
double energy_drift(ExplicitSystem& system, const Motion& start,
                    double time_step) {
  Dynamics dynamics(system, {time_step, 0.0, 0.0, 0, 1}, start);
  const auto total = [&] {
    return dynamics.evaluation().energy + dynamics.kinetic_energy();
  };
  const double first = total();
  double drift = 0.0;
  double kinetic = 0.0;
  const int n_steps = static_cast<int>(std::lround(1e-12 / time_step));
  for (int i = 0; i < n_steps; ++i) {
    dynamics.step();
    drift = maximum(drift, std::abs(total() - first));
    kinetic += dynamics.kinetic_energy() / n_steps;
  }
  return drift / kinetic;
}

// Without damping the energy of a block in contact is conserved, within 5e-3 of
// the kinetic energy at the 10 fs of the paper's atoms, and the error is of
// second order in the time step. Tolerance of the order: the next one, (w h)^2
// of some 0.1 on a factor of 4.
TEST(Dynamics, ConservesTheEnergyToSecondOrder) {
  RoughContact problem{16};
  problem.levels = 2;
  problem.layers = 3;
  ExplicitSystem system = problem.system();
  const double height = problem.highest() + 3.5 * angstrom;
  system.set_load({Load::Kind::height, height});
  const DynamicsSettings hot{5.0 * femtosecond, 5e12, 300.0, 9, 1};
  Dynamics heating(
      system, hot,
      {0, system.undeformed(height), thermal_velocities(system, hot)});
  for (int i = 0; i < 300; ++i)
    heating.step();

  const double coarse =
      energy_drift(system, heating.motion(), 10.0 * femtosecond);
  const double fine = energy_drift(system, heating.motion(), 5.0 * femtosecond);

  RecordProperty("drift_10_fs", std::to_string(coarse));
  RecordProperty("drift_5_fs", std::to_string(fine));
  EXPECT_GT(heating.evaluation().contact_force, 0.0);
  EXPECT_LT(coarse, 5e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.4);
}

// The thermal noise does not change the prescribed means. Tolerance: roundoff
// of the sums.
TEST(Dynamics, LeavesPrescribedMeansUnchanged) {
  const RoughContact problem{16};
  ExplicitSystem system = problem.system();
  const double height = problem.highest() + 3.5 * angstrom;
  system.set_load({Load::Kind::height, height});
  Dynamics dynamics(system, {5.0 * femtosecond, 5e12, 300.0, 10, 1},
                    {0, system.undeformed(height), {}});

  for (int i = 0; i < 100; ++i)
    dynamics.step();

  const LayerView layer = layer_of(system, dynamics.motion().state);
  EXPECT_NEAR(mean(layer.x), 0.0, 1e-12 * angstrom);
  EXPECT_NEAR(mean(layer.y), 0.0, 1e-12 * angstrom);
  EXPECT_NEAR(mean(layer.z), height, 1e-12 * height);
}

// The noise is normal: mean, variance and fourth moment within three standard
// errors of n numbers, 1, sqrt(2), sqrt(96) over sqrt(n). It is the same for
// any number of threads and differs from step to step.
TEST(ThermalNoise, IsNormalAndFixedByItsKey) {
  std::vector<double> numbers(100'003);
  draw_normal(1, 2, 1, numbers);

  double moments[3] = {0.0, 0.0, 0.0};
  const auto n = static_cast<double>(numbers.size());
  for (const double number : numbers) {
    moments[0] += number / n;
    moments[1] += number * number / n;
    moments[2] += std::pow(number, 4) / n;
  }
  EXPECT_NEAR(moments[0], 0.0, 3.0 / std::sqrt(n));
  EXPECT_NEAR(moments[1], 1.0, 3.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(moments[2], 3.0, 3.0 * std::sqrt(96.0 / n));

  std::vector<double> again(numbers.size());
  draw_normal(1, 2, 3, again);
  EXPECT_EQ(again, numbers);
  draw_normal(1, 3, 1, again);
  EXPECT_NE(again, numbers);
  draw_normal(2, 2, 1, again);
  EXPECT_NE(again, numbers);
}

TEST(Dynamics, RefusesBadSettings) {
  const Oscillators system;
  const Motion rest{0, system.undeformed(0.0), {}};

  EXPECT_THROW(Dynamics(system, {0.0, 1.0, 0.0, 0, 1}, rest),
               std::domain_error);
  EXPECT_THROW(Dynamics(system, {1e-15, -1.0, 0.0, 0, 1}, rest),
               std::domain_error);
  EXPECT_THROW(Dynamics(system, {1e-15, 1.0, -1.0, 0, 1}, rest),
               std::domain_error);
  EXPECT_THROW(Dynamics(system, {1e-15, 1.0, 0.0, 0, 1}, {0, {1.0}, {}}),
               std::domain_error);
}

} // namespace asperity::md::dynamics_test
