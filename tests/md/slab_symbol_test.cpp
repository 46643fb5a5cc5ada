// Tests of md/lattice/slab_symbol.hpp: the composed slab equals the eliminated
// block, and has the modulus of the continuum for long waves.
#include "md/lattice/slab_symbol.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace asperity::md::slab_symbol_test {

constexpr double spacing = 2.6e-10;
constexpr int half_space = 1 << 30;

using Real = long double;
using Matrix = Eigen::Matrix<std::complex<Real>, 3, 3>;

Crystal crystal_of(mechanics::AtomLattice lattice) {
  return {lattice, spacing, 77.2e9,
          lattice == mechanics::AtomLattice::central ? 0.25 : 0.42};
}

/// The contact modulus of the continuum: E/(1 - nu^2), and 2 sqrt(E G) for the
/// Born lattice [Pa].
double long_wave_contact_modulus(const Crystal& crystal) {
  const double nu = crystal.poisson_ratio;
  return crystal.lattice == mechanics::AtomLattice::born
             ? 2.0 * crystal.youngs_modulus / std::sqrt(2.0 * (1.0 + nu))
             : crystal.youngs_modulus / (1.0 - nu * nu);
}

using WideCell = std::array<Real, 24 * 24>;

/// The cell with row sums that are exactly zero: without this a uniform
/// displacement would cost energy at the level of roundoff, which a wave of a
/// thousand atoms would show at 1e-11.
WideCell invariant_cell(const Crystal& crystal) {
  const CellStiffness cell = cell_stiffness(crystal);
  WideCell wide{};
  std::copy(cell.begin(), cell.end(), wide.begin());
  for (std::size_t row = 0; row < 24; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Real sum = 0;
      for (std::size_t corner = 0; corner < 8; ++corner)
        sum += wide[row * 24 + 3 * corner + axis];
      wide[row * 24 + row - row % 3 + axis] -= sum;
    }
  return wide;
}

/// One layer of cells between the planes 0 (lower) and 1, from the phases of
/// the corners.
Matrix face_block(const WideCell& cell, double angle_x, double angle_y,
                  std::size_t face, std::size_t other_face) {
  const auto angle = [&](std::size_t corner) {
    return static_cast<Real>(corner & 1U) * static_cast<Real>(angle_x) +
           static_cast<Real>((corner >> 1U) & 1U) * static_cast<Real>(angle_y);
  };
  Matrix block = Matrix::Zero();
  for (std::size_t c = 4 * face; c < 4 * face + 4; ++c)
    for (std::size_t d = 4 * other_face; d < 4 * other_face + 4; ++d)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          block(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
              cell[(3 * c + i) * 24 + 3 * d + j] *
              std::polar(Real{1}, angle(d) - angle(c));
  return block;
}

/// The reference: Gaussian elimination from the clamped top, layer by layer, in
/// extended precision, then the multiplication by i.
Matrix eliminated(const Crystal& crystal, double angle_x, double angle_y,
                  int cells) {
  const WideCell cell = invariant_cell(crystal);
  const auto block = [&](std::size_t face, std::size_t other) {
    return face_block(cell, angle_x, angle_y, face, other);
  };
  const Matrix lower = block(0, 0);
  const Matrix upper = block(1, 1);
  const Matrix up = block(0, 1);
  const Matrix down = block(1, 0);
  Matrix stiffness = lower;
  for (int layer = 1; layer < cells; ++layer)
    stiffness = lower - up * (upper + stiffness).inverse() * down;
  const std::complex<Real> i(0, 1);
  const Matrix turn =
      Eigen::Matrix<std::complex<Real>, 3, 1>(i, i, 1).asDiagonal();
  return turn.adjoint() * stiffness * turn;
}

/// Largest difference of any entry over the largest entry.
double difference(const SymmetricBlock& block, const Matrix& expected) {
  Matrix matrix;
  matrix << block.xx, block.xy, block.xz, block.xy, block.yy, block.yz,
      block.xz, block.yz, block.zz;
  return static_cast<double>((matrix - expected).cwiseAbs().maxCoeff() /
                             expected.cwiseAbs().maxCoeff());
}

class AnyCrystal : public ::testing::TestWithParam<mechanics::AtomLattice> {};

// The composition by powers of two equals the elimination layer by layer, for
// any number of layers and any wave. Tolerance: some 9 compositions of 3 x 3
// blocks of a few dozen roundings each, 6e-15 measured.
TEST_P(AnyCrystal, IsTheBlockEliminatedLayerByLayer) {
  const Crystal crystal = crystal_of(GetParam());
  const SlabSymbol symbol(crystal);
  double worst = 0.0;

  for (const double size : {2.0 * std::numbers::pi / 1000.0, 0.03, 0.7, 3.0})
    for (const double direction : {0.0, 0.4, 2.5})
      for (const int cells : {1, 2, 3, 8, 13, 100, 357}) {
        const double x = size * std::cos(direction);
        const double y = size * std::sin(direction);
        worst = std::max(worst, difference(symbol.clamped(x, y, cells),
                                           eliminated(crystal, x, y, cells)));
      }

  EXPECT_LT(worst, 5e-14);
}

// At zero wavevector the slab is springs in series: C_11 a^2 / (n a) normally,
// C_44 a^2 / (n a) laterally. Tolerance: one rounding per composition.
TEST_P(AnyCrystal, IsASeriesOfSpringsWithoutAWave) {
  const Crystal crystal = crystal_of(GetParam());
  const double nu = crystal.poisson_ratio;
  const double shear = crystal.youngs_modulus / (2.0 * (1.0 + nu));
  const double longitudinal = GetParam() == mechanics::AtomLattice::born
                                  ? crystal.youngs_modulus
                                  : 2.0 * shear * (1.0 - nu) / (1.0 - 2.0 * nu);
  const int cells = 300;

  const SymmetricBlock block = SlabSymbol(crystal).clamped(0.0, 0.0, cells);

  EXPECT_NEAR(block.zz * cells / (longitudinal * spacing), 1.0, 1e-13);
  EXPECT_NEAR(block.xx * cells / (shear * spacing), 1.0, 1e-13);
  EXPECT_NEAR(block.yy * cells / (shear * spacing), 1.0, 1e-13);
}

// The half-space has its closed form for long waves; the difference decreases
// as theta^2 (the lattice's dispersion), at most theta^2 / 10.
TEST_P(AnyCrystal, HasItsContactModulusForLongWaves) {
  const Crystal crystal = crystal_of(GetParam());
  const SlabSymbol symbol(crystal);

  for (const double angle : {1e-3, 1e-2, 5e-2})
    for (const double direction : {0.0, 0.3, 0.25 * std::numbers::pi})
      EXPECT_NEAR(symbol.contact_modulus(angle * std::cos(direction),
                                         angle * std::sin(direction),
                                         half_space) /
                      long_wave_contact_modulus(crystal),
                  1.0, 0.1 * angle * angle + 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Lattices, AnyCrystal,
                         ::testing::Values(mechanics::AtomLattice::isotropic,
                                           mechanics::AtomLattice::born,
                                           mechanics::AtomLattice::central));

// Verifies the bounds of the design, for the paper's E and nu, in every
// direction.
TEST(IsotropicCrystal, AgreesWithTheContinuumUpToATenthOfTheSpacing) {
  const Crystal crystal = crystal_of(mechanics::AtomLattice::isotropic);
  const SlabSymbol symbol(crystal);
  const auto ratio = [&](double angle, double direction) {
    return symbol.contact_modulus(angle * std::cos(direction),
                                  angle * std::sin(direction), half_space) /
           long_wave_contact_modulus(crystal);
  };

  for (const double direction : {0.0, 0.2, 0.25 * std::numbers::pi})
    for (const double angle : {0.02, 0.05, 0.1})
      EXPECT_NEAR(ratio(angle, direction), 1.0, 0.0005);
  EXPECT_NEAR(ratio(0.4, 0.0), 0.996, 0.001);
}

TEST(SymmetricBlock, IsInvertedByItsInverse) {
  const SymmetricBlock block{4.0, 3.0, 5.0, 0.5, -1.0, 0.75};

  const SymmetricBlock inverted = inverse(block, 0.25, 2.0);

  Eigen::Matrix3d sum;
  sum << 4.25, 0.5, -1.0, 0.5, 3.25, 0.75, -1.0, 0.75, 7.0;
  Eigen::Matrix3d other;
  other << inverted.xx, inverted.xy, inverted.xz, inverted.xy, inverted.yy,
      inverted.yz, inverted.xz, inverted.yz, inverted.zz;
  EXPECT_LT((sum * other - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(),
            1e-15);
}

TEST(SlabSymbol, RefusesNoLayers) {
  EXPECT_THROW(
      SlabSymbol(crystal_of(mechanics::AtomLattice::born)).clamped(0.1, 0.0, 0),
      std::domain_error);
}

} // namespace asperity::md::slab_symbol_test
