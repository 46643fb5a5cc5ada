// Tests of reports/analysis/two_surfaces.hpp: two surfaces without a mechanical
// method are those of one contact, whose roughness is their sum.
#include "reports/analysis/two_surfaces.hpp"
#include "reports/pages/report.hpp"
#include "surfaces/maps/shells.hpp"
#include "tests/reports/drawn.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synthetic.hpp"

namespace asperity::reports::two_surfaces_test {

class TwoSurfaces : public ::testing::Test {
protected:
  TwoSurfaces() {
    result.methods.pop_back(); // theory alone
    for (results::SurfaceRecord& surface : result.surfaces)
      measure(surface);
  }

  // Measures the spectrum as a run does.
  static void measure(results::SurfaceRecord& surface) {
    surface.spectrum.clear();
    for (const auto& shell :
         surfaces::spectral_shells({surface.grid, surface.heights}))
      surface.spectrum.push_back(
          {shell.wavevector, surfaces::shell_density(shell, surface.grid)});
  }

  double ratio(const results::SurfaceRecord& sum) const {
    return sum_spectrum_ratio(result, sum, rough.surface.wavevector_roll_off,
                              rough.surface.wavevector_high);
  }

  cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 2);
};

// Heights are added node by node; by Parseval the h_rms of the sum is that of
// its heights. Tolerance: roundoff.
TEST_F(TwoSurfaces, AreAddedNodeByNode) {
  const auto sum = sum_of_two_surfaces(result);

  ASSERT_TRUE(sum);
  double squares = 0.0;
  for (std::size_t i = 0; i < sum->heights.size(); ++i) {
    const double height =
        result.surfaces[0].heights[i] + result.surfaces[1].heights[i];
    ASSERT_EQ(sum->heights[i], height);
    squares += height * height;
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(sum->heights.size())) /
                  sum->rms_height,
              1.0, 1e-12);
}

// Independent surfaces have C_0 + C_1. Tolerance: a shell of n modes, n/2 of
// them independent, has the error of the mean of as many cosines of random
// angles, 1/sqrt(n), and as much again for Gaussian amplitudes; of some 70
// shells some 20 have 8 modes, which leaves 0.02 of the mean, three times that
// here.
TEST_F(TwoSurfaces, HaveTheSumOfTheirSpectra) {
  EXPECT_NEAR(ratio(*sum_of_two_surfaces(result)), 1.0, 0.06);
}

// A surface on itself has 4 C = 2 (C + C), on half of its negative C/4 = 0.2 (C
// + C/4). Tolerance: roundoff.
TEST_F(TwoSurfaces, AreDistinguishedFromMatchingSurfaces) {
  result.surfaces[1] = result.surfaces[0];
  EXPECT_NEAR(ratio(*sum_of_two_surfaces(result)), 2.0, 1e-12);

  for (double& height : result.surfaces[1].heights)
    height *= -0.5;
  measure(result.surfaces[1]);
  EXPECT_NEAR(ratio(*sum_of_two_surfaces(result)), 0.2, 1e-12);
}

TEST_F(TwoSurfaces, AreNoneWithAMechanicalMethod) {
  EXPECT_FALSE(sum_of_two_surfaces(synthetic::rough_result(rough, 2)));
  EXPECT_FALSE(sum_of_two_surfaces(synthetic::rough_result(rough, 3)));
  result.surfaces[1].heights.clear();
  EXPECT_FALSE(sum_of_two_surfaces(result));
}

// The report has the maps, the third distribution and the third spectrum, but
// not where there is one surface.
TEST_F(TwoSurfaces, AreDrawnWithTheirSum) {
  const ReportEntry pair = entry_of(result, rough);

  const std::vector<Figure> maps = drawn(figures::two_faces, pair);

  ASSERT_EQ(maps.size(), 1U);
  EXPECT_EQ(maps[0].maps.size(), 3U);
  for (const FigureGroup& group : figures_of(std::span(&pair, 1)))
    for (const Figure& figure : group.figures) {
      EXPECT_FALSE(figure.title.empty()) << figure.name;
      EXPECT_FALSE(figure.caption.empty()) << figure.name;
    }
  for (const char* curve : {"realisation 0", "realisation 1", "sum of both"})
    EXPECT_NE(drawn(figures::spectrum, pair).at(0).data.find(curve),
              std::string::npos);
  EXPECT_NE(drawn(figures::height_distribution, pair)
                .at(0)
                .caption.find("Sum of both: skewness"),
            std::string::npos);
  result.surfaces.pop_back();
  const ReportEntry one = entry_of(result, rough);
  EXPECT_TRUE(drawn(figures::two_faces, one).empty());
  EXPECT_EQ(drawn(figures::spectrum, one).at(0).data.find("sum of both"),
            std::string::npos);
}

} // namespace asperity::reports::two_surfaces_test
