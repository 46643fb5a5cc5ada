// Tests of spread_spectrum_of() in run/methods/surfaces_of_case.hpp: the
// studies of a measured map describe the contact whose curve the theory gives.
#include "run/methods/surfaces_of_case.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"
#include "theory/persson/magnification.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace asperity::methods::spread_spectrum_test {

// The area at the highest magnification is that of the lines to roundoff: it
// depends on the mean square slope alone. The mean gap also depends on where
// each line lies in its annulus: 1 % for a width of 10 %.
TEST(SpreadSpectrum, GivesTheContactOfTheLines) {
  constexpr double unit = 2.0 * std::numbers::pi / 1e-5;
  constexpr double modulus = 1e9;
  const auto formula = surfaces::SelfAffineSpectrum::with_rms_height(
      {0.8, unit, 4.0 * unit, 60.0 * unit}, 1e-8);
  const surfaces::HeightMap map =
      surfaces::realize(formula.isotropic(), {256, 256, 1e-5, 1e-5}, {3, 0});
  const SurfaceOfCase surface = surface_of_map(map, modulus);

  const theory::PerssonContact lines(spectrum_of(surface), modulus, 0.42);
  const theory::PerssonContact spread(spread_spectrum_of(surface), modulus,
                                      0.42);

  ASSERT_TRUE(spread.spectrum().has_density());
  EXPECT_NEAR(spread.spectrum().rms_height() / lines.spectrum().rms_height(),
              1.0, 1e-9);
  for (const double pressure : {1e5, 1e6, 1e7}) {
    EXPECT_NEAR(spread.area_fraction(pressure) / lines.area_fraction(pressure),
                1.0, 1e-9);
    EXPECT_NEAR(spread.mean_gap(pressure) / lines.mean_gap(pressure), 1.0,
                0.01);
    const theory::MagnifiedContact magnified(spread, pressure, unit);
    EXPECT_NEAR(magnified.area_fraction(magnified.highest_magnification()),
                lines.area_fraction(pressure), 1e-9);
  }
}

} // namespace asperity::methods::spread_spectrum_test
