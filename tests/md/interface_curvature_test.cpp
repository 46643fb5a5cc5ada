// Tests of the second derivatives of md/interface/interface.hpp and of
// md/interface/interface_curvature.hpp.
#include "base/maximum.hpp"
#include "base/special_numbers.hpp"
#include "md/interface/interface_curvature.hpp"
#include "tests/md/small_interface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace asperity::md::interface_curvature_test {

using problems::Planes;

Interface interface_of(const problems::InterfaceProblem& problem,
                       double attraction = 0.0, int threads = 1) {
  return {problems::paper_atoms(attraction), problem.layer, problem.substrate,
          problem.heights, threads};
}

double largest(const std::vector<SymmetricBlock>& blocks) {
  double most = 0.0;
  for (const SymmetricBlock& block : blocks)
    for (const double entry :
         {block.xx, block.yy, block.zz, block.xy, block.xz, block.yz})
      most = maximum(most, std::abs(entry));
  return most;
}

/// The decrease of all forces when every atom moves along one axis by `shift`,
/// divided by it, by a central difference.
Planes differences(const Interface& interface, Planes atoms,
                   std::vector<double> Planes::*axis, double shift) {
  Planes behind(atoms.x.size());
  Planes ahead(atoms.x.size());
  for (double& place : atoms.*axis)
    place -= shift;
  interface.energy_and_forces(atoms.view(), behind.forces());
  for (double& place : atoms.*axis)
    place += 2.0 * shift;
  interface.energy_and_forces(atoms.view(), ahead.forces());
  for (const auto component : {&Planes::x, &Planes::y, &Planes::z})
    for (std::size_t i = 0; i < atoms.x.size(); ++i)
      (behind.*component)[i] =
          ((behind.*component)[i] - (ahead.*component)[i]) / (2.0 * shift);
  return behind;
}

/// H of all atoms times a step, by the class.
Planes products(const InterfaceCurvature& curvature, const Planes& step) {
  Planes forces(step.x.size());
  curvature.add_product(step.view(), forces.forces());
  return forces;
}

double along(const Planes& left, const Planes& right, std::size_t i) {
  return left.x[i] * right.x[i] + left.y[i] * right.y[i] +
         left.z[i] * right.z[i];
}

Planes random_step(std::size_t atoms, unsigned seed) {
  Planes step(atoms);
  step.x = problems::random_numbers(atoms, -1.0, 1.0, seed);
  step.y = problems::random_numbers(atoms, -1.0, 1.0, seed + 1);
  step.z = problems::random_numbers(atoms, -1.0, 1.0, seed + 2);
  return step;
}

// A block is the finite difference of the force of its atom. Tolerance, of the
// largest entry: the difference leaves 14 15/6 (shift/r)^2 = 1e-7 at r = 2
// angstrom, and the roundoff of the forces 1e-12 r/(13 shift) = 2e-9.
TEST(SecondDerivatives, AreTheDifferencesOfTheForces) {
  const problems::InterfaceProblem problem(10, 16, 0.5 * problems::angstrom, 3);
  for (const double attraction : {0.0, 0.7}) {
    const Interface interface = interface_of(problem, attraction);
    std::vector<SymmetricBlock> blocks(problem.layer.size());
    const double shift = 1e-14;

    interface.second_derivatives(problem.atoms.view(), blocks);

    const Planes x = differences(interface, problem.atoms, &Planes::x, shift);
    const Planes y = differences(interface, problem.atoms, &Planes::y, shift);
    const Planes z = differences(interface, problem.atoms, &Planes::z, shift);
    const double tolerance = 2e-7 * largest(blocks);
    ASSERT_GT(tolerance, 0.0);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      EXPECT_NEAR(blocks[i].xx, x.x[i], tolerance);
      EXPECT_NEAR(blocks[i].yy, y.y[i], tolerance);
      EXPECT_NEAR(blocks[i].zz, z.z[i], tolerance);
      EXPECT_NEAR(blocks[i].xy, x.y[i], tolerance);
      EXPECT_NEAR(blocks[i].xz, x.z[i], tolerance);
      EXPECT_NEAR(blocks[i].yz, y.z[i], tolerance);
    }
  }
}

// The number of threads changes no bit, and an atom whose position is not
// finite has no second derivatives.
TEST(SecondDerivatives, AreTheSameBitsForAnyNumberOfThreads) {
  problems::InterfaceProblem problem(10, 16, 0.5 * problems::angstrom, 4);
  problem.atoms.x[7] = std::numeric_limits<double>::quiet_NaN();
  std::vector<SymmetricBlock> one(problem.layer.size());
  std::vector<SymmetricBlock> three(problem.layer.size());

  interface_of(problem).second_derivatives(problem.atoms.view(), one);
  interface_of(problem, 0.0, 3).second_derivatives(problem.atoms.view(), three);

  EXPECT_TRUE(std::isnan(one[7].zz));
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (i == 7)
      continue;
    EXPECT_EQ(one[i].xx, three[i].xx);
    EXPECT_EQ(one[i].yz, three[i].yz);
  }
  one.pop_back();
  EXPECT_THROW(
      interface_of(problem).second_derivatives(problem.atoms.view(), one),
      std::domain_error);
}

// No atom is softer than the given limit, one that was not softer is unchanged,
// and infinity restores the original. Tolerance: 3 x 3 eigenvalues in closed
// form, accurate to about the root of the roundoff of the largest.
TEST(InterfaceCurvature, ConvexifiesEachAtom) {
  const problems::InterfaceProblem problem(10, 16, 0.5 * problems::angstrom, 5);
  const std::size_t n = problem.layer.size();
  const double bulk = 10.0;
  InterfaceCurvature curvature(n, bulk, false);
  curvature.take(interface_of(problem), problem.atoms.view());
  std::vector<SymmetricBlock> blocks(n);
  interface_of(problem).second_derivatives(problem.atoms.view(), blocks);
  const double rounding = 1e-7 * largest(blocks);
  int softened = 0;

  for (unsigned seed = 0; seed < 60; seed += 3) {
    const Planes step = random_step(n, seed);
    curvature.limit_negative_curvature(infinity);
    const Planes whole = products(curvature, step);
    curvature.limit_negative_curvature(0.01);
    const Planes limited = products(curvature, step);
    for (std::size_t i = 0; i < n; ++i) {
      const double square = along(step, step, i);
      EXPECT_GE(along(step, limited, i), -(0.01 * bulk + rounding) * square);
      EXPECT_GE(along(step, limited, i),
                along(step, whole, i) - rounding * square);
      softened +=
          along(step, limited, i) > along(step, whole, i) + 0.01 * bulk * square
              ? 1
              : 0;
    }
    curvature.limit_negative_curvature(infinity);
    EXPECT_EQ(products(curvature, step).x, whole.x);
  }
  EXPECT_GT(softened, 0);
  EXPECT_THROW(curvature.limit_negative_curvature(-1.0), std::domain_error);
}

// Verifies S (k + max(H, 0)) S = k + k_c for every atom. Tolerance as above.
TEST(InterfaceCurvature, EqualisesAllAtoms) {
  const problems::InterfaceProblem problem(10, 16, 0.5 * problems::angstrom, 6);
  const std::size_t n = problem.layer.size();
  const double bulk = 10.0;
  InterfaceCurvature curvature(n, bulk, false);
  curvature.take(interface_of(problem), problem.atoms.view());
  curvature.limit_negative_curvature(0.0);
  const Planes step = random_step(n, 1);

  Planes scaled = step;
  curvature.scale(scaled.forces());
  Planes forces = products(curvature, scaled);
  for (const auto axis : {&Planes::x, &Planes::y, &Planes::z})
    for (std::size_t i = 0; i < n; ++i)
      (forces.*axis)[i] += bulk * (scaled.*axis)[i];
  curvature.scale(forces.forces());

  const double alike = bulk + curvature.mean_stiffness();
  EXPECT_GT(alike, 1.1 * bulk);
  for (const auto axis : {&Planes::x, &Planes::y, &Planes::z})
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR((forces.*axis)[i], alike * (step.*axis)[i], 1e-6 * alike);
}

} // namespace asperity::md::interface_curvature_test
