// Tests of contact with a counter-body that has a mesh of its own: the patch
// test, the balance of forces, and points beside the body.
#include "fem/newton/contact_newton.hpp"
#include "meshes/counter_body.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "tests/message_of.hpp"

#include <deal.II/dofs/dof_tools.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace asperity::fem::counter_body_test {

using mechanics::BlockSides;
using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::CounterShape;
using mechanics::FarBoundary;

constexpr double length = 1e-3; // m
const mechanics::BodyModuli soft{soft_modulus, 0.3};
const mechanics::BodyModuli stiff{3.0 * soft_modulus, 0.2};

/// A block with a cuboid of the same cross-section below it, both free to
/// expand.
BlockProblem stacked(int points, int degree, double counter_size) {
  const Grid grid{points, points, length, length};
  BlockProblem problem = boxes_problem(grid, degree, soft, 0.8 * length);
  problem.sides = BlockSides::free;
  problem.far_boundary = FarBoundary::sliding;
  problem.counter = stiff;
  problem.counter_mesh = meshes::counter_body({.shape = CounterShape::cuboid,
                                               .radius = 0.5 * length,
                                               .height = 0.6 * length,
                                               .size_at_contact = counter_size,
                                               .size_far = length,
                                               .fine_radius = 0.5 * length,
                                               .centre_x = 0.5 * length,
                                               .centre_y = 0.5 * length});
  return problem;
}

BlockContact contact_of(ContactLaw law) {
  return {law, 100.0 * soft_modulus / length, 1e-9, 400};
}

struct Stack {
  int degree;
  double ratio; ///< of the cell sizes of counter-body and block
};

/// Lowest and highest pressure and the von Mises stress, over the load.
struct Uniformity {
  double lowest = 1e300, highest = 0.0, von_mises = 0.0;
};

Uniformity pressed(const Stack& stack) {
  constexpr int points = 8;
  BlockProblem problem = stacked(points, stack.degree,
                                 stack.degree * length / points * stack.ratio);
  const auto block = make_full_block(problem);
  const double load = 1e-3 * soft_modulus;
  const BlockSolution solution = block->solve(
      std::vector<double>(problem.grid.size(), 0.0),
      {Control::nominal_pressure, load}, contact_of(ContactLaw::penalty));
  EXPECT_TRUE(solution.converged) << solution.note;
  EXPECT_NEAR(solution.nominal_pressure / load, 1.0, 1e-9);
  Uniformity found;
  for (const double pressure : solution.pressure) {
    found.lowest = std::min(found.lowest, pressure / load);
    found.highest = std::max(found.highest, pressure / load);
  }
  found.von_mises = block->strongest_stress().von_mises / load;
  return found;
}

class StackedBodies : public ::testing::TestWithParam<Stack> {};

// The patch test of one-pass contact: on meshes that match, or whose faces of
// the counter-body consist of whole faces of the block, uniform uniaxial stress
// is exact. Tolerance: that of the balance of forces.
TEST_P(StackedBodies, AreUniformlyStressedOnNestedMeshes) {
  const Uniformity found = pressed(GetParam());

  EXPECT_NEAR(found.lowest, 1.0, 1e-7);
  EXPECT_NEAR(found.highest, 1.0, 1e-7);
  EXPECT_NEAR(found.von_mises, 1.0, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Nested, StackedBodies,
                         ::testing::Values(Stack{1, 1.0}, Stack{1, 2.0},
                                           Stack{2, 1.0}, Stack{2, 2.0}));

// On other meshes one-pass contact does not pass the patch test. Measured with
// cells 1.4 times as large as those of the block: pressures between 0.923 and
// 1.041 times the load in first order, 0.977 and 1.016 in second order; the
// bound allows a fifth more.
TEST(StackedMeshes, ThatDoNotMatchDisturbThePressure) {
  for (const auto& [stack, bound] :
       {std::pair{Stack{1, 1.4}, 0.093}, std::pair{Stack{2, 1.4}, 0.028}}) {
    const Uniformity found = pressed(stack);

    EXPECT_GT(found.lowest, 1.0 - bound);
    EXPECT_LT(found.highest, 1.0 + bound);
    EXPECT_LT(found.lowest, 1.0 - 1e-4) << "nothing was tested";
  }
}

/// A periodic block on a cylinder at a place that is no node of the block.
BlockProblem on_column(int degree, double radius) {
  const Grid grid{12, 12, length, length};
  BlockProblem problem = boxes_problem(grid, degree, soft, length);
  problem.counter = stiff;
  problem.counter_mesh =
      meshes::counter_body({.shape = CounterShape::cylinder,
                            .radius = radius,
                            .height = 0.5 * length,
                            .size_at_contact = degree * length / 12.0,
                            .size_far = 0.3 * length,
                            .fine_radius = radius,
                            .centre_x = 0.47 * length,
                            .centre_y = 0.56 * length});
  return problem;
}

// The displacement of the face interpolates a linear field exactly, so that a
// motion of both bodies that is linear in x and y leaves every gap as it is. In
// particular the entries of a row cancel: forces on both bodies are opposite,
// and so are their moments about x and y.
TEST(CounterFaces, FollowLinearMotions) {
  for (const int degree : {1, 2}) {
    BlockProblem problem = on_column(degree, 0.3 * length);
    problem.sides = BlockSides::free;
    const BlockSystem system(problem);
    std::vector<dealii::Point<3>> places(system.n_unknowns());
    dealii::DoFTools::map_dofs_to_support_points(
        system.space().mapping(), system.space().dof_handler(), places);
    auto field = system.space().make_vector();
    for (std::size_t i = 0; i < places.size(); ++i)
      field(static_cast<unsigned int>(i)) =
          3.0 + (2.0 * places[i][0] - 5.0 * places[i][1]) / length;
    std::vector<double> gaps;
    system.contact().take_displacement(field, gaps);
    std::size_t n_opposed = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i)
      if (system.contact()[i].is_opposed) {
        ++n_opposed;
        EXPECT_NEAR(gaps[i], 0.0, 1e-12);
      }
    EXPECT_GT(n_opposed, 30U);
    EXPECT_LT(n_opposed, gaps.size());
  }
}

// The points that face the column cover its end: the area differs from pi R^2
// by part of the points on its rim, here less than 6 % (measured: 3 %).
TEST(CounterFaces, OpposeThePointsAboveTheBody) {
  const BlockSystem system(on_column(1, 0.3 * length));
  const double radius = 0.3 * length;
  double area = 0.0;
  for (std::size_t i = 0; i < system.contact().size(); ++i) {
    const ContactPoint& point = system.contact()[i];
    const double r = point.place.distance({0.47 * length, 0.56 * length});
    if (point.is_opposed)
      area += point.area;
    if (std::abs(r / radius - 1.0) > 0.03) { // the end is a polygon
      EXPECT_EQ(point.is_opposed, r < radius) << r / radius;
    }
  }
  EXPECT_NEAR(area / (std::numbers::pi * radius * radius), 1.0, 0.06);
}

// A block that is much higher beside the column than above it still touches the
// column only.
TEST(CounterFaces, LeaveThePointsBesideTheBodyFree) {
  const BlockProblem problem = on_column(1, 0.3 * length);
  const auto block = make_full_block(problem);
  std::vector<double> heights(problem.grid.size(), 0.0);
  const auto distance = [&](int ix, int iy) {
    return std::hypot(ix / 12.0 - 0.47, iy / 12.0 - 0.56);
  };
  for (int iy = 0; iy < 12; ++iy)
    for (int ix = 0; ix < 12; ++ix)
      if (distance(ix, iy) > 0.3)
        heights[problem.grid.index(ix, iy)] = 0.1 * length;
  for (const ContactLaw law : {ContactLaw::penalty, ContactLaw::augmented}) {
    const BlockSolution solution =
        block->solve(heights, {Control::nominal_pressure, 1e-4 * soft_modulus},
                     contact_of(law));

    EXPECT_TRUE(solution.converged) << solution.note;
    EXPECT_NEAR(solution.nominal_pressure, 1e-4 * soft_modulus, 1.0);
    double largest = 0.0;
    for (int iy = 0; iy < 12; ++iy)
      for (int ix = 0; ix < 12; ++ix) {
        const double pressure = solution.pressure[problem.grid.index(ix, iy)];
        if (distance(ix, iy) > 0.3)
          EXPECT_EQ(pressure, 0.0);
        else
          largest = std::max(largest, pressure);
      }
    EXPECT_GT(largest, 1e-4 * soft_modulus);
  }
}

TEST(CounterBodies, ThatCannotBeSolvedAreRefused) {
  const auto words = [](const BlockProblem& problem) {
    return tests::message_of<std::domain_error>(
        [&] { make_full_block(problem); });
  };
  BlockProblem problem = on_column(1, 0.3 * length);
  problem.far_boundary = FarBoundary::pressure;
  EXPECT_NE(words(problem).find("can tilt"), std::string::npos);
  problem = on_column(1, 0.3 * length);
  problem.mesh = tetrahedra_of(problem.mesh);
  EXPECT_NE(words(problem).find("choose cells = \"hexahedra\""),
            std::string::npos);
  problem = on_column(1, 0.3 * length);
  for (meshes::Place& place : problem.counter_mesh->vertices)
    place[0] += 2.0 * length;
  EXPECT_NE(words(problem).find("no point of the contact surface faces"),
            std::string::npos);
}

} // namespace asperity::fem::counter_body_test
