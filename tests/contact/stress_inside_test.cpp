// Tests of contact/operators/stress_inside.hpp: the stress agrees with Hertz's
// and satisfies the conditions of the far boundary. Balance and energy are
// those of layers, stress_layers_test.cpp.
#include "base/special_numbers.hpp"
#include "contact/operators/stress_inside.hpp"
#include "tests/theory/hertz_stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::contact::stress_inside_test {

using std::numbers::pi;

constexpr double modulus = 2.0;

std::vector<double> oblique_wave(const Grid& grid, int jx, int jy) {
  std::vector<double> pressure(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      pressure[grid.index(ix, iy)] = std::cos(
          2.0 * pi *
          (jx * ix / double(grid.points_x) + jy * iy / double(grid.points_y)));
  return pressure;
}

std::vector<double> hertz_map(const Grid& grid,
                              const theory::HertzContact& contact) {
  std::vector<double> pressure(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double x = ix * grid.spacing_x() - 0.5 * grid.length_x;
      const double y = iy * grid.spacing_y() - 0.5 * grid.length_y;
      pressure[grid.index(ix, iy)] =
          theory::hertz_pressure(contact, std::hypot(x, y));
    }
  return pressure;
}

// Under Hertz's pressure on a cell twelve radii wide the maximum von Mises
// stress is 0.62 p_0 at the depth 0.48 a on the axis (nu = 0.3; Johnson, Sec.
// 4.2). Tolerance: a sixteenth of a spacing in the radius, and the periodic
// images, whose pressure adds p_0 pi (2/3) a^2/L^2 = 1.5 % of p_0, mostly as a
// hydrostatic pressure.
TEST(StressInside, HasItsMaximumWhereHertzHasIt) {
  const theory::HertzContact contact = theory::hertz_contact(2.0, 5e-3, 70e9);
  const double a = contact.contact_radius;
  const Grid grid{192, 192, 12.0 * a, 12.0 * a};
  const StressInside inside(
      grid, {70e9, 0.3, infinity, mechanics::FarBoundary::clamped},
      hertz_map(grid, contact));

  const StressPeak peak = inside.strongest();

  EXPECT_NEAR(peak.von_mises / contact.peak_pressure, 0.620, 0.007);
  EXPECT_NEAR(peak.depth / a, 0.481, 0.015);
  EXPECT_EQ(peak.node, grid.index(96, 96));
}

// Verifies Huber's field and its largest shear stress in each plane, also off
// the axis. Tolerance as above.
TEST(StressInside, IsHubersFieldInAPlane) {
  const theory::HertzContact contact = theory::hertz_contact(2.0, 5e-3, 70e9);
  const double a = contact.contact_radius;
  const Grid grid{192, 192, 12.0 * a, 12.0 * a};
  const StressInside inside(
      grid, {70e9, 0.3, infinity, mechanics::FarBoundary::clamped},
      hertz_map(grid, contact));

  for (const double depth : {0.25 * a, 0.5 * a, 1.0 * a}) {
    const StressPlane plane = inside.at_depth(depth);
    const std::vector<double> shear = largest_shear(plane);
    for (const int offset : {0, 8, 16, 24}) {
      const theory::AxisymmetricStress exact =
          theory::hertz_stress(contact, offset * grid.spacing_x(), depth, 0.3);
      const std::size_t node = grid.index(96 + offset, 96);

      EXPECT_NEAR(plane.zz[node] / contact.peak_pressure,
                  exact.axial / contact.peak_pressure, 0.01);
      EXPECT_NEAR(plane.zx[node] / contact.peak_pressure,
                  exact.shear / contact.peak_pressure, 0.01);
      EXPECT_NEAR(shear[node] / contact.peak_pressure,
                  exact.largest_shear() / contact.peak_pressure, 0.01);
    }
  }
}

// Verifies that a free far boundary carries no traction and a sliding one no
// shear. Tolerance: roundoff of a 4 x 4 solve whose condition number is some
// 1e4 at q d = 0.4.
TEST(StressInside, SatisfiesTheFarBoundary) {
  const Grid grid{16, 16, 1.0, 1.0};
  const double thickness = 0.06;
  const StressPlane free_face =
      StressInside(grid,
                   {modulus, 0.3, thickness, mechanics::FarBoundary::pressure},
                   oblique_wave(grid, 1, 0))
          .at_depth(thickness);
  const StressPlane sliding_face =
      StressInside(grid,
                   {modulus, 0.3, thickness, mechanics::FarBoundary::sliding},
                   oblique_wave(grid, 1, 0))
          .at_depth(thickness);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    EXPECT_NEAR(free_face.zz[i], 0.0, 1e-10);
    EXPECT_NEAR(free_face.zx[i], 0.0, 1e-10);
    EXPECT_NEAR(sliding_face.zx[i], 0.0, 1e-10);
  }
}

// A uniform pressure compresses the block as in an oedometer.
TEST(StressInside, UnderUniformPressureIsThatOfAnOedometer) {
  const Grid grid{8, 8, 1.0, 1.0};
  const StressInside inside(
      grid, {modulus, 0.25, infinity, mechanics::FarBoundary::clamped},
      std::vector<double>(grid.size(), 3.0));
  const StressPlane plane = inside.at_depth(0.7);
  EXPECT_NEAR(plane.zz[9], -3.0, 1e-14);
  EXPECT_NEAR(plane.xx[9], -1.0, 1e-14);
  EXPECT_NEAR(von_mises(plane)[9], 2.0, 1e-14);
  EXPECT_NEAR(largest_shear(plane)[9], 1.0, 1e-14);
}

TEST(StressInside, RefusesInvalidArguments) {
  const Grid grid{8, 8, 1.0, 1.0};
  const mechanics::ElasticBlock slab{modulus, 0.3, 0.5,
                                     mechanics::FarBoundary::clamped};
  const std::vector<double> pressure(grid.size(), 1.0);
  EXPECT_THROW(StressInside(grid, slab, std::vector<double>(3, 1.0)),
               std::domain_error);
  EXPECT_THROW(StressInside(grid, {modulus, 0.6, 0.5}, pressure),
               std::domain_error);
  EXPECT_THROW(StressInside(grid, slab, pressure).at_depth(0.6),
               std::domain_error);
  EXPECT_THROW(StressInside(grid, slab, pressure).at_depth(-0.1),
               std::domain_error);
}

} // namespace asperity::contact::stress_inside_test
