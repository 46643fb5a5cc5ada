// Tests of md/minimise/newton.hpp and of the second derivatives of
// md/contact/green_system.hpp: Newton's method converges to the state of L-BFGS
// with far fewer evaluations.
#include "base/field_sums.hpp"
#include "base/maximum.hpp"
#include "base/special_numbers.hpp"
#include "md/contact/green_system.hpp"
#include "md/minimise/newton.hpp"
#include "tests/md/rough_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace asperity::md::newton_test {

using mechanics::AtomModes;

constexpr double modulus = 77.2e9 / (1.0 - 0.42 * 0.42);

struct Held {
  AtomModes modes;
  Load::Kind kind;
};

/// Rough enough that atoms lie on slopes and some have a small stiffness.
class EveryLoadKind : public ::testing::TestWithParam<Held> {
protected:
  EveryLoadKind()
      : system(SurfaceStiffness(problems::paper_crystal(), contact.layer(), 16,
                                GetParam().modes),
               contact.interface()) {
    system.set_load(GetParam().kind == Load::Kind::height
                        ? Load{Load::Kind::height, 4.0 * problems::angstrom}
                        : Load{Load::Kind::nominal_pressure, 0.05 * modulus});
  }

  std::vector<double> start() const {
    return system.undeformed(contact.highest() + 3.0 * problems::angstrom);
  }

  /// A random displacement of what may move [m].
  std::vector<double> step(double most, unsigned seed) const {
    std::vector<double> step =
        problems::random_numbers(system.size(), -most, most, seed);
    system.shorten(step, infinity);
    return step;
  }

  problems::RoughContact contact{.rms_height = 1.5 * problems::angstrom};
  GreenSystem system;
};

// The curvature times a step is the reduction of the forces by the step.
// Tolerance: of the largest force, as in interface_curvature_test.
TEST_P(EveryLoadKind, CurvatureIsTheDifferenceOfTheForces) {
  std::vector<double> state = start();
  for (std::size_t i = 0; const double part : step(2e-11, 1))
    state[i++] += part;
  const std::vector<double> along = step(1.0, 2);
  std::vector<double> product(state.size());
  std::vector<double> behind(state.size());
  std::vector<double> ahead(state.size());
  const double length = 1e-14;

  system.linearise(state);
  system.curvature_times(along, product);

  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] -= length * along[i];
  system.energy_and_forces(state, behind);
  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] += 2.0 * length * along[i];
  system.energy_and_forces(state, ahead);
  const double most = largest_magnitude(product);
  ASSERT_GT(most, 0.0);
  for (std::size_t i = 0; i < state.size(); ++i)
    EXPECT_NEAR((behind[i] - ahead[i]) / (2.0 * length), product[i],
                1e-6 * most);
}

// P is symmetric and positive, as conjugate gradients require. Tolerance:
// roundoff of sums over all unknowns.
TEST_P(EveryLoadKind, PreconditionerIsSymmetricAndPositive) {
  system.linearise(start());
  const std::vector<double> first = step(1.0, 3);
  const std::vector<double> second = step(1.0, 4);
  std::vector<double> of_first(first.size());
  std::vector<double> of_second(first.size());

  system.precondition_curved(first, of_first);
  system.precondition_curved(second, of_second);

  EXPECT_GT(dot(first, of_first), 0.0);
  EXPECT_NEAR(dot(second, of_first), dot(first, of_second),
              1e-12 * dot(first, of_first));
}

// The state is that of L-BFGS. Tolerance: both leave a residual of 1e-9, and
// the softest wave of these blocks is at most 1e3 times softer than a pair, so
// that forces agree to 1e-6 of the mean and energies to their roundoff.
TEST_P(EveryLoadKind, EndsWhereLbfgsDoes) {
  RelaxationSettings settings;
  settings.tolerance = 1e-9;
  settings.contact_stiffness = 20.0;
  std::vector<double> by_lbfgs = start();
  std::vector<double> by_newton = start();

  const Relaxation lbfgs = relax(system, by_lbfgs, settings);
  const Relaxation newton = relax_by_newton(system, by_newton, settings);

  ASSERT_TRUE(lbfgs.converged) << lbfgs.note;
  ASSERT_TRUE(newton.converged) << newton.note;
  EXPECT_LE(newton.residual, settings.tolerance);
  EXPECT_NEAR(newton.energy / lbfgs.energy, 1.0, 1e-9);
  const std::vector<double> reference = normal_forces(system, by_lbfgs);
  const std::vector<double> forces = normal_forces(system, by_newton);
  double mean = 0.0;
  for (const double force : reference)
    mean += std::abs(force) / static_cast<double>(reference.size());
  for (std::size_t i = 0; i < reference.size(); ++i)
    EXPECT_NEAR(forces[i], reference[i], 1e-6 * mean);
  const Inspection found = system.interface().inspect(
      layer_of(system, by_newton), 2.2e-10, problems::contact_distance);
  EXPECT_EQ(found.below_substrate, 0);
  EXPECT_EQ(found.close_pairs, 0);
  EXPECT_LT(newton.evaluations, lbfgs.evaluations);
  EXPECT_LE(newton.linearisations, newton.evaluations);
  EXPECT_GE(newton.products, newton.linearisations);
}

// No atom moves farther than allowed in one step.
TEST_P(EveryLoadKind, KeepsToTheLargestStep) {
  const std::vector<double> from = start();
  std::vector<double> state = from;
  RelaxationSettings settings;
  settings.largest_step = 1e-12;
  settings.max_evaluations = 2;

  const Relaxation answer = relax_by_newton(system, state, settings);

  EXPECT_EQ(answer.evaluations, 2);
  EXPECT_NE(answer.note.find("not converged after 2 evaluations"),
            std::string::npos)
      << answer.note;
  EXPECT_NE(state, from);
  for (std::size_t i = 0; i < state.size(); ++i)
    EXPECT_LE(std::abs(state[i] - from[i]), 1e-12 * (1.0 + 1e-3));
}

// The step of an atom that would move too far is shortened without changing the
// others. Tolerance: what is prescribed is subtracted again, at most the means
// of the step of one atom.
TEST_P(EveryLoadKind, ShortensOneAtomAlone) {
  std::vector<double> moved = step(1e-13, 5);
  moved[2 * contact.layer().size() + 9] = 1e-9;
  const std::vector<double> before = moved;

  system.shorten(moved, 1e-11);

  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (i % contact.layer().size() != 9) {
      EXPECT_NEAR(moved[i], before[i], 1e-13);
    }
  }
  EXPECT_NEAR(moved[2 * contact.layer().size() + 9], 1e-11, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(
    Loads, EveryLoadKind,
    ::testing::Values(Held{AtomModes::vector, Load::Kind::nominal_pressure},
                      Held{AtomModes::vector, Load::Kind::height},
                      Held{AtomModes::normal, Load::Kind::nominal_pressure},
                      Held{AtomModes::normal, Load::Kind::height}));

TEST(RelaxByNewton, StopsOnRequest) {
  const problems::RoughContact contact;
  GreenSystem system(SurfaceStiffness(problems::paper_crystal(),
                                      contact.layer(), 16, AtomModes::vector),
                     contact.interface());
  system.set_load({Load::Kind::nominal_pressure, 1e9});
  std::vector<double> state = system.undeformed(contact.highest() + 4e-10);
  std::vector<Progress> seen;

  const Relaxation answer =
      relax_by_newton(system, state, {}, [&](const Progress& progress) {
        seen.push_back(progress);
        return seen.size() < 3;
      });

  EXPECT_FALSE(answer.converged);
  EXPECT_EQ(answer.note, "stopped by the caller");
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_LT(seen[2].energy, seen[0].energy);
  state.pop_back();
  EXPECT_THROW(relax_by_newton(system, state, {}), std::domain_error);
}

} // namespace asperity::md::newton_test
