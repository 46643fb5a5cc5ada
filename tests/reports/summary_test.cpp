// Tests of reports/analysis/summary.hpp: from an entire result to named
// numbers.
#include "reports/analysis/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synthetic.hpp"

namespace asperity::reports::summary_test {

double value_of(const Summary& summary, const std::string& method,
                const std::string& quantity) {
  for (const MethodSummary& one : summary.methods)
    if (one.name == method)
      return one.quantities.at(quantity).value;
  return not_a_number;
}

// The synthetic method is the theory with its area times 1.25 and its gap
// shifted by 0.02 h_rms times 0.8, 1, 1.2 in the three realisations.
class RoughSummary : public ::testing::Test {
protected:
  const cases::Case rough = synthetic::contact_case();
  const results::Result result = synthetic::rough_result(rough, 3);
  const Summary summary = summarize(result, rough);
};

// Tolerances: roundoff; rows of both curves are at the same pressures.
TEST_F(RoughSummary, FindsWhatTheMethodWasMadeWith) {
  EXPECT_NEAR(value_of(summary, "fem", "area_excess"), 0.25, 1e-12);
  EXPECT_NEAR(value_of(summary, "fem", "gap_deviation"), 0.02 * 1.2, 1e-12);
  EXPECT_NEAR(value_of(summary, "fem", "mean_gap_deviation"), 0.02, 1e-12);
  EXPECT_NEAR(value_of(summary, "fem", "gamma_slope"),
              value_of(summary, "theory", "gamma_slope"), 1e-12);
  EXPECT_EQ(value_of(summary, "theory", "gamma_curve"), 0.38);
  EXPECT_EQ(value_of(summary, "fem", "iterations_max"), 35.0);
}

// The interval of the mean is Student's, 4.30265 s/sqrt(3) with s = 0.2 times
// the mean.
TEST_F(RoughSummary, MeanDeviationHasTheIntervalOfTheMean) {
  const Estimate& mean =
      summary.methods.back().quantities.at("mean_gap_deviation");

  EXPECT_NEAR(mean.half_width, 4.30265 * 0.2 * 0.02 / std::sqrt(3.0), 1e-7);
  EXPECT_EQ(mean.realizations, 3);
}

// The fitted slope of the theory lies within 10 % of its limit u_0/h_rms of
// (18): the window excludes the inflection, where the slope is 19 % above.
TEST_F(RoughSummary, SlopeOfTheTheoryIsNearItsOwnLimit) {
  const RealizationFits& fits = summary.methods.front().fits.front();

  const double limit = synthetic::contact_of(rough.surface).gap_decay_length() /
                       *rough.surface.rms_height;

  EXPECT_NEAR(fits.asymptotic_slope, limit, 1e-12);
  EXPECT_NEAR(fits.slope.gamma_slope.value / limit, 1.0, 0.10);
}

// The h_rms and h' of the formula are those of the theory's quadrature.
TEST_F(RoughSummary, ScalesOfTheFormulaAreThoseOfItsSpectrum) {
  const theory::HeightSpectrum spectrum =
      synthetic::contact_of(rough.surface).spectrum();

  const SurfaceScales scales =
      scales_of(result, rough, result.methods.front(), 0);

  EXPECT_NEAR(scales.rms_height / spectrum.rms_height(), 1.0, 1e-12);
  EXPECT_NEAR(scales.rms_slope / spectrum.rms_slope(), 1.0, 1e-12);
}

// A case that states its slope has the same scales as one that states the
// corresponding height.
TEST_F(RoughSummary, SlopeAndHeightAreInterchangeable) {
  cases::Case by_slope = rough;
  const SurfaceScales scales =
      scales_of(result, rough, result.methods.front(), 0);
  by_slope.surface.rms_height.reset();
  by_slope.surface.rms_slope = scales.rms_slope;

  const SurfaceScales again =
      scales_of(result, by_slope, result.methods.front(), 0);

  EXPECT_NEAR(again.rms_height / *rough.surface.rms_height, 1.0, 1e-12);
}

// The fit of the gamma of (10) with the spectrum of the heights recovers the
// gamma of a curve made from that spectrum. The maps here do not have exactly
// the spectrum of the formula, so that the curve is made from them. Tolerance:
// roundoff of two transforms and of shells separated to 1e-9.
TEST_F(RoughSummary, FitsGammaByTheSurfacesOwnSpectrum) {
  results::Result own = synthetic::rough_result(rough, 1);
  const std::vector<theory::SpectrumShell> shells =
      synthetic::shells_by_sum(own.surfaces.front());
  const theory::PerssonContact contact(theory::HeightSpectrum(shells),
                                       synthetic::contact_modulus, 0.43);
  for (results::CurvePoint& point : own.methods[1].realizations[0].points)
    point.mean_gap = contact.mean_gap(point.nominal_pressure);

  const Summary found = summarize(own, rough);

  EXPECT_NEAR(value_of(found, "fem", "gamma_curve"), 0.43, 1e-8);
  EXPECT_NEAR(found.methods[1].fits.front().asymptotic_slope,
              contact.gap_decay_length() / own.surfaces.front().rms_height,
              1e-8);

  // the same for a method with its own surface, different from that of the case
  own.methods[1].realizations[0].own_surface = own.surfaces[0];
  for (double& height : own.surfaces[0].heights)
    height *= 3.0;
  EXPECT_NEAR(value_of(summarize(own, rough), "fem", "gamma_curve"), 0.43,
              1e-8);
}

// A method is measured in its own surface. With half the h_rms and slope the
// same curve has twice the gamma, half the kappa and, since its maps are
// unchanged, twice the penetration. Tolerance: roundoff.
TEST_F(RoughSummary, MeasuresAMethodInItsOwnSurface) {
  results::Result own = synthetic::rough_result(rough, 1);
  own.methods[1].realizations[0].fields[0].gap[5] = -1e-9;
  const Summary before = summarize(own, rough);
  results::SurfaceRecord surface = own.surfaces[0];
  surface.rms_height *= 0.5;
  surface.rms_slope *= 0.5;
  for (double& height : surface.heights)
    height *= 0.5;
  own.methods[1].realizations[0].own_surface = surface;

  const Summary found = summarize(own, rough);

  const auto ratio = [&](const std::string& quantity) {
    return value_of(found, "fem", quantity) / value_of(before, "fem", quantity);
  };
  EXPECT_NEAR(scales_of(own, rough, own.methods[1], 0).rms_slope,
              0.5 * own.surfaces[0].rms_slope, 1e-15);
  EXPECT_EQ(surface_of(own, own.methods[0], 0), &own.surfaces[0]);
  EXPECT_NEAR(ratio("kappa"), 0.5, 1e-12);
  EXPECT_NEAR(ratio("penetration"), 2.0, 1e-12);
}

TEST_F(RoughSummary, StatesWhyThereIsNoGammaWithoutHeights) {
  results::Result bare = result;
  for (results::SurfaceRecord& surface : bare.surfaces)
    surface.heights.clear();

  const Summary found = summarize(bare, rough);

  const Estimate& gamma = found.methods[1].quantities.at("gamma_curve");
  EXPECT_FALSE(gamma.has_value());
  EXPECT_EQ(gamma.remark, "the heights are not in the result");
}

TEST_F(RoughSummary, AddsUpTheCost) {
  const Cost& cost = summary.methods[1].cost;

  EXPECT_EQ(cost.steps, 48);
  EXPECT_EQ(cost.failed_steps, 0);
  EXPECT_NEAR(cost.cpu_time, 3.0 * (16 * 0.05 + 0.01 * 120), 1e-12);
  EXPECT_NEAR(cost.step_cpu_time, 0.05 + 0.01 * 7.5, 1e-12);
}

} // namespace asperity::reports::summary_test
