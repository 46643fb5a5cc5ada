// Tests of surfaces/inner_roughness.hpp against closed forms and quadrature on
// a fine grid.
#include "surfaces/inner_roughness.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "surfaces/maps/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::surfaces::inner_roughness_test {

using mechanics::Edges;
using mechanics::SurfaceKind;
using mechanics::SurfaceSpec;

TEST(InnerRoughness, OfASphereIsThatOfItsParaboloid) {
  SurfaceSpec sphere;
  sphere.kind = SurfaceKind::sphere;
  sphere.radius = 2.0;

  const auto found = exact_roughness(sphere, 0.3, 0.4);

  EXPECT_DOUBLE_EQ(found->rms_curvature, 0.5);
  EXPECT_DOUBLE_EQ(found->rms_slope, 0.5 / std::sqrt(12.0) / 2.0);
}

// The mean over the nodes of a grid inside the square, which converges to that
// over the square. Tolerance: its error of second order, and the jump of the
// curvature at the flat end, of first order.
TEST(InnerRoughness, OfARoundedPunchIsTheMeanOverTheSquare) {
  SurfaceSpec punch;
  punch.kind = SurfaceKind::rounded_punch;
  punch.radius = 0.2;
  punch.edge_radius = 3.0;
  constexpr int n = 2000;
  double slope = 0.0, curvature = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double r = std::hypot((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5);
      if (r < punch.radius)
        continue;
      slope += std::pow((r - punch.radius) / punch.edge_radius, 2);
      curvature += std::pow(
          (1.0 + (r - punch.radius) / r) / (2.0 * punch.edge_radius), 2);
    }

  const auto found = exact_roughness(punch, 1.0, 1.0);

  EXPECT_NEAR(found->rms_slope / (std::sqrt(slope) / n), 1.0, 1e-4);
  EXPECT_NEAR(found->rms_curvature / (std::sqrt(curvature) / n), 1.0, 1e-3);
}

TEST(InnerRoughness, IsNotStatedWhereItHasNoBound) {
  SurfaceSpec shape;
  shape.slope = 0.1;
  shape.kind = SurfaceKind::cone;
  EXPECT_EQ(exact_roughness(shape, 1.0, 1.0)->rms_slope, 0.1);
  EXPECT_TRUE(std::isnan(exact_roughness(shape, 1.0, 1.0)->rms_curvature));
  shape.kind = SurfaceKind::punch;
  EXPECT_TRUE(std::isnan(exact_roughness(shape, 1.0, 1.0)->rms_slope));
  for (const SurfaceKind kind : {SurfaceKind::measured, SurfaceKind::wave_1d,
                                 SurfaceKind::self_affine}) {
    shape.kind = kind;
    EXPECT_FALSE(exact_roughness(shape, 1.0, 1.0));
  }
}

// The edges at which the images of a paraboloid meet have no part in it.
TEST(InnerRoughness, OfAMapIsThatInside) {
  for (const int points : {16, 64}) {
    const HeightMap map = paraboloid({points, points / 2, 1.0, 0.5}, 4.0);

    EXPECT_NEAR(inner_curvature(map), 0.25, 1e-9);
    EXPECT_GT(statistics(map).rms_curvature, 0.5);
  }
  EXPECT_TRUE(std::isnan(
      inner_curvature({{2, 4, 1.0, 2.0}, {1, 2, 3, 4, 5, 6, 7, 8}})));
}

TEST(InnerRoughness, CountsWhereEdgesAreNotPressed) {
  SurfaceSpec surface;
  surface.kind = SurfaceKind::measured;
  EXPECT_TRUE(is_judged_inside(surface, true));
  EXPECT_FALSE(is_judged_inside(surface, false));
  surface.kind = SurfaceKind::self_affine;
  EXPECT_FALSE(is_judged_inside(surface, true)); // it is periodic by itself
  surface.form_radius = 1.0;
  EXPECT_TRUE(is_judged_inside(surface, false));
}

} // namespace asperity::surfaces::inner_roughness_test
