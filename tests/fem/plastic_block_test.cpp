// Tests of blocks with a yield stress: the law at a point, uniaxial strain and
// its unloading against the closed form, the limit of no flow, and a sphere.
#include "fem/block/plastic_response.hpp"
#include "fem/solution/meshed_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "tests/fem/tangent_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace asperity::fem::plastic_block_test {

using Tensor = dealii::SymmetricTensor<2, 3>;

constexpr double length = 1e-6; // m
constexpr double poisson = 0.3;
const Moduli elastic = moduli(mechanics::BodyModuli{soft_modulus, poisson});

Tensor random_strain(unsigned int seed, double size) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Tensor strain;
  for (unsigned int i = 0; i < 6; ++i)
    strain.access_raw_entry(i) = size * normal(random);
  return strain;
}

double von_mises_of(const Tensor& strain, const PointHistory& history) {
  return von_mises(plastic_stress(strain, history, elastic));
}

// The stress is on the grown yield surface, the flow keeps the volume and has
// the direction of the deviator, and going back a little is elastic.
TEST(PlasticResponse, ReturnsToTheYieldSurface) {
  const Plasticity law{0.01 * soft_modulus, 0.1 * soft_modulus};
  PointHistory history;
  for (unsigned int seed = 0; seed < 5; ++seed) {
    const Tensor strain = random_strain(seed, 0.02);
    const FlowResponse found = plastic_response(strain, history, elastic, law);
    ASSERT_TRUE(found.is_flowing);
    EXPECT_GT(found.history.equivalent, history.equivalent);
    const double allowed = law.yield_stress_after(found.history.equivalent);
    EXPECT_NEAR(von_mises_of(strain, found.history), allowed, 1e-12 * allowed);
    EXPECT_NEAR(trace(found.history.plastic_strain), 0.0, 1e-16);
    const Tensor flow = found.history.plastic_strain - history.plastic_strain;
    const Tensor stress =
        deviator(plastic_stress(strain, found.history, elastic));
    EXPECT_NEAR(flow * stress, flow.norm() * stress.norm(),
                1e-12 * flow.norm() * stress.norm());
    EXPECT_FALSE(
        plastic_response(strain, found.history, elastic, law).is_flowing);
    EXPECT_FALSE(
        plastic_response(strain - 1e-3 / elastic.shear_modulus * stress,
                         found.history, elastic, law)
            .is_flowing);
    history = found.history;
  }
}

// The tangent is the derivative of the stress, by central differences.
// Tolerance: their error of second order and roundoff.
TEST(PlasticResponse, HasTheDerivativeOfItsStress) {
  for (const double hardening : {0.0, 0.1, 3.0}) {
    const Plasticity law{0.01 * soft_modulus, hardening * soft_modulus};
    const PointHistory before =
        plastic_response(random_strain(1, 0.02), {}, elastic, law).history;
    const Tensor strain = random_strain(2, 0.05);
    const FlowResponse found = plastic_response(strain, before, elastic, law);
    ASSERT_TRUE(found.is_flowing);
    const auto stress_at = [&](const Tensor& there) {
      return plastic_stress(
          there, plastic_response(there, before, elastic, law).history,
          elastic);
    };
    for (unsigned int seed = 3; seed < 6; ++seed) {
      const Tensor step = random_strain(seed, 1e-6);
      const Tensor change =
          0.5 * (stress_at(strain + step) - stress_at(strain - step));
      EXPECT_LT((stress_of(found.tangent, step) - change).norm(),
                1e-7 * change.norm())
          << hardening;
    }
  }
}

/// A flat block of hexahedra, of cells of one or of several sizes.
BlockProblem flat_block(bool is_shaken, const Plasticity& law) {
  BlockProblem problem =
      boxes_problem({8, 8, length, length}, 2, {soft_modulus, poisson}, length);
  if (is_shaken) {
    problem.mesh = meshes::hanging_mesh({4, 4, length, length}, length, 1);
    const std::vector<meshes::Place> straight = problem.mesh.vertices;
    shake(problem.mesh, 0.05 * length);
    const auto is_inside = [](double x) {
      return x > 1e-9 * length && x < (1.0 - 1e-9) * length;
    };
    for (std::size_t i = 0; i < straight.size(); ++i)
      if (!is_inside(straight[i][0]) || !is_inside(straight[i][1]))
        problem.mesh.vertices[i] = straight[i];
  }
  problem.plasticity = law;
  return problem;
}

/// Compression of a block without lateral strain by a pressure that rises to a
/// highest value.
struct UniaxialStrain {
  Plasticity law;
  double highest = 0.0; ///< [Pa]

  /// With the von Mises stress 2 mu (e - 3/2 alpha) = Y + H alpha, and the
  /// pressure kappa e + 2/3 of it.
  double equivalent() const {
    const double bulk =
        elastic.lame_modulus + 2.0 / 3.0 * elastic.shear_modulus;
    const double twice = 2.0 * elastic.shear_modulus;
    return std::max(0.0,
                    (twice * (highest - 2.0 / 3.0 * law.yield_stress) / bulk -
                     law.yield_stress) /
                        (law.hardening + 1.5 * twice +
                         2.0 / 3.0 * twice * law.hardening / bulk));
  }

  /// The von Mises stress after unloading to a pressure.
  double von_mises_at(double pressure) const {
    const double fall = 2.0 * elastic.shear_modulus * (highest - pressure) /
                        (elastic.lame_modulus + 2.0 * elastic.shear_modulus);
    return std::abs(law.yield_stress_after(equivalent()) - fall);
  }

  double work() const {
    return length * equivalent() * law.yield_stress_after(0.5 * equivalent());
  }
};

// A flat block under loads that rise and fall flows as the closed form says,
// on boxes and on distorted cells with hanging nodes, with and without
// hardening, and unloads elastically. Tolerance: that of the balance of forces.
TEST(PlasticBlock, FlowsUnderUniaxialStrain) {
  for (const bool is_shaken : {false, true})
    for (const double hardening : {0.0, 0.2}) {
      const Plasticity law{0.01 * soft_modulus, hardening * soft_modulus};
      MeshedBlock block(flat_block(is_shaken, law));
      const std::vector<double> heights(block.grid().size(), 0.0);
      const double first = law.yield_stress * (1.0 - poisson) /
                           (1.0 - 2.0 * poisson); // where it begins to flow
      UniaxialStrain expected{law, 0.0};
      for (const double pressure :
           {0.99 * first, 1.5 * first, 2.5 * first, 2.2 * first}) {
        expected.highest = std::max(expected.highest, pressure);
        const BlockSolution found = block.solve(
            heights, {mechanics::Control::nominal_pressure, pressure},
            {mechanics::ContactLaw::hard, 100.0 * soft_modulus / length, 1e-10,
             100});
        ASSERT_TRUE(found.converged) << found.note;
        const double scale = law.yield_stress / soft_modulus;
        EXPECT_NEAR(found.plastic_strain, expected.equivalent(), 1e-7 * scale);
        EXPECT_NEAR(found.plastic_work, expected.work(),
                    1e-7 * scale * law.yield_stress * length);
        const double stress = pressure < first
                                  ? pressure / first * law.yield_stress
                                  : expected.von_mises_at(pressure);
        EXPECT_NEAR(block.strongest_stress().von_mises, stress, 1e-7 * stress)
            << is_shaken << hardening << pressure / first;
      }
    }
}

std::vector<double> sphere_heights(const Grid& grid, double sphere) {
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double r = std::hypot((ix - grid.points_x / 2) * grid.spacing_x(),
                                  (iy - grid.points_y / 2) * grid.spacing_y());
      heights[grid.index(ix, iy)] = -0.5 * r * r / sphere;
    }
  return heights;
}

/// A sphere on a block of halved boxes with 3 cells per contact radius.
BlockProblem under_sphere(std::optional<Plasticity> law) {
  BlockProblem problem = boxes_problem({32, 32, length, length}, 2,
                                       {soft_modulus, poisson}, length);
  problem.mesh = meshes::hanging_mesh({16, 16, length, length}, length, 4);
  problem.linear_solver = LinearSolver::multigrid;
  problem.plasticity = law;
  return problem;
}

BlockSolution press(MeshedBlock& block, double nominal_pressure,
                    mechanics::ContactLaw law) {
  return block.solve(sphere_heights(block.grid(), 10.0 * length),
                     {mechanics::Control::nominal_pressure, nominal_pressure},
                     {law, 1e3 * soft_modulus / length, 1e-9, 200});
}

const double modulus = soft_modulus / (1.0 - poisson * poisson);

/// The nominal pressure at which Hertz' contact has this radius [Pa], and its
/// largest pressure then.
double load_of(double radius) {
  return 4.0 / 3.0 * modulus * std::pow(radius, 3) /
         (10.0 * length * length * length);
}

double peak_of(double radius) {
  return 2.0 * modulus * radius / (M_PI * 10.0 * length);
}

// A block that never flows is the elastic one, bit for bit.
TEST(PlasticBlock, IsElasticBelowItsYieldStress) {
  MeshedBlock never(under_sphere(Plasticity{1e3 * soft_modulus, 0.0}));
  MeshedBlock block(under_sphere({}));
  const double load = load_of(0.2 * length);
  for (const auto law :
       {mechanics::ContactLaw::hard, mechanics::ContactLaw::penalty}) {
    const BlockSolution found = press(never, load, law);
    const BlockSolution expected = press(block, load, law);
    ASSERT_TRUE(found.converged && expected.converged);
    EXPECT_EQ(found.plastic_work, 0.0);
    EXPECT_EQ(found.mean_gap, expected.mean_gap);
    EXPECT_EQ(largest_difference(found.pressure, expected.pressure), 0.0);
    EXPECT_EQ(never.strongest_stress().von_mises,
              block.strongest_stress().von_mises);
  }
}

// A sphere under a load that rises and falls: the work of plastic flow rises
// with the load and stays on the way back, the contact is larger and its
// pressure lower than that of the elastic block, and on the way back it is
// larger than before.
TEST(PlasticBlock, LeavesAnImprintOfASphere) {
  const double radius = 0.25 * length;
  const Plasticity law{peak_of(radius) / 4.0, 0.0};
  MeshedBlock elastic_block(under_sphere({}));
  MeshedBlock block(under_sphere(law));
  const double load = load_of(radius);
  const BlockSolution stiff =
      press(elastic_block, load, mechanics::ContactLaw::hard);

  const BlockSolution half =
      press(block, 0.5 * load, mechanics::ContactLaw::hard);
  const BlockSolution full = press(block, load, mechanics::ContactLaw::hard);
  const BlockSolution back =
      press(block, 0.5 * load, mechanics::ContactLaw::hard);

  ASSERT_TRUE(half.converged && full.converged && back.converged)
      << half.note << full.note << back.note;
  RecordProperty("iterations", std::to_string(full.iterations));
  RecordProperty("linear", std::to_string(full.linear_iterations));
  EXPECT_GT(half.plastic_work, 0.0);
  EXPECT_GT(full.plastic_work, 2.0 * half.plastic_work);
  EXPECT_NEAR(back.plastic_work, full.plastic_work, 0.02 * full.plastic_work);
  EXPECT_GT(full.area_by_points, stiff.area_by_points);
  EXPECT_LT(largest_magnitude(full.pressure),
            0.9 * largest_magnitude(stiff.pressure));
  EXPECT_GT(back.area_by_points, half.area_by_points);
  EXPECT_LT(block.strongest_stress().von_mises,
            (1.0 + 1e-9) * law.yield_stress);
}

/// Presses a flat block on a wave, with a load relative to its modulus.
BlockSolution press_wave(MeshedBlock& block, double load) {
  const Grid& grid = block.grid();
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      heights[grid.index(ix, iy)] =
          2e-2 * length * std::cos(2.0 * M_PI * ix / grid.points_x);
  return block.solve(
      heights, {mechanics::Control::nominal_pressure, load * soft_modulus},
      {mechanics::ContactLaw::hard, 1e3 * soft_modulus / length, 1e-9, 200});
}

// A block that takes the memory of an equal one goes on from there bit for bit,
// with the geometric and with the algebraic multigrid, whose hierarchy the
// first block has set up for another contact.
TEST(PlasticBlock, GoesOnFromItsMemory) {
  const Plasticity law{0.01 * soft_modulus, 0.1 * soft_modulus};
  for (const bool is_shaken : {false, true}) {
    const BlockProblem problem = flat_block(is_shaken, law);
    MeshedBlock block(problem);
    MeshedBlock resumed(problem);
    EXPECT_FALSE(resumed.recall({}));
    const BlockSolution half = press_wave(block, 0.02);
    ASSERT_GT(half.plastic_work, 0.0);

    ASSERT_TRUE(resumed.recall(block.memory()));
    EXPECT_EQ(block.memory(), resumed.memory());
    const BlockSolution full = press_wave(block, 0.03);
    const BlockSolution again = press_wave(resumed, 0.03);

    ASSERT_TRUE(full.converged) << full.note;
    EXPECT_GT(full.plastic_work, half.plastic_work);
    EXPECT_EQ(full.pressure, again.pressure);
    EXPECT_EQ(full.gap, again.gap);
    EXPECT_EQ(full.plastic_work, again.plastic_work);
    EXPECT_EQ(full.linear_iterations, again.linear_iterations);
    EXPECT_EQ(block.memory(), resumed.memory());
  }
}

TEST(PlasticBlock, RefusesWhatItDoesNotCompute) {
  BlockProblem problem = flat_block(false, {1e6, 0.0});
  MeshedBlock block(problem);
  const std::vector<double> heights(block.grid().size(), 0.0);
  EXPECT_THROW(block.solve(heights, {mechanics::Control::mean_gap, 1e-9},
                           {mechanics::ContactLaw::hard, 1e15, 1e-8, 10}),
               std::domain_error);
  EXPECT_THROW(block.stiffness(), std::domain_error);
  problem.degree = 1;
  EXPECT_THROW(MeshedBlock{problem}, std::domain_error);
}

} // namespace asperity::fem::plastic_block_test
