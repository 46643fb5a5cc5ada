// Tests of suite/robustness/instance_report.hpp: how a step without a solution
// counts.
#include "suite/robustness/instance_report.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace asperity::robustness::instance_report_test {

const std::string advice =
    "the linear solver did not converge; linear_solver must be \"direct\" for "
    "this block";

Outcome outcome_of(std::string note) {
  return outcome_of_note(note, []() -> std::optional<std::string> {
    ADD_FAILURE() << "the direct solver is not advised";
    return {};
  });
}

TEST(OutcomeOfNote, ANoteOfWhatIsAllowedIsARefusal) {
  EXPECT_EQ(outcome_of("the mean gap is -1 m, but must be >= 0 m"),
            Outcome::refused);
  EXPECT_EQ(outcome_of("the contact set did not converge"),
            Outcome::not_converged);
}

TEST(OutcomeOfNote, AnAdvisedSolverThatSolvesTheStepMakesARefusal) {
  std::string note = advice;
  int solutions = 0;

  const Outcome outcome =
      outcome_of_note(note, [&]() -> std::optional<std::string> {
        ++solutions;
        return {};
      });

  EXPECT_EQ(outcome, Outcome::refused);
  EXPECT_EQ(note, advice);
  EXPECT_EQ(solutions, 1);
}

TEST(OutcomeOfNote, AnAdvisedSolverThatFailsIsAFailureWithItsReason) {
  std::string note = advice;

  const Outcome outcome = outcome_of_note(
      note, []() -> std::optional<std::string> { return "singular matrix"; });

  EXPECT_EQ(outcome, Outcome::not_converged);
  EXPECT_EQ(note, advice + "; but the direct solver: singular matrix");
  EXPECT_FALSE(is_good(outcome));
}

TEST(OutcomeOfNote, SolutionsDoNotConverge) {
  EXPECT_EQ(name_of(Outcome::not_converged), "did not converge");
}

} // namespace asperity::robustness::instance_report_test
