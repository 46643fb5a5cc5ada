// Tests of results/observables/observables.hpp with shapes whose area,
// perimeter and energy are known by geometry or by an integral.
#include "results/observables/observables.hpp"
#include "tests/results/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::results::observables_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A rectangle of a x b cells has its own area and 2 (a h_x + b h_y), also where
// it lies across the periodic border. Tolerance: roundoff of a sum of equal
// terms and of two divisions.
TEST(ContactPerimeter, OfARectangleIsExactAlsoAcrossTheBorder) {
  const Grid grid{20, 12, 2.0, 3.0};               // cells of 0.1 m x 0.25 m
  for (const double centre_x : {0.65, 1.65, 1.95}) // 6 columns: inside, at
    for (const double centre_y : {1.0, 0.25, 2.75, 0.0}) { // the border, across
      const auto pressure = shape(grid, [&](double x, double y) {
        return std::abs(periodic_distance(x, centre_x, 2.0)) < 0.3 &&
               std::abs(periodic_distance(y, centre_y, 3.0)) < 0.3; // 3 rows
      });

      EXPECT_NEAR(counted_area_fraction(ContactNodes::under(pressure)),
                  6 * 3 / 240.0, 4 * epsilon);
      EXPECT_NEAR(contact_perimeter(grid, ContactNodes::under(pressure)),
                  2.0 * (0.6 + 0.75) / grid.area(), 4 * epsilon);
    }
}

// Beyond a free border there is no contact, so that the border counts for a
// contact that reaches it: full contact has the perimeter of the map, and a
// rectangle in one corner its own.
TEST(ContactPerimeter, IncludesAFreeBorder) {
  const Grid grid{20, 12, 2.0, 3.0};
  EXPECT_NEAR(contact_perimeter(
                  grid, ContactNodes::under(std::vector<double>(240, 2.0)),
                  Border::free),
              2.0 * (2.0 + 3.0) / grid.area(), 4 * epsilon);
  std::vector<double> pressure(240, 0.0);
  for (const int iy : {0, 1, 2})
    for (const int ix : {16, 17, 18, 19})
      pressure[grid.index(ix, iy)] = 1.0;
  EXPECT_NEAR(
      contact_perimeter(grid, ContactNodes::under(pressure), Border::free),
      2.0 * (0.4 + 0.75) / grid.area(), 4 * epsilon);
  pressure[grid.index(0, 0)] = 1.0; // no neighbour across the border
  EXPECT_NEAR(
      contact_perimeter(grid, ContactNodes::under(pressure), Border::free),
      2.0 * (0.4 + 0.75 + 0.1 + 0.25) / grid.area(), 4 * epsilon);
}

TEST(ContactPerimeter, VanishesWithoutContactAndInFullContact) {
  const Grid grid{8, 8, 1.0, 1.0};

  EXPECT_EQ(contact_perimeter(
                grid, ContactNodes::under(std::vector<double>(64, 0.0))),
            0.0);
  EXPECT_EQ(contact_perimeter(
                grid, ContactNodes::under(std::vector<double>(64, 2.0))),
            0.0);
  EXPECT_EQ(
      counted_area_fraction(ContactNodes::under(std::vector<double>(64, 2.0))),
      1.0);
}

// The perimeter on the grid of a disc, as a set of nodes, is that of its
// bounding box, 8 R to within one spacing per side, so that the isotropic
// perimeter is 2 pi R; the count satisfies Gauss's bound |N - pi r^2| <= 2
// sqrt(2) pi r of the circle problem.
TEST(ContactPerimeter, OfADiscIsThatOfItsBoundingBox) {
  const Grid grid{256, 256, 1.0, 1.0};
  const double radius = 0.3;
  const double spacing = grid.spacing_x();

  const auto pressure = shape(grid, [&](double x, double y) {
    return std::hypot(x - 0.503, y - 0.498) < radius;
  });

  const double perimeter =
      contact_perimeter(grid, ContactNodes::under(pressure));
  EXPECT_NEAR(perimeter, 8.0 * radius, 4.0 * spacing);
  EXPECT_NEAR(counted_area_fraction(ContactNodes::under(pressure)),
              std::numbers::pi * radius * radius,
              2 * std::numbers::sqrt2 * std::numbers::pi * radius * spacing);
}

// p = a (1 + cos qx) and w = C a cos qx give 1/2 <p w> = C a^2/4 and 1/2
// <p^2>/k = 3 a^2/(4 k). The sum over a DFT grid is exact for a trigonometric
// polynomial; tolerance: roundoff of 256 terms.
TEST(Energy, OfAWaveIsItsIntegral) {
  const Grid grid{16, 16, 1.0, 1.0};
  const double amplitude = 3e6;    // Pa
  const double compliance = 2e-13; // m/Pa
  const double local_compliance = 5e-14;
  std::vector<double> pressure(grid.size());
  std::vector<double> displacement(grid.size());
  for (int iy = 0; iy < 16; ++iy)
    for (int ix = 0; ix < 16; ++ix) {
      const double wave = std::cos(2 * std::numbers::pi * ix / 16.0);
      pressure[grid.index(ix, iy)] = amplitude * (1.0 + wave);
      displacement[grid.index(ix, iy)] = compliance * amplitude * wave;
    }

  const double scale = amplitude * amplitude * compliance;
  EXPECT_NEAR(elastic_energy(pressure, displacement) / scale, 0.25,
              256 * epsilon);
  EXPECT_NEAR(contact_energy(pressure, local_compliance) /
                  (amplitude * amplitude * local_compliance),
              0.75, 256 * epsilon);
  EXPECT_EQ(contact_energy(pressure, 0.0), 0.0);
}

// Weights count nodes by their area: the mean over nodes of areas 1/2 and 3/2
// equals that over nodes that are repeated in this proportion.
TEST(NodalWeights, CountANodeByItsArea) {
  const std::vector<double> weights{0.5, 1.5};
  const std::vector<double> pressure{0.0, 4.0};

  EXPECT_DOUBLE_EQ(weighted_mean(pressure, weights), 3.0);
  EXPECT_DOUBLE_EQ(
      counted_area_fraction(ContactNodes::under(pressure), weights), 0.75);
  EXPECT_DOUBLE_EQ(elastic_energy(pressure, pressure, weights), 6.0);
  EXPECT_DOUBLE_EQ(contact_energy(pressure, 2.0, weights), 12.0);
}

// Full contact is 1, also where the weights sum to more by roundoff. Here 36
// weights of mean 1 + 1 ulp.
TEST(NodalWeights, OfRoundedSumsGiveNoAreaAboveOne) {
  const std::vector<double> weights(36, 1.0 + epsilon);
  const std::vector<double> pressure(36, 1.0);
  ASSERT_GT(weighted_mean(pressure, weights), 1.0);

  EXPECT_EQ(counted_area_fraction(ContactNodes::under(pressure), weights), 1.0);
}

// The lever of a force is the mean place of its pressure, from the node in the
// middle. Two nodes carry 1 and 3 units; weights count a node by its area.
TEST(PressureCentre, IsTheMeanPlaceOfThePressure) {
  const Grid grid{8, 4, 4.0, 1.0}; // cells of 0.5 m x 0.25 m, middle (4, 2)
  std::vector<double> pressure(32, 0.0);
  pressure[grid.index(4, 2)] = 1.0;
  pressure[grid.index(6, 1)] = 3.0;
  std::vector<double> weights(32, 1.0);
  weights[grid.index(6, 1)] = 1.0 / 3.0;

  EXPECT_DOUBLE_EQ(pressure_centre(grid, pressure).x, 0.75 * 2 * 0.5);
  EXPECT_DOUBLE_EQ(pressure_centre(grid, pressure).y, -0.75 * 0.25);
  EXPECT_DOUBLE_EQ(pressure_centre(grid, pressure, weights).x, 0.5 * 2 * 0.5);
}

TEST(PressureCentre, IsNotDeterminedWithoutContact) {
  const Grid grid{4, 4, 1.0, 1.0};

  EXPECT_TRUE(
      std::isnan(pressure_centre(grid, std::vector<double>(16, 0.0)).x));
  // Tension that balances the pressure leaves no load, but for roundoff.
  std::vector<double> balanced(16, 0.0);
  balanced[1] = 1.0;
  balanced[2] = -1.0 + 1e-9;
  EXPECT_TRUE(std::isnan(pressure_centre(grid, balanced).x));
  balanced[2] = -0.5;
  EXPECT_FALSE(std::isnan(pressure_centre(grid, balanced).x));
  EXPECT_THROW(pressure_centre(grid, std::vector<double>(15, 0.0)),
               std::domain_error);
}

TEST(MapSizes, AreCheckedByName) {
  const Grid grid{4, 4, 1.0, 1.0};
  const std::vector<double> pressure(15, 1.0);
  try {
    contact_perimeter(grid, ContactNodes::under(pressure));
    FAIL() << "a map of another size was accepted";
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(error.what(), "nodes.size() = 15, but must be equal to 16");
  }
  EXPECT_THROW(weighted_mean({}), std::domain_error);
  EXPECT_THROW(weighted_mean(pressure, std::vector<double>(14, 1.0)),
               std::domain_error);
}

} // namespace asperity::results::observables_test
