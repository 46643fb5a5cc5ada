// Flow through gaps whose conductance is known: plates, wedges, channels, an
// impermeable disc, media with an exact duality, and random gaps.
#include "fem/plugin.hpp"
#include "mechanics/flow/reynolds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace asperity::flow::reynolds_test {
namespace {

using mechanics::Border;
using std::numbers::pi;

NetworkSolution by_plugin(const Network& network) {
  return fem::load_fem_module().solved_network(network);
}

/// The gap at the middle of each cell of a map with sides 1 and 1 over n and
/// n points, by a function of x and y in 0..1.
template <class Gap>
std::vector<double> sampled(const Grid& grid, const Gap& gap) {
  std::vector<double> field(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      field[grid.index(ix, iy)] =
          gap((ix + 0.5) / grid.points_x, (iy + 0.5) / grid.points_y);
  return field;
}

template <class Gap>
GapFlow flow_of(int n, const Gap& gap, Direction direction = Direction::x) {
  const Grid grid{n, n, 1.0, 1.0};
  return flow_through(grid, sampled(grid, gap), direction, Border::periodic,
                      by_plugin);
}

// The error of a second-order method falls to a quarter.
void expect_second_order(double coarse, double fine, double exact) {
  EXPECT_GT(std::abs(coarse - exact), 1e-9 * exact);
  EXPECT_NEAR((coarse - exact) / (fine - exact), 4.0, 0.4);
}

TEST(Reynolds, ParallelPlatesOfAnyShape) {
  // Q = u^3 W/L for 12 eta = Dp = 1, and phi = 1.
  const Grid grid{24, 16, 3e-6, 1e-6};
  const std::vector<double> gap(grid.size(), 2e-9);
  const GapFlow x =
      flow_through(grid, gap, Direction::x, Border::periodic, by_plugin);
  const GapFlow y =
      flow_through(grid, gap, Direction::y, Border::periodic, by_plugin);
  EXPECT_NEAR(x.conductance, 8e-27 / 3.0, 1e-36);
  EXPECT_NEAR(y.conductance, 8e-27 * 3.0, 1e-35);
  EXPECT_NEAR(x.flow_factor, 1.0, 1e-10);
  EXPECT_NEAR(y.flow_factor, 1.0, 1e-10);
  EXPECT_TRUE(x.percolates);
  EXPECT_EQ(x.critical_gap, 2e-9);
  EXPECT_LT(x.imbalance, 1e-10);
}

TEST(Reynolds, WedgeAlongTheFlow) {
  // 1/Q = int dx/(1/2 + x/2)^3 = 3.
  const auto wedge = [](double x, double) { return 0.5 + 0.5 * x; };
  expect_second_order(flow_of(32, wedge).conductance,
                      flow_of(64, wedge).conductance, 1.0 / 3.0);
}

TEST(Reynolds, SinusoidalChannels) {
  // u = 1 + a cos 2 pi x. Across: Q = 1/<u^-3> =
  // (1 - a^2)^(5/2)/(1 + a^2/2); along: Q = <u^3> = 1 + 3 a^2/2.
  const double a = 0.7;
  const auto channel = [=](double x, double) {
    return 1.0 + a * std::cos(2.0 * pi * x);
  };
  const double across = std::pow(1.0 - a * a, 2.5) / (1.0 + 0.5 * a * a);
  EXPECT_NEAR(flow_of(64, channel).conductance, across, 1e-6 * across);
  EXPECT_NEAR(flow_of(64, channel, Direction::y).conductance, 1.0 + 1.5 * a * a,
              1e-9);
}

TEST(Reynolds, ImpermeableDisc) {
  // A disc of radius .2 in a unit cell: .7767144889, a lattice sum. Its border
  // is a staircase: first order.
  const auto disc = [](double x, double y) {
    return std::hypot(x - 0.5, y - 0.5) < 0.2 ? 0.0 : 1.0;
  };
  const double exact = 0.7767144889;
  const double coarse = flow_of(128, disc).conductance;
  const double fine = flow_of(512, disc).conductance;
  EXPECT_NEAR(coarse, exact, 6e-3 * exact);
  EXPECT_NEAR(fine, exact, 1.5e-3 * exact);
}

TEST(Reynolds, TwoPhasesByDuality) {
  // Keller (1964), Dykhne (1971): the conductance along x of a periodic medium
  // k and that along y of k_1 k_2/k have the product k_1 k_2. The medium is
  // that of random squares and their mirror images, so that the reservoirs are
  // planes of symmetry. The corners of the squares have singularities.
  std::mt19937 random(3);
  constexpr int squares = 8;
  std::vector<bool> phase(squares * squares);
  for (auto&& one : phase)
    one = random() % 2 == 0;
  const auto medium = [&](double small, double large) {
    return [&phase, small, large](double x, double y) {
      const auto at = [](double place) {
        return static_cast<std::size_t>(2 * squares *
                                        std::min(place, 1.0 - place));
      };
      return std::cbrt(phase[at(y) * squares + at(x)] ? large : small);
    };
  };
  const auto error = [&](int n) {
    return std::abs(flow_of(n, medium(1.0, 4.0), Direction::x).conductance *
                        flow_of(n, medium(4.0, 1.0), Direction::y).conductance -
                    4.0) /
           4.0;
  };
  const double coarse = error(64), fine = error(256);
  EXPECT_LT(coarse, 0.04);
  EXPECT_LT(fine, 0.3 * coarse);
}

std::vector<double> rough_gap(const Grid& grid, double closed) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> phase(0.0, 2.0 * pi);
  std::vector<double> gap(grid.size(), 0.0);
  for (int jy = -5; jy <= 5; ++jy)
    for (int jx = 1; jx <= 5; ++jx) {
      const double shift = phase(random);
      for (int iy = 0; iy < grid.points_y; ++iy)
        for (int ix = 0; ix < grid.points_x; ++ix)
          gap[grid.index(ix, iy)] +=
              std::cos(2.0 * pi *
                           (jx * (ix + 0.5) / grid.points_x +
                            jy * (iy + 0.5) / grid.points_y) +
                       shift) /
              (jx * jx + jy * jy);
    }
  for (double& u : gap)
    u = std::max(0.0, u - closed);
  return gap;
}

TEST(Reynolds, RoughGapIsBalancedAndTurnsWithTheMap) {
  const Grid grid{96, 96, 1.0, 1.0};
  const std::vector<double> gap = rough_gap(grid, -0.8);
  const GapFlow x =
      flow_through(grid, gap, Direction::x, Border::periodic, by_plugin);
  ASSERT_TRUE(x.percolates);
  EXPECT_LT(x.flow_factor, 0.9);
  EXPECT_LT(x.imbalance, 1e-6);
  EXPECT_LE(x.iterations, 12);
  std::vector<double> turned(gap.size()), scaled(gap);
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      turned[grid.index(iy, ix)] = gap[grid.index(ix, iy)];
  const GapFlow y =
      flow_through(grid, turned, Direction::y, Border::periodic, by_plugin);
  EXPECT_NEAR(y.conductance, x.conductance, 1e-10 * x.conductance);
  EXPECT_EQ(y.critical_gap, x.critical_gap);
  EXPECT_EQ(y.critical_x, x.critical_y);
  for (double& u : scaled)
    u *= 1e-9;
  const GapFlow small =
      flow_through(grid, scaled, Direction::x, Border::periodic, by_plugin);
  EXPECT_NEAR(small.conductance, 1e-27 * x.conductance, 1e-36 * x.conductance);
  EXPECT_NEAR(small.flow_factor, x.flow_factor, 1e-9);
}

TEST(Reynolds, WidestPathIsThatOfAMazeWithOneGate) {
  // Two walls with a gate each; the second gate is narrower.
  const Grid grid{32, 32, 1.0, 1.0};
  std::vector<double> gap(grid.size(), 1.0);
  for (int iy = 0; iy < 32; ++iy)
    gap[grid.index(8, iy)] = gap[grid.index(20, iy)] = 0.0;
  gap[grid.index(8, 3)] = 0.2;
  gap[grid.index(20, 25)] = 0.1;
  gap[grid.index(20, 5)] = 0.05;
  const GapFlow flow =
      flow_through(grid, gap, Direction::x, Border::periodic, by_plugin);
  EXPECT_EQ(flow.critical_gap, 0.1);
  EXPECT_EQ(flow.critical_x, 20);
  EXPECT_EQ(flow.critical_y, 25);
  gap[grid.index(8, 3)] = 0.0;
  gap[grid.index(8, 4)] = 0.0;
  const GapFlow sealed =
      flow_through(grid, gap, Direction::x, Border::periodic, by_plugin);
  EXPECT_FALSE(sealed.percolates);
  EXPECT_EQ(sealed.conductance, 0.0);
  EXPECT_TRUE(flow_through(grid, gap, Direction::y, Border::periodic, by_plugin)
                  .percolates);
}

TEST(Reynolds, CornersDoNotLeak) {
  const Grid grid{4, 4, 1.0, 1.0};
  std::vector<double> gap(grid.size(), 0.0);
  gap[grid.index(0, 0)] = gap[grid.index(1, 0)] = gap[grid.index(2, 1)] =
      gap[grid.index(3, 1)] = 1.0;
  EXPECT_FALSE(
      flow_through(grid, gap, Direction::x, Border::periodic, by_plugin)
          .percolates);
  gap[grid.index(2, 0)] = 1.0;
  EXPECT_TRUE(flow_through(grid, gap, Direction::x, Border::periodic, by_plugin)
                  .percolates);
}

TEST(Reynolds, LognormalConductivity) {
  // In two dimensions k_eff = exp<ln k> for a lognormal k; here the geometric
  // mean of an uncorrelated field on an interpolated grid is met to the spread
  // of one realisation, sigma/n cells.
  std::mt19937 random(11);
  const int cells = 64, n = 4 * cells;
  std::normal_distribution<double> normal(0.0, 0.5);
  std::vector<double> logarithm(cells * cells);
  double mean = 0.0;
  for (double& one : logarithm) {
    one = normal(random);
    mean += one / (cells * cells);
  }
  const auto field = [&](double x, double y) {
    const auto at = [](double place) {
      return static_cast<std::size_t>(place * cells);
    };
    return std::exp(logarithm[at(y) * cells + at(x)] / 3.0);
  };
  const double exact = std::exp(mean);
  EXPECT_NEAR(flow_of(n, field).conductance, exact, 0.02 * exact);
}

TEST(Reynolds, FluxOfAChannelWithAWall) {
  // Two channels of widths 1/4 and 1/2 between walls: u^3 is 1 in both, so that
  // |q| over its mean is 4/3 in both and 0 in the walls.
  const Grid grid{16, 16, 2.0, 1.0};
  std::vector<double> gap(grid.size(), 1.0);
  for (int iy = 0; iy < 16; ++iy)
    for (int ix = 0; ix < 16; ++ix)
      if (iy == 0 || iy == 1 || iy == 6 || iy == 7)
        gap[grid.index(ix, iy)] = 0.0;
  const GapFlow flow =
      flow_through(grid, gap, Direction::x, Border::periodic, by_plugin, true);
  ASSERT_EQ(flow.flux.size(), grid.size());
  for (int iy = 0; iy < 16; ++iy)
    for (int ix = 0; ix < 16; ++ix)
      EXPECT_NEAR(flow.flux[grid.index(ix, iy)],
                  gap[grid.index(ix, iy)] > 0.0 ? 4.0 / 3.0 : 0.0, 1e-7);
}

// A map with a free border is insulated: it is a periodic one with one more
// column, or row, that is closed. Random gaps, an eighth of them closed.
TEST(Reynolds, FreeBorderIsInsulated) {
  const Grid grid{12, 10, 1.2, 1.0}, wider{12, 11, 1.2, 1.1};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> width(-0.1, 0.7);
  int open = 0;
  for (int map = 0; map < 20; ++map) {
    std::vector<double> gap(grid.size());
    std::ranges::generate(gap, [&] { return std::max(0.0, width(random)); });
    std::vector<double> closed_above = gap;
    closed_above.resize(wider.size());

    const GapFlow free =
        flow_through(grid, gap, Direction::x, Border::free, by_plugin);
    const GapFlow walled = flow_through(wider, closed_above, Direction::x,
                                        Border::periodic, by_plugin);

    EXPECT_EQ(free.percolates, walled.percolates);
    EXPECT_NEAR(free.conductance, walled.conductance,
                1e-12 * walled.conductance);
    EXPECT_EQ(free.critical_gap, walled.critical_gap);
    open += free.percolates ? 1 : 0;
  }
  EXPECT_GT(open, 10);
}

// An oblique ridge closes every row of the map, and no row of its periodic
// continuation.
TEST(Reynolds, ObliqueRidgeSealsAMapThatIsPressedOnce) {
  const Grid grid{16, 16, 1.0, 1.0};
  std::vector<double> gap(grid.size(), 1.0);
  for (int iy = 0; iy < 16; ++iy)
    for (const int ix : {4 + iy / 2, 5 + iy / 2})
      gap[grid.index(ix, iy)] = 0.0;
  const auto along_x = [&](Border border) {
    return flow_through(grid, gap, Direction::x, border, by_plugin);
  };

  EXPECT_FALSE(along_x(Border::free).percolates);
  EXPECT_TRUE(along_x(Border::periodic).percolates);
}

TEST(Reynolds, RefusesAnotherSize) {
  EXPECT_THROW(flow_through({8, 8, 1.0, 1.0}, std::vector<double>(63),
                            Direction::x, Border::periodic, by_plugin),
               std::domain_error);
}

} // namespace
} // namespace asperity::flow::reynolds_test
