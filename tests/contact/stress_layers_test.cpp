// Tests of contact/operators/stress_inside.hpp with layered blocks: equal
// layers change nothing, the field is in balance and its tractions are
// continuous across interfaces, it stores the work done on the surface, and it
// describes the bending of a stiff coating.
#include "base/maximum.hpp"
#include "base/special_numbers.hpp"
#include "contact/operators/stress_inside.hpp"
#include "tests/base/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity::contact::stress_layers_test {

using std::numbers::pi;

constexpr std::array far_boundaries{mechanics::FarBoundary::clamped,
                                    mechanics::FarBoundary::sliding,
                                    mechanics::FarBoundary::pressure};
constexpr std::array<mechanics::BondedLayer, 2> two_layers{
    {{0.02, 8.0, 0.2}, {0.08, 0.5, 0.45}}};

double plane_strain(double youngs_modulus, double poisson_ratio) {
  return youngs_modulus / (1.0 - poisson_ratio * poisson_ratio);
}

/// Two layers on a remainder of E = 2, nu = 0.3.
mechanics::ElasticBlock layered_block(double thickness,
                                      mechanics::FarBoundary boundary) {
  return {plane_strain(2.0, 0.3),
          0.3,
          thickness,
          boundary,
          {two_layers.begin(), two_layers.end()}};
}

std::vector<double> wave(const Grid& grid, int jx, int jy) {
  std::vector<double> pressure(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      pressure[grid.index(ix, iy)] = std::cos(
          2.0 * pi *
          (jx * ix / double(grid.points_x) + jy * iy / double(grid.points_y)));
  return pressure;
}

/// A patch of pressure in the middle, at most 1.
std::vector<double> patch(const Grid& grid, double radius) {
  std::vector<double> pressure(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double r = std::hypot(ix * grid.spacing_x() - 0.5 * grid.length_x,
                                  iy * grid.spacing_y() - 0.5 * grid.length_y) /
                       radius;
      pressure[grid.index(ix, iy)] = std::sqrt(std::max(0.0, 1.0 - r * r));
    }
  return pressure;
}

double largest_difference(const StressPlane& a, const StressPlane& b) {
  double largest = 0.0;
  for (const auto component :
       {&StressPlane::xx, &StressPlane::yy, &StressPlane::zz, &StressPlane::xy,
        &StressPlane::yz, &StressPlane::zx})
    largest =
        maximum(largest, tests::largest_difference(a.*component, b.*component));
  return largest;
}

// Verifies that layers with the moduli of the block change no stress on either
// side of an interface. Tolerance: roundoff of stresses of a few units; the
// free plate bends with some (q d)^-2 = 10.
TEST(StressInLayers, OfEqualModuliEqualsTheBlock) {
  const Grid grid{16, 24, 1.0, 1.3};
  const std::vector<double> pressure = patch(grid, 0.3);
  for (const double thickness : {0.1, 0.7, infinity})
    for (const mechanics::FarBoundary boundary : far_boundaries) {
      const mechanics::ElasticBlock plain{plane_strain(2.0, 0.35), 0.35,
                                          thickness, boundary};
      mechanics::ElasticBlock cut = plain;
      cut.layers = {{0.03, 2.0, 0.35}, {0.04, 2.0, 0.35}};
      const StressInside whole(grid, plain, pressure);
      const StressInside layers(grid, cut, pressure);

      for (const double depth : {0.0, 0.01, 0.03, 0.05, 0.1})
        for (const InterfaceSide side :
             {InterfaceSide::upper, InterfaceSide::lower})
          EXPECT_LT(largest_difference(whole.at_depth(depth),
                                       layers.at_depth(depth, side)),
                    2e-13)
              << thickness << " " << static_cast<int>(boundary) << " " << depth;

      EXPECT_NEAR(layers.strongest().von_mises / whole.strongest().von_mises,
                  1.0, 1e-3); // of the search, which samples other planes
    }
}

// Verifies the balance of forces along x, y and z inside each layer. For one
// wave the derivatives along the plane are those of a wave that is shifted by a
// quarter. Tolerance: central differences over 1e-5, h^2/6 of a third
// derivative of some (q = 14)^3 times stresses of up to 10.
TEST(StressInLayers, IsInBalance) {
  const Grid grid{32, 32, 1.0, 1.0};
  const double h = 1e-5;
  for (const mechanics::FarBoundary boundary : far_boundaries) {
    const StressInside inside(grid, layered_block(0.3, boundary),
                              wave(grid, 1, 2));
    for (const double z : {0.01, 0.05, 0.2}) {
      const StressPlane here = inside.at_depth(z);
      const StressPlane below = inside.at_depth(z + h);
      const StressPlane above = inside.at_depth(z - h);
      const auto change = [&](const std::vector<double>& lower,
                              const std::vector<double>& upper, std::size_t i) {
        return (lower[i] - upper[i]) / (2.0 * h);
      };
      for (const int ix : {0, 3, 7}) {
        const std::size_t i = grid.index(ix, 5);
        const std::size_t x_on = grid.index(ix + 8, 5);
        const std::size_t y_on = grid.index(ix, 5 + 4);
        const auto along = [&](const std::vector<double>& by_x,
                               const std::vector<double>& by_y) {
          return 2.0 * pi * by_x[x_on] + 4.0 * pi * by_y[y_on];
        };
        EXPECT_NEAR(along(here.xx, here.xy) + change(below.zx, above.zx, i),
                    0.0, 1e-5);
        EXPECT_NEAR(along(here.xy, here.yy) + change(below.yz, above.yz, i),
                    0.0, 1e-5);
        EXPECT_NEAR(along(here.zx, here.yz) + change(below.zz, above.zz, i),
                    0.0, 1e-5);
      }
    }
  }
}

// Across an interface the tractions and the in-plane strains are continuous,
// for waves, for uniform pressure and for their sum, and sigma_xx is not.
// Tolerance: roundoff.
TEST(StressInLayers, IsContinuousAcrossInterfaces) {
  const Grid grid{16, 24, 1.0, 1.3};
  const StressInside inside(grid,
                            layered_block(0.3, mechanics::FarBoundary::clamped),
                            patch(grid, 0.3));
  const auto strain = [](const StressPlane& plane, double modulus, double nu,
                         std::size_t i) {
    return (plane.xx[i] - nu * (plane.yy[i] + plane.zz[i])) / modulus;
  };
  const double depth = two_layers[0].thickness;

  const StressPlane upper = inside.at_depth(depth, InterfaceSide::upper);
  const StressPlane lower = inside.at_depth(depth, InterfaceSide::lower);

  double jump = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    EXPECT_NEAR(upper.zz[i], lower.zz[i], 1e-14);
    EXPECT_NEAR(upper.yz[i], lower.yz[i], 1e-14);
    EXPECT_NEAR(upper.zx[i], lower.zx[i], 1e-14);
    EXPECT_NEAR(strain(upper, 8.0, 0.2, i), strain(lower, 0.5, 0.45, i), 1e-14);
    jump = std::max(jump, std::abs(upper.xx[i] - lower.xx[i]));
  }
  EXPECT_GT(jump, 1.0);
  EXPECT_EQ(largest_difference(upper, inside.at_depth(depth)), 0.0);
}

/// Mean strain energy of a layer per unit area, by Simpson's rule.
double energy_of(const StressInside& inside, double top, double bottom,
                 double modulus, double nu) {
  constexpr int n = 200;
  double energy = 0.0;
  for (int k = 0; k <= n; ++k) {
    const StressPlane s =
        inside.at_depth(std::min(top + (bottom - top) * k / n, bottom),
                        k == 0 ? InterfaceSide::lower : InterfaceSide::upper);
    double density = 0.0;
    for (std::size_t i = 0; i < s.zz.size(); ++i) {
      const double trace = s.xx[i] + s.yy[i] + s.zz[i];
      const double square =
          s.xx[i] * s.xx[i] + s.yy[i] * s.yy[i] + s.zz[i] * s.zz[i] +
          2.0 * (s.xy[i] * s.xy[i] + s.yz[i] * s.yz[i] + s.zx[i] * s.zx[i]);
      density += ((1.0 + nu) * square - nu * trace * trace) / (2.0 * modulus);
    }
    const double weight = k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    energy += weight * density / static_cast<double>(s.zz.size()) *
              (bottom - top) / (3.0 * n);
  }
  return energy;
}

// The strain energy of all layers is the work done on the surface, C(q)/4 per
// unit area for a pressure cos(q.x). Tolerance: Simpson over 200 intervals of
// functions of exp(-2 q z), q t < 2: 1e-8.
TEST(StressInLayers, StoresTheWorkDoneOnTheSurface) {
  const Grid grid{16, 16, 1.0, 1.0};
  const double q = 2.0 * pi * std::sqrt(2.0);
  for (const double thickness : {0.15, 0.3})
    for (const mechanics::FarBoundary boundary : far_boundaries) {
      const mechanics::ElasticBlock block = layered_block(thickness, boundary);
      const StressInside inside(grid, block, wave(grid, 1, 1));

      const double energy = energy_of(inside, 0.0, 0.02, 8.0, 0.2) +
                            energy_of(inside, 0.02, 0.1, 0.5, 0.45) +
                            energy_of(inside, 0.1, thickness, 2.0, 0.3);

      EXPECT_NEAR(energy / (0.25 * layered_compliance(q, block)), 1.0, 1e-7)
          << thickness << " " << static_cast<int>(boundary);
    }
}

// A very stiff coating bends as a plate, with tension at its lower boundary:
// sigma_xx = E*_1 q^2 w t/2, where w is the displacement of the surface.
// Tolerance: the shear of a plate, (q t)^2 = 2.5e-3 times a number of order
// one, and the stretching by the shear of the substrate, 2 E_2/(E_1 (q t)^2) =
// 8e-5.
TEST(StressInLayers, BendsAStiffCoatingAsAPlate) {
  const Grid grid{16, 16, 1.0, 1.0};
  const double thickness = 0.05 / (2.0 * pi);
  const double ratio = 1e7;
  const mechanics::ElasticBlock block{1.0,
                                      0.0,
                                      infinity,
                                      mechanics::FarBoundary::clamped,
                                      {{thickness, ratio, 0.0}}};
  const double q = 2.0 * pi;

  const StressPlane bottom =
      StressInside(grid, block, wave(grid, 1, 0)).at_depth(thickness);

  const double displacement = layered_compliance(q, block);
  EXPECT_NEAR(bottom.xx[0] / (ratio * q * q * displacement * thickness / 2.0),
              1.0, 5e-3);
}

// Under a patch of pressure the lower boundary of a coating that is ten times
// stiffer is in tension, in contrast to a uniform block. If the patch is wider
// than the coating is thick, the maximum stress lies there, above the
// interface.
TEST(StressInLayers, PullsTheBottomOfAStiffCoating) {
  const Grid grid{64, 64, 1.0, 1.0};
  const double thickness = 0.04;
  mechanics::ElasticBlock block{1.0,
                                0.3,
                                infinity,
                                mechanics::FarBoundary::clamped,
                                {{thickness, 9.1, 0.3}}};
  const std::vector<double> pressure = patch(grid, 0.08);
  const std::size_t middle = grid.index(32, 32);

  const StressInside coated(grid, block, pressure);
  block.layers.clear();
  const StressInside uniform(grid, block, pressure);

  const StressPeak peak = coated.strongest();
  EXPECT_GT(coated.at_depth(thickness).xx[middle], 1.0);
  EXPECT_LT(uniform.at_depth(thickness).xx[middle], 0.0);
  EXPECT_EQ(peak.depth, thickness);
  EXPECT_EQ(peak.node, middle);
  EXPECT_EQ(peak.side, InterfaceSide::upper);
  EXPECT_GT(peak.von_mises, 2.0 * uniform.strongest().von_mises);
}

// In an incompressible coating the stress is nearly hydrostatic, so that the
// maximum lies just below the interface: in the map of that side, which exceeds
// every value of the other side.
TEST(StressInLayers, IsStrongestBelowASoftCoating) {
  const Grid grid{64, 64, 1.0, 1.0};
  const double thickness = 0.04;
  const mechanics::ElasticBlock block{1.0,
                                      0.0,
                                      infinity,
                                      mechanics::FarBoundary::clamped,
                                      {{thickness, 0.5, 0.5}}};
  const StressInside inside(grid, block, patch(grid, 0.08));
  const auto largest = [&](InterfaceSide side) {
    const std::vector<double> map = von_mises(inside.at_depth(thickness, side));
    return *std::max_element(map.begin(), map.end());
  };

  const StressPeak peak = inside.strongest();

  EXPECT_EQ(peak.depth, thickness);
  EXPECT_EQ(peak.side, InterfaceSide::lower);
  EXPECT_EQ(peak.von_mises, largest(InterfaceSide::lower));
  EXPECT_GT(peak.von_mises, largest(InterfaceSide::upper));
}

} // namespace asperity::contact::stress_layers_test
