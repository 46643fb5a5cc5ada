// Tests of md/dynamics/dynamics_run.hpp and md/dynamics/checkpoint.hpp: an
// interrupted and resumed run equals an uninterrupted one, and the averages at
// finite temperature.
#include "md/dynamics/checkpoint.hpp"
#include "md/dynamics/dynamics_run.hpp"
#include "tests/md/rough_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace asperity::md::dynamics_run_test {

using problems::angstrom;
using problems::RoughContact;

struct Killed {};

class Runs : public ::testing::Test {
protected:
  Runs()
      : folder(std::filesystem::temp_directory_path() /
               ("asperity-motion-" + std::to_string(::getpid()))),
        system(RoughContact{16, 2, 2}.system()) {
    std::filesystem::create_directories(folder);
    load = {Load::Kind::height, RoughContact{}.highest() + 3.5 * angstrom};
    system.set_load(load);
  }

  ~Runs() override { std::filesystem::remove_all(folder); }

  std::vector<double> start() const { return system.undeformed(load.amount); }

  /// 203 steps at 300 K with a checkpoint every 40.
  DynamicsRun hot_run(bool is_put_aside) const {
    return {{5e-15, 5e12, 300.0, 3, 1},
            203 * 5e-15,
            0.0,
            is_put_aside ? folder / "motion" : std::filesystem::path{},
            40,
            "label"};
  }

  std::filesystem::path folder;
  ExplicitSystem system;
  Load load;
};

void expect_same_bits(const DynamicsOutcome& a, const DynamicsOutcome& b) {
  EXPECT_EQ(a.relaxation.evaluations, b.relaxation.evaluations);
  EXPECT_EQ(a.relaxation.energy, b.relaxation.energy);
  EXPECT_EQ(a.relaxation.residual, b.relaxation.residual);
  EXPECT_EQ(a.average.samples, b.average.samples);
  EXPECT_EQ(a.average.state, b.average.state);
  EXPECT_EQ(a.average.normal_forces, b.average.normal_forces);
  EXPECT_EQ(a.average.interface_energy, b.average.interface_energy);
  EXPECT_EQ(a.average.force_spread, b.average.force_spread);
}

// A run that is killed, in the first half and in the second, resumes from the
// last checkpoint, at steps 80 and 160.
TEST_F(Runs, KilledAndResumedEqualUninterrupted) {
  std::vector<double> whole = start();
  const DynamicsOutcome expected =
      run_dynamics(system, load, whole, hot_run(false));

  for (const int last : {90, 190}) {
    std::vector<double> state = start();
    int first = 0;
    EXPECT_THROW(run_dynamics(system, load, state, hot_run(true),
                              [&](const Progress& progress) {
                                first =
                                    first == 0 ? progress.evaluations : first;
                                if (progress.evaluations > last)
                                  throw Killed{};
                                return true;
                              }),
                 Killed);
    EXPECT_EQ(first, last == 90 ? 1 : 81);
  }
  std::vector<double> state = start();
  const DynamicsOutcome outcome =
      run_dynamics(system, load, state, hot_run(true));

  EXPECT_EQ(state, whole);
  expect_same_bits(outcome, expected);
  EXPECT_FALSE(std::filesystem::exists(folder / "motion"));
}

// A checkpoint of another run, a truncated one and one with a byte changed in
// its header are ignored, and the run starts from the beginning.
TEST_F(Runs, ForeignCheckpointsAreIgnored) {
  const std::string mine(40, 'a');
  Checkpoint written;
  written.motion.step = 7;
  written.motion.state = {1.0, 2.0};
  written.motion.velocities = {3.0, 4.0};
  written.sums = {5.0};
  const std::filesystem::path path = folder / "checkpoint";
  write_checkpoint(path, mine, written);

  const std::optional<Checkpoint> read = read_checkpoint(path, mine, 2, 1);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->motion.step, 7);
  EXPECT_EQ(read->motion.state, written.motion.state);
  EXPECT_EQ(read->motion.velocities, written.motion.velocities);
  EXPECT_EQ(read->sums, written.sums);

  EXPECT_FALSE(read_checkpoint(folder / "absent", mine, 2, 1));
  EXPECT_FALSE(read_checkpoint(path, std::string(40, 'b'), 2, 1));
  EXPECT_FALSE(read_checkpoint(path, mine, 1, 3)); // the same number of values
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_FALSE(read_checkpoint(path, mine, 2, 1));
  write_checkpoint(path, mine, written);
  std::fstream(path, std::ios::in | std::ios::out).write("a", 1);
  EXPECT_FALSE(read_checkpoint(path, mine, 2, 1));
}

// Everything that defines a run is in its fingerprint: a run with another seed,
// load or label does not resume from the checkpoint.
TEST_F(Runs, AnotherRunStartsFromTheBeginning) {
  const auto first_evaluation = [&](const DynamicsRun& run,
                                    const Load& target) {
    int first = 0;
    std::vector<double> state = start();
    run_dynamics(system, target, state, run, [&](const Progress& progress) {
      first = progress.evaluations;
      return false;
    });
    return first;
  };
  const auto put_aside = [&] {
    std::vector<double> state = start();
    run_dynamics(
        system, load, state, hot_run(true),
        [&](const Progress& progress) { return progress.evaluations < 100; });
  };
  DynamicsRun other_seed = hot_run(true);
  other_seed.dynamics.seed = 4;
  DynamicsRun other_label = hot_run(true);
  other_label.label = "another";
  const Load other_load{Load::Kind::height, 1.001 * load.amount};

  put_aside();
  EXPECT_EQ(first_evaluation(hot_run(true), load), 101);
  put_aside();
  EXPECT_EQ(first_evaluation(other_seed, load), 1);
  put_aside();
  EXPECT_EQ(first_evaluation(other_label, load), 1);
  put_aside();
  EXPECT_EQ(first_evaluation(hot_run(true), other_load), 1);
}

// At finite temperature a block under pressure balances its load on average.
// Tolerance: three standard errors, the spread of the samples over the root of
// some 20 oscillations of the block on its contact (2 pi / w = 10 ps at w^2 =
// 0.5 N/m / 5 m).
TEST_F(Runs, ThermalBlockBalancesItsLoadOnAverage) {
  RoughContact problem{8, 1, 2};
  problem.rms_height = 0.3 * angstrom;
  ExplicitSystem small = problem.system();
  const Load pressure{Load::Kind::nominal_pressure, 1e9};
  small.set_load(pressure);
  std::vector<double> state =
      small.undeformed(problem.highest() + 3.8 * angstrom);
  const DynamicsRun run{
      {10e-15, 2e12, 300.0, 3, 1}, 150e-12, 0.0, {}, 1000, {}};

  const DynamicsOutcome outcome = run_dynamics(small, pressure, state, run);

  EXPECT_TRUE(outcome.relaxation.converged);
  EXPECT_GE(outcome.average.samples, 750);
  const std::vector<double>& forces = outcome.average.normal_forces;
  const double mean = std::accumulate(forces.begin(), forces.end(), 0.0) /
                      static_cast<double>(forces.size());
  const double load_an_atom = 1e9 * problem.layer().cell_area();
  EXPECT_GT(outcome.average.force_spread, 0.0);
  EXPECT_GT(outcome.average.height_spread, 0.0);
  EXPECT_NEAR(mean, load_an_atom,
              3.0 * outcome.average.force_spread / std::sqrt(20.0));
  EXPECT_LT(outcome.average.force_spread / std::sqrt(20.0), 0.2 * load_an_atom);
}

TEST_F(Runs, RefusesARunThatCannotEnd) {
  std::vector<double> state = start();
  DynamicsRun run = hot_run(false);
  run.dynamics.temperature = 0.0;
  run.dynamics.damping = 0.0;
  EXPECT_THROW(run_dynamics(system, load, state, run), std::domain_error);
  run = hot_run(false);
  run.duration = 1e-15;
  EXPECT_THROW(run_dynamics(system, load, state, run), std::domain_error);
}

} // namespace asperity::md::dynamics_run_test
