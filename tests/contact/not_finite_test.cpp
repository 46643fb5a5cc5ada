// Verifies that for any number that is not finite in a contact solver the
// solution either passes an independent check or is not converged with a
// reason, and that no solver ends by an exception.
#include "base/special_numbers.hpp"
#include "contact/solvers/active_set.hpp"
#include "contact/solvers/contact_state.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/polonsky_keer.hpp"
#include "tests/contact/faulty_operator.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace asperity::contact::not_finite_test {

using problems::Fault;
using problems::FaultyOperator;
using Kind = mechanics::Control;

using Solve = ContactSolution (*)(SurfaceOperator&, const ContactProblem&,
                                  const mechanics::LoadTarget&,
                                  std::span<const double>);

struct Solver {
  const char* name;
  Solve solve;
};

constexpr std::array solvers{Solver{"solve_contact", solve_contact},
                             Solver{"active_set", active_set},
                             Solver{"polonsky_keer", polonsky_keer},
                             Solver{"solve_augmented", solve_augmented}};

class FaultyContact : public ::testing::Test {
protected:
  Grid grid{16, 16, 1.0, 1.0};
  std::vector<double> heights =
      problems::rough_heights(grid, {0.8, 2.0, 4.0, 3});
  double tolerance = 1e-9 * problems::rms(heights);
  FourierOperator exact = problems::unit_halfspace(grid);

  /// Passes the check with the correct operator, or is not converged with a
  /// reason.
  void expect_verified_or_failed(const ContactSolution& answer,
                                 const ContactProblem& problem,
                                 const mechanics::LoadTarget& target) {
    if (!answer.converged) {
      EXPECT_FALSE(answer.note.empty());
      ++failed;
      return;
    }
    EXPECT_LE(problems::complementarity_error(exact, problem, answer),
              1.01 * tolerance);
    EXPECT_NEAR(target.control == Kind::mean_gap ? answer.mean_gap
                                                 : answer.nominal_pressure,
                target.amount, 1e-12);
    ++verified;
  }

  int verified = 0;
  int failed = 0;
};

TEST_F(FaultyContact, NoSolverConvergesOnANumberThatIsNotFinite) {
  for (const Solver& solver : solvers)
    for (const auto call : {Fault::Call::displacement, Fault::Call::change,
                            Fault::Call::estimate})
      for (const double value : {not_a_number, infinity, -infinity})
        for (const bool is_whole : {false, true})
          for (int after = 0; after < 12; ++after)
            for (const mechanics::LoadTarget target :
                 {mechanics::LoadTarget{Kind::nominal_pressure, 0.05},
                  mechanics::LoadTarget{Kind::mean_gap, 0.05}}) {
              SCOPED_TRACE(::testing::Message()
                           << solver.name << ", call " << static_cast<int>(call)
                           << " after " << after << " is " << value
                           << (is_whole ? " everywhere" : ""));
              const bool is_augmented = solver.solve == solve_augmented;
              const ContactProblem problem{heights, 0.0, tolerance, 500};
              ContactProblem given = problem;
              if (is_augmented)
                given.local_compliance = 1e-3;
              FaultyOperator faulty(exact, {call, after, 1, is_whole, value});
              ContactSolution answer;
              ASSERT_NO_THROW(answer = solver.solve(faulty, given, target, {}));
              expect_verified_or_failed(answer, problem, target);
            }
  RecordProperty("verified", verified);
  RecordProperty("not converged", failed);
  EXPECT_GT(verified, 0);
  EXPECT_GT(failed, 0);
}

// Verifies that a fault in one load step, also on the coarse grid of its
// initial guess, has no effect on the next one.
TEST_F(FaultyContact, ALoadSequenceContinuesAfterAFault) {
  grid = {64, 64, 1.0, 1.0};
  heights = problems::rough_heights(grid, {});
  tolerance = 1e-9 * problems::rms(heights);
  exact = problems::unit_halfspace(grid);
  for (const mechanics::ContactLaw law :
       {mechanics::ContactLaw::hard, mechanics::ContactLaw::augmented})
    for (int after = 0; after < 30; after += 3) {
      SCOPED_TRACE(after);
      LoadSequence sequence(std::make_unique<FaultyOperator>(
                                exact, Fault{Fault::Call::displacement, after,
                                             1, true, not_a_number}),
                            heights, {law, 1e3}, tolerance, 500);
      for (const double pressure : {0.02, 0.03, 0.05, 0.08}) {
        const mechanics::LoadTarget target{Kind::nominal_pressure, pressure};
        expect_verified_or_failed(sequence.solve(target),
                                  {heights, 0.0, tolerance, 500}, target);
      }
    }
  EXPECT_GT(verified, 3 * failed);
  EXPECT_GT(failed, 0);
}

// A step so long that it leaves no node in contact to carry the load.
TEST_F(FaultyContact, AStepWithoutContactIsNotASolution) {
  const ContactProblem problem{heights, 0.0, tolerance, 500};
  const mechanics::LoadTarget target{Kind::nominal_pressure, 0.05};
  ContactState state(exact, problem, target, {});
  state.update_residual();
  std::vector<float> direction(heights.size(), 1.0F);
  state.advance(1e6F, direction);
  state.update_residual();
  EXPECT_TRUE(state.is_at_end());
  const ContactSolution answer = std::move(state).solution();
  EXPECT_FALSE(answer.converged);
  EXPECT_NE(answer.note.find("not finite"), std::string::npos) << answer.note;

  ProjectedState plain(exact, problem, target, {});
  plain.update_residual();
  plain.advance(1e6, std::vector<double>(heights.size(), 1.0), {});
  plain.update_residual();
  EXPECT_TRUE(plain.is_at_end());
  const ContactSolution plain_answer = std::move(plain).solution();
  EXPECT_FALSE(plain_answer.converged);
  EXPECT_NE(plain_answer.note.find("not finite"), std::string::npos)
      << plain_answer.note;
}

// A tolerance below the roundoff of the recurrence must not be met by roundoff
// alone: convergence is measured in the gap of the returned solution.
TEST_F(FaultyContact, PolonskyAndKeerConvergeInTheGapTheyReturn) {
  for (const double share : {1e-12, 1e-13, 1e-14, 3e-15, 1e-15}) {
    const ContactProblem problem{heights, 0.0, share * problems::rms(heights),
                                 3000};
    const ContactSolution answer =
        polonsky_keer(exact, problem, {Kind::nominal_pressure, 0.3});
    double shown = 0.0;
    for (std::size_t i = 0; i < heights.size(); ++i)
      if (answer.pressure[i] > 0.0 || answer.gap[i] < 0.0)
        shown = std::max(shown, std::abs(answer.gap[i]));
    EXPECT_TRUE(!answer.converged || shown <= problem.gap_tolerance)
        << share << ": " << shown;
  }
}

TEST_F(FaultyContact, ASavedStateThatIsNotFiniteIsRefused) {
  LoadSequence sequence(exact.clone(), heights,
                        {mechanics::ContactLaw::hard, 0.0}, tolerance, 500);
  sequence.solve({Kind::nominal_pressure, 0.05});
  for (const double bad : {not_a_number, infinity, -infinity}) {
    std::vector<double> memory = sequence.memory();
    memory.back() = bad;
    LoadSequence other(exact.clone(), heights,
                       {mechanics::ContactLaw::hard, 0.0}, tolerance, 500);
    EXPECT_THROW(other.recall(memory), std::domain_error) << bad;
  }
}

// Verifies that the check used by all contact tests rejects solutions with a
// number that is not finite and fields of another size.
TEST_F(FaultyContact, TheCheckItselfDetectsEachFault) {
  const ContactProblem problem{heights, 0.0, tolerance, 500};
  const ContactSolution good =
      solve_contact(exact, problem, {Kind::nominal_pressure, 0.05});
  const auto error_of = [&](const ContactProblem& given,
                            const ContactSolution& answer) {
    return problems::complementarity_error(exact, given, answer);
  };
  ASSERT_LE(error_of(problem, good), 1.01 * tolerance);
  for (const double bad : {not_a_number, infinity, -infinity})
    for (const std::size_t at : {std::size_t{0}, heights.size() - 1}) {
      ContactSolution answer = good;
      answer.pressure[at] = bad;
      EXPECT_FALSE(error_of(problem, answer) < 1e300);
      answer = good;
      answer.gap[at] = bad;
      EXPECT_FALSE(error_of(problem, answer) < 1e300);
      std::vector<double> broken = heights;
      broken[at] = bad;
      EXPECT_FALSE(error_of({broken, 0.0, tolerance, 500}, good) < 1e300);
    }
  ContactSolution shorter = good;
  shorter.pressure.pop_back();
  EXPECT_FALSE(error_of(problem, shorter) < 1e300);
  EXPECT_FALSE(error_of(problem, {}) < 1e300);
}

// The smallest grids, and a grid of one row: one node, or one node in contact.
TEST(SmallestContacts, AreSolvedAndVerified) {
  for (const Grid& grid : {Grid{1, 1, 1.0, 1.0}, Grid{2, 1, 1.0, 0.5},
                           Grid{2, 2, 1.0, 1.0}, Grid{8, 8, 1.0, 1.0}}) {
    FourierOperator elasticity = problems::unit_halfspace(grid);
    std::vector<double> needle(grid.size(), 0.0);
    needle.back() = 1.0;
    const std::vector<double> flat(grid.size(), 0.0);
    for (const std::vector<double>& heights : {needle, flat})
      for (const double compliance : {0.0, 1e-2})
        for (const double pressure : {1e-6, 1e-3, 10.0})
          for (const Solver& solver : solvers) {
            if (solver.solve == solve_augmented && compliance == 0.0)
              continue;
            SCOPED_TRACE(::testing::Message()
                         << solver.name << " " << grid.points_x << " x "
                         << grid.points_y << " at " << pressure);
            ContactProblem problem{heights, compliance, 1e-9, 500};
            const mechanics::LoadTarget target{Kind::nominal_pressure,
                                               pressure};
            const ContactSolution answer =
                solver.solve(elasticity, problem, target, {});
            ASSERT_TRUE(answer.converged) << answer.note;
            if (solver.solve == solve_augmented)
              problem.local_compliance = 0.0;
            EXPECT_LE(
                problems::complementarity_error(elasticity, problem, answer),
                1.01 * problem.gap_tolerance);
            EXPECT_NEAR(answer.nominal_pressure / pressure, 1.0, 1e-12);
            const ContactSolution by_gap =
                solver.solve(elasticity, {heights, compliance, 1e-9, 500},
                             {Kind::mean_gap, 2.0}, {}); // out of contact
            if (by_gap.converged) {
              EXPECT_EQ(by_gap.nominal_pressure, 0.0);
            } else { // C alone is singular where every node is active
              EXPECT_EQ(solver.solve, active_set);
              EXPECT_FALSE(by_gap.note.empty());
            }
          }
  }
}

} // namespace asperity::contact::not_finite_test
