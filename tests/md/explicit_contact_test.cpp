// Tests of md/contact/explicit_contact.hpp: the loading path of a rough contact
// by each minimiser, and the notes about a step.
#include "input/input_error.hpp"
#include "md/contact/explicit_contact.hpp"
#include "md/engines.hpp"
#include "md/lattice/effective_modulus.hpp"
#include "md/lattice/slab_symbol.hpp"
#include "tests/base/fields.hpp"
#include "tests/md/rough_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace asperity::md::explicit_contact_test {

using mechanics::AtomMinimizer;
using mechanics::Control;
using problems::angstrom;
using problems::RoughContact;

AtomRequest request_of(const RoughContact& problem) {
  AtomRequest request;
  mechanics::MdSettings& settings = request.settings;
  settings.bulk = mechanics::AtomBulk::explicit_layers;
  settings.levels = problem.levels;
  settings.layers = problem.layers;
  settings.interaction_energy = problems::paper_atoms().energy;
  settings.interaction_distance = problems::paper_atoms().distance;
  settings.cutoff = 10.0 * angstrom;
  settings.contact_distance = problems::contact_distance;
  settings.tolerance = 1e-6;
  settings.mass = problems::atom_mass;
  settings.time_step = 10e-15;
  settings.damping = 6e11;
  settings.duration = 100e-12;
  request.youngs_modulus = problems::paper_crystal().youngs_modulus;
  request.poisson_ratio = problems::paper_crystal().poisson_ratio;
  request.layer = problem.layer();
  request.substrate = problem.substrate();
  request.heights = problem.heights();
  return request;
}

RoughContact small_contact() {
  RoughContact problem{16};
  problem.levels = 2;
  problem.layers = 3;
  return problem;
}

class Folder : public ::testing::Test {
protected:
  Folder() { std::filesystem::create_directories(path); }

  ~Folder() override { std::filesystem::remove_all(path); }

  std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("asperity-explicit-" + std::to_string(::getpid()));
};

// Verifies that another process continues from the saved state as this one
// does, bit for bit.
TEST(ExplicitContact, ContinuesFromItsState) {
  const auto first = make_explicit_contact(request_of(small_contact()));
  first->solve({Control::nominal_pressure, 2e8}, 0);
  const auto second = make_explicit_contact(request_of(small_contact()));
  second->restore(first->state());

  const AtomStep went_on = first->solve({Control::nominal_pressure, 1e9}, 1);
  const AtomStep restored = second->solve({Control::nominal_pressure, 1e9}, 1);

  EXPECT_EQ(went_on.mean_gap, restored.mean_gap);
  EXPECT_EQ(went_on.pressure, restored.pressure);
  EXPECT_EQ(first->state(), second->state());
  EXPECT_THROW(second->restore(std::vector<double>(3)), std::domain_error);
}

// Pressure control and prescribed height give one curve, although one loads the
// plate and the other the layer. Tolerance: the residual, 1e-6 of the mean
// force, over the stiffness of the curve, whose range is some hundred times
// larger; 1e-4.
TEST(ExplicitContact, PressureAndHeightAgree) {
  const auto by_pressure = make_explicit_contact(request_of(small_contact()));
  const auto by_height = make_explicit_contact(request_of(small_contact()));
  for (const double pressure : {2e8, 2e9}) {
    const AtomStep pressed =
        by_pressure->solve({Control::nominal_pressure, pressure}, 0);
    const AtomStep held =
        by_height->solve({Control::mean_gap, pressed.mean_gap}, 0);

    ASSERT_TRUE(pressed.converged) << pressed.note;
    ASSERT_TRUE(held.converged) << held.note;
    EXPECT_NEAR(pressed.nominal_pressure / pressure, 1.0, 1e-5);
    EXPECT_NEAR(held.nominal_pressure / pressure, 1.0, 1e-4);
    // L-BFGS stores its steps in single precision.
    EXPECT_NEAR(held.mean_gap, pressed.mean_gap, 1e-9 * angstrom);
    EXPECT_NEAR(held.elastic_energy / pressed.elastic_energy, 1.0, 1e-4);
    EXPECT_NEAR(held.interface_energy / pressed.interface_energy, 1.0, 1e-4);
    EXPECT_EQ(held.inspection.in_contact, pressed.inspection.in_contact);
    EXPECT_GT(pressed.contact_count, 0.0);
    EXPECT_GT(pressed.elastic_energy, 0.0);
  }
}

// L-BFGS and damped motion converge to one state, and the motion ends early.
// Tolerance: as above.
TEST(ExplicitContact, BothMinimizersAgree) {
  AtomRequest request = request_of(small_contact());
  const AtomStep lbfgs = make_explicit_contact(request)->solve(
      {Control::nominal_pressure, 1e9}, 0);
  request.settings.minimizer = AtomMinimizer::dynamics;
  const AtomStep motion = make_explicit_contact(request)->solve(
      {Control::mean_gap, lbfgs.mean_gap}, 0);

  for (const AtomStep* step : {&lbfgs, &motion}) {
    ASSERT_TRUE(step->converged) << step->note;
    EXPECT_TRUE(step->note.empty());
    EXPECT_LE(step->residual, 1e-6);
    EXPECT_NEAR(step->nominal_pressure / 1e9, 1.0, 1e-4);
    EXPECT_NEAR(step->mean_gap, lbfgs.mean_gap, 1e-4 * angstrom);
    EXPECT_NEAR(step->elastic_energy / lbfgs.elastic_energy, 1.0, 1e-4);
  }
  EXPECT_LT(motion.evaluations, 10000);
  EXPECT_LT(tests::largest_difference(motion.pressure, lbfgs.pressure), 1e6);
}

// Without contact the block carries no pressure and is at rest, which is a
// valid result.
TEST(ExplicitContact, HasNoContactFarAbove) {
  const auto contact = make_explicit_contact(request_of(small_contact()));
  ASSERT_TRUE(contact->solve({Control::nominal_pressure, 1e9}, 0).converged);

  const AtomStep step = contact->solve({Control::mean_gap, 20.0 * angstrom}, 1);

  EXPECT_TRUE(step.converged);
  EXPECT_EQ(step.nominal_pressure, 0.0);
  EXPECT_EQ(step.contact_count, 0.0);
  EXPECT_EQ(step.interface_energy, 0.0);
  EXPECT_NEAR(step.mean_gap, 20.0 * angstrom, 1e-12 * angstrom);
  EXPECT_NEAR(step.elastic_energy, 0.0, 1e-20);
}

// A step at finite temperature is the mean of its second half and states its
// fluctuation; interrupted and resumed by another object it has the same bits.
TEST_F(Folder, ThermalStepIsAveragedAndResumed) {
  AtomRequest request = request_of(small_contact());
  request.settings.minimizer = AtomMinimizer::dynamics;
  request.settings.temperature = 300.0;
  request.settings.damping = 5e12;
  request.settings.time_step = 5e-15;
  request.settings.duration = 1.5e-12;
  const AtomStep whole =
      make_explicit_contact(request)->solve({Control::mean_gap, 1e-10}, 3);
  ASSERT_TRUE(whole.converged) << whole.note;
  EXPECT_TRUE(whole.note.starts_with("mean over 15 samples at 300 K"))
      << whole.note;
  EXPECT_GT(whole.nominal_pressure, 0.0);

  request.scratch = path;
  const AtomStep stopped = make_explicit_contact(request)->solve(
      {Control::mean_gap, 1e-10}, 3,
      [](const Progress& progress) { return progress.evaluations < 222; });
  EXPECT_FALSE(stopped.converged);
  EXPECT_EQ(stopped.note, "stopped");
  EXPECT_TRUE(std::filesystem::exists(path / "step-0003.motion"));
  int first = 0;
  const AtomStep resumed = make_explicit_contact(request)->solve(
      {Control::mean_gap, 1e-10}, 3, [&](const Progress& progress) {
        first = first == 0 ? progress.evaluations : first;
        return true;
      });

  EXPECT_EQ(first, 231);
  EXPECT_EQ(resumed.pressure, whole.pressure);
  EXPECT_EQ(resumed.gap, whole.gap);
  EXPECT_EQ(resumed.note, whole.note);
}

// A step in which atoms pass through the substrate is not a result.
TEST(ExplicitContact, ReportsAtomsThatPassedThrough) {
  AtomRequest request = request_of(small_contact());
  request.settings.interaction_energy *= 1e-9; // no repulsion
  const auto contact = make_explicit_contact(request);

  const AtomStep step = contact->solve({Control::mean_gap, -4.0 * angstrom}, 0);

  EXPECT_FALSE(step.converged);
  EXPECT_TRUE(step.note.find("atoms have penetrated") != std::string::npos)
      << step.note;
}

int atoms_in(const std::filesystem::path& dump) {
  int atoms = -1;
  std::ifstream(dump) >> atoms;
  return atoms;
}

// Dumps are named by the step and contain what the bulk has: substrate and
// lowest layer, or all free atoms.
TEST_F(Folder, DumpsTheAtomsOfAStep) {
  AtomRequest request = request_of(small_contact());
  request.scratch = path;
  request.settings.dump = true;

  make_atomic_contact(request)->solve({Control::nominal_pressure, 1e9}, 12);
  request.settings.bulk = mechanics::AtomBulk::green;
  request.settings.depth = {18.0 * problems::layer_spacing};
  make_atomic_contact(request)->solve({Control::nominal_pressure, 1e9}, 13);

  const int both = 26 * 26 + 256;
  EXPECT_EQ(atoms_in(path / "step-0012.xyz"), both + 2 * 256 + 3 * 64);
  EXPECT_EQ(atoms_in(path / "step-0013.xyz"), both);
}

// Verifies that one deep level has the modulus of slab doubling. Tolerance:
// roundoff. Four levels of six layers have it within 1 %.
TEST(EffectiveModulus, IsThatOfTheSlab) {
  const Crystal crystal = problems::paper_crystal();
  const double angle = 2.0 * std::acos(-1.0) / 63.0; // nearest to 0.1

  const double one = effective_contact_modulus(crystal, 1, 40);

  const SlabSymbol slab(crystal);
  EXPECT_NEAR(one / slab.contact_modulus(angle, 0.0, 40), 1.0, 1e-12);
  EXPECT_NEAR(effective_contact_modulus(crystal, 4, 6) /
                  slab.contact_modulus(0.1, 0.0, 90),
              1.0, 0.01);
}

TEST(ExplicitContact, RefusesOtherSettings) {
  AtomRequest request = request_of(small_contact());
  request.settings.bulk = mechanics::AtomBulk::green;
  EXPECT_THROW(make_explicit_contact(request), input::InputError);
  request = request_of(small_contact());
  request.settings.modes = mechanics::AtomModes::normal;
  EXPECT_THROW(make_explicit_contact(request), input::InputError);
  request = request_of(small_contact());
  request.settings.levels = 6;
  EXPECT_THROW(make_explicit_contact(request), std::domain_error);
  EXPECT_THROW(make_explicit_contact(request_of(small_contact()))
                   ->solve({Control::nominal_pressure, 0.0}, 0),
               std::domain_error);
}

} // namespace asperity::md::explicit_contact_test
