// Tests of fem/block/full_block.hpp. The reference is the condensed compliance
// with the projected solver of contact/, which shares nothing with the full
// model but deal.II's cell matrices.
#include "contact/operators/fourier_operator.hpp"
#include "contact/solvers/solver.hpp"
#include "fem/block/full_block.hpp"
#include "fem/waves/condensed_q1.hpp"
#include "fem/waves/q2_operator.hpp"
#include "tests/fem/blocks.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>
#include <string>

namespace asperity::fem::full_block_test {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;

/// Waves of up to three periods per side, rms about 1 nm on a micrometre.
std::vector<double> rough_heights(const Grid& grid) {
  const std::vector<double> phases = random_field(16, 3);
  std::vector<double> heights(grid.size(), 0.0);
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      for (int j = 1; j < 16; ++j) {
        const double turn = (j % 4) * static_cast<double>(ix) / grid.points_x +
                            (j / 4) * static_cast<double>(iy) / grid.points_y +
                            phases[static_cast<std::size_t>(j)];
        heights[grid.index(ix, iy)] +=
            1e-9 / (j % 4 + j / 4) * std::cos(2.0 * std::numbers::pi * turn);
      }
  return heights;
}

std::unique_ptr<contact::SurfaceOperator>
condensed_block(const Grid& grid, int degree, const LayeredBlock& block) {
  if (degree == 1)
    return std::make_unique<contact::FourierOperator>(
        grid, condensed_compliance_q1(grid, block));
  return std::make_unique<Q2Operator>(condensed_compliance_q2(grid, block));
}

struct ContactCase {
  int degree;
  FarBoundary far_boundary;
  ContactLaw law;
  double penalty; ///< in E/h
  Control control;
  std::vector<double> loads; ///< [Pa] or [m]
  int points = 10;           ///< nodes per side
};

class CondensedAndFullBlock : public ::testing::TestWithParam<ContactCase> {
protected:
  const Grid grid_{GetParam().points, GetParam().points, 1e-6, 1e-6};
  const double penalty_ = GetParam().penalty * soft_modulus / grid_.spacing_x();
  const LayeredBlock block_ =
      layered_block(GetParam().degree * grid_.spacing_x(), grid_.length_x,
                    GetParam().far_boundary);
  const std::vector<double> heights_ = rough_heights(grid_);

  contact::ContactSolution condensed(double load) const {
    const auto elasticity = condensed_block(grid_, GetParam().degree, block_);
    const bool is_penalty = GetParam().law == ContactLaw::penalty;
    const auto kind = GetParam().control == Control::mean_gap
                          ? mechanics::Control::mean_gap
                          : mechanics::Control::nominal_pressure;
    return contact::solve_contact(
        *elasticity, {heights_, is_penalty ? 1.0 / penalty_ : 0.0, 1e-19, 2000},
        {kind, load});
  }

  void expect_same_curve(LinearSolver solver) const {
    const auto full = make_full_block(grid_, GetParam().degree, block_, solver);
    for (const double load : GetParam().loads) {
      const contact::ContactSolution expected = condensed(load);

      const BlockSolution found =
          full->solve(heights_, {GetParam().control, load},
                      {GetParam().law, penalty_, 1e-9, 200});

      ASSERT_TRUE(expected.converged) << expected.note;
      ASSERT_TRUE(found.converged) << found.note;
      EXPECT_LE(found.residual, 1e-9);
      EXPECT_NEAR(found.mean_gap, expected.mean_gap, 1e-7 * 1e-9);
      EXPECT_NEAR(found.nominal_pressure / expected.nominal_pressure, 1.0,
                  1e-7);
      EXPECT_LT(largest_difference(found.pressure, expected.pressure),
                1e-7 * largest_magnitude(expected.pressure));
      EXPECT_LT(largest_difference(found.gap, expected.gap), 1e-7 * 1e-9);
    }
  }
};

// Verifies that the full model gives the contact curve of the condensed one.
// Tolerance: the required 1e-7; the projected solver converges to 1e-10 of the
// rms height and the augmentation to the same, and the loads differ by no more
// than that times the stiffness. Up to 16 points the systems are solved
// by the direct solver and by the choice of `auto`, which is multigrid, at 32
// by the latter.
TEST_P(CondensedAndFullBlock, GiveTheSameContactCurve) {
  expect_same_curve(LinearSolver::automatic);
  if (grid_.points_x <= 16)
    expect_same_curve(LinearSolver::direct);
}

std::vector<ContactCase> contact_cases() {
  using enum mechanics::FarBoundary;
  using enum mechanics::ContactLaw;
  using enum mechanics::Control;
  return {{1, clamped, penalty, 100.0, nominal_pressure, {1e5, 1e6, 4e6, 3e7}},
          {1, clamped, penalty, 100.0, nominal_pressure, {1e6, 1e7}, 16},
          {1, sliding, penalty, 100.0, nominal_pressure, {4e6}, 32},
          {1, sliding, penalty, 1.0, nominal_pressure, {1e6, 1e7}},
          {1, pressure, penalty, 1e6, nominal_pressure, {1e6, 1e7}},
          {1, pressure, penalty, 10.0, mean_gap, {1e-9, 2e-10}},
          {1, clamped, hard, 100.0, nominal_pressure, {1e6, 1e7}},
          {2, clamped, penalty, 100.0, nominal_pressure, {1e6, 1e7}},
          {2, clamped, hard, 100.0, nominal_pressure, {4e6}},
          {2, pressure, augmented, 30.0, mean_gap, {1e-9}}};
}

INSTANTIATE_TEST_SUITE_P(Cases, CondensedAndFullBlock,
                         ::testing::ValuesIn(contact_cases()));

// Verifies that a solution satisfies its contact law and balances the load, for
// every linear solver: p = k (-gap)+ at each node, and the weighted mean of p
// is p_0. Tolerance: the direct solver balances to roundoff, the others each
// node to the required 1e-8 of the largest force.
TEST(FullBlockTest, SatisfiesItsLawAndBalancesTheLoad) {
  const Grid grid{12, 8, 1e-6, 0.7e-6};
  const double penalty = 20.0 * soft_modulus / grid.spacing_x();
  for (const auto solver : {LinearSolver::direct, LinearSolver::multigrid}) {
    const auto full = make_full_block(
        grid, 2,
        layered_block(2.0 * grid.spacing_x(), 1e-6, FarBoundary::clamped),
        solver);

    const BlockSolution found =
        full->solve(rough_heights(grid), {Control::nominal_pressure, 3e6},
                    {ContactLaw::penalty, penalty, 1e-8, 50});

    ASSERT_TRUE(found.converged) << found.note;
    double borne = 0.0;
    std::size_t touching = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      EXPECT_NEAR(found.pressure[i], std::max(0.0, -penalty * found.gap[i]),
                  1e-9 * 3e6);
      borne += full->nodal_weights()[i] * found.pressure[i];
      touching += found.pressure[i] > 0.0;
    }
    const double largest = largest_magnitude(found.pressure) / 3e6;
    EXPECT_NEAR(borne / static_cast<double>(grid.size()) / 3e6, 1.0,
                solver == LinearSolver::direct ? 1e-12 : 1e-8 * largest);
    EXPECT_GT(touching, grid.size() / 10);
    EXPECT_LT(touching, grid.size() * 9 / 10);
  }
}

// Verifies that the active set of Newton's method converges over ten decades of
// penalty and from first touch to full contact, with the solution of another
// problem as initial guess, on white-noise heights. At 1e8 E/h the roundoff of
// the gap alone is 1e-8 of the pressure, and the note says so.
class AnyLinearSolver : public ::testing::TestWithParam<LinearSolver> {};

TEST_P(AnyLinearSolver, ConvergesForRandomProblems) {
  const Grid grid{8, 8, 1e-6, 1e-6};
  const auto full = make_full_block(
      grid, 1, layered_block(grid.spacing_x(), 1e-6, FarBoundary::clamped),
      GetParam());
  for (unsigned int seed = 0; seed < 40; ++seed) {
    const std::vector<double> dice = random_field(2, 1000 + seed);
    std::vector<double> heights = random_field(grid.size(), seed);
    for (double& height : heights)
      height *= 1e-8;
    const double penalty =
        std::pow(10.0, 10.0 * dice[0] - 4.0) * soft_modulus / grid.spacing_x();
    const double load = std::pow(10.0, 5.0 * dice[1] + 4.0);

    const BlockSolution found =
        full->solve(heights, {Control::nominal_pressure, load},
                    {ContactLaw::penalty, penalty, 1e-8, 40});

    EXPECT_TRUE(found.converged)
        << "seed " << seed << ", k " << penalty << ", p " << load << ": "
        << found.note << ", residual " << found.residual << ", "
        << found.iterations << " steps";
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, AnyLinearSolver,
                         ::testing::Values(LinearSolver::direct,
                                           LinearSolver::automatic));

// Verifies that an offset of all heights by a thousand times their rms height
// changes nothing: the tolerance of the gap is a fraction of the rms height
// about the mean, so that as many steps lead to the same pressures. Tolerance:
// 1e-13 of a gap of 1 um is lost to roundoff, times the stiffness of a cell.
TEST(FullBlockTest, IsTheSameForHeightsWithAMean) {
  const Grid grid{8, 8, 1e-6, 1e-6};
  const std::vector<double> heights = rough_heights(grid);
  std::vector<double> raised = heights;
  for (double& height : raised)
    height += 1e-6;
  const BlockContact contact{ContactLaw::hard,
                             100.0 * soft_modulus / grid.spacing_x(), 1e-3, 50};
  const auto solve = [&](const std::vector<double>& surface) {
    return make_full_block(
               grid, 1,
               layered_block(grid.spacing_x(), 1e-6, FarBoundary::clamped))
        ->solve(surface, {Control::nominal_pressure, 4e6}, contact);
  };

  const BlockSolution plain = solve(heights);
  const BlockSolution high = solve(raised);

  ASSERT_TRUE(plain.converged && high.converged) << plain.note << high.note;
  EXPECT_EQ(high.iterations, plain.iterations);
  EXPECT_LT(largest_difference(high.pressure, plain.pressure),
            1e-8 * largest_magnitude(plain.pressure));
}

TEST(FullBlockTest, WithoutContactCarriesNothing) {
  const Grid grid{8, 8, 1e-6, 1e-6};
  const auto full = make_full_block(
      grid, 1, layered_block(grid.spacing_x(), 1e-6, FarBoundary::clamped));

  const BlockSolution found =
      full->solve(rough_heights(grid), {Control::mean_gap, 1e-7},
                  {ContactLaw::penalty, 1e17, 1e-8, 50});

  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.nominal_pressure, 0.0);
  EXPECT_NEAR(found.mean_gap, 1e-7, 1e-20);
}

TEST(FullBlockTest, ReportsNonConvergenceAndRefusesBadArguments) {
  const Grid grid{8, 8, 1e-6, 1e-6};
  const auto full = make_full_block(
      grid, 1, layered_block(grid.spacing_x(), 1e-6, FarBoundary::clamped));
  const std::vector<double> heights = rough_heights(grid);

  const BlockSolution found =
      full->solve(heights, {Control::nominal_pressure, 3e6},
                  {ContactLaw::penalty, 1e17, 1e-8, 1});

  EXPECT_FALSE(found.converged);
  EXPECT_NE(found.note.find("contact set"), std::string::npos);
  EXPECT_THROW(full->solve(heights, {Control::nominal_pressure, -1.0},
                           {ContactLaw::penalty, 1e17, 1e-8, 50}),
               std::domain_error);
  EXPECT_THROW(full->solve({}, {Control::nominal_pressure, 1.0},
                           {ContactLaw::penalty, 1e17, 1e-8, 50}),
               std::domain_error);
}

} // namespace asperity::fem::full_block_test
