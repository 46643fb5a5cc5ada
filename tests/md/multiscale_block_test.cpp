#include "base/maximum.hpp"
#include "md/lattice/multiscale_block.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::md::multiscale_block_test {

constexpr double spacing = 2.6e-10;

Crystal crystal_of(mechanics::AtomLattice lattice) {
  return {lattice, spacing, 77.2e9,
          lattice == mechanics::AtomLattice::central ? 0.25 : 0.42};
}

MultiscaleBlock block_of(mechanics::AtomLattice lattice, int atoms_x,
                         int atoms_y, int levels, int layers, int threads = 1) {
  const Grid layer{atoms_x, atoms_y, atoms_x * spacing, atoms_y * spacing};
  return {crystal_of(lattice), {layer, levels, layers}, threads};
}

std::vector<double> random_state(const MultiscaleBlock& block, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> displacement(-1e-11, 1e-11);
  std::vector<double> state(block.size());
  for (double& value : state)
    value = displacement(random);
  return state;
}

/// Calls act(index of x, y, z; site) for each atom.
template <class Act>
void for_atoms(const MultiscaleBlock& block, const Act& act) {
  for (int level = 0; level < block.shape().levels; ++level) {
    const Grid grid = block.level_grid(level);
    for (int layer = 0; layer < block.shape().layers; ++layer)
      for (int iy = 0; iy < grid.points_y; ++iy)
        for (int ix = 0; ix < grid.points_x; ++ix) {
          const std::size_t first =
              block.begin_of(level, layer) + grid.index(ix, iy);
          act(std::array{first, first + grid.size(), first + 2 * grid.size()},
              std::array{ix * grid.spacing_x(), iy * grid.spacing_y(),
                         block.height_of(level, layer)});
        }
  }
}

using Gradient = std::array<std::array<double, 3>, 3>;

/// The displacement u = gradient (r - r_top), which is not periodic.
std::vector<double> homogeneous(const MultiscaleBlock& block,
                                const Gradient& gradient) {
  std::vector<double> state(block.size());
  for_atoms(block, [&](const auto& unknowns, const auto& site) {
    for (std::size_t i = 0; i < 3; ++i)
      state[unknowns[i]] = gradient[i][0] * site[0] + gradient[i][1] * site[1] +
                           gradient[i][2] * (site[2] - block.depth());
  });
  return state;
}

class EveryLattice : public ::testing::TestWithParam<mechanics::AtomLattice> {};

INSTANTIATE_TEST_SUITE_P(Lattices, EveryLattice,
                         ::testing::Values(mechanics::AtomLattice::isotropic,
                                           mechanics::AtomLattice::born,
                                           mechanics::AtomLattice::central));

// The patch test. A homogeneous strain or rotation causes no force on an atom
// inside, with and without hanging atoms between levels. Tolerance: roundoff of
// sums of 81 terms, relative to the force of one spring under this strain.
// Lateral strains do not fit the period and the plate: atoms within two coarse
// spacings of either are excluded.
TEST_P(EveryLattice, PassesThePatchTest) {
  const MultiscaleBlock block = block_of(GetParam(), 32, 32, 3, 2);
  const double coarse = 4 * spacing;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Gradient gradient{};
      gradient[i][j] = 1e-3;
      const std::vector<double> state = homogeneous(block, gradient);
      std::vector<double> forces(block.size());

      block.energy_and_forces(state, forces);

      double error = 0.0;
      for_atoms(block, [&](const auto& unknowns, const auto& site) {
        const bool is_inside =
            site[2] > 0.0 && site[2] < block.depth() - 1.5 * coarse &&
            std::min(site[0], site[1]) > 1.5 * coarse &&
            std::max(site[0], site[1]) < 32 * spacing - 2.5 * coarse;
        for (const std::size_t unknown : unknowns)
          if (is_inside)
            error = maximum(error, std::abs(forces[unknown]));
      });
      EXPECT_LT(error / (77.2e9 * spacing * 1e-3 * 32 * spacing), 1e-14)
          << i << j;
    }
  }
}

// u_z and u_x linear in height, which the period and the plate allow, cause no
// force except on the lowest layer, and their energy is that of the continuum,
// volume (C_11 e_zz^2 + C_44 g_xz^2) / 2, for any levels. Tolerance: roundoff.
TEST_P(EveryLattice, CompressesAndShearsAsTheContinuum) {
  const Crystal crystal = crystal_of(GetParam());
  const double shear_modulus =
      crystal.youngs_modulus / (2.0 * (1.0 + crystal.poisson_ratio));
  const double nu = crystal.poisson_ratio;
  const double confined =
      GetParam() == mechanics::AtomLattice::born
          ? crystal.youngs_modulus
          : 2.0 * shear_modulus * (1.0 - nu) / (1.0 - 2.0 * nu);
  for (const int levels : {1, 2, 4}) {
    const MultiscaleBlock block = block_of(GetParam(), 16, 24, levels, 3);
    Gradient gradient{};
    gradient[2][2] = -2e-3;
    gradient[0][2] = 1e-3;
    const std::vector<double> state = homogeneous(block, gradient);
    std::vector<double> forces(block.size());

    const double energy = block.energy_and_forces(state, forces);

    const double volume = 16 * 24 * spacing * spacing * block.depth();
    const double expected =
        0.5 * volume * (confined * 4e-6 + shear_modulus * 1e-6);
    EXPECT_NEAR(energy / expected, 1.0, 1e-12);
    const double pull = confined * 2e-3 * spacing * spacing;
    for_atoms(block, [&](const auto& unknowns, const auto& site) {
      if (site[2] == 0.0)
        return;
      for (const std::size_t unknown : unknowns)
        EXPECT_NEAR(forces[unknown] / pull, 0.0, 1e-11);
    });
    EXPECT_NEAR(forces[block.plate()] / (pull * 16 * 24), 1.0, 1e-12);
    EXPECT_NEAR(block.energy_of_waves(state) / expected, 0.0, 1e-12);
  }
}

// Forces are minus the gradient of the energy, including those of hanging atoms
// and of the plate. A central difference of a quadratic function has no error
// but roundoff: eps E over the change of the energy, some 1e-9 here.
TEST_P(EveryLattice, ForcesAreMinusTheGradient) {
  const MultiscaleBlock block = block_of(GetParam(), 8, 12, 3, 2);
  std::vector<double> state = random_state(block, 1);
  const std::vector<double> direction = random_state(block, 2);
  std::vector<double> forces(block.size());
  std::vector<double> unused(block.size());
  block.energy_and_forces(state, forces);
  double work = 0.0;
  for (std::size_t i = 0; i < block.size(); ++i)
    work += forces[i] * direction[i];

  const auto energy_at = [&](double step) {
    std::vector<double> moved = state;
    for (std::size_t i = 0; i < block.size(); ++i)
      moved[i] += step * direction[i];
    return block.energy_and_forces(moved, unused);
  };

  EXPECT_NEAR((energy_at(-0.5) - energy_at(0.5)) / work, 1.0, 1e-11);
  for (const std::size_t unknown :
       {block.plate(), block.begin_of(1, 0), block.begin_of(2, 0) + 3}) {
    std::vector<double> moved = state;
    moved[unknown] = state[unknown] + 5e-12;
    const double above = block.energy_and_forces(moved, unused);
    moved[unknown] = state[unknown] - 5e-12;
    const double below = block.energy_and_forces(moved, unused);
    EXPECT_NEAR((below - above) / (1e-11 * forces[unknown]), 1.0, 1e-9);
  }
}

// A uniform displacement of block and plate along z causes no force, on hanging
// atoms and on the plate neither. Tolerance: roundoff, relative to the force of
// one spring under this displacement.
TEST_P(EveryLattice, IsInvariantUnderTranslationInHeight) {
  const MultiscaleBlock block = block_of(GetParam(), 8, 8, 2, 3);
  std::vector<double> state(block.size(), 0.0);
  for_atoms(block, [&](const auto& unknowns, const auto&) {
    state[unknowns[2]] = 1e-10;
  });
  state[block.plate()] = 1e-10;
  std::vector<double> forces(block.size());

  const double energy = block.energy_and_forces(state, forces);

  const double spring = 77.2e9 * spacing * 1e-10;
  EXPECT_NEAR(energy / (spring * 1e-10), 0.0, 1e-11);
  EXPECT_LT(largest_magnitude(forces) / spring, 1e-11);
}

// The total mass is that of the cells. One level has the mass of atoms x
// layers; the mass of hanging atoms is on the coarse atoms. Exact in binary.
TEST(MultiscaleBlock, HasTheMassOfItsCells) {
  for (const int levels : {1, 2, 3}) {
    const MultiscaleBlock block =
        block_of(mechanics::AtomLattice::isotropic, 16, 8, levels, 5);

    const std::vector<double> masses = block.masses(1.0);

    double sum = masses[block.plate()];
    for_atoms(block, [&](const auto& unknowns, const auto&) {
      sum += masses[unknowns[2]];
      EXPECT_EQ(masses[unknowns[0]], masses[unknowns[2]]);
    });
    EXPECT_EQ(sum, 16.0 * 8.0 * 5.0 * (std::pow(2.0, levels) - 1.0));
  }
}

// Verifies that the number of threads changes no bit.
TEST(MultiscaleBlock, HasTheSameBitsForAnyThreads) {
  const MultiscaleBlock one =
      block_of(mechanics::AtomLattice::isotropic, 16, 16, 3, 3, 1);
  const MultiscaleBlock three =
      block_of(mechanics::AtomLattice::isotropic, 16, 16, 3, 3, 3);
  const std::vector<double> state = random_state(one, 4);
  std::vector<double> forces(one.size());
  std::vector<double> same_forces(one.size());

  const double energy = one.energy_and_forces(state, forces);

  EXPECT_EQ(three.energy_and_forces(state, same_forces), energy);
  EXPECT_EQ(same_forces, forces);
}

TEST(MultiscaleBlock, RefusesIndivisibleSizes) {
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [] { block_of(mechanics::AtomLattice::born, 12, 16, 4, 6); }),
            "atoms per side = 12, but must be a multiple of 2^(levels - 1)");
  EXPECT_TRUE(tests::message_of<std::domain_error>([] {
                block_of(mechanics::AtomLattice::born, 8, 8, 0, 6);
              }).starts_with("levels = 0"));
  EXPECT_TRUE(tests::message_of<std::domain_error>([] {
                block_of(mechanics::AtomLattice::born, 8, 8, 1, 0);
              }).starts_with("layers = 0"));
  EXPECT_TRUE(tests::message_of<std::domain_error>([] {
                const Grid layer{8, 8, 1e-9, 1e-9};
                MultiscaleBlock(crystal_of(mechanics::AtomLattice::born),
                                {layer, 1, 6});
              }).starts_with("spacing of the layer = 1.25e-10"));
}

} // namespace asperity::md::multiscale_block_test
