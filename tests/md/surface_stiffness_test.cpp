// Tests of md/lattice/surface_stiffness.hpp: the symbol of every wavevector is
// stored where the transforms expect it, and K and its inverse are consistent.
#include "md/lattice/surface_stiffness.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace asperity::md::surface_stiffness_test {

using mechanics::AtomModes;

constexpr double spacing = 2.6e-10;
constexpr Crystal crystal{mechanics::AtomLattice::isotropic, spacing, 77.2e9,
                          0.42};

// Sums over the layer of a few hundred terms of either sign.
constexpr double rounding = 1e-12;

Grid layer_of(int points) {
  return {points, points, points * spacing, points * spacing};
}

/// Three planes in one vector, and the views of them.
struct Planes {
  explicit Planes(const Grid& grid) : n(grid.size()), values(3 * n, 0.0) {}

  std::span<double> plane(std::size_t axis) {
    return std::span(values).subspan(axis * n, n);
  }

  LayerView view() { return {plane(0), plane(1), plane(2)}; }

  LayerForces target() { return {plane(0), plane(1), plane(2)}; }

  std::size_t n;
  std::vector<double> values;
};

Planes random_planes(const Grid& grid, unsigned seed) {
  Planes planes(grid);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1e-11, 1e-11);
  for (double& value : planes.values)
    value = uniform(generator);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0.0;
    for (const double value : planes.plane(axis))
      sum += value;
    for (double& value : planes.plane(axis))
      value -= sum / static_cast<double>(planes.n);
  }
  return planes;
}

double dot(const Planes& left, const Planes& right) {
  double sum = 0.0;
  for (std::size_t i = 0; i < left.values.size(); ++i)
    sum += left.values[i] * right.values[i];
  return sum;
}

/// The reference: layers of cells, atom by atom, every cell with its 24
/// unknowns.
class PlainBlock {
public:
  PlainBlock(int points, int cells)
      : points_(points), cells_(cells), stiffness_(cell_stiffness(crystal)) {}

  /// Forces that keep the atoms of the block in place; planes by height, then
  /// axis.
  std::vector<double> forces(const std::vector<double>& u) const {
    std::vector<double> f(u.size(), 0.0);
    for (int cell = 0; cell < points_ * points_ * cells_; ++cell)
      for (std::size_t i = 0; i < 24; ++i)
        for (std::size_t j = 0; j < 24; ++j)
          f[index(cell, i)] += stiffness_[24 * i + j] * u[index(cell, j)];
    return f;
  }

private:
  std::size_t index(int cell, std::size_t unknown) const {
    const auto corner = static_cast<int>(unknown / 3);
    const int x = (cell % points_ + (corner & 1)) % points_;
    const int y = (cell / points_ % points_ + ((corner >> 1) & 1)) % points_;
    const int z = cell / points_ / points_ + (corner >> 2);
    const int n = points_ * points_;
    return static_cast<std::size_t>(
        (3 * z + static_cast<int>(unknown % 3)) * n + y * points_ + x);
  }

  int points_;
  int cells_;
  CellStiffness stiffness_;
};

class EveryDepth : public ::testing::TestWithParam<int> {};

// K is the Schur complement: with the inner atoms relaxed (conjugate gradients
// on the plain block, to 1e-14), the forces on the lower ones are K u.
// Tolerance: that of the inner solution. With one layer of cells nothing is
// relaxed, and K u is the sum over the cells.
TEST_P(EveryDepth, IsTheBlockWithItsInsideRelaxed) {
  const Grid layer = layer_of(6);
  const int cells = GetParam();
  SurfaceStiffness stiffness(crystal, layer, cells, AtomModes::vector);
  Planes u = random_planes(layer, 3);
  Planes forces(layer);
  const double energy = stiffness.apply(u.view(), forces.target());

  const PlainBlock block(6, cells);
  const std::size_t first = u.values.size();
  const std::size_t end = static_cast<std::size_t>(cells) * first;
  // The top plane, beyond the end, is clamped.
  std::vector<double> all(end + first, 0.0);
  std::ranges::copy(u.values, all.begin());
  std::vector<double> residual = block.forces(all);
  std::vector<double> direction(all.size(), 0.0);
  double before = 1.0;
  for (int step = 0; step < 400; ++step) {
    double now = 0.0;
    for (std::size_t i = first; i < end; ++i)
      now += residual[i] * residual[i];
    for (std::size_t i = first; i < end; ++i)
      direction[i] = -residual[i] + (step ? now / before : 0.0) * direction[i];
    if (now < 1e-44)
      break;
    const std::vector<double> change = block.forces(direction);
    double curvature = 0.0;
    for (std::size_t i = first; i < end; ++i)
      curvature += direction[i] * change[i];
    for (std::size_t i = 0; i < end; ++i) {
      all[i] += now / curvature * direction[i];
      residual[i] += now / curvature * change[i];
    }
    before = now;
  }

  // Without its mean force: the uniform displacement is determined by the
  // caller.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0.0;
    for (std::size_t i = 0; i < u.n; ++i)
      sum += residual[axis * u.n + i];
    for (std::size_t i = 0; i < u.n; ++i)
      EXPECT_NEAR(forces.plane(axis)[i],
                  residual[axis * u.n + i] - sum / static_cast<double>(u.n),
                  1e-10 * 20.0 * 1e-11);
  }
  EXPECT_NEAR(energy / (0.5 * dot(u, forces)), 1.0, rounding);
}

INSTANTIATE_TEST_SUITE_P(Depths, EveryDepth, ::testing::Values(1, 3));

class BothModes : public ::testing::TestWithParam<AtomModes> {};

TEST_P(BothModes, SolveInvertsStiffnessAndContactTogether) {
  const Grid layer = layer_of(10);
  SurfaceStiffness stiffness(crystal, layer, 10, GetParam());
  const ContactStiffness contact{0.3, 1.2};
  Planes u = random_planes(layer, 5);
  if (GetParam() == AtomModes::normal) {
    std::ranges::fill(u.plane(0), 0.0);
    std::ranges::fill(u.plane(1), 0.0);
  }
  Planes forces(layer);

  stiffness.apply(u.view(), forces.target());
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < u.n; ++i)
      forces.plane(axis)[i] +=
          (axis == 2 ? contact.normal : contact.lateral) * u.plane(axis)[i];
  Planes back(layer);
  stiffness.solve(forces.view(), contact, back.target());

  for (std::size_t i = 0; i < u.values.size(); ++i)
    EXPECT_NEAR(back.values[i], u.values[i], rounding * 1e-10);
}

TEST_P(BothModes, LeavesTheUniformDisplacementUnchanged) {
  const Grid layer = layer_of(10);
  SurfaceStiffness stiffness(crystal, layer, 10, GetParam());
  Planes u(layer);
  std::ranges::fill(u.values, 1e-10);
  Planes forces(layer);

  EXPECT_EQ(stiffness.apply(u.view(), forces.target()), 0.0);
  stiffness.solve(u.view(), {1.0, 1.0}, forces.target());

  for (const double value : forces.values)
    EXPECT_NEAR(value, 0.0, rounding * 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Modes, BothModes,
                         ::testing::Values(AtomModes::vector,
                                           AtomModes::normal));

// The normal mode is the vector mode without tangential force: the force K_n
// u_z, alone, gives the displacement u_z.
TEST(NormalModes, HaveNoTangentialForce) {
  const Grid layer = layer_of(8);
  SurfaceStiffness normal(crystal, layer, 8, AtomModes::normal);
  SurfaceStiffness vector(crystal, layer, 8, AtomModes::vector);
  Planes u = random_planes(layer, 9);
  std::ranges::fill(u.plane(0), 0.0);
  std::ranges::fill(u.plane(1), 0.0);
  Planes forces(layer);
  Planes back(layer);

  normal.apply(u.view(), forces.target());
  vector.solve(forces.view(), {}, back.target());

  for (std::size_t i = 0; i < u.n; ++i)
    EXPECT_NEAR(back.plane(2)[i], u.plane(2)[i], rounding * 1e-10);
  EXPECT_LT(dot(forces, u), 2.0 * vector.apply(u.view(), back.target()));
}

TEST(SurfaceStiffness, RefusesAnotherLayer) {
  const auto refusal = [](const Grid& layer, int cells) -> std::string {
    return tests::message_of<std::domain_error>(
        [&] { SurfaceStiffness(crystal, layer, cells, AtomModes::vector); });
  };

  EXPECT_NE(refusal({8, 6, 8 * spacing, 6 * spacing}, 4).find("points_y"),
            std::string::npos);
  EXPECT_NE(refusal(layer_of(7), 4).find("even"), std::string::npos);
  EXPECT_NE(refusal({8, 8, 9 * spacing, 9 * spacing}, 4).find("spacing"),
            std::string::npos);
  EXPECT_NE(refusal(layer_of(8), 0).find("cells"), std::string::npos);
}

} // namespace asperity::md::surface_stiffness_test
