// Tests of blocks with a yield stress: the law at a point, uniaxial strain and
// its unloading against the closed form, the limit of no flow, and a sphere.
#include "fem/block/material_points.hpp"
#include "fem/linear/hexahedron_block.hpp"
#include "fem/material/hooke.hpp"
#include "fem/material/j2_plasticity.hpp"
#include "fem/material/material_law.hpp"
#include "fem/solution/meshed_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "tests/fem/block_vectors.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

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

/// lambda tr(e) 1 + 2 mu e - (s : e) s [Pa], s the softening of the tangent.
/// @param strain  e [1]
Tensor stress_of(const PointTangent& tangent, const Tensor& strain) {
  Tensor s;
  const auto& own = tangent.softening;
  s[0][0] = own[0];
  s[1][1] = own[1];
  s[2][2] = own[2];
  s[1][2] = own[3];
  s[2][0] = own[4];
  s[0][1] = own[5];
  return tangent.lame * trace(strain) * dealii::unit_symmetric_tensor<3>() +
         2.0 * tangent.shear * strain - (s * strain) * s;
}

/// The yield stress and its increase with plastic strain [Pa].
struct Plasticity {
  double yield_stress = 0.0, hardening = 0.0;

  double yield_stress_after(double strain) const {
    return yield_stress + hardening * strain;
  }

  std::shared_ptr<const MaterialLaw> law() const {
    return j2_plasticity(yield_stress, hardening);
  }
};

/// A point that has gone through strains.
struct Point {
  Tensor plastic_strain;
  double equivalent = 0.0;
  PointResponse last = {};

  Tensor stress(const Tensor& strain) const {
    return elastic_stress(strain - plastic_strain, elastic);
  }

  Point at(const Tensor& strain, const Plasticity& plasticity) const {
    Point next = *this;
    next.last = plasticity.law()->respond(strain, plastic_strain, elastic,
                                          {&next.equivalent, 1});
    next.plastic_strain = next.last.inelastic_strain;
    return next;
  }
};

// The stress is on the grown yield surface, the flow keeps the volume and has
// the direction of the deviator, and going back a little is elastic.
TEST(J2Plasticity, ReturnsToTheYieldSurface) {
  const Plasticity law{0.01 * soft_modulus, 0.1 * soft_modulus};
  Point before;
  for (unsigned int seed = 0; seed < 5; ++seed) {
    const Tensor strain = random_strain(seed, 0.02);
    const Point found = before.at(strain, law);
    ASSERT_FALSE(found.last.is_elastic);
    EXPECT_GT(found.equivalent, before.equivalent);
    const double allowed = law.yield_stress_after(found.equivalent);
    EXPECT_NEAR(von_mises(found.stress(strain)), allowed, 1e-12 * allowed);
    EXPECT_NEAR(trace(found.plastic_strain), 0.0, 1e-16);
    const Tensor flow = found.plastic_strain - before.plastic_strain;
    const Tensor stress = deviator(found.stress(strain));
    EXPECT_NEAR(flow * stress, flow.norm() * stress.norm(),
                1e-12 * flow.norm() * stress.norm());
    EXPECT_TRUE(found.at(strain, law).last.is_elastic);
    EXPECT_TRUE(found.at(strain - 1e-3 / elastic.shear_modulus * stress, law)
                    .last.is_elastic);
    before = found;
  }
}

// The tangent is the derivative of the stress, by central differences.
// Tolerance: their error of second order and roundoff.
TEST(J2Plasticity, HasTheDerivativeOfItsStress) {
  for (const double hardening : {0.0, 0.1, 3.0}) {
    const Plasticity law{0.01 * soft_modulus, hardening * soft_modulus};
    const Point before = Point{}.at(random_strain(1, 0.02), law);
    const Tensor strain = random_strain(2, 0.05);
    const Point found = before.at(strain, law);
    ASSERT_FALSE(found.last.is_elastic);
    const auto stress_at = [&](const Tensor& there) {
      return before.at(there, law).stress(there);
    };
    for (unsigned int seed = 3; seed < 6; ++seed) {
      const Tensor step = random_strain(seed, 1e-6);
      const Tensor change =
          0.5 * (stress_at(strain + step) - stress_at(strain - step));
      EXPECT_LT((stress_of(found.last.tangent, step) - change).norm(),
                1e-7 * change.norm())
          << hardening;
    }
  }
}

double work_of(const BlockSolution& solution) {
  return solution.of_material.at("plastic_work");
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
  problem.law = law.law();
  return problem;
}

// The tangents of the cells are the derivative of the force, on distorted cells
// with hanging nodes, by central differences, and the cells are elastic again
// without them. With a hundredth of the elastic stiffness along the flow,
// conjugate gradients with elastic levels take at most four times the
// iterations. Tolerance: measured 3e-10, the error of the differences.
TEST(MaterialPoints, HaveTheDerivativeOfTheForce) {
  const BlockProblem problem =
      flat_block(true, {0.01 * soft_modulus, 0.012 * soft_modulus});
  const BlockSystem system(problem);
  HexahedronBlock block(problem, system);
  MaterialPoints points(system);
  const auto force_at = [&](const BlockVector& displacement) {
    BlockVector force(displacement);
    block.vmult(force, displacement);
    points.follow(displacement, force);
    return force;
  };
  BlockVector displacement = random_vector(system, 1);
  displacement *= 2e-3 * length;
  const BlockVector step = random_vector(system, 2);
  const BlockVector expected =
      derivative_along(step, force_at, displacement, 1e-9 * length);
  const PartialContact none(system, 0.0, false);
  BlockVector elastic_force(step), found(step), again(step);
  block.vmult(elastic_force, step);
  const int iterations = iterations_with(block, none);

  static_cast<void>(force_at(displacement));
  ASSERT_FALSE(points.is_elastic());
  block.set_tangents(points.tangents());
  block.vmult(found, step);
  const int flowing_iterations = iterations_with(block, none);
  block.set_tangents({});
  block.vmult(again, step);

  EXPECT_GT(relative_difference(elastic_force, expected), 0.05);
  EXPECT_LT(relative_difference(found, expected), 1e-8);
  EXPECT_EQ(relative_difference(again, elastic_force), 0.0);
  EXPECT_LE(flowing_iterations, 4 * iterations);
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
        EXPECT_NEAR(found.of_material.at("plastic_strain"),
                    expected.equivalent(), 1e-7 * scale);
        EXPECT_NEAR(work_of(found), expected.work(),
                    1e-7 * scale * law.yield_stress * length);
        const double stress = pressure < first
                                  ? pressure / first * law.yield_stress
                                  : expected.von_mises_at(pressure);
        EXPECT_NEAR(block.strongest_stress().von_mises, stress, 1e-7 * stress)
            << is_shaken << hardening << pressure / first;
      }
    }
}

/// A sphere on a block of halved boxes with 3 cells per contact radius.
BlockProblem under_sphere(std::optional<Plasticity> law) {
  BlockProblem problem = boxes_problem({32, 32, length, length}, 2,
                                       {soft_modulus, poisson}, length);
  problem.mesh = meshes::hanging_mesh({16, 16, length, length}, length, 4);
  problem.linear_solver = LinearSolver::multigrid;
  if (law)
    problem.law = law->law();
  return problem;
}

BlockSolution press(MeshedBlock& block, double nominal_pressure,
                    mechanics::ContactLaw law) {
  return block.solve(surfaces::paraboloid(block.grid(), 10.0 * length).heights,
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
    EXPECT_EQ(work_of(found), 0.0);
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
  EXPECT_GT(work_of(half), 0.0);
  EXPECT_GT(work_of(full), 2.0 * work_of(half));
  EXPECT_NEAR(work_of(back), work_of(full), 0.02 * work_of(full));
  EXPECT_GT(full.area_by_points, stiff.area_by_points);
  EXPECT_LT(largest_magnitude(full.pressure),
            0.9 * largest_magnitude(stiff.pressure));
  EXPECT_GT(back.area_by_points, half.area_by_points);
  EXPECT_LT(block.strongest_stress().von_mises,
            (1.0 + 1e-9) * law.yield_stress);
}

/// Presses a flat block on a wave, with a load relative to its modulus.
BlockSolution press_wave(MeshedBlock& block, double load) {
  return block.solve(
      wave_heights(block.grid(), 2e-2 * length),
      {mechanics::Control::nominal_pressure, load * soft_modulus},
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
    ASSERT_GT(work_of(half), 0.0);

    ASSERT_TRUE(resumed.recall(block.memory()));
    EXPECT_EQ(block.memory(), resumed.memory());
    const BlockSolution full = press_wave(block, 0.03);
    const BlockSolution again = press_wave(resumed, 0.03);

    ASSERT_TRUE(full.converged) << full.note;
    EXPECT_GT(work_of(full), work_of(half));
    EXPECT_EQ(full.pressure, again.pressure);
    EXPECT_EQ(full.gap, again.gap);
    EXPECT_EQ(work_of(full), work_of(again));
    EXPECT_EQ(full.linear_iterations, again.linear_iterations);
    EXPECT_EQ(block.memory(), resumed.memory());
  }
}

TEST(PlasticBlock, RefusesWhatItDoesNotCompute) {
  MeshedBlock block(flat_block(false, {1e6, 0.0}));
  const std::vector<double> heights(block.grid().size(), 0.0);
  EXPECT_THROW(block.solve(heights, {mechanics::Control::mean_gap, 1e-9},
                           {mechanics::ContactLaw::hard, 1e15, 1e-8, 10}),
               std::domain_error);
  EXPECT_THROW(block.stiffness(), std::domain_error);
  BlockProblem distorted = flat_block(true, {1e6, 0.0});
  distorted.degree = 1;
  EXPECT_THROW(MeshedBlock{distorted}, std::domain_error);
}

} // namespace asperity::fem::plastic_block_test
