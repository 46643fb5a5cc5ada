// Verifies that LAMMPS and our own engine agree at small slopes. They have only
// the pair law in common: LAMMPS finds its own pairs, has bonds for the
// crystal, every atom of its block, and another minimiser. Skipped where the
// Debian package lammps is not installed.
#include "base/child_process.hpp"
#include "md/contact/green_system.hpp"
#include "md/lammps/lammps_block.hpp"
#include "md/lammps/lammps_contact.hpp"
#include "md/minimise/relaxation.hpp"
#include "tests/md/lammps_requests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity::md::lammps_agreement_test {

constexpr int points = 24;
constexpr int cells = 12;
constexpr double modulus = 77.2e9 / (1.0 - 0.25 * 0.25); // E* [Pa]

/// The solution of our own engine, far below the residual of the other.
struct OwnAnswer {
  std::vector<double> pressure;
  double nominal_pressure = 0.0;
  double elastic_energy = 0.0;
  double interface_energy = 0.0;
};

OwnAnswer answer_at(const AtomRequest& request, double mean_gap) {
  const LammpsBlock block = lammps_block(request);
  GreenSystem system(SurfaceStiffness(block.crystal, block.layer, cells,
                                      mechanics::AtomModes::vector),
                     Interface(block.interaction, block.layer, block.substrate,
                               block.heights));
  const double height = mean_gap + request.settings.contact_distance;
  std::vector<double> state = system.undeformed(height);
  system.set_load({Load::Kind::height, height});
  RelaxationSettings settings;
  settings.tolerance = 1e-7;
  const Relaxation relaxation = relax(system, state, settings);
  EXPECT_TRUE(relaxation.converged) << relaxation.note;

  const double area = block.layer.area();
  OwnAnswer answer;
  for (const double force : normal_forces(system, state)) {
    answer.pressure.push_back(force / block.layer.cell_area());
    answer.nominal_pressure += force / area;
  }
  answer.elastic_energy = system.elastic_energy(state) / area;
  std::vector<double> forces(state.size());
  answer.interface_energy =
      system.energy_and_forces(state, forces).energy / area -
      answer.elastic_energy;
  return answer;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Root mean square about the mean: the variation of the load between atoms,
/// which depends on the stiffness of the block.
double fluctuation(std::vector<double> values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) /
                      static_cast<double>(values.size());
  for (double& value : values)
    value -= mean;
  return root_mean_square(values);
}

class LammpsAgreement : public testing::Test {
protected:
  void SetUp() override {
    if (program_on_path("lmp").empty())
      GTEST_SKIP() << "skipped: needs lammps";
  }

  ~LammpsAgreement() override {
    std::filesystem::remove_all(
        problems::small_request(points, cells, 0.0).scratch);
  }
};

// Tolerance: 0.3 % of p at the same u is the required agreement of the engines.
// The difference is that bonds rotate and stretch where our springs are linear.
TEST_F(LammpsAgreement, PressureAgainstGapIsThatOfTheGreenBlock) {
  const AtomRequest request = problems::small_request(points, cells, 0.05);
  const auto lammps = make_lammps_contact(request);

  for (int step = 0; step < 2; ++step) {
    const double pressure = (0.01 + 0.02 * step) * modulus;
    const AtomStep found =
        lammps->solve({mechanics::Control::nominal_pressure, pressure}, step);
    ASSERT_TRUE(found.converged) << found.note;
    const OwnAnswer own = answer_at(request, found.mean_gap);

    EXPECT_NEAR(found.nominal_pressure / own.nominal_pressure, 1.0, 3e-3);
    EXPECT_NEAR(found.elastic_energy / own.elastic_energy, 1.0, 5e-3);
    EXPECT_NEAR(found.interface_energy / own.interface_energy, 1.0, 3e-3);
  }
}

// Where strains are small, so is every difference. The variation of the load
// reveals a wrong stiffness. Tolerance: strains are of the order of p/E*,
// 0.003, and change a pressure by a third of themselves.
TEST_F(LammpsAgreement, MapsAreTheSameWhereStrainsAreSmall) {
  AtomRequest request = problems::small_request(points, cells, 0.02);
  request.settings.tolerance = 1e-5;

  const AtomStep found = make_lammps_contact(request)->solve(
      {mechanics::Control::nominal_pressure, 0.003 * modulus}, 0);

  ASSERT_TRUE(found.converged) << found.note;
  const OwnAnswer own = answer_at(request, found.mean_gap);
  std::vector<double> difference = own.pressure;
  for (std::size_t i = 0; i < difference.size(); ++i)
    difference[i] -= found.pressure[i];
  EXPECT_NEAR(fluctuation(found.pressure) / fluctuation(own.pressure), 1.0,
              1e-3);
  EXPECT_LT(fluctuation(difference) / own.nominal_pressure, 1e-3);
}

} // namespace asperity::md::lammps_agreement_test
