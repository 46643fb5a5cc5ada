// Tests of `bulk = "green"` in md/contact/atomic_contact.hpp: the curve does
// not depend on the history, load and energy are consistent, and atoms that
// passed through the substrate are reported.
#include "input/input_error.hpp"
#include "md/contact/green_contact.hpp"
#include "md/contact/green_system.hpp"
#include "md/contact/request_parts.hpp"
#include "md/contact/step_reading.hpp"
#include "md/engines.hpp"
#include "surfaces/build.hpp"
#include "tests/md/small_interface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace asperity::md::green_contact_test {

using mechanics::Control;

constexpr int points = 48;
constexpr double spacing = 2.6e-10;
constexpr double length = points * spacing;
constexpr double rms_height = 2e-10;
constexpr double poisson_ratio = 0.42;
constexpr double youngs_modulus = 77.2e9;
const double modulus = youngs_modulus / (1.0 - poisson_ratio * poisson_ratio);

/// The paper's atoms (Sec. 4) over a flat surface of this number of atoms per
/// side.
AtomRequest flat_request(int substrate_points) {
  AtomRequest request;
  request.settings.interaction_energy = 74.4e-3 * 1.602176634e-19;
  request.settings.interaction_distance = 3.28e-10;
  request.settings.cutoff = 10e-10;
  request.settings.contact_distance = 4.3615e-10;
  request.scales = {modulus, length, spacing, rms_height};
  request.youngs_modulus = youngs_modulus;
  request.poisson_ratio = poisson_ratio;
  request.layer = {points, points, length, length};
  request.substrate = {substrate_points, substrate_points, length, length};
  request.heights.assign(request.substrate.size(), 0.0);
  return request;
}

/// A surface on which three decades of loads are possible: waves from length
/// down to a sixth.
AtomRequest rough_request() {
  AtomRequest request = flat_request(mechanics::incommensurate_atoms(points));
  mechanics::SurfaceSpec surface;
  surface.length = length;
  surface.points = request.substrate.points_x;
  surface.seed = 1;
  surface.rms_height = rms_height;
  surface.rescale = true;
  surface.hurst = 0.8;
  const double longest = 2.0 * std::numbers::pi / length;
  surface.wavevector_low = 0.99 * longest;
  surface.wavevector_roll_off = 2.0 * longest;
  surface.wavevector_high = 6.01 * longest;
  request.heights = surfaces::build_surface(surface, 0).heights;
  return request;
}

// The solution depends on the load alone: after loading and unloading the gap
// is the same to 1e-5 h_rms. A residual of 1e-6 leaves that much at the softest
// state, where the stiffness of the contact is p / (h_rms / 2).
TEST(GreenContact, UnloadsOnItsLoadingCurve) {
  AtomRequest request = rough_request();
  request.settings.tolerance = 1e-6;
  const auto contact = make_atomic_contact(request);
  const std::vector<double> loads{1e-3, 1e-2, 0.1};
  std::vector<double> gaps;

  int step = 0;
  for (const double load : loads) {
    const AtomStep answer =
        contact->solve({Control::nominal_pressure, load * modulus}, step++);
    ASSERT_TRUE(answer.converged) << answer.note;
    gaps.push_back(answer.mean_gap);
  }

  EXPECT_GT(gaps[0] - gaps[2], rms_height);
  for (std::size_t i = loads.size() - 1; i-- > 0;) {
    const AtomStep answer =
        contact->solve({Control::nominal_pressure, loads[i] * modulus}, step++);
    EXPECT_NEAR(answer.mean_gap / rms_height, gaps[i] / rms_height, 1e-5);
  }
}

// The atoms carry the load. Their mean pressure differs from it by at most
// sqrt(3) times the residual, a root mean square over three directions.
TEST(GreenContact, CarriesTheLoad) {
  const AtomRequest request = rough_request();
  const auto contact = make_atomic_contact(request);
  const double pressure = 0.02 * modulus;

  const AtomStep answer =
      contact->solve({Control::nominal_pressure, pressure}, 0);

  ASSERT_TRUE(answer.converged) << answer.note;
  const double sum =
      std::accumulate(answer.pressure.begin(), answer.pressure.end(), 0.0);
  const double atoms = static_cast<double>(request.layer.size());
  EXPECT_NEAR(sum / atoms / pressure, 1.0,
              std::sqrt(3.0) * request.settings.tolerance);
  EXPECT_DOUBLE_EQ(answer.nominal_pressure, sum / atoms);
  EXPECT_GE(*std::ranges::min_element(answer.pressure), 0.0);
}

// A prescribed gap and a prescribed pressure give one curve: at the gap that a
// pressure gave, the block carries that pressure. p changes by exp(-2
// du/h_rms).
TEST(GreenContact, IsOneCurveUnderEitherControl) {
  AtomRequest request = rough_request();
  request.settings.tolerance = 1e-6;
  const double pressure = 0.01 * modulus;
  const AtomStep by_pressure = make_atomic_contact(request)->solve(
      {Control::nominal_pressure, pressure}, 0);

  const AtomStep by_gap = make_atomic_contact(request)->solve(
      {Control::mean_gap, by_pressure.mean_gap}, 0);

  ASSERT_TRUE(by_gap.converged) << by_gap.note;
  EXPECT_NEAR(by_gap.mean_gap / by_pressure.mean_gap, 1.0, 1e-9);
  EXPECT_NEAR(by_gap.nominal_pressure / pressure, 1.0, 2e-5);
}

// Virtual work: -dE/du = p per area, where E is the energy of the bulk and of
// the pairs. Central difference over 2 * 0.01 h_rms: (0.01 * 2)^2 / 6 = 7e-5 of
// p.
TEST(GreenContact, StoresTheWorkOfTheLoad) {
  AtomRequest request = rough_request();
  request.settings.tolerance = 1e-7;
  const auto contact = make_atomic_contact(request);
  const double step = 0.01 * rms_height;
  const double gap = 0.7 * rms_height;

  std::vector<AtomStep> answers;
  for (const double at : {gap + step, gap, gap - step})
    answers.push_back(contact->solve({Control::mean_gap, at}, 0));

  for (const AtomStep& answer : answers)
    ASSERT_TRUE(answer.converged) << answer.note;
  const double gain = answers[2].elastic_energy + answers[2].interface_energy -
                      answers[0].elastic_energy - answers[0].interface_energy;
  EXPECT_NEAR(gain / (2.0 * step) / answers[1].nominal_pressure, 1.0, 1e-4);
}

// Over an incommensurate flat surface the pressure of the continuous wall at
// d_c gives u = 0. The cut-off reduces the pressure by about
// (2/9)(d_c/cutoff)^9 (1e-4), and the corrugation by the layer itself is
// smooth; u changes by d_c/11 of it.
TEST(GreenContact, LiesAtTheContactDistanceOnAnIncommensurateSurface) {
  const AtomRequest request =
      flat_request(mechanics::incommensurate_atoms(points));
  const double distance = request.settings.contact_distance;
  const double pressure = problems::plane_repulsion_pressure(
      interaction_of(request.settings), request.layer.cell_area(),
      request.substrate.cell_area(), distance);

  const AtomStep answer = make_atomic_contact(request)->solve(
      {Control::nominal_pressure, pressure}, 0);

  ASSERT_TRUE(answer.converged) << answer.note;
  EXPECT_NEAR(answer.mean_gap / distance, 0.0, 1e-3);
}

/// Atoms that attract each other by 20 meV; the cutoff takes 1e-7 of it.
AtomRequest with_attraction(AtomRequest request) {
  request.settings.potential = mechanics::AtomPotential::lennard_jones;
  request.settings.interaction_energy *= 20.0 / 74.4;
  request.settings.cutoff = 0.4 * length;
  request.settings.contact_distance =
      request.settings.flat_law(length, points).value().adhesion_range;
  return request;
}

// Over an incommensurate flat surface the atoms have the pressure of the 10-4
// law at the prescribed gap, in compression and in tension. The block is a
// thousand times stiffer than that of the paper, whose atoms move into the
// hollows between those of the substrate: 5e-3 of the pressure at -0.1 A.
// Tolerance: a thousandth of that, and the attraction that the cutoff takes.
TEST(GreenContact, HasTheLawOfFlatLayersThatAttract) {
  AtomRequest request =
      with_attraction(flat_request(mechanics::incommensurate_atoms(points)));
  request.youngs_modulus *= 1e3;
  const mechanics::ContactInterface law =
      request.settings.flat_law(length, points).value();
  const auto contact = make_atomic_contact(request);

  for (const double gap : {3e-10, 0.4e-10, 0.1e-10, -0.1e-10, 2e-10}) {
    const AtomStep answer = contact->solve({Control::mean_gap, gap}, 0);

    ASSERT_TRUE(answer.converged) << answer.note;
    EXPECT_NEAR(answer.nominal_pressure / law.pressure(gap), 1.0, 2e-5) << gap;
  }
}

// On both sides of the largest tension the derivative of the energy by the mean
// gap is minus the pressure. Tolerance: h^2 of the difference and the residual.
TEST(GreenContact, StoresTheWorkOfATension) {
  AtomRequest request = with_attraction(rough_request());
  request.settings.cutoff = 10e-10; // which the energy knows
  const auto contact = make_atomic_contact(request);
  constexpr double step = 0.01e-10;
  for (const double gap : {5e-10, 2e-10}) {
    std::vector<AtomStep> answers;
    for (const double change : {step, 0.0, -step})
      answers.push_back(contact->solve({Control::mean_gap, gap + change}, 0));
    const double gain = answers[2].elastic_energy +
                        answers[2].interface_energy -
                        answers[0].elastic_energy - answers[0].interface_energy;

    EXPECT_LT(answers[1].nominal_pressure, 0.0) << gap;
    EXPECT_NEAR(gain / (2.0 * step) / answers[1].nominal_pressure, 1.0, 1e-4)
        << gap;
  }
}

// With every atom on top of another the lattice sum decides: u is where the
// force of the atom below it and of its neighbours, summed here, is the load.
TEST(GreenContact, LiesOnTopOfACommensurateSurface) {
  const AtomRequest request = flat_request(points);
  const Interaction law = interaction_of(request.settings);
  const double pressure = 1e9;

  const AtomStep answer = make_atomic_contact(request)->solve(
      {Control::nominal_pressure, pressure}, 0);

  ASSERT_TRUE(answer.converged) << answer.note;
  const double height = answer.mean_gap + request.settings.contact_distance;
  double force = 0.0;
  for (int ix = -4; ix <= 4; ++ix)
    for (int iy = -4; iy <= 4; ++iy) {
      const double distance = std::hypot(ix * spacing, iy * spacing, height);
      if (distance < law.cutoff)
        force += pair_term(law, distance).force_over_distance * height;
    }
  EXPECT_NEAR(force / (pressure * spacing * spacing), 1.0, 1e-4);
}

GreenSystem system_of(const AtomRequest& request) {
  return {SurfaceStiffness(crystal_of(request), request.layer, points,
                           request.settings.modes),
          Interface(interaction_of(request.settings), request.layer,
                    request.substrate, request.heights)};
}

Inspection inspected(const GreenSystem& system, const AtomRequest& request,
                     const std::vector<double>& state) {
  return system.interface().inspect(layer_of(system, state),
                                    close_distance(request.settings),
                                    request.settings.contact_distance);
}

// A small residual is not sufficient: below a surface with a wide spacing of
// atoms the layer is in balance, with every pair far enough apart.
TEST(GreenContact, FlagsABalanceOnTheWrongSide) {
  const AtomRequest request = flat_request(points / 2);
  GreenSystem system = system_of(request);
  const double height = -0.9 * request.settings.contact_distance;
  system.set_load({Load::Kind::height, height});
  std::vector<double> state = system.undeformed(height);

  const Relaxation relaxation = relax(system, state, {});

  ASSERT_TRUE(relaxation.converged) << relaxation.note;
  const Inspection found = inspected(system, request, state);
  EXPECT_EQ(found.close_pairs, 0);
  EXPECT_EQ(invalidity_reason(found, request.layer.size()).rfind("100 % of", 0),
            0U);
}

TEST(FaultOf, NamesAtomsThatPassedThrough) {
  EXPECT_EQ(invalidity_reason({0, 0, 2.9e-10, 7}, 100), "");
  EXPECT_NE(invalidity_reason({3, 0, 2.9e-10, 7}, 100).find("3 % of the atoms"),
            std::string::npos);
  EXPECT_NE(
      invalidity_reason({0, 2, 2.1e-10, 7}, 100).find("2 pairs are too close"),
      std::string::npos);
}

TEST(GreenContact, HasNoLoadWithoutContact) {
  const auto contact = make_atomic_contact(rough_request());

  const AtomStep answer = contact->solve({Control::mean_gap, 3e-9}, 0);

  EXPECT_TRUE(answer.converged);
  EXPECT_EQ(answer.nominal_pressure, 0.0);
  EXPECT_EQ(answer.contact_count, 0.0);
  EXPECT_NEAR(answer.mean_gap, 3e-9, 1e-21);
}

// A step that is given up is reported, and the next one is as if the former had
// finished.
TEST(GreenContact, ReportsNonConvergence) {
  AtomRequest request = rough_request();
  request.settings.max_evaluations = 5;
  const auto contact = make_atomic_contact(request);

  const AtomStep answer =
      contact->solve({Control::nominal_pressure, 0.1 * modulus}, 0);

  EXPECT_FALSE(answer.converged);
  EXPECT_NE(answer.note.find("5 evaluations"), std::string::npos)
      << answer.note;
  EXPECT_GT(answer.residual, request.settings.tolerance);
}

TEST(GreenContact, DescribesItself) {
  AtomRequest request = rough_request();
  request.settings.modes = mechanics::AtomModes::normal;
  request.settings.depth = {4.0, mechanics::ReferenceUnit::length};
  const auto contact = make_atomic_contact(request);

  EXPECT_NE(contact->description().find("isotropic lattice, 48 x 48 atoms"),
            std::string::npos);
  EXPECT_NE(contact->description().find("192 cells deep, normal"),
            std::string::npos);
  EXPECT_NEAR(contact->effective_contact_modulus() / modulus, 1.0, 0.0005);
}

TEST(GreenContact, RefusesOtherSettings) {
  AtomRequest request = rough_request();
  request.settings.minimizer = mechanics::AtomMinimizer::dynamics;
  EXPECT_THROW(make_atomic_contact(request), input::InputError);
  request = rough_request();
  request.settings.bulk = mechanics::AtomBulk::explicit_layers;
  EXPECT_THROW(make_green_contact(request), input::InputError);
  EXPECT_THROW(make_atomic_contact(rough_request())
                   ->solve({Control::nominal_pressure, 0.0}, 0),
               std::domain_error);
  request = rough_request();
  request.settings.depth = {0.0, mechanics::ReferenceUnit::length};
  EXPECT_THROW(make_atomic_contact(request), std::domain_error);
}

} // namespace asperity::md::green_contact_test
