// Tests of blocks that flow over a loading path: the balance of energies of an
// implicit step and its order, halved load steps, the order of loads, cells of
// first order, and a sphere from its first flow to full flow.
#include "fem/block/material_points.hpp"
#include "fem/material/hooke.hpp"
#include "fem/material/j2_plasticity.hpp"
#include "fem/newton/contact_newton.hpp"
#include "fem/refined/refined_block.hpp"
#include "fem/solution/face_maps.hpp"
#include "fem/solution/meshed_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "tests/fem/block_vectors.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace asperity::fem::plastic_balance_test {

constexpr double length = 1e-6; // m
constexpr double poisson = 0.3;
constexpr double modulus = soft_modulus / (1.0 - poisson * poisson);
constexpr double yield_stress = 0.01 * soft_modulus;

/// Crossed waves, of which each contact flows.
std::vector<double> hills(const Grid& grid) {
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      heights[grid.index(ix, iy)] =
          1e-2 * length *
          (std::cos(2.0 * std::numbers::pi * ix / grid.points_x) +
           std::cos(2.0 * std::numbers::pi * iy / grid.points_y));
  return heights;
}

BlockProblem yielding_boxes(int degree, int points = 8,
                            double yield = yield_stress) {
  BlockProblem problem = boxes_problem({points, points, length, length}, degree,
                                       {soft_modulus, poisson}, length);
  problem.law = j2_plasticity(yield, 0.0);
  return problem;
}

BlockSolution press(FullBlock& block, double share_of_modulus,
                    mechanics::ContactLaw law = mechanics::ContactLaw::hard) {
  const BlockSolution found = block.solve(
      hills(block.grid()),
      {mechanics::Control::nominal_pressure, share_of_modulus * soft_modulus},
      {law, 1e3 * soft_modulus / length, 1e-10, 300});
  EXPECT_TRUE(found.converged) << found.note;
  return found;
}

// The tangents of first-order boxes are the derivative of the force, by central
// differences, and the boxes are elastic again without them.
TEST(MaterialPoints, HaveTheDerivativeOfTheForceOfBoxes) {
  const BlockProblem problem = yielding_boxes(1);
  const BlockSystem system(problem);
  const std::unique_ptr<BlockInverse> block = refined_block_of(problem, system);
  MaterialPoints points(system);
  const auto force_at = [&](const BlockVector& displacement) {
    BlockVector force(displacement);
    block->vmult(force, displacement);
    points.follow(displacement, force);
    return force;
  };
  BlockVector displacement = random_vector(system, 1);
  displacement *= 2e-3 * length;
  const BlockVector step = random_vector(system, 2);
  const BlockVector expected =
      derivative_along(step, force_at, displacement, 1e-9 * length);
  BlockVector elastic_force(step), found(step), again(step);
  block->vmult(elastic_force, step);

  static_cast<void>(force_at(displacement));
  ASSERT_FALSE(points.is_elastic());
  block->set_tangents(points.tangents());
  block->vmult(found, step);
  block->set_tangents({});
  block->vmult(again, step);

  EXPECT_GT(relative_difference(elastic_force, expected), 0.05);
  EXPECT_LT(relative_difference(found, expected), 1e-7);
  EXPECT_EQ(relative_difference(again, elastic_force), 0.0);
}

/// Energies of a part of the loading path [J].
struct Energies {
  double work_at_end = 0.0;  ///< of the contact forces at the end of each step
  double work_between = 0.0; ///< of the means of those before and after
  double elastic = 0.0;      ///< stored at the end
  double flow = 0.0;         ///< dissipated
  double steps = 0.0;        ///< sum of the elastic energies of dsigma
  double lag = 0.0;          ///< sum of dsigma : d(plastic strain)/2
};

/// A block that is pressed, with the stresses after its last step.
class Balance {
public:
  explicit Balance(const BlockProblem& problem)
      : system_(problem),
        maps_(system_),
        newton_(system_, LinearSolver::multigrid,
                refined_block_of(problem, system_)),
        values_(system_.space().mapping(), system_.space().element(),
                system_.space().cell_quadrature(), dealii::update_JxW_values),
        strains_(system_.space()) {}

  void press(double share_of_modulus) {
    const std::vector<double> pressure = newton_.state().pressure;
    const std::vector<double> place = newton_.state().face_displacement;
    BlockSolution answer;
    newton_.solve(
        maps_.at_points(hills(system_.grid())), 1e-2 * length,
        {mechanics::Control::nominal_pressure, share_of_modulus * soft_modulus},
        {mechanics::ContactLaw::hard, 1e3 * soft_modulus / length, 1e-10, 300},
        answer);
    ASSERT_TRUE(answer.converged) << answer.note;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      const double way = system_.contact()[i].area *
                         (newton_.state().face_displacement[i] - place[i]);
      sums.work_at_end += newton_.state().pressure[i] * way;
      sums.work_between +=
          0.5 * (newton_.state().pressure[i] + pressure[i]) * way;
    }
    sums.flow =
        answer.of_material.at("plastic_work") * system_.contact().area();
    add_stresses();
  }

  Energies sums;

private:
  struct Point {
    dealii::SymmetricTensor<2, 3> stress, plastic_strain;
  };

  void add_stresses() {
    strains_.set(newton_.state().displacement);
    sums.elastic = 0.0;
    std::size_t next = 0;
    for (const auto& cell :
         system_.space().dof_handler().active_cell_iterators()) {
      values_.reinit(cell);
      const Moduli own = system_.moduli_of(cell);
      const std::vector<CellStrains::Strain> strains = strains_.at_points(cell);
      std::vector<CellStrains::Strain> elastic_strains = strains;
      newton_.state().material()->subtract_from(elastic_strains, cell);
      points_.resize(std::max(points_.size(), next + strains.size()));
      for (std::size_t q = 0; q < strains.size(); ++q, ++next) {
        const Point now{elastic_stress(elastic_strains[q], own),
                        strains[q] - elastic_strains[q]};
        const auto change = now.stress - points_[next].stress;
        const double half = 0.5 * values_.JxW(static_cast<unsigned int>(q));
        sums.elastic += half * elastic_product(now.stress, now.stress, own);
        sums.steps += half * elastic_product(change, change, own);
        sums.lag +=
            half *
            (change * (now.plastic_strain - points_[next].plastic_strain));
        points_[next] = now;
      }
    }
  }

  BlockSystem system_;
  FaceMaps maps_;
  ContactNewton newton_;
  dealii::FEValues<3> values_;
  CellStrains strains_;
  std::vector<Point> points_;
};

constexpr double highest = 0.01; ///< load [E]

/// The way up in equal steps, and down to a quarter.
Energies cycle_in(const BlockProblem& problem, int steps) {
  Balance block(problem);
  for (int i = 1; i <= steps; ++i)
    block.press(highest * i / steps);
  for (int i = 1; i <= steps; ++i)
    block.press(highest * (1.0 - 0.75 * i / steps));
  return block.sums;
}

// A step of the implicit Euler method balances to the tolerance of the forces:
// the work of the contact forces at its end is the increase of the stored
// energy, the work of flow, and the energy of the change of the stress. The
// work of the mean forces falls short of the first two by half of dsigma :
// d(plastic strain), which falls faster than the steps: to less than half and
// then to less than 2/5 with twice the steps (measured 0.40 and 0.30), to 0.6 %
// with 16 steps up and down.
TEST(PlasticBalance, HoldsInEachStep) {
  for (const int degree : {1, 2}) {
    double before = std::numeric_limits<double>::infinity();
    for (const int steps : {4, 8, 16}) {
      const Energies sums = cycle_in(yielding_boxes(degree), steps);
      const double spent = sums.elastic + sums.flow;
      EXPECT_GT(sums.flow, 0.5 * spent);
      EXPECT_NEAR(sums.work_at_end, spent + sums.steps, 1e-9 * spent);
      EXPECT_NEAR(sums.work_between, spent - sums.lag, 1e-9 * spent);
      EXPECT_LT(sums.lag, (steps == 16 ? 0.4 : 0.5) * before);
      before = sums.lag;
      if (steps == 16) {
        EXPECT_NEAR(sums.work_between, spent, 0.01 * spent);
      }
    }
  }
}

/// Presses in equal steps up to the highest load.
BlockSolution press_in(FullBlock& block, int steps) {
  BlockSolution found;
  for (int i = 1; i <= steps; ++i)
    found = press(block, highest * i / steps);
  return found;
}

void expect_equal(const BlockSolution& found, const BlockSolution& expected,
                  double gap, double flow) {
  EXPECT_NEAR(found.mean_gap, expected.mean_gap, gap * expected.mean_gap);
  for (const char* name : {"plastic_work", "plastic_strain"})
    EXPECT_NEAR(found.of_material.at(name), expected.of_material.at(name),
                flow * expected.of_material.at(name))
        << name;
}

// What was unloaded and is loaded again is where it was: it has flowed on the
// way up only. Tolerance: that of the balance of forces; with the first order a
// tie between nodes of equal height costs 7e-6 of the gap and 2e-4 of the work.
TEST(PlasticBalance, ForgetsWhatIsElastic) {
  for (const int degree : {1, 2})
    for (const double share : {0.9, 0.5, 0.1}) {
      MeshedBlock block(yielding_boxes(degree));
      const BlockSolution up = press_in(block, 4);
      const BlockSolution back = press(block, share * highest);
      const BlockSolution again = press(block, highest);

      EXPECT_GT(up.of_material.at("plastic_strain"), 0.01);
      EXPECT_NE(back.mean_gap, up.mean_gap);
      if (degree == 2)
        expect_equal(again, up, 1e-8, 1e-8);
      else
        expect_equal(again, up, 1e-4, 1e-3);
      EXPECT_EQ(again.area_by_points, up.area_by_points);
    }
}

// The first load finds a contact that has many times the points of the elastic
// one, which cannot carry it at the yield stress (E* h' = 20 Y; measured 21
// iterations).
TEST(PlasticBalance, FindsContactsThatFlowWidens) {
  constexpr double load = 4e-3;
  MeshedBlock elastic_block(yielding_boxes(2, 16, soft_modulus));
  MeshedBlock block(yielding_boxes(2, 16, 3e-3 * soft_modulus));
  const BlockSolution elastic = press(elastic_block, load);
  const BlockSolution found = press(block, load);

  EXPECT_GT(found.area_by_points, 2.0 * elastic.area_by_points);
  EXPECT_LE(found.iterations, 40);
}

// Springs with multipliers find the contact of the active set, under a layer of
// 400 times the modulus that flows in bending.
TEST(PlasticBalance, HasTheContactOfTheActiveSetBySprings) {
  BlockProblem problem = yielding_boxes(2);
  problem.moduli.add_layer(
      0.1 * length, moduli(mechanics::BodyModuli{400.0 * soft_modulus, 0.0}));
  MeshedBlock held(problem);
  MeshedBlock sprung(problem);
  for (const double load : {1e-3, 2e-3, 2.02e-3}) {
    const BlockSolution expected = press(held, load);
    const BlockSolution found =
        press(sprung, load, mechanics::ContactLaw::augmented);

    EXPECT_GT(expected.of_material.at("plastic_strain"), 0.0);
    expect_equal(found, expected, 1e-7, 1e-7);
    EXPECT_EQ(found.area_by_points, expected.area_by_points);
  }
}

// Load steps of half the size change the gap by less and less. Tolerance:
// measured 0.8 % of the gap, 0.7 % of the work and 0.9 % of the strain from
// four steps to eight; on 16^2 nodes 1.1, 0.8 and 0.9 %.
TEST(PlasticBalance, ConvergesWithTheSteps) {
  for (const int degree : {1, 2}) {
    std::vector<BlockSolution> found;
    for (const int steps : {2, 4, 8}) {
      MeshedBlock block(yielding_boxes(degree));
      found.push_back(press_in(block, steps));
    }
    expect_equal(found[1], found[2], 0.015, 0.015);
    EXPECT_LT(std::abs(found[1].mean_gap - found[2].mean_gap),
              std::abs(found[0].mean_gap - found[1].mean_gap));
  }
}

/// The mean pressure in the contact over the yield stress, and whether it has
/// flowed.
struct Indentation {
  double hardness = 0.0;
  double radius = 0.0; ///< E* a/(Y R)
  double strain = 0.0;
};

/// Presses a sphere in steps on halved boxes, with an area of contact of the
/// radius 0.25 L if it flows fully.
/// @param number  E* a/(Y R) of this radius
Indentation indent(int degree, double number) {
  constexpr double radius = 10.0 * length;
  constexpr double contact = 0.25 * length;
  BlockProblem problem = boxes_problem({32, 32, length, length}, degree,
                                       {soft_modulus, poisson}, length);
  problem.mesh = meshes::hanging_mesh(
      {32 / degree, 32 / degree, length, length}, length, 4);
  const double yield = modulus * contact / (radius * number);
  problem.law = j2_plasticity(yield, 0.0);
  MeshedBlock block(problem);
  const double force =
      std::min(4.0 / 3.0 * modulus * std::pow(contact, 3) / radius,
               2.8 * yield * std::numbers::pi * contact * contact);
  BlockSolution found;
  for (const double share : {0.25, 0.5, 1.0})
    found = block.solve(
        surfaces::paraboloid(block.grid(), radius).heights,
        {mechanics::Control::nominal_pressure,
         share * force / (length * length)},
        {mechanics::ContactLaw::hard, 1e3 * soft_modulus / length, 1e-8, 300});
  EXPECT_TRUE(found.converged) << found.note;
  const double area = found.area_by_points * length * length;
  return {force / area / yield,
          modulus * std::sqrt(area / std::numbers::pi) / (yield * radius),
          found.of_material.at("plastic_strain")};
}

// A sphere first flows at E* a/(Y R) = pi/2 * 1.6128 = 2.53 (von Mises, nu =
// 0.3). Here it is between 2.2 and that: the images of the contact raise the
// stress, and four cells in a radius do not resolve it.
TEST(PlasticSphere, FirstFlowsWhereHertzSays) {
  for (const int degree : {1, 2}) {
    EXPECT_EQ(indent(degree, 2.2).strain, 0.0);
    EXPECT_GT(indent(degree, 2.53).strain, 0.0);
  }
}

/// The mean pressure over the yield stress of Jackson and Green (2005), an
/// approximation of their axisymmetric finite elements.
double jackson_green(double yield_over_modulus, double radius) {
  const double c = 1.295 * std::exp(0.736 * poisson);
  const double unit = 0.5 * std::numbers::pi * c * yield_over_modulus;
  const double b = 0.14 * std::exp(23.0 * yield_over_modulus);
  const double a = radius * yield_over_modulus; // over R
  const double depth =                          // over that of first flow
      std::pow(std::pow(a / unit, 2) * std::pow(1.9, b), 1.0 / (1.0 + b));
  const double hardness = 2.84 - 0.92 * (1.0 - std::cos(std::numbers::pi * a));
  const double force =
      4.0 / 3.0 * std::pow(unit, 3) *
      (std::exp(-std::pow(depth, 5.0 / 12.0) / 4.0) * std::pow(depth, 1.5) +
       4.0 * hardness / c *
           (1.0 - std::exp(-std::pow(depth, 5.0 / 9.0) / 25.0)) * depth);
  return force / (std::numbers::pi * a * a * yield_over_modulus);
}

// Towards full flow the mean pressure is that of Jackson and Green, less the
// area by which counted points exceed the contact: 4 % in elastic contact.
// Measured -4 % with the second order and -7 % with the first, which does not
// lock.
TEST(PlasticSphere, FlowsFully) {
  for (const auto& [degree, number] :
       {std::pair{2, 20.0}, std::pair{1, 20.0}}) {
    const Indentation found = indent(degree, number);
    const double expected = jackson_green(0.025 / number, found.radius);
    EXPECT_NEAR(found.hardness, expected, 0.08 * expected);
  }
}

} // namespace asperity::fem::plastic_balance_test
