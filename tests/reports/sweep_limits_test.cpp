// Tests of reports/sweeps/sweep_limits.hpp on numbers that obey its formula.
#include "reports/sweeps/sweep_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::reports::sweep_limits_test {

SweepRecord record_of(const std::string& key) {
  SweepRecord record;
  record.keys = {{key, {"1", "2"}}};
  return record;
}

/// A point of "halfspace" with 8 realisations whose gamma_matched scatters by
/// +-0.01 about a value, alike at all points.
void add_point(SweptResults& results, const SpectrumPoint& spectrum,
               double value) {
  auto result = std::make_unique<SweptResult>();
  result->point = results.size();
  result->status = "complete";
  result->spectrum = spectrum;
  MethodSummary method;
  method.name = method.kind = "halfspace";
  for (int r = 0; r < 8; ++r) {
    RealizationFits fits;
    fits.matched.gamma.value = value + (r % 2 == 0 ? 0.01 : -0.01);
    method.fits.push_back(fits);
  }
  result->summary.methods = {method};
  results.push_back(std::move(result));
}

/// gamma = 0.3 + ratio/100 + 0.2 (lambda_0/L)^2 + 0.5 (h/lambda_1)^2.
double formula(double ratio, double size, double nodes) {
  return 0.3 + 0.01 * ratio + 0.2 / (size * size) + 0.5 / (nodes * nodes);
}

SweptResults sample() {
  SweptResults results;
  for (const auto& [ratio, size, nodes] :
       {std::array{4.0, 1.0, 4.0}, std::array{4.0, 2.0, 4.0},
        std::array{4.0, 4.0, 8.0}, std::array{8.0, 1.0, 3.0},
        std::array{8.0, 2.0, 4.0}, std::array{16.0, 1.0, 4.0}})
    add_point(results, {0.8, ratio, size, nodes, 10.0 * ratio + size},
              formula(ratio, size, nodes));
  return results;
}

// The least squares are exact for numbers that obey the formula. The scatter is
// that of a mean of 8 numbers +-0.01, whose Student interval is .0089.
TEST(SweepLimits, AreExactForNumbersThatObeyTheFormula) {
  const auto limits = sweep_limits(record_of("surface.points"), sample());

  ASSERT_EQ(limits.size(), 4U); // three ratios, and all
  for (std::size_t i = 0; i < 3; ++i) {
    const Estimate& gamma = limits[i].limits.at("gamma_matched");
    EXPECT_EQ(limits[i].ratio, 4.0 * std::pow(2.0, i));
    EXPECT_NEAR(gamma.value, 0.3 + 0.01 * limits[i].ratio, 1e-12);
    EXPECT_NEAR(gamma.half_width, 0.0089, 0.0012);
    EXPECT_EQ(limits[i].limits.count("kappa"), 0U);
  }
  EXPECT_EQ(limits[0].nayak, 44.0); // the largest surface
  EXPECT_EQ(limits[0].points, 3U);
  EXPECT_TRUE(std::isnan(limits[3].ratio));
  EXPECT_EQ(limits[3].points, 6U);
}

TEST(SweepLimits, NeedSurfacesOfOneSpectrumThatDiffer) {
  SweptResults results;
  add_point(results, {0.8, 4.0, 1.0, 4.0, 1.0}, 0.4);
  add_point(results, {0.8, 8.0, 1.0, 4.0, 1.0}, 0.5);

  EXPECT_TRUE(sweep_limits(record_of("surface.points"), results).empty());
}

TEST(SweepLimits, NeedASweepOfSpectrumAndGridAlone) {
  EXPECT_TRUE(sweep_limits(record_of("halfspace.thickness"), sample()).empty());
}

} // namespace asperity::reports::sweep_limits_test
