#include "base/maximum.hpp"
#include "md/lattice/block_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace asperity::md::block_solver_test {

constexpr double spacing = 2.6e-10;
constexpr double contact_stiffness = 1.2; // N/m

Crystal crystal_of(mechanics::AtomLattice lattice) {
  return {lattice, spacing, 77.2e9,
          lattice == mechanics::AtomLattice::central ? 0.25 : 0.42};
}

MultiscaleBlock block_of(const Crystal& crystal, int atoms_x, int atoms_y,
                         int levels, int layers) {
  const Grid layer{atoms_x, atoms_y, atoms_x * crystal.spacing,
                   atoms_y * crystal.spacing};
  return {crystal, {layer, levels, layers}};
}

void centre(std::span<double> values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  for (double& value : values)
    value -= sum / static_cast<double>(values.size());
}

/// Subtracts the mean of the components that the support constrains.
void hold(const MultiscaleBlock& block, bool is_height_held,
          std::span<double> values) {
  const std::size_t n = block.shape().layer.size();
  for (std::size_t axis = 0; axis < (is_height_held ? 3 : 2); ++axis)
    centre(values.subspan(axis * n, n));
}

struct BlockProblem {
  int levels = 1;
  int layers = 6;
  int atoms_x = 16;
  int atoms_y = 24;
  bool is_height_held = false;
  mechanics::AtomLattice lattice = mechanics::AtomLattice::isotropic;
};

void PrintTo(const BlockProblem& problem, std::ostream* out) {
  *out << problem.levels << " levels of " << problem.layers << ", "
       << problem.atoms_x << " x " << problem.atoms_y
       << (problem.is_height_held ? ", held" : "");
}

class EveryBlockProblem : public ::testing::TestWithParam<BlockProblem> {};

INSTANTIATE_TEST_SUITE_P(
    Problems, EveryBlockProblem,
    ::testing::Values(
        BlockProblem{}, BlockProblem{1, 1, 2, 4, true},
        BlockProblem{1, 20, 8, 8}, BlockProblem{2, 2, 6, 10, true},
        BlockProblem{3, 6, 16, 24},
        BlockProblem{4, 3, 16, 8, true, mechanics::AtomLattice::born},
        BlockProblem{3, 2, 4, 12, false, mechanics::AtomLattice::central}));

// Verifies that solve() inverts the forces of the block and of the contact
// springs exactly: these are computed by stencil and hanging atoms, the inverse
// in Fourier space. Tolerance: roundoff times the condition number of the chain
// of one wave, some hundreds.
TEST_P(EveryBlockProblem, InvertsTheForcesOfAnyDisplacement) {
  const auto [levels, layers, atoms_x, atoms_y, is_held, lattice] = GetParam();
  const MultiscaleBlock block =
      block_of(crystal_of(lattice), atoms_x, atoms_y, levels, layers);
  const BlockSolver solver(block, {contact_stiffness, is_held});
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> displacement(-1e-11, 1e-11);
  std::vector<double> state(block.size());
  for (double& value : state)
    value = displacement(random);
  hold(block, is_held, state);
  std::vector<double> load(block.size());
  block.energy_and_forces(state, load);
  for (double& force : load)
    force = -force;
  for (std::size_t i = 0; i < 3 * block.shape().layer.size(); ++i)
    load[i] += contact_stiffness * state[i];
  hold(block, is_held, load);

  std::vector<double> answer(block.size());
  solver.solve(load, answer);

  for (std::size_t i = 0; i < block.size(); ++i)
    ASSERT_NEAR(answer[i], state[i], 1e-12 * 1e-11) << i;
}

/// Amplitude of z under a force cos(2 pi j x / L) on every atom of the lowest
/// layer, divided by the force [m/N].
double compliance(const MultiscaleBlock& block, int wavenumber) {
  const BlockSolver solver(block, {0.0, true});
  const Grid& grid = block.shape().layer;
  std::vector<double> forces(block.size());
  std::vector<double> answer(block.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      forces[2 * grid.size() + grid.index(ix, iy)] =
          std::cos(2.0 * std::numbers::pi * wavenumber * ix / grid.points_x);

  solver.solve(forces, answer);

  double projection = 0.0;
  for (std::size_t i = 0; i < 3 * grid.size(); ++i)
    projection += answer[i] * forces[i];
  return 2.0 * projection / static_cast<double>(grid.size());
}

// Verifies that one level equals slab doubling with the same cells (another
// algorithm, for one wave). Tolerance: roundoff.
TEST(BlockSolver, AgreesWithSlabDoublingOnOneLevel) {
  const Crystal crystal = crystal_of(mechanics::AtomLattice::isotropic);
  const SlabSymbol slab(crystal);
  for (const int layers : {1, 6, 32}) {
    const MultiscaleBlock block = block_of(crystal, 32, 4, 1, layers);
    for (const int wavenumber : {1, 5, 15}) {
      const SymmetricBlock stiffness =
          slab.clamped(2.0 * std::numbers::pi * wavenumber / 32.0, 0.0, layers);
      EXPECT_NEAR(compliance(block, wavenumber) / inverse(stiffness).zz, 1.0,
                  1e-12)
          << layers << ' ' << wavenumber;
    }
  }
}

TEST(BlockSolver, RefusesAnUnsupportedBlock) {
  const MultiscaleBlock block =
      block_of(crystal_of(mechanics::AtomLattice::isotropic), 4, 4, 1, 2);

  EXPECT_THROW(BlockSolver(block, {0.0, false}), std::domain_error);
  EXPECT_NO_THROW(BlockSolver(block, {0.0, true}));
}

} // namespace asperity::md::block_solver_test
