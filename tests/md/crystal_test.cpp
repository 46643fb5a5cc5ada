// Tests of md/lattice/crystal.hpp: one cell has the energy of the continuum in
// homogeneous strain, and none under rigid motion.
#include "md/lattice/crystal.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace asperity::md::crystal_test {

constexpr double spacing = 2.6e-10;
constexpr double modulus = 77.2e9;

// Sums of 24 x 24 terms whose size is the largest entry times displacement
// squared: a few hundred roundings.
constexpr double rounding = 1e-13;

using Gradient = std::array<std::array<double, 3>, 3>; // [axis][direction]

Crystal crystal_of(mechanics::AtomLattice lattice, double poisson_ratio) {
  return {lattice, spacing, modulus, poisson_ratio};
}

std::array<double, 24> displaced(const Gradient& gradient,
                                 const std::array<double, 3>& shift = {}) {
  std::array<double, 24> displacement{};
  for (std::size_t corner = 0; corner < 8; ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      displacement[3 * corner + axis] = shift[axis];
      for (std::size_t along = 0; along < 3; ++along)
        if ((corner >> along) & 1U)
          displacement[3 * corner + axis] += spacing * gradient[axis][along];
    }
  return displacement;
}

/// Twice the energy over the cell's volume [Pa].
double doubled_density(const Crystal& crystal,
                       const std::array<double, 24>& displacement) {
  const CellStiffness matrix = cell_stiffness(crystal);
  double sum = 0.0;
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j)
      sum += displacement[i] * matrix[i * 24 + j] * displacement[j];
  return sum / std::pow(spacing, 3);
}

/// lambda (tr e)^2 + 2 mu e : e of the isotropic continuum [Pa].
double isotropic_density(double poisson_ratio, const Gradient& gradient) {
  const double shear = modulus / (2.0 * (1.0 + poisson_ratio));
  const double lame = 2.0 * shear * poisson_ratio / (1.0 - 2.0 * poisson_ratio);
  double trace = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    trace += gradient[i][i];
    for (std::size_t j = 0; j < 3; ++j)
      square += std::pow(0.5 * (gradient[i][j] + gradient[j][i]), 2);
  }
  return lame * trace * trace + 2.0 * shear * square;
}

const Gradient some_gradient{
    {{0.3, -0.7, 0.2}, {0.5, 0.1, -0.4}, {-0.6, 0.9, 0.8}}};

class AnyLattice : public ::testing::TestWithParam<Crystal> {};

TEST_P(AnyLattice, IsSymmetric) {
  const CellStiffness matrix = cell_stiffness(GetParam());

  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_EQ(matrix[i * 24 + j], matrix[j * 24 + i]);
}

TEST_P(AnyLattice, TranslatesWithoutEnergy) {
  const std::array<double, 3> shift{spacing, -2.0 * spacing, 0.5 * spacing};

  const double density = doubled_density(GetParam(), displaced({}, shift));

  EXPECT_NEAR(density / modulus, 0.0, rounding);
}

// Verifies that rigid motion, rotations included, and nothing else costs no
// energy: 24 minus 6 positive eigenvalues, 24 minus 3 for born. The Cholesky
// factorisation of the matrix with a slightly increased diagonal has no
// negative pivot, and as many small pivots as there are rigid motions.
TEST_P(AnyLattice, HasNoOtherFreeMotion) {
  CellStiffness matrix = cell_stiffness(GetParam());
  const double scale = modulus * spacing;
  const double lift = 1e-8 * scale;
  for (std::size_t i = 0; i < 24; ++i)
    matrix[i * 24 + i] += lift;

  int small = 0;
  for (std::size_t k = 0; k < 24; ++k) {
    const double pivot = matrix[k * 24 + k];
    ASSERT_GT(pivot, 0.0);
    small += pivot < 1e-6 * scale ? 1 : 0;
    for (std::size_t i = k + 1; i < 24; ++i)
      for (std::size_t j = k + 1; j < 24; ++j)
        matrix[i * 24 + j] -= matrix[i * 24 + k] * matrix[k * 24 + j] / pivot;
  }

  EXPECT_EQ(small, GetParam().lattice == mechanics::AtomLattice::born ? 3 : 6);
}

INSTANTIATE_TEST_SUITE_P(
    Lattices, AnyLattice,
    ::testing::Values(crystal_of(mechanics::AtomLattice::isotropic, 0.42),
                      crystal_of(mechanics::AtomLattice::isotropic, 0.0),
                      crystal_of(mechanics::AtomLattice::isotropic, -0.9),
                      crystal_of(mechanics::AtomLattice::born, 0.42),
                      crystal_of(mechanics::AtomLattice::central, 0.25)));

TEST(IsotropicCell, IsTheContinuumInHomogeneousStrain) {
  for (const double nu : {-0.9, 0.0, 0.25, 0.42, 0.499}) {
    const double density =
        doubled_density(crystal_of(mechanics::AtomLattice::isotropic, nu),
                        displaced(some_gradient));

    EXPECT_NEAR(density / isotropic_density(nu, some_gradient), 1.0, 1e-12);
  }
}

TEST(CentralCell, IsTheContinuumForPoissonsRatioOneQuarter) {
  const double density =
      doubled_density(crystal_of(mechanics::AtomLattice::central, 0.25),
                      displaced(some_gradient));

  EXPECT_NEAR(density / isotropic_density(0.25, some_gradient), 1.0, 1e-12);
}

// C_11 = E in each direction, G for each gradient across it, and no coupling of
// any two: the energy is a sum of squares.
TEST(BornCell, IsASumOfSquaresOfTheGradient) {
  const double shear = modulus / (2.0 * 1.42);
  double expected = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      expected += (i == j ? modulus : shear) * std::pow(some_gradient[i][j], 2);

  const double density = doubled_density(
      crystal_of(mechanics::AtomLattice::born, 0.42), displaced(some_gradient));

  EXPECT_NEAR(density / expected, 1.0, rounding);
}

std::string refusal(const Crystal& crystal) {
  return tests::message_of<std::domain_error>([&] { cell_stiffness(crystal); });
}

TEST(Crystal, RefusesWhatIsOutsideItsRange) {
  Crystal crystal = crystal_of(mechanics::AtomLattice::isotropic, 0.5);
  EXPECT_NE(refusal(crystal).find("poisson_ratio"), std::string::npos);
  crystal.poisson_ratio = -1.0;
  EXPECT_NE(refusal(crystal).find("poisson_ratio"), std::string::npos);
  crystal = crystal_of(mechanics::AtomLattice::central, 0.3);
  EXPECT_NE(refusal(crystal).find("1/4"), std::string::npos);
  crystal = crystal_of(mechanics::AtomLattice::born, 0.3);
  crystal.spacing = 0.0;
  EXPECT_NE(refusal(crystal).find("spacing"), std::string::npos);
  crystal = crystal_of(mechanics::AtomLattice::born, 0.3);
  crystal.youngs_modulus = std::nan("");
  EXPECT_NE(refusal(crystal).find("youngs_modulus"), std::string::npos);
}

} // namespace asperity::md::crystal_test
