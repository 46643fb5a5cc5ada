// Tests of md/lammps/lammps_contact.hpp without a second engine: both controls
// give one curve, the energy is the work of the load, any number of processes
// gives the same solution, and a step that fails states the reason. Skipped
// where the Debian package lammps is not installed.
#include "base/child_process.hpp"
#include "md/engines.hpp"
#include "md/lammps/lammps_contact.hpp"
#include "tests/md/lammps_requests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace asperity::md::lammps_contact_test {

using mechanics::Control;

constexpr double modulus = 77.2e9 / (1.0 - 0.25 * 0.25); // E* [Pa]

class LammpsContactTest : public testing::Test {
protected:
  void SetUp() override {
    if (program_on_path("lmp").empty())
      GTEST_SKIP() << "skipped: needs lammps";
  }

  ~LammpsContactTest() override {
    std::filesystem::remove_all(request.scratch);
  }

  AtomRequest request = problems::small_request(12, 6, 0.05);
};

/// Smallest u of the curve; contact is light to moderate there.
constexpr double gap = 0.2e-10;

// Tolerance: p decreases by 2.3 in 1e-10 m, and a residual of 1e-4 leaves u
// uncertain by 1e-4 of that.
TEST_F(LammpsContactTest, BothControlsGiveOneCurve) {
  const auto contact = make_lammps_contact(request);
  const double pressure = 0.01 * modulus;

  const AtomStep pressed =
      contact->solve({Control::nominal_pressure, pressure}, 0);
  const AtomStep held =
      contact->solve({Control::mean_gap, pressed.mean_gap}, 1);

  ASSERT_TRUE(pressed.converged) << pressed.note;
  ASSERT_TRUE(held.converged) << held.note;
  EXPECT_NEAR(pressed.nominal_pressure / pressure, 1.0, 3e-4);
  EXPECT_NEAR(held.mean_gap, pressed.mean_gap, 1e-17);
  EXPECT_NEAR(held.nominal_pressure / pressed.nominal_pressure, 1.0, 3e-4);
}

// Tolerance: two solutions within the residual of the same one.
TEST_F(LammpsContactTest, TwoProcessesFindTheSameAnswer) {
  if (program_on_path("mpirun").empty())
    GTEST_SKIP() << "skipped: needs mpi-default-bin";
  const AtomStep one =
      make_lammps_contact(request)->solve({Control::mean_gap, gap}, 0);
  request.settings.ranks = 2;
  const AtomStep two =
      make_lammps_contact(request)->solve({Control::mean_gap, gap}, 0);

  ASSERT_TRUE(two.converged) << two.note;
  EXPECT_NEAR(two.nominal_pressure / one.nominal_pressure, 1.0, 1e-4);
  for (std::size_t i = 0; i < one.pressure.size(); ++i)
    EXPECT_NEAR(two.pressure[i] / one.nominal_pressure,
                one.pressure[i] / one.nominal_pressure, 5e-3);
}

TEST_F(LammpsContactTest, MapsMeansAndDumpAreOfTheSameAtoms) {
  request.settings.dump = true;
  const AtomStep step =
      make_lammps_contact(request)->solve({Control::mean_gap, gap}, 7);

  ASSERT_EQ(step.pressure.size(), request.layer.size());
  const double n = static_cast<double>(request.layer.size());
  const double mean =
      std::accumulate(step.pressure.begin(), step.pressure.end(), 0.0) / n;
  EXPECT_NEAR(step.nominal_pressure / mean, 1.0, 1e-12);
  EXPECT_NEAR(step.mean_gap, gap, 1e-17);
  EXPECT_EQ(step.inspection.in_contact / n, step.contact_count);
  // Where the gap is small the pressure is high.
  const auto smallest = std::min_element(step.gap.begin(), step.gap.end());
  const auto at = static_cast<std::size_t>(smallest - step.gap.begin());
  EXPECT_GT(step.pressure[at], 2.0 * mean);
  EXPECT_TRUE(
      std::filesystem::exists(request.scratch / "lammps" / "step-0007.dump"));
}

TEST_F(LammpsContactTest, OutOfReachThereIsNoPressure) {
  const AtomStep step =
      make_atomic_contact(request)->solve({Control::mean_gap, 20e-10}, 0);

  EXPECT_TRUE(step.converged) << step.note;
  EXPECT_EQ(step.nominal_pressure, 0.0);
  EXPECT_EQ(step.interface_energy, 0.0);
}

// A block that is loaded and touches nothing is not in balance. Its atoms start
// 4 angstrom above the substrate and end beyond the cut-off here.
TEST_F(LammpsContactTest, ALoadIsNotInBalanceOutOfReach) {
  request.settings.cutoff = 3.9e-10;
  request.settings.contact_distance = 3.3e-10;
  request.settings.max_evaluations = 2;

  const AtomStep step =
      make_lammps_contact(request)->solve({Control::nominal_pressure, 1e3}, 0);

  EXPECT_EQ(step.nominal_pressure, 0.0);
  EXPECT_FALSE(step.converged);
  EXPECT_FALSE(step.note.empty());
}

TEST_F(LammpsContactTest, AFailedStepStatesTheReason) {
  request.settings.max_evaluations = 5;
  const auto contact = make_lammps_contact(request);

  const AtomStep tired = contact->solve({Control::nominal_pressure, 1e9}, 0);
  EXPECT_FALSE(tired.converged);
  EXPECT_NE(tired.note.find("but must be at most 0.0001"), std::string::npos)
      << tired.note;

  const AtomStep stopped =
      contact->solve({Control::nominal_pressure, 1e9}, 1,
                     [](const Progress&) { return false; });
  EXPECT_FALSE(stopped.converged);
  EXPECT_NE(stopped.note.find("stopped"), std::string::npos) << stopped.note;

  EXPECT_THROW(contact->solve({Control::nominal_pressure, 0.0}, 2),
               std::domain_error);
  EXPECT_NE(contact->description().find("LAMMPS"), std::string::npos);
}

} // namespace asperity::md::lammps_contact_test
