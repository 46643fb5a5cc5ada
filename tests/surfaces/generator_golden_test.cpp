// The bits of the generator, because the meaning of a seed must never change.
// The heights are our own earlier output: a golden test of the platform and of
// the conventions.
#include "surfaces/build.hpp"
#include "surfaces/maps/random_modes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace asperity::surfaces::generator_golden_test {

// The generator is Philox-4x64-10. Expected: the known answer of its authors
// for counter 0 and key 0, words 16554d9eca36314c and db20fe9d672d0fdc.
TEST(GeneratorGolden, GivesThePublishedValuesOfItsAuthors) {
  const UniformPair draw = draw_mode({0, 0, RandomStream{0}}, 0, 0);

  EXPECT_EQ(draw.first, (0x16554d9eca363p0 + 0.5) * 0x1p-52);
  EXPECT_EQ(draw.second, (0xdb20fe9d672d0p0 + 0.5) * 0x1p-52);
}

TEST(GeneratorGolden, GivesTheStoredHeights) {
  constexpr double unit = 2.0 * std::numbers::pi / 1e-5;
  mechanics::SurfaceSpec surface;
  surface.length = 1e-5;
  surface.points = 64;
  surface.seed = 7;
  surface.rms_height = 1e-9;
  surface.hurst = 0.8;
  surface.wavevector_low = unit;
  surface.wavevector_roll_off = 4 * unit;
  surface.wavevector_high = 20 * unit;

  const HeightMap map = build_surface(surface, 2);

  // The roundoff of the transform may differ between platforms: 1e-14 h_rms.
  EXPECT_NEAR(map.heights[map.grid.index(0, 0)], 2.236465369449389e-09, 1e-23);
  EXPECT_NEAR(map.heights[map.grid.index(17, 5)], -4.0908318815024976e-10,
              1e-23);
  EXPECT_NEAR(map.heights[map.grid.index(40, 63)], 9.0555343562943455e-11,
              1e-23);
}

} // namespace asperity::surfaces::generator_golden_test
