// Tests of numbers that are not finite: the full model refuses them by name, no
// solution with one is accepted, and the comparisons of the tests themselves
// fail with them.
#include "base/special_numbers.hpp"
#include "fem/block/full_block.hpp"
#include "fem/newton/contact_newton.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace asperity::fem::not_finite_test {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;

const Grid grid{4, 4, 1e-6, 1e-6};

std::unique_ptr<FullBlock> small_block() {
  return make_full_block(
      grid, 1, layered_block(grid.spacing_x(), 1e-6, FarBoundary::clamped));
}

BlockContact contact_of(ContactLaw law) {
  return {law, 100.0 * soft_modulus / grid.spacing_x(), 1e-8, 50};
}

std::string refusal(std::vector<double> heights,
                    const mechanics::LoadTarget& load,
                    const BlockContact& contact) {
  return tests::message_of<std::domain_error>(
      [&] { static_cast<void>(small_block()->solve(heights, load, contact)); });
}

TEST(ComparisonsOfFields, FailOnNumbersThatAreNotFinite) {
  for (const double bad : {not_a_number, infinity, -infinity}) {
    EXPECT_FALSE(largest_magnitude(std::vector{bad, 1.0}) < 2.0);
    EXPECT_FALSE(largest_magnitude(std::vector{1.0, bad}) < 2.0);
    EXPECT_FALSE(
        largest_difference(std::vector{1.0, bad}, std::vector{1.0, bad}) < 2.0);
    EXPECT_FALSE(
        largest_difference(std::vector{bad, 1.0}, std::vector{1.0, 1.0}) < 2.0);
  }
}

TEST(ComparisonsOfFields, FailOnFieldsThatAreEmptyOrOfTwoSizes) {
  EXPECT_FALSE(largest_magnitude({}) < 1.0);
  EXPECT_FALSE(largest_difference({}, {}) < 1.0);
  EXPECT_FALSE(largest_difference(std::vector{1.0}, {}) < 1.0);
  EXPECT_FALSE(largest_difference(std::vector{1.0}, std::vector{1.0, 1.0}) <
               1.0);
}

TEST(ComparisonsOfFields, FindTheLargest) {
  EXPECT_EQ(largest_magnitude(std::vector{1.0, -3.0, 2.0}), 3.0);
  EXPECT_EQ(largest_difference(std::vector{1.0, -3.0}, std::vector{2.0, 1.0}),
            4.0);
}

TEST(FullBlockTest, RefusesHeightsThatAreNotFinite) {
  for (const double bad : {not_a_number, infinity, -infinity})
    for (const ContactLaw law : {ContactLaw::penalty, ContactLaw::hard})
      for (const Control control :
           {Control::nominal_pressure, Control::mean_gap}) {
        std::vector<double> heights(grid.size(), 0.0);
        heights[5] = bad;

        const std::string words =
            refusal(heights, {control, 1e-9}, contact_of(law));

        EXPECT_NE(words.find("height of node 5"), std::string::npos) << words;
      }
}

TEST(FullBlockTest, RefusesSettingsThatAreNotFinite) {
  const std::vector<double> heights(grid.size(), 0.0);
  const BlockContact good = contact_of(ContactLaw::penalty);
  for (const double bad : {not_a_number, infinity}) {
    EXPECT_NE(refusal(heights, {Control::mean_gap, bad}, good).find("mean gap"),
              std::string::npos);
    EXPECT_NE(refusal(heights, {Control::nominal_pressure, bad}, good)
                  .find("nominal pressure"),
              std::string::npos);
    BlockContact contact = good;
    contact.penalty = bad;
    EXPECT_NE(
        refusal(heights, {Control::mean_gap, 1e-9}, contact).find("penalty"),
        std::string::npos);
    contact = good;
    contact.tolerance = bad;
    EXPECT_NE(
        refusal(heights, {Control::mean_gap, 1e-9}, contact).find("tolerance"),
        std::string::npos);
  }
}

TEST(FullBlockTest, RefusesPressuresThatAreNotFinite) {
  std::vector<double> pressure(grid.size(), 1e6);
  pressure[3] = not_a_number;
  const auto block = small_block();

  EXPECT_THROW(static_cast<void>(block->displacement(pressure)),
               std::domain_error);
  EXPECT_THROW(static_cast<void>(block->displacement(
                   std::span<const double>(pressure).first(3))),
               std::domain_error);
}

// A state that is not finite has not converged, for any law and control. A
// maximum of residuals drops NaN, and a pressure of max(0, NaN) is 0.
TEST(ContactNewton, DoesNotConvergeOnStatesThatAreNotFinite) {
  const BlockSystem system(boxes_problem(grid, 1, {soft_modulus, 0.3}, 1e-6));
  for (const double bad : {not_a_number, infinity, -infinity})
    for (const ContactLaw law :
         {ContactLaw::penalty, ContactLaw::augmented, ContactLaw::hard})
      for (const mechanics::LoadTarget& load :
           {mechanics::LoadTarget{Control::nominal_pressure, 1e6},
            mechanics::LoadTarget{Control::mean_gap, 1e-9}}) {
        ContactNewton newton(system, LinearSolver::direct);
        std::vector<double> heights(system.contact().size(), 0.0);
        heights[5] = bad;
        BlockSolution found;

        newton.solve(heights, 1e-9, load, contact_of(law), found);

        EXPECT_FALSE(found.converged)
            << "law " << static_cast<int>(law) << ", control "
            << static_cast<int>(load.control) << ", height " << bad
            << ": residual " << found.residual << ", gap " << found.mean_gap;
        EXPECT_NE(found.note, "");
      }
}

/// A solver that never converges.
class LazyBlock final : public BlockInverse {
public:
  void vmult(Vector&, const Vector&) const override {}

  void prepare(std::span<const double>, const std::vector<bool>&,
               bool) override {}

  LinearSolution solve(Vector&, const Vector&, double,
                       int most_iterations) override {
    return {false, most_iterations, 1.0, 1.0};
  }

  int setups() const override { return 1; }

  std::string name() const override { return "lazy"; }

  std::size_t bytes() const override { return 0; }
};

// The direct solver goes on where conjugate gradients do not converge, and the
// note says so, once.
TEST(ContactNewton, SaysThatTheDirectSolverGoesOn) {
  const BlockSystem system(boxes_problem(grid, 1, {soft_modulus, 0.3}, 1e-6));
  ContactNewton newton(system, LinearSolver::multigrid,
                       std::make_unique<LazyBlock>());
  BlockSolution found, next;
  const std::vector<double> heights(system.contact().size(), 0.0);

  newton.solve(heights, 1e-9, {Control::mean_gap, -1e-9},
               contact_of(ContactLaw::penalty), found);
  newton.solve(heights, 1e-9, {Control::mean_gap, -2e-9},
               contact_of(ContactLaw::penalty), next);

  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.note, "lazy has not converged in 500 iterations; the "
                        "linear solver is now direct (MUMPS)");
  EXPECT_TRUE(next.converged);
  EXPECT_EQ(next.note, "");
}

} // namespace asperity::fem::not_finite_test
