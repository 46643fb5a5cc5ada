// Tests of contact/solvers/load_sequence.hpp: an initial guess changes the
// number of iterations and not the solution, and each contact law has its
// documented meaning.
#include "contact/solvers/load_sequence.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::contact::load_sequence_test {

using Kind = mechanics::Control;

class Sequence : public ::testing::Test {
protected:
  static constexpr Grid grid{128, 128, 1.0, 1.0};
  std::vector<double> heights = problems::rough_heights(grid, {});
  double rms_height = problems::rms(heights);
  double tolerance = 1e-9 * rms_height;
  FourierOperator elasticity = problems::unit_halfspace(grid);

  LoadSequence sequence(mechanics::ContactLaw law, double penalty = 0.0) const {
    return {elasticity.clone(), heights, {law, penalty}, tolerance, 2000};
  }

  ContactSolution cold(double pressure, double local_compliance = 0.0) {
    return solve_contact(elasticity,
                         {heights, local_compliance, tolerance, 2000},
                         {Kind::nominal_pressure, pressure});
  }
};

// Tolerance: each solution is accurate to `tolerance` in the gap.
TEST_F(Sequence, GivesTheSolutionOfAColdStart) {
  LoadSequence program = sequence(mechanics::ContactLaw::hard);
  int warm_iterations = 0;
  int cold_iterations = 0;
  for (const double pressure : {0.01, 0.02, 0.04, 0.08, 0.16, 0.05, 0.01}) {
    const ContactSolution warm =
        program.solve({Kind::nominal_pressure, pressure});
    const ContactSolution fresh = cold(pressure);

    ASSERT_TRUE(warm.converged);
    EXPECT_NEAR(warm.mean_gap, fresh.mean_gap, 2.0 * tolerance);
    warm_iterations += warm.iterations;
    cold_iterations += fresh.iterations;
  }
  EXPECT_LT(warm_iterations, cold_iterations);
}

TEST_F(Sequence, CoarseStartSavesFineIterations) {
  const ContactProblem problem{heights, 0.0, tolerance, 2000};
  const mechanics::LoadTarget target{Kind::nominal_pressure, 0.02};

  const std::vector<double> start =
      coarse_start(elasticity, problem, target, 1e-3 * rms_height);
  const ContactSolution from_coarse =
      solve_contact(elasticity, problem, target, start);

  ASSERT_EQ(start.size(), heights.size());
  EXPECT_LT(from_coarse.iterations, cold(0.02).iterations);
}

// Verifies that the solution does not depend on the penalty of the
// augmentation, down to a millionth of the stiffness of the grid's waves.
// Tolerance: each solution is accurate to `tolerance` in the gap.
TEST_F(Sequence, AugmentsAnyPenalty) {
  const double hard = cold(0.05).mean_gap;
  for (const double penalty : {1e-6, 1.0, 1e15}) {
    LoadSequence program =
        sequence(mechanics::ContactLaw::augmented, penalty / grid.spacing_x());
    const ContactSolution found = program.solve({Kind::nominal_pressure, 0.05});

    ASSERT_TRUE(found.converged) << penalty << ": " << found.note;
    EXPECT_NEAR(found.mean_gap, hard, 2.0 * tolerance) << penalty;
  }
}

// A penalty far softer than the elastic surface carries a load whose
// penetration is a million times the heights: every node is in contact and the
// mean gap is -p_0/k. Tolerance: (8 + N/8) eps of it, as documented.
TEST_F(Sequence, SolvesWithAVerySoftPenalty) {
  const double penalty = 1e-6 / grid.spacing_x();
  LoadSequence program = sequence(mechanics::ContactLaw::penalty, penalty);

  const ContactSolution found = program.solve({Kind::nominal_pressure, 100.0});

  ASSERT_TRUE(found.converged) << found.note;
  EXPECT_NEAR(found.mean_gap * penalty / -100.0, 1.0, 2056.0 * 2.3e-16);
}

TEST_F(Sequence, FollowsAGapHistory) {
  LoadSequence by_pressure = sequence(mechanics::ContactLaw::hard);
  LoadSequence by_gap = sequence(mechanics::ContactLaw::hard);
  for (const double pressure : {0.01, 0.03, 0.1, 0.3}) {
    const double gap =
        by_pressure.solve({Kind::nominal_pressure, pressure}).mean_gap;
    const ContactSolution solution = by_gap.solve({Kind::mean_gap, gap});

    ASSERT_TRUE(solution.converged);
    EXPECT_NEAR(solution.nominal_pressure / pressure, 1.0, 1e-6);
  }
}

// Steps under gap control start from one another. A step under the other
// control does not, since an amount in Pa cannot be extrapolated from amounts
// in m: it equals that of a new sequence, bit for bit. The steps are short: the
// coarse-to-fine guess is as good for long ones.
TEST_F(Sequence, RestartsWhenTheControlChanges) {
  LoadSequence program = sequence(mechanics::ContactLaw::hard);
  int warm_iterations = 0;
  int cold_iterations = 0;
  for (const double gap : {1.5, 1.49, 1.48, 1.47}) {
    const mechanics::LoadTarget target{Kind::mean_gap, gap * rms_height};
    warm_iterations += program.solve(target).iterations;
    cold_iterations +=
        sequence(mechanics::ContactLaw::hard).solve(target).iterations;
  }
  EXPECT_LT(warm_iterations, cold_iterations);

  const mechanics::LoadTarget changed{Kind::nominal_pressure, 1.3 * rms_height};
  EXPECT_EQ(program.solve(changed).pressure,
            sequence(mechanics::ContactLaw::hard).solve(changed).pressure);
}

// Verifies that the initial guess of the next step has a pressure where a gap
// closes, which saves iterations. Margin: between the measured count and that
// of an extrapolation of the pressures alone.
TEST_F(Sequence, ExtrapolatesNewContacts) {
  tolerance = 1e-5 * rms_height;
  LoadSequence program = sequence(mechanics::ContactLaw::hard);
  int iterations = 0;
  for (int step = 0; step < 16; ++step)
    iterations +=
        program.solve({Kind::nominal_pressure, 0.003 * std::pow(1.36, step)})
            .iterations;

  EXPECT_LE(iterations, 130);
}

// Verifies that a sequence that restores the saved state of another continues
// as that one does, bit for bit, under either control.
TEST_F(Sequence, ContinuesFromTheSavedStateOfAnother) {
  for (const Kind kind : {Kind::nominal_pressure, Kind::mean_gap}) {
    const double unit = kind == Kind::mean_gap ? rms_height : 0.05;
    LoadSequence first = sequence(mechanics::ContactLaw::hard);
    first.solve({kind, 1.5 * unit});
    first.solve({kind, 1.4 * unit});
    LoadSequence second = sequence(mechanics::ContactLaw::hard);

    second.recall(first.memory());

    EXPECT_EQ(second.memory(), first.memory());
    const ContactSolution found = second.solve({kind, 1.3 * unit});
    const ContactSolution expected = first.solve({kind, 1.3 * unit});
    EXPECT_EQ(found.iterations, expected.iterations);
    EXPECT_EQ(found.pressure, expected.pressure);
  }
}

// The gap of a penalty contact is -p/k, and its limit k -> inf is hard contact.
TEST_F(Sequence, PenaltyIsALocalSpring) {
  const double spacing = grid.spacing_x();
  LoadSequence soft = sequence(mechanics::ContactLaw::penalty, 100.0 / spacing);
  EXPECT_EQ(soft.local_compliance(), spacing / 100.0);
  const ContactSolution solution = soft.solve({Kind::nominal_pressure, 0.05});
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (solution.pressure[i] > 0.0)
      ASSERT_NEAR(solution.gap[i], -solution.pressure[i] * spacing / 100.0,
                  tolerance);
    else
      ASSERT_GE(solution.gap[i], -tolerance);
  }
  LoadSequence stiff = sequence(mechanics::ContactLaw::penalty, 1e12 / spacing);
  LoadSequence hard = sequence(mechanics::ContactLaw::hard);
  EXPECT_NEAR(stiff.solve({Kind::nominal_pressure, 0.05}).mean_gap,
              hard.solve({Kind::nominal_pressure, 0.05}).mean_gap,
              2.0 * tolerance);
}

// Verifies that augmentation removes the penetration of any penalty, under
// either control, and that the gap is measured to the given surface.
TEST_F(Sequence, AugmentedPenaltyConvergesToHardContact) {
  for (const double reduced_penalty : {1.0, 100.0}) {
    LoadSequence augmented = sequence(mechanics::ContactLaw::augmented,
                                      reduced_penalty / grid.spacing_x());
    const ContactSolution hard = cold(0.05);
    const ContactSolution by_pressure =
        augmented.solve({Kind::nominal_pressure, 0.05});
    const ContactSolution by_gap =
        augmented.solve({Kind::mean_gap, hard.mean_gap});

    ASSERT_TRUE(by_pressure.converged) << by_pressure.note;
    ASSERT_TRUE(by_gap.converged) << by_gap.note;
    EXPECT_EQ(augmented.local_compliance(), 0.0);
    EXPECT_NEAR(by_pressure.mean_gap, hard.mean_gap, 3.0 * tolerance);
    EXPECT_NEAR(by_gap.nominal_pressure / 0.05, 1.0, 1e-6);
    EXPECT_GE(*std::min_element(by_pressure.gap.begin(), by_pressure.gap.end()),
              -tolerance);
  }
}

// With one deep node in a flat surface, which is the last to touch, the
// multipliers converge too slowly. The solver of hard contact, which has the
// same solution, completes the step, and the note states it.
TEST(AugmentedContact, IsFinishedByHardContact) {
  const Grid grid{32, 32, 1.0, 1.0};
  std::vector<double> heights(grid.size(), 1.0 / 1024.0);
  heights[grid.index(16, 16)] -= 1.0;
  const double scale = problems::rms(heights);
  FourierOperator elasticity = halfspace_operator(
      grid, {.contact_modulus = 1.0,
             .thickness = std::numeric_limits<double>::infinity()});
  const ContactProblem problem{heights, 0.02 / 32.0, 1e-8 * scale};
  const mechanics::LoadTarget target{mechanics::Control::mean_gap,
                                     0.01 * scale};

  const ContactSolution answer =
      solve_augmented(elasticity, problem, target, {});

  EXPECT_TRUE(answer.converged);
  EXPECT_NE(answer.note.find("finished by the solver of hard contact"),
            std::string::npos)
      << answer.note;
  EXPECT_LE(problems::complementarity_error(
                elasticity, {heights, 0.0, problem.gap_tolerance}, answer),
            1.1 * problem.gap_tolerance);
}

} // namespace asperity::contact::load_sequence_test
