// Tests of suite/robustness/verify.hpp: a correct solution passes, and each
// check fails by its own name on a solution with exactly that error.
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/solver.hpp"
#include "suite/robustness/verify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asperity::robustness::verify_test {

using contact::ContactSolution;
using mechanics::LoadTarget;

constexpr double load = 0.02; // [Pa], E* = 1 Pa

class Verify : public ::testing::Test {
protected:
  Verify() {
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      const double x = static_cast<double>(i % 32) / 32.0;
      const double y = static_cast<double>(i / 32) / 32.0;
      heights_[i] = 0.01 * std::cos(2.0 * std::numbers::pi * x) *
                    std::cos(2.0 * std::numbers::pi * y);
    }
    asked_.heights = heights_;
    asked_.gap_tolerance = 1e-10;
    asked_.long_wave_compliance = 1.0 / std::numbers::pi;
    asked_.short_wave_compliance = asked_.long_wave_compliance / 16.0;
    answer_ = solved(load);
  }

  contact::FourierOperator half_space() const {
    return contact::halfspace_operator(
        grid_, {1.0, 0.0, std::numeric_limits<double>::infinity(), {}});
  }

  ContactSolution solved(double pressure) const {
    contact::FourierOperator elasticity = half_space();
    return contact::solve_contact(
        elasticity, {heights_, 0.0, asked_.gap_tolerance, 500},
        {mechanics::Control::nominal_pressure, pressure});
  }

  /// The name of the first check that fails on the present solution.
  std::string failing_check() const {
    contact::FourierOperator elasticity = half_space();
    const auto failure =
        verify_step(asked_, {mechanics::Control::nominal_pressure, load},
                    answer_, [&](auto pressure, auto displacement) {
                      elasticity.displacement(pressure, displacement);
                    });
    return failure ? failure->check : "";
  }

  /// A node in contact and one far from it.
  std::size_t touching() const { return 0; }

  std::size_t apart() const { return 16; }

  Grid grid_{32, 32, 1.0, 1.0};
  std::vector<double> heights_ = std::vector<double>(grid_.size());
  AskedContact asked_;
  ContactSolution answer_;
};

TEST_F(Verify, PassesACorrectSolution) {
  ASSERT_TRUE(answer_.converged);
  ASSERT_GT(answer_.pressure[touching()], 0.0);
  ASSERT_EQ(answer_.pressure[apart()], 0.0);
  EXPECT_EQ(failing_check(), "");
  EXPECT_FALSE(verify_pair(summary_of(asked_, answer_),
                           summary_of(asked_, solved(1.01 * load))));
  EXPECT_FALSE(verify_same(summary_of(asked_, answer_),
                           summary_of(asked_, solved(load))));
}

TEST_F(Verify, DetectsWhatIsNotANumber) {
  answer_.gap[apart()] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(failing_check(), "finite");
}

TEST_F(Verify, DetectsATensilePressure) {
  answer_.pressure[apart()] = -1e-12;
  EXPECT_EQ(failing_check(), "pressure sign");
}

TEST_F(Verify, DetectsAPressureOnASeparatedSurface) {
  contact::FourierOperator elasticity = half_space();
  const double above_the_crest = 0.0101;
  const auto failure =
      verify_step(asked_, {mechanics::Control::mean_gap, above_the_crest},
                  answer_, [&](auto pressure, auto displacement) {
                    elasticity.displacement(pressure, displacement);
                  });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->check, "apart");
}

TEST_F(Verify, DetectsALoadThatIsNotBalanced) {
  for (double& pressure : answer_.pressure)
    pressure *= 1.0 + 1e-9;
  EXPECT_EQ(failing_check(), "balance");
}

TEST_F(Verify, DetectsAnotherMeanGap) {
  contact::FourierOperator elasticity = half_space();
  const auto failure = verify_step(
      asked_, {mechanics::Control::mean_gap, answer_.mean_gap + 1e-8}, answer_,
      [&](auto pressure, auto displacement) {
        elasticity.displacement(pressure, displacement);
      });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->check, "balance");
}

TEST_F(Verify, DetectsAGapThatDoesNotBelongToThePressure) {
  answer_.gap[apart()] += 1e-8;
  EXPECT_EQ(failing_check(), "gap field");
}

// A pressure that is a hundredth too high at one node of the contact, at the
// right load, has a duality gap beyond the tolerance. NaN in the solution gives
// no bound.
TEST_F(Verify, DetectsAWrongPressure) {
  contact::FourierOperator elasticity = half_space();
  EXPECT_FALSE(verify_certificate(asked_, answer_, elasticity));
  ContactSolution moved = answer_;
  const double extra = 0.01 * moved.pressure[touching()];
  moved.pressure[touching()] += extra;
  moved.pressure[touching() + 32] -= extra;
  const auto failure = verify_certificate(asked_, moved, elasticity);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->check, "certificate");

  answer_.nominal_pressure = 0.0;
  EXPECT_FALSE(verify_certificate(asked_, answer_, elasticity));
}

// The entire solution is displaced into the surface, including the mean gap.
TEST_F(Verify, DetectsAnOverlap) {
  for (double& gap : answer_.gap)
    gap -= 1e-8;
  answer_.mean_gap -= 1e-8;
  EXPECT_EQ(failing_check(), "overlap");
}

TEST_F(Verify, DetectsPressureAcrossAGap) {
  for (double& gap : answer_.gap)
    gap += 1e-8;
  answer_.mean_gap += 1e-8;
  EXPECT_EQ(failing_check(), "complementarity");
}

class VerifyPair : public Verify {
protected:
  std::string failing_pair() const {
    const auto failure = verify_pair(less_, more_);
    const auto reversed = verify_pair(more_, less_);
    EXPECT_EQ(failure.has_value(), reversed.has_value());
    return failure ? failure->check : "";
  }

  StepSummary less_ = summary_of(asked_, answer_);
  StepSummary more_ = summary_of(asked_, solved(1.01 * load));
};

TEST_F(VerifyPair, DetectsAGapThatGrowsUnderLoad) {
  more_.separation = less_.separation + 1e-8;
  EXPECT_EQ(failing_pair(), "monotone gap");
}

TEST_F(VerifyPair, DetectsAnAreaThatShrinksUnderLoad) {
  more_.area = less_.area - 3.0 / 1024.0;
  EXPECT_EQ(failing_pair(), "monotone area");
  less_.may_lose_contact = more_.may_lose_contact = true;
  EXPECT_EQ(failing_pair(), "");
}

// Apart, two gaps are in order whichever is given first.
TEST_F(VerifyPair, TakesTwoGapsWithoutContact) {
  less_ = more_ = {};
  less_.separation = 2e-3;
  more_.separation = 1e-3;
  EXPECT_EQ(failing_pair(), "");
}

// A hundredth of the change p du of the energy is outside its bounds, whose
// slopes differ by a hundredth.
TEST_F(VerifyPair, DetectsEnergyWithoutWork) {
  const double gained = more_.energy - less_.energy;
  more_.energy += 0.011 * gained;
  EXPECT_EQ(failing_pair(), "energy");
  more_.energy -= 0.022 * gained;
  EXPECT_EQ(failing_pair(), "energy");
}

TEST_F(VerifyPair, DetectsAnotherSolutionInOtherUnits) {
  StepSummary scaled = less_;
  scaled.mean_gap *= 1e3;
  scaled.tolerance *= 1e3;
  scaled.energy *= 1e3 * 1e6;
  scaled.nominal_pressure *= 1e6;
  EXPECT_FALSE(verify_same(less_, scaled, 1e3, 1e6));
  scaled.mean_gap += 1e3 * 1e-8;
  EXPECT_TRUE(verify_same(less_, scaled, 1e3, 1e6));
  scaled.mean_gap -= 1e3 * 1e-8;
  scaled.energy *= 1.0001;
  EXPECT_TRUE(verify_same(less_, scaled, 1e3, 1e6));
}

} // namespace asperity::robustness::verify_test
