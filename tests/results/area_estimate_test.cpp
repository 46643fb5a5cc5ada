// Tests of results/observables/area_estimate.hpp: straight contact boundaries
// and spheres with exactly known fields, and shapes whose Euler characteristic
// is known by counting.
#include "results/observables/area_estimate.hpp"
#include "results/observables/observables.hpp"
#include "tests/results/shapes.hpp"
#include "theory/exact/hertz.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::results::area_estimate_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double modulus = 2e9; // E* [Pa]

struct Maps {
  std::vector<double> pressure;
  std::vector<double> gap;
};

/// (A.1) with a = 3e11 Pa/m^(1/2) where depth_at(x, y) [m], the distance from
/// the contact boundary, is > 0 inside and < 0 outside.
template <class DepthAt>
Maps boundary_fields(const Grid& grid, DepthAt depth_at) {
  constexpr double strength = 3e11;
  Maps maps;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double depth =
          depth_at(ix * grid.spacing_x(), iy * grid.spacing_y());
      maps.pressure.push_back(depth > 0.0 ? strength * std::sqrt(depth) : 0.0);
      maps.gap.push_back(depth < 0.0 ? 4.0 * strength * std::pow(-depth, 1.5) /
                                           (3.0 * modulus)
                                     : 0.0);
    }
  return maps;
}

// Verifies (A.2): the fraction t satisfies the equation and increases with the
// pressure. Tolerance: the closed form is a few operations on numbers of its
// own size, 1 - t to 8 eps; (1 - t)^3 and rho t follow relatively where neither
// t nor 1 - t is small, which 1e-6 < rho < 1e6 keeps above 1e-6.
RC_GTEST_PROP(BoundaryFraction, SolvesItsCubic, ()) {
  const double pressure = *rc::gen::inRange(1, 1000) * 1e6;
  const double spacing = *rc::gen::inRange(1, 100) * 1e-8;
  const double root = std::pow(10.0, *rc::gen::inRange(-300, 301) * 0.01);
  const double gap = root * 4.0 * pressure * spacing / (3.0 * modulus);

  const double share = boundary_share(pressure, gap, spacing, modulus);

  RC_ASSERT(share >= 0.0 && share <= 1.0);
  const double cube = std::pow(1.0 - share, 3.0);
  RC_ASSERT(std::abs(cube - root * root * share) <=
            1e-9 * (cube + root * root * share));
  RC_ASSERT(boundary_share(1.01 * pressure, gap, spacing, modulus) > share);
}

// The limits of (A.2): a node that touches or overlaps belongs to the contact
// entirely, a distant one not at all, also beyond the range of rho.
TEST(BoundaryFraction, EndsAtZeroAndOne) {
  EXPECT_EQ(boundary_share(1e6, 0.0, 1e-8, modulus), 1.0);
  EXPECT_EQ(boundary_share(1e6, -1e-12, 1e-8, modulus), 1.0);
  EXPECT_EQ(boundary_share(1e300, 1e-300, 1e-8, modulus), 1.0);
  EXPECT_EQ(boundary_share(1e-300, 1.0, 1e-8, modulus), 0.0);
  EXPECT_THROW(boundary_share(0.0, 1e-9, 1e-8, modulus), std::domain_error);
  EXPECT_THROW(boundary_share(1e6, 1e-9, 0.0, modulus), std::domain_error);
  EXPECT_THROW(boundary_share(1e6, 1e-9, 1e-8, -1.0), std::domain_error);
  EXPECT_THROW(boundary_share(1e6, std::nan(""), 1e-8, modulus),
               std::domain_error);
}

// A straight strip along x or y whose boundaries lie anywhere between nodes has
// its own width. Every line across it finds the boundaries and no line along it
// has one, so that the lines across give the width and those along it the
// count: their mean. Tolerance: roundoff of t, some 100 eps, because depths are
// differences of positions.
RC_GTEST_PROP(LineArea, FindsTheRimsOfAStrip, ()) {
  const bool is_along_y = *rc::gen::arbitrary<bool>();
  const Grid grid = is_along_y ? Grid{32, 4, 1.0, 0.3} : Grid{4, 32, 0.3, 1.0};
  const double centre = *rc::gen::inRange(0, 1000) * 1e-3;
  const double half_width = 0.1 + *rc::gen::inRange(0, 1000) * 2.5e-4;
  const Maps maps = boundary_fields(grid, [&](double x, double y) {
    return half_width -
           std::abs(periodic_distance(is_along_y ? x : y, centre, 1.0));
  });
  const double counted =
      counted_area_fraction(ContactNodes::under(maps.pressure));

  const double area =
      line_area_fraction(grid, maps.pressure, maps.gap, modulus);

  RC_ASSERT(std::abs(2.0 * area - counted - 2.0 * half_width) < 100 * epsilon);
}

/// The error of t from (A.2), in the mean over t, where the step crosses the
/// contact boundary at an angle of sine `sine`: rho is then too small by
/// sine^2.
double share_added(double sine) {
  constexpr int n = 400;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double share = (i + 0.5) / n;
    const double pressure = std::sqrt(share * sine);
    const double gap = 4.0 / 3.0 * std::pow((1.0 - share) * sine, 1.5);
    sum += boundary_share(pressure, gap, 1.0, 1.0) - share;
  }
  return sum / n;
}

/// Per pair, for a contact boundary without a preferred direction: pairs along
/// a line are as frequent as the sine of the angle at which they cross the
/// boundary. Half of it is added to the area.
double area_added() {
  constexpr int n = 400;
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i < n; ++i) {
    const double sine = std::sin((i + 0.5) / n * 0.5 * std::numbers::pi);
    sum += sine * share_added(sine);
    weights += sine;
  }
  return 0.5 * sum / weights;
}

// For Hertz's pressure and gap, sampled at nodes, the lines give the area of
// the disc except for the contribution of oblique crossings: area_added() per
// pair. Tolerance: three standard errors over the positions, and the next
// order, h/a of what is added.
TEST(LineArea, OfASphereIsTooLargeByTheObliqueCrossings) {
  const Grid grid{128, 128, 1e-3, 1e-3};
  const double radius = 0.31e-3;
  const theory::HertzContact contact = theory::hertz_contact(
      theory::hertz_load(radius, 0.01, modulus), 0.01, modulus);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.4e-3, 0.6e-3);
  constexpr int n_places = 50;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (int i = 0; i < n_places; ++i) {
    const double centre_x = place(random);
    const double centre_y = place(random);
    Maps maps;
    for (int iy = 0; iy < grid.points_y; ++iy)
      for (int ix = 0; ix < grid.points_x; ++ix) {
        const double r = std::hypot(ix * grid.spacing_x() - centre_x,
                                    iy * grid.spacing_y() - centre_y);
        maps.pressure.push_back(theory::hertz_pressure(contact, r));
        maps.gap.push_back(theory::hertz_gap(contact, r));
      }
    const double lines =
        line_area_fraction(grid, maps.pressure, maps.gap, modulus);
    const double excess =
        (lines - std::numbers::pi * radius * radius / grid.area()) /
        (contact_perimeter(grid, ContactNodes::under(maps.pressure)) *
         grid.spacing_x());
    sum += excess;
    sum_of_squares += excess * excess;
  }

  const double mean = sum / n_places;
  const double standard_error =
      std::sqrt((sum_of_squares / n_places - mean * mean) / n_places);
  EXPECT_NEAR(mean, area_added(),
              3.0 * standard_error + area_added() * grid.spacing_x() / radius);
  EXPECT_NEAR(area_added(), 0.026, 0.0005); // as the header prints it
  EXPECT_LT(standard_error, 0.001);
}

TEST(LineArea, IsTheCountWithoutABoundary) {
  const Grid grid{8, 8, 1.0, 1.0};
  const std::vector<double> none(64, 0.0);
  const std::vector<double> all(64, 1e6);

  EXPECT_EQ(line_area_fraction(grid, none, all, modulus), 0.0);
  EXPECT_EQ(line_area_fraction(grid, all, none, modulus), 1.0);
  EXPECT_EQ(
      corrected_area_fraction(grid, all, none, {modulus, {0.1, 0.5}}).value,
      1.0);
}

// (A.5) subtracts c h S_d, with S_d of contact_perimeter, and adds e h^2 chi.
// Tolerance: roundoff of sums of 64 terms of order 1.
TEST(CorrectedArea, SubtractsThePerimeterAndAddsThePatches) {
  const Grid grid{32, 32, 1.0, 1.0};
  const Maps maps = boundary_fields(grid, [](double x, double y) {
    return 0.3 - std::hypot(x - 0.51, y - 0.48);
  });
  const double lines =
      line_area_fraction(grid, maps.pressure, maps.gap, modulus);
  const double spacing = grid.spacing_x();

  const double corrected =
      corrected_area_fraction(grid, maps.pressure, maps.gap,
                              {modulus, {0.1, 0.5}})
          .value;

  EXPECT_NEAR(
      corrected,
      lines -
          0.1 * contact_perimeter(grid, ContactNodes::under(maps.pressure)) *
              spacing +
          0.5 * spacing * spacing,
      64 * epsilon);
}

// Neither the unit of pressure nor that of length matters: a power of two
// changes no bit.
TEST(CorrectedArea, IsIndependentOfUnits) {
  const auto area = [](double length_unit, double pressure_unit) {
    const Grid grid{32, 32, length_unit, length_unit};
    Maps maps = boundary_fields(Grid{32, 32, 1.0, 1.0}, [](double x, double y) {
      return 0.3 - std::hypot(x - 0.51, y - 0.48);
    });
    for (double& pressure : maps.pressure)
      pressure *= pressure_unit;
    for (double& gap : maps.gap)
      gap *= length_unit;
    return corrected_area_fraction(grid, maps.pressure, maps.gap,
                                   {modulus * pressure_unit, {0.1, 0.5}})
        .value;
  };

  EXPECT_EQ(area(0x1p-20, 0x1p-30), area(1.0, 1.0));
}

/// The corrected area of nodes at 1 MPa wherever is_in_contact(ix, iy), with
/// the gap `gap` elsewhere, on 16 by 16 nodes.
template <class IsInContact>
Observed corrected_of(IsInContact is_in_contact, double gap,
                      const AreaCoefficients& coefficients) {
  const Grid grid{16, 16, 1e-6, 1e-6};
  Maps maps{std::vector<double>(256, 0.0), std::vector<double>(256, gap)};
  for (int iy = 0; iy < 16; ++iy)
    for (int ix = 0; ix < 16; ++ix)
      if (is_in_contact(ix, iy)) {
        maps.pressure[grid.index(ix, iy)] = 1e6;
        maps.gap[grid.index(ix, iy)] = 0.0;
      }
  return corrected_area_fraction(grid, maps.pressure, maps.gap,
                                 {modulus, coefficients});
}

// With nodes in contact the corrected area is never 0. One node, and a
// checkerboard with large gaps, are below the resolution of the grid: the area
// is not determined and the reason states by how much, for every operator; a
// patch of five by five is determined.
TEST(CorrectedArea, IsNotDeterminedBelowTheGrid) {
  const auto node = [](int ix, int iy) { return ix == 3 && iy == 5; };
  const auto checkerboard = [](int ix, int iy) { return (ix + iy) % 2 == 0; };
  const auto patch = [](int ix, int iy) { return ix < 5 && iy < 5; };
  for (const AreaCoefficients& coefficients :
       {halfspace_area_coefficients, q2_area_coefficients,
        q1_area_coefficients(1.0), q1_area_coefficients(1.5)}) {
    for (const auto& contact :
         {std::function<bool(int, int)>(node), {checkerboard}}) {
      const Observed area = corrected_of(contact, 1e-9, coefficients);
      EXPECT_TRUE(std::isnan(area.value)) << area.value;
      EXPECT_NE(area.reason.find("too small for this grid"), std::string::npos)
          << area.reason;
    }
    EXPECT_GT(corrected_of(patch, 1e-9, coefficients).value, 10.0 / 256.0);
    // all except one: the open node reduces the area, and no value exceeds 1
    EXPECT_LT(corrected_of([&](int ix, int iy) { return !node(ix, iy); }, 1e-12,
                           coefficients)
                  .value,
              1.0);
  }
}

// Coefficients for depths between the measured ones are interpolated; beyond
// these they are those of the nearest.
TEST(AreaCoefficients, OfQ1AreLinearBetweenTheMeasuredDepths) {
  const auto [shallow, cubic, deep] =
      std::array{q1_area_coefficients(0.5), q1_area_coefficients(1.0),
                 q1_area_coefficients(1.5)};
  EXPECT_GT(shallow.perimeter, cubic.perimeter);
  EXPECT_GT(cubic.perimeter, deep.perimeter);
  EXPECT_DOUBLE_EQ(q1_area_coefficients(1.25).perimeter,
                   0.5 * (cubic.perimeter + deep.perimeter));
  EXPECT_DOUBLE_EQ(q1_area_coefficients(0.75).euler,
                   0.5 * (shallow.euler + cubic.euler));
  EXPECT_EQ(q1_area_coefficients(9.0).perimeter, deep.perimeter);
  EXPECT_EQ(q1_area_coefficients(0.1).euler, shallow.euler);
  EXPECT_THROW(q1_area_coefficients(0.0), std::domain_error);
}

TEST(AreaMaps, AreCheckedByName) {
  const Grid grid{4, 4, 1.0, 1.0};
  const std::vector<double> full(16, 1.0);
  const std::vector<double> short_map(15, 1.0);
  try {
    line_area_fraction(grid, full, short_map, modulus);
    FAIL() << "a map of another size was accepted";
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(error.what(), "gap.size() = 15, but must be equal to 16");
  }
  EXPECT_THROW(euler_characteristic(grid, short_map), std::domain_error);
  EXPECT_THROW(corrected_area_fraction(grid, short_map, full, {modulus}),
               std::domain_error);
}

// Patches minus holes, wherever the periodic boundary cuts them.
TEST(EulerNumber, CountsPatchesMinusHoles) {
  const Grid grid{40, 40, 1.0, 1.0};
  const auto euler = [&](auto is_inside) {
    return euler_characteristic(grid, shape(grid, is_inside));
  };
  const auto disc = [](double x, double y, double centre, double radius) {
    return std::hypot(periodic_distance(x, centre, 1.0),
                      periodic_distance(y, centre, 1.0)) < radius;
  };

  for (const double centre : {0.0, 0.13, 0.5}) {
    EXPECT_EQ(
        euler([&](double x, double y) { return disc(x, y, centre, 0.3); }),
        1.0);
    EXPECT_EQ(euler([&](double x, double y) {
                return disc(x, y, centre, 0.3) && !disc(x, y, centre, 0.1);
              }),
              0.0); // a ring
    EXPECT_EQ(
        euler([&](double x, double y) { return !disc(x, y, centre, 0.3); }),
        -1.0);
  }
  EXPECT_EQ(euler([](double x, double) { return x < 0.5; }), 0.0); // a strip
  EXPECT_EQ(euler([](double, double) { return false; }), 0.0);
  EXPECT_EQ(euler([](double, double) { return true; }), 0.0);
}

// Beyond a free border there is no contact: full contact is one patch, a strip
// too, and contacts on opposite sides of the map are two. The border has no
// gap, so that the lines of a contact that reaches it end with its cells.
TEST(FreeBorder, EndsAContact) {
  const Grid grid{12, 8, 1.2, 0.8};
  const auto euler = [&](auto is_inside) {
    return euler_characteristic(grid, shape(grid, is_inside), Border::free);
  };
  EXPECT_EQ(euler([](double, double) { return true; }), 1.0);
  EXPECT_EQ(euler([](double x, double) { return x < 0.5; }), 1.0);
  EXPECT_EQ(euler([](double x, double) { return x < 0.25 || x > 0.85; }), 2.0);
  EXPECT_EQ(euler([](double x, double y) {
              return std::abs(x - 0.6) > 0.15 || std::abs(y - 0.4) > 0.15;
            }),
            0.0); // a frame around a hole
  const std::vector<double> full(grid.size(), modulus);
  const std::vector<double> no_gap(grid.size(), 0.0);
  EXPECT_EQ(line_area_fraction(grid, full, no_gap, modulus, Border::free), 1.0);
}

// Contact and its complement have opposite Euler characteristics on a periodic
// surface, whose own is 0. Exact: multiples of a quarter.
RC_GTEST_PROP(EulerNumber, ChangesSignWithTheComplement, ()) {
  const Grid grid{8, 6, 1.0, 1.0};
  std::vector<double> pressure(grid.size());
  std::vector<double> complement(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    pressure[i] = *rc::gen::inRange(0, 2);
    complement[i] = 1.0 - pressure[i];
  }

  RC_ASSERT(euler_characteristic(grid, pressure) ==
            -euler_characteristic(grid, complement));
}

} // namespace asperity::results::area_estimate_test
