// Tests of contact/operators/free_halfspace.hpp: the displacement is the sum
// over loaded cells, and Hertzian contacts have no periodic images.
#include "contact/certificate/certificate.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/polonsky_keer.hpp"
#include "contact/solvers/solver.hpp"
#include "tests/contact/problems.hpp"
#include "theory/exact/hertz.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace asperity::contact::free_halfspace_test {

using std::numbers::pi;

constexpr double modulus = 2.0;

/// A paraboloid of radius 10 with its apex at (x, y), on a square of side 1.
std::vector<double> paraboloid(const Grid& grid, double x, double y) {
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      heights[grid.index(ix, iy)] = -(std::pow(ix * grid.spacing_x() - x, 2) +
                                      std::pow(iy * grid.spacing_y() - y, 2)) /
                                    20.0;
  return heights;
}

ContactSolution pressed(const Grid& grid, const std::vector<double>& heights,
                        double load, double tolerance) {
  LoadSequence sequence(free_halfspace(grid, modulus).clone(), heights,
                        mechanics::ContactInterface{}, tolerance, 500);
  return sequence.solve({mechanics::Control::nominal_pressure, load});
}

TEST(RectangleDisplacement, HasItsKnownValues) {
  // At the centre of a square of side s: 4 s ln(1 + sqrt 2)/(pi E*).
  EXPECT_NEAR(rectangle_displacement(0.0, 0.0, 0.5, 0.5, modulus),
              4.0 * 0.5 * std::log(1.0 + std::sqrt(2.0)) / (pi * modulus),
              1e-15);
  // Far away it is the displacement under a point load.
  EXPECT_NEAR(rectangle_displacement(300.0, -400.0, 0.5, 0.2, modulus),
              0.1 / (pi * modulus * 500.0), 1e-9 * 0.1 / (pi * modulus));
  // Four quarters sum to a rectangle.
  EXPECT_NEAR(rectangle_displacement(0.3, 0.1, 0.4, 0.2, modulus),
              rectangle_displacement(0.2, 0.05, 0.2, 0.1, modulus) +
                  rectangle_displacement(0.4, 0.05, 0.2, 0.1, modulus) +
                  rectangle_displacement(0.2, 0.15, 0.2, 0.1, modulus) +
                  rectangle_displacement(0.4, 0.15, 0.2, 0.1, modulus),
              1e-15);
  EXPECT_THROW(rectangle_displacement(0.0, 0.0, 0.0, 1.0, 1.0),
               std::domain_error);
}

/// The integral of 1/r over a rectangle by its corners in long double, which
/// has eps r^2 of it at the distance r in sides.
long double exact_integral(long double x, long double y, long double side_x,
                           long double side_y) {
  const auto corner = [](long double a, long double b) {
    return a * std::asinh(b / std::abs(a)) + b * std::asinh(a / std::abs(b));
  };
  const long double a = x - side_x / 2, b = y - side_y / 2;
  return corner(a + side_x, b + side_y) - corner(a, b + side_y) -
         corner(a + side_x, b) + corner(a, b);
}

// Claim: no digit is lost far away, where the sum over corners in double
// precision has an error of eps r^2. Tolerance: the documented 1e-12, and the
// roundoff of the comparison.
TEST(RectangleDisplacement, KeepsItsDigitsAtAnyDistance) {
  for (const long double aspect : {1.0L, 0.25L})
    for (const int r : {3, 20, 63, 65, 128, 1000, 4095})
      for (const long double slope : {0.0L, 0.3L, 1.0L}) {
        const long double x = r, y = slope * r;
        const long double exact = exact_integral(x, y, 1.0L, aspect);
        const double found = rectangle_displacement(
            r, static_cast<double>(y), 1.0, static_cast<double>(aspect), 1.0);
        const double lost = 1e-18 * r * r;
        EXPECT_NEAR(static_cast<double>(
                        found * std::numbers::pi_v<long double> / exact),
                    1.0, 1e-12 + lost)
            << r << " " << static_cast<double>(slope);
      }
}

TEST(FreeHalfspaceOperator, IsTheSumOverPressedCells) {
  const Grid grid{9, 6, 1.8, 0.6}; // cells of 0.2 by 0.1
  FourierOperator elasticity = free_halfspace(grid, modulus);
  EXPECT_FALSE(elasticity.is_periodic());
  const std::vector<double> pressure = problems::random_field(grid.size());
  std::vector<double> displacement(grid.size());
  elasticity.displacement(pressure, displacement);
  const std::vector<float> change(pressure.begin(), pressure.end());
  std::vector<float> single(grid.size());
  elasticity.displacement_change(change, single);
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      double sum = 0.0;
      for (int jy = 0; jy < grid.points_y; ++jy)
        for (int jx = 0; jx < grid.points_x; ++jx)
          sum += pressure[grid.index(jx, jy)] *
                 rectangle_displacement(0.2 * (ix - jx), 0.1 * (iy - jy), 0.2,
                                        0.1, modulus);
      EXPECT_NEAR(displacement[grid.index(ix, iy)], sum, 1e-15);
      EXPECT_NEAR(single[grid.index(ix, iy)], sum, 1e-7);
    }
}

// Verifies that the preconditioner is positive on the grid and on the wide one,
// also for elongated cells and for numbers of points that are not halved, and
// that the wide grid is that of the fine operator, halved.
TEST(FreeHalfspaceOperator, HasAPositivePreconditioner) {
  for (const Grid& grid : {Grid{40, 24, 1.0, 6.0}, Grid{33, 7, 1.0, 1.0},
                           Grid{64, 128, 1.0, 2.0}}) {
    FourierOperator elasticity = free_halfspace(grid, modulus);
    const Grid wide = elasticity.wide_grid();
    EXPECT_GE(4 * wide.points_x, 5 * grid.points_x);
    EXPECT_GE(4 * wide.points_y, 5 * grid.points_y);
    EXPECT_NEAR(wide.spacing_x(), grid.spacing_x(), 1e-15);
    EXPECT_NEAR(wide.spacing_y(), grid.spacing_y(), 1e-15);
    for (const std::size_t nodes : {grid.size(), wide.size()})
      for (std::size_t node = 0; node < nodes; node += 37) {
        std::vector<float> gap(nodes), pressure(nodes);
        gap[node] = 1.0F;
        gap[(node + 1) % nodes] = -1.0F;
        elasticity.pressure_estimate(gap, 0.0, pressure);
        EXPECT_GT(pressure[node] - pressure[(node + 1) % nodes], 0.0F);
      }
    if (const auto coarse = elasticity.coarsened()) {
      EXPECT_EQ(2 * coarse->wide_grid().points_x, wide.points_x);
      EXPECT_EQ(2 * coarse->wide_grid().points_y, wide.points_y);
    }
  }
}

TEST(FreeHalfspaceOperator, IsCoarsenedOnTheSameRectangle) {
  const FourierOperator fine = free_halfspace({64, 128, 1.0, 2.0}, modulus);
  const auto coarse = fine.coarsened();
  ASSERT_NE(coarse, nullptr);
  EXPECT_EQ(coarse->grid(), (Grid{32, 64, 1.0, 2.0}));
  EXPECT_FALSE(coarse->is_periodic());
  EXPECT_EQ(coarse->coarsened(), nullptr);
}

TEST(FreeHertz, HasNoPeriodicImages) {
  const Grid grid{128, 128, 1.0, 1.0};
  for (const double radius : {0.12, 0.25, 0.45}) {
    const double load = theory::hertz_load(radius, 10.0, modulus);
    const theory::HertzContact hertz =
        theory::hertz_contact(load, 10.0, modulus);
    const std::vector<double> heights = paraboloid(grid, 0.5, 0.5);
    const ContactSolution answer = pressed(grid, heights, load, 1e-9);
    ASSERT_TRUE(answer.converged);
    EXPECT_LE(answer.iterations, 12);
    double worst = 0.0;
    double energy = 0.0;
    for (int iy = 0; iy < 128; ++iy)
      for (int ix = 0; ix < 128; ++ix) {
        const std::size_t node = grid.index(ix, iy);
        const double r = std::hypot(ix / 128.0 - 0.5, iy / 128.0 - 0.5);
        worst = std::max(worst, std::abs(answer.displacement[node] -
                                         theory::hertz_displacement(hertz, r)));
        energy += 0.5 * answer.pressure[node] * answer.displacement[node] /
                  static_cast<double>(grid.size());
      }
    EXPECT_LE(worst, 1e-3 * hertz.approach) << radius;
    EXPECT_NEAR(energy, hertz.elastic_energy, 1e-3 * hertz.elastic_energy);
  }
}

TEST(FreeHertz, DoesNotDependOnThePlaceInTheMap) {
  const Grid grid{96, 96, 1.0, 1.0};
  const double load = theory::hertz_load(0.1, 10.0, modulus);
  const ContactSolution centre =
      pressed(grid, paraboloid(grid, 0.5, 0.5), load, 1e-12);
  const ContactSolution corner =
      pressed(grid, paraboloid(grid, 13.0 / 96, 83.0 / 96), load, 1e-12);
  ASSERT_TRUE(centre.converged && corner.converged);
  const double peak = *std::ranges::max_element(centre.pressure);
  EXPECT_GT(peak, 0.0);
  for (int y = -12; y <= 12; ++y)
    for (int x = -12; x <= 12; ++x)
      EXPECT_NEAR(centre.pressure[grid.index(48 + x, 48 + y)],
                  corner.pressure[grid.index(13 + x, 83 + y)], 1e-6 * peak);
}

TEST(FreeContact, AgreesWithTheUnpreconditionedMethod) {
  const Grid grid{64, 64, 1.0, 1.0};
  const std::vector<double> heights = problems::rough_heights(grid, {});
  FourierOperator elasticity = free_halfspace(grid, modulus);
  // In the last contact the whole border touches.
  for (const double compliance : {0.0, 0.01})
    for (const double load : {0.02, 0.2, 8.0}) {
      const ContactProblem problem{heights, compliance, 1e-9, 5000};
      const mechanics::LoadTarget target{mechanics::Control::nominal_pressure,
                                         load};
      const ContactSolution fast = solve_contact(elasticity, problem, target);
      const ContactSolution slow = polonsky_keer(elasticity, problem, target);
      ASSERT_TRUE(fast.converged && slow.converged) << load;
      EXPECT_LE(fast.iterations, 25) << load;
      EXPECT_NEAR(fast.mean_gap, slow.mean_gap, 1e-8);
      EXPECT_LE(problems::complementarity_error(elasticity, problem, fast),
                2e-9);
    }
}

TEST(FreeContact, RefusesAPrescribedMeanGap) {
  const Grid grid{8, 8, 1.0, 1.0};
  FourierOperator elasticity = free_halfspace(grid, modulus);
  const std::vector<double> heights = paraboloid(grid, 0.5, 0.5);
  EXPECT_THROW(solve_contact(elasticity, {heights, 0.0, 1e-9},
                             {mechanics::Control::mean_gap, 0.01}),
               std::domain_error);
}

} // namespace asperity::contact::free_halfspace_test
