// Tests of contact/operators/tile_operator.hpp and
// contact/solvers/tile_start.hpp.
#include "base/ranks/node_sums.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/tile_operator.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <mutex>

namespace asperity::contact::tiles_test {

using Kind = mechanics::Control;

const mechanics::ElasticBlock halfspace{1.0, 0.3,
                                        std::numeric_limits<double>::infinity(),
                                        mechanics::FarBoundary::clamped};

/// Calls do_node(node of the grid, node of the tiles).
template <class DoNode>
void each_node(const Grid& grid, const Tiles& tiles, const DoNode& do_node) {
  for (std::size_t i = 0; i < tiles.numbers.size() * tile_nodes; ++i) {
    const int tile = tiles.numbers[i / tile_nodes];
    const int x = static_cast<int>(i % tile_side);
    const int y = static_cast<int>(i % tile_nodes / tile_side);
    do_node(grid.index(tile % tiles.per_row * tile_points + x,
                       tile / tiles.per_row * tile_points + y),
            i);
  }
}

/// Largest difference of the two displacements on the tiles, up to a constant,
/// over the largest displacement.
double difference_on_tiles(FourierOperator whole, const Tiles& tiles) {
  const Grid grid = whole.grid();
  const std::unique_ptr<SurfaceOperator> part = whole.on_tiles(tiles);
  const std::vector<double> random = problems::random_field(grid.size());
  std::vector<double> pressure(grid.size()), displacement(grid.size());
  std::vector<double> own_pressure(part->grid().size()),
      own_displacement(part->grid().size());
  each_node(grid, tiles, [&](std::size_t node, std::size_t own) {
    own_pressure[own] = pressure[node] = 0.2 + random[node];
  });
  whole.displacement(pressure, displacement);
  part->displacement(own_pressure, own_displacement);
  Largest highest, lowest, largest;
  each_node(grid, tiles, [&](std::size_t node, std::size_t own) {
    const double difference = own_displacement[own] - displacement[node];
    highest += {difference};
    lowest += {-difference};
    largest += {std::abs(displacement[node])};
  });
  return 0.5 * (highest.value + lowest.value) / largest.value;
}

// A corner, of which other tiles are beside it across the border, and tiles
// beside each other in both directions and diagonally. Measured: 2.6e-5
// and 2.2e-5.
TEST(Tiles, HaveTheDisplacementOfTheWholeSurface) {
  EXPECT_LT(
      difference_on_tiles(halfspace_operator({512, 512, 1.0, 1.0}, halfspace),
                          {8, 8, true, {0, 7, 18, 19, 27, 36, 56}}),
      4e-5);
  EXPECT_LT(
      difference_on_tiles(halfspace_operator({1024, 512, 3.0, 1.5}, halfspace),
                          {16, 8, true, {5, 6, 64, 127}}),
      4e-5);
}

TEST(Tiles, MayHaveThePressureInTheMemoryOfTheGap) {
  const FourierOperator whole =
      halfspace_operator({512, 512, 1.0, 1.0}, halfspace);
  const std::unique_ptr<SurfaceOperator> part =
      whole.on_tiles({8, 8, true, {18, 19, 27}});
  const std::vector<double> random = problems::random_field(part->n_nodes());
  std::vector<float> field(random.begin(), random.end());
  std::vector<float> pressure(field.size());

  part->pressure_estimate(field, 0.0, pressure);
  part->pressure_estimate(field, 0.0, field);

  EXPECT_EQ(field, pressure);
}

// Between opposite borders the convolution on the coarse nodes, which lie up to
// two beyond them, wraps around. Measured: 4.5e-5 inside, 2.7e-4 and 1.0e-4.
TEST(Tiles, HaveTheDisplacementWithFreeBoundaries) {
  const FourierOperator square = free_halfspace({512, 512, 1.0, 1.0}, 1.0);
  EXPECT_LT(difference_on_tiles(square, {8, 8, false, {18, 19, 27, 36, 44}}),
            6e-5);
  EXPECT_LT(
      difference_on_tiles(square, {8, 8, false, {0, 7, 18, 19, 27, 36, 56}}),
      4e-4);
  EXPECT_LT(difference_on_tiles(free_halfspace({1024, 512, 3.0, 1.5}, 1.0),
                                {16, 8, false, {5, 6, 64, 127}}),
            4e-4);
}

/// Two spheres, which touch at the border of two tiles and inside of one; the
/// second one is lower.
std::vector<double> two_spheres(const Grid& grid) {
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const auto height = [&](int x, int y, double top) {
        return top - 5e-3 * ((ix - x) * (ix - x) + (iy - y) * (iy - y));
      };
      heights[grid.index(ix, iy)] =
          std::max(height(128, 90, 0.0), height(350, 345, -0.1));
    }
  return heights;
}

constexpr double tolerance = 1e-7;

const Grid square{512, 512, 512.0, 512.0};

void expect_solved_on_tiles(
    const ContactSolution& solution, const ContactProblem& problem,
    int transforms,
    FourierOperator elasticity = halfspace_operator(square, halfspace)) {
  EXPECT_TRUE(solution.converged) << solution.note;
  EXPECT_LE(solution.transforms, transforms);
  EXPECT_LT(problems::complementarity_error(elasticity, problem, solution),
            1.01 * tolerance);
}

// The displacement is computed twice, in the start and in the solution, which
// is that of the whole surface. An iteration there takes two or three.
TEST(Tiles, SolveLightContact) {
  const std::vector<double> heights = two_spheres(square);
  for (const double compliance : {0.0, 0.5}) {
    mechanics::ContactInterface interface;
    if (compliance > 0.0)
      interface = {mechanics::ContactLaw::penalty, 1.0 / compliance};
    LoadSequence sequence(halfspace_operator(square, halfspace).clone(),
                          heights, interface, tolerance, 2000);
    for (const double pressure : {1e-4, 2e-4, 3e-4})
      expect_solved_on_tiles(sequence.solve({Kind::nominal_pressure, pressure}),
                             {heights, compliance, tolerance}, 4);
  }
}

TEST(Tiles, SolveLightContactWithFreeBoundaries) {
  const std::vector<double> heights = two_spheres(square);
  const FourierOperator elasticity = free_halfspace(square, 1.0);
  LoadSequence sequence(elasticity.clone(), heights, {}, tolerance, 2000);
  for (const double pressure : {1e-4, 2e-4, 3e-4})
    expect_solved_on_tiles(sequence.solve({Kind::nominal_pressure, pressure}),
                           {heights, 0.0, tolerance}, 4, elasticity);
}

// The start has no pressure at the second sphere, which is outside of the
// tiles until the gap is known.
TEST(Tiles, AreAddedWhereTheSurfacesOverlap) {
  const std::vector<double> heights = two_spheres(square);
  std::vector<double> start(square.size());
  for (int iy = -15; iy <= 15; ++iy)
    for (int ix = -15; ix <= 15; ++ix)
      start[square.index(128 + ix, 90 + iy)] =
          std::sqrt(std::max(0, 15 * 15 - ix * ix - iy * iy));
  FourierOperator elasticity = halfspace_operator(square, halfspace);
  const ContactProblem problem{heights, 0.0, tolerance};
  const ContactSolution solution =
      solve_contact(elasticity, problem, {Kind::nominal_pressure, 2e-4}, start);
  expect_solved_on_tiles(solution, problem, 5);
  EXPECT_GT(solution.pressure[square.index(350, 345)], 0.0);
}

TEST(Tiles, GiveTheSameBitsOnThreads) {
  const std::vector<double> heights = two_spheres(square);
  const auto solved = [&](int threads) {
    LoadSequence sequence(
        halfspace_operator(square, halfspace, threads).clone(), heights, {},
        tolerance, 2000);
    return sequence.solve({Kind::nominal_pressure, 2e-4});
  };
  const ContactSolution alone = solved(1);
  EXPECT_LE(alone.transforms, 2);
  EXPECT_EQ(solved(3).pressure, alone.pressure);
}

} // namespace asperity::contact::tiles_test
