// Tests of fem/waves/lattice_solver.hpp. The reference is deal.II's assembled
// matrix with a direct solver.
#include "base/special_numbers.hpp"
#include "fem/waves/lattice_solver.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/uniform_block.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace asperity::fem::lattice_solver_test {

using mechanics::FarBoundary;

bool is_shift_free(FarBoundary far_boundary, std::size_t component) {
  return far_boundary == FarBoundary::pressure ||
         (far_boundary == FarBoundary::sliding && component < 2);
}

/// Subtracts the mean of the components that the far boundary leaves free.
void remove_shifts(const NodeLattice& lattice, FarBoundary far_boundary,
                   bool is_z_held, std::vector<double>& field) {
  for (std::size_t component = 0; component < 3; ++component) {
    if (!is_shift_free(far_boundary, component) ||
        (component == 2 && is_z_held))
      continue;
    double sum = 0.0;
    for (std::size_t plane = 0; plane < lattice.planes; ++plane)
      for (std::size_t i = 0; i < lattice.grid.size(); ++i)
        sum += field[lattice.index(plane, component, i)];
    const double mean =
        sum / static_cast<double>(lattice.planes * lattice.grid.size());
    for (std::size_t plane = 0; plane < lattice.planes; ++plane)
      for (std::size_t i = 0; i < lattice.grid.size(); ++i)
        field[lattice.index(plane, component, i)] -= mean;
  }
}

/// Independent loads on all nodes, -1/2..1/2, zero at constrained unknowns, and
/// balanced where nothing supports the block.
std::vector<double> loads(const NodeLattice& lattice, FarBoundary far_boundary,
                          bool is_z_held, unsigned int seed) {
  std::vector<double> force = random_field(lattice.size(), seed);
  for (double& value : force)
    value -= 0.5;
  remove_shifts(lattice, far_boundary, is_z_held, force);
  for (std::size_t component = 0; component < 3; ++component)
    if (far_boundary == FarBoundary::clamped ||
        (far_boundary == FarBoundary::sliding && component == 2))
      for (std::size_t i = 0; i < lattice.grid.size(); ++i)
        force[lattice.index(lattice.planes - 1, component, i)] = 0.0;
  return force;
}

LayeredBlock block_on(const Grid& grid, int degree, FarBoundary far_boundary) {
  return layered_block(degree * grid.spacing_x(), 0.8 * grid.length_x,
                       far_boundary);
}

class LatticeAgainstDealii
    : public ::testing::TestWithParam<std::tuple<int, Grid, FarBoundary>> {};

// Verifies K^-1 for every wavevector and node class at once, with layers of
// different moduli and unequal sides. Tolerance: roundoff of both solves.
TEST_P(LatticeAgainstDealii, InvertsTheSameMatrix) {
  const auto [degree, grid, far_boundary] = GetParam();
  const LayeredBlock block = block_on(grid, degree, far_boundary);
  LatticeSolver solver(grid, degree, block, 2);
  const std::vector<double> force =
      loads(solver.lattice(), far_boundary, false, 7);
  std::vector<double> found(force.size());

  solver.solve(force, found);

  std::vector<double> expected =
      UniformBlock(grid, degree, block).solve(force, {});
  remove_shifts(solver.lattice(), far_boundary, false, expected);
  remove_shifts(solver.lattice(), far_boundary, false, found);
  EXPECT_LT(largest_difference(found, expected),
            1e-12 * largest_magnitude(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Linear, LatticeAgainstDealii,
    ::testing::Combine(::testing::Values(1),
                       ::testing::Values(Grid{8, 8, 1e-6, 1e-6},
                                         Grid{12, 7, 1e-6, 0.7e-6},
                                         Grid{9, 5, 1e-6, 0.5e-6}),
                       ::testing::Values(FarBoundary::clamped,
                                         FarBoundary::sliding,
                                         FarBoundary::pressure)));
INSTANTIATE_TEST_SUITE_P(
    Quadratic, LatticeAgainstDealii,
    ::testing::Combine(
        ::testing::Values(2),
        ::testing::Values(Grid{8, 8, 1e-6, 1e-6}, Grid{12, 6, 1e-6, 0.7e-6}),
        ::testing::Values(FarBoundary::clamped, FarBoundary::sliding,
                          FarBoundary::pressure)));

class LatticeWithSprings
    : public ::testing::TestWithParam<std::tuple<int, FarBoundary, double>> {};

/// Springs k a_i at about a third of the nodes, with areas that differ by a
/// factor of 3.
std::vector<double> springs_of(const Grid& grid, double stiffness) {
  std::vector<double> springs(grid.size(), 0.0);
  const std::vector<double> chance = random_field(grid.size(), 11);
  for (std::size_t i = 0; i < springs.size(); ++i)
    if (chance[i] < 0.35)
      springs[i] = stiffness * (1.0 + 2.0 * chance[i] / 0.35);
  return springs;
}

// Verifies the inverse of the matrix with springs of any stiffness, including
// nodes in hard contact. Tolerance: 1e-13 of the free displacement from the
// inner iterations, and the roundoff of the reference, whose matrix with
// springs of 1e6 E h has a condition number that is 1e6 times as large.
TEST_P(LatticeWithSprings, InvertsTheMatrixWithItsSprings) {
  const auto [degree, far_boundary, stiffness] = GetParam();
  const Grid grid{8, 6, 1e-6, 0.8e-6};
  const LayeredBlock block = block_on(grid, degree, far_boundary);
  const std::vector<double> springs =
      springs_of(grid, stiffness * soft_modulus * grid.spacing_x());
  LatticeSolver solver(grid, degree, block);
  const std::vector<double> force =
      loads(solver.lattice(), far_boundary, true, 8);
  std::vector<double> found(force.size());
  solver.set_springs(springs);

  const SpringSolve how = solver.solve_with_springs(force, found, 1e-13);

  std::vector<double> expected =
      UniformBlock(grid, degree, block).solve(force, springs);
  ASSERT_TRUE(how.converged);
  remove_shifts(solver.lattice(), far_boundary, true, expected);
  remove_shifts(solver.lattice(), far_boundary, true, found);
  EXPECT_LT(largest_difference(found, expected),
            1e-10 * largest_magnitude(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Stiffnesses, LatticeWithSprings,
    ::testing::Combine(::testing::Values(1, 2),
                       ::testing::Values(FarBoundary::clamped,
                                         FarBoundary::sliding,
                                         FarBoundary::pressure),
                       ::testing::Values(1e-3, 1.0, 1e3, 1e6, infinity)));

double product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Verifies that both inverses are symmetric and positive on any grid with any
// springs (including nodes in hard contact), as conjugate gradients require.
// Tolerance: roundoff of an inverse whose waves differ by the square of the
// number of points, below 1e3; with springs 1e-12 of the inner iterations times
// that.
RC_GTEST_PROP(LatticeSolver, IsSymmetricAndPositive, ()) {
  const int degree = *rc::gen::inRange(1, 3);
  const Grid grid{degree * *rc::gen::inRange(2, 9),
                  degree * *rc::gen::inRange(2, 9), 1e-6, 0.9e-6};
  const FarBoundary far_boundary = *rc::gen::element(
      FarBoundary::clamped, FarBoundary::sliding, FarBoundary::pressure);
  LatticeSolver solver(grid, degree, block_on(grid, degree, far_boundary));
  std::vector<double> springs(grid.size(), 0.0);
  for (double& spring : springs)
    if (*rc::gen::inRange(0, 3) == 0)
      spring = *rc::gen::element(1e-3, 1.0, 1e3, 1e6, infinity) * soft_modulus *
               grid.spacing_x();
  solver.set_springs(springs);
  const auto seed = *rc::gen::inRange(1u, 1000u);
  const std::vector<double> first =
      loads(solver.lattice(), far_boundary, false, seed);
  const std::vector<double> second =
      loads(solver.lattice(), far_boundary, false, seed + 1000u);
  std::vector<double> by_first(first.size()), by_second(first.size());

  for (const bool with_springs : {false, true}) {
    if (with_springs) {
      RC_ASSERT(solver.solve_with_springs(first, by_first).converged);
      RC_ASSERT(solver.solve_with_springs(second, by_second).converged);
    } else {
      solver.solve(first, by_first);
      solver.solve(second, by_second);
    }

    const double energy = product(first, by_first);
    RC_ASSERT(energy > 0.0);
    RC_ASSERT(std::abs(product(second, by_first) - product(first, by_second)) <
              (with_springs ? 1e-9 : 1e-12) * energy);
  }
}

// Verifies that the number of threads changes no bit.
TEST(LatticeSolver, HasTheSameBitsOnAnyNumberOfThreads) {
  const Grid grid{48, 48, 1e-6, 1e-6};
  const LayeredBlock block = block_on(grid, 2, FarBoundary::pressure);
  std::vector<std::vector<double>> answers;
  for (const int threads : {1, 3}) {
    LatticeSolver solver(grid, 2, block, threads);
    solver.set_springs(springs_of(grid, soft_modulus * grid.spacing_x()));
    answers.emplace_back(solver.lattice().size());
    solver.solve_with_springs(
        loads(solver.lattice(), FarBoundary::pressure, true, 1),
        answers.back());
  }

  EXPECT_EQ(answers[0], answers[1]);
}

TEST(LatticeSolver, RefusesWhatIsOutOfRange) {
  const Grid grid{8, 8, 1e-6, 1e-6};
  const LayeredBlock block = block_on(grid, 1, FarBoundary::clamped);
  LatticeSolver solver(grid, 1, block);
  std::vector<double> springs(grid.size(), 0.0);
  std::vector<double> too_short(solver.lattice().size() - 1);
  std::vector<double> field(solver.lattice().size());

  EXPECT_THROW(LatticeSolver(grid, 3, block), std::domain_error);
  EXPECT_THROW(LatticeSolver(grid, 1, block, 0), std::domain_error);
  EXPECT_THROW(LatticeSolver({7, 8, 1e-6, 1e-6}, 2, block), std::domain_error);
  EXPECT_THROW(solver.solve(too_short, field), std::domain_error);
  EXPECT_THROW(solver.solve_with_springs(field, field, 0.0), std::domain_error);
  EXPECT_THROW(solver.set_springs(too_short), std::domain_error);
  for (const double bad : {-1.0, std::nan("")}) {
    springs[3] = bad;
    EXPECT_THROW(solver.set_springs(springs), std::domain_error);
  }
}

} // namespace asperity::fem::lattice_solver_test
