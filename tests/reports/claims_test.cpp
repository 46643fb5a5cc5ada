// Tests of reports/analysis/claims.hpp and of the figure of heights with curves
// and surfaces whose results are known beforehand.
#include "reports/analysis/claims.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/pages/report.hpp"
#include "tests/reports/drawn.hpp"
#include "theory/exact/asperity_models.hpp"
#include "theory/persson/highest_peak.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "synthetic.hpp"

namespace asperity::reports::claims_test {

class Claims : public ::testing::Test {
protected:
  Estimate of(const std::string& method, const std::string& quantity) const {
    for (const MethodSummary& one : summarize(result, rough).methods)
      if (one.name == method)
        if (const auto found = one.quantities.find(quantity);
            found != one.quantities.end())
          return found->second;
    return {};
  }

  std::vector<results::CurvePoint>& fem_points() {
    return result.methods[1].realizations[0].points;
  }

  cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 1);
};

// (16) at 0.38, to the digits of an independent quadrature.
TEST_F(Claims, HaveTheTheorysEpsilon) {
  EXPECT_NEAR(of("theory", "epsilon").value, 5.496775152921, 1e-11);
  EXPECT_FALSE(of("fem", "epsilon").has_value());
}

// A curve whose pressure at equal gap is e^{1/4} times that of the theory, and
// departs from that linearly below 0.5 and above 1.5 h_rms, has that offset and
// departs where the deviation reaches 10 %. Tolerance: roundoff, since rows are
// at the gaps of the theory and linear between, as the deviation is.
TEST_F(Claims, FindTheDepartureFromTheory) {
  const double height =
      scales_of(result, rough, result.methods[1], 0).rms_height;
  const auto theory = result.methods[0].realizations[0].points;
  ASSERT_LT(theory.back().mean_gap, 0.2 * height);
  for (std::size_t i = 0; i < theory.size(); ++i) {
    const double gap = theory[i].mean_gap / height;
    const double ramp =
        0.4 * std::fmax(0.0, 0.5 - gap) - 0.2 * std::fmax(0.0, gap - 1.5);
    fem_points()[i].mean_gap = theory[i].mean_gap;
    fem_points()[i].nominal_pressure =
        theory[i].nominal_pressure * std::exp(0.25 + ramp);
  }

  EXPECT_NEAR(of("fem", "pressure_offset").value, 0.25, 1e-12);
  EXPECT_NEAR(of("fem", "departure_high").value, 2.0, 1e-12);
  EXPECT_NEAR(of("fem", "departure_low").value, 0.25, 1e-12);
}

// A curve that equals the theory except for a factor of the pressure has no
// departure within the load range, and the result says so. Tolerance: roundoff.
TEST_F(Claims, FindNoDepartureWhereThereIsNone) {
  for (results::CurvePoint& row : fem_points())
    row.mean_gap = CurveFunction(result.methods[0].realizations[0].points)
                       .gap(row.nominal_pressure);
  for (results::CurvePoint& row : fem_points())
    row.nominal_pressure *= 0.7;

  EXPECT_NEAR(of("fem", "pressure_offset").value, std::log(0.7), 1e-12);
  EXPECT_FALSE(of("fem", "departure_high").has_value());
  EXPECT_EQ(of("fem", "departure_low").remark,
            "no departure within the load range, or no agreement at u = h_rms");
}

// At the lightest load the shortfall is what was subtracted from the gap.
TEST_F(Claims, MeasureTheShortfallOfTheGap) {
  const double height =
      scales_of(result, rough, result.methods[1], 0).rms_height;
  fem_points()[0].mean_gap =
      result.methods[0].realizations[0].points[0].mean_gap - 0.3 * height;

  EXPECT_NEAR(of("fem", "gap_shortfall").value, 0.3, 1e-12);
}

// Exactly proportional rows have no deviation, and one that is 6 % too large
// among n has 0.06 (1 - 1/n)/(1 + 0.06/n). Tolerance: roundoff.
TEST_F(Claims, MeasureTheAreasLine) {
  int n = 0;
  for (results::CurvePoint& row : fem_points()) {
    row.area_fraction_corrected =
        3.0 * row.nominal_pressure / result.contact_modulus;
    n += row.area_fraction_corrected <= linear_area;
  }
  const double straight = of("fem", "area_linearity").value;
  fem_points()[0].area_fraction_corrected *= 1.06;

  EXPECT_NEAR(straight, 0.0, 1e-14);
  EXPECT_NEAR(of("fem", "area_linearity").value,
              0.06 * (1.0 - 1.0 / n) / (1.0 + 0.06 / n), 1e-14);
  EXPECT_EQ(of("fem", "area_at_highest_load").value,
            fem_points().back().area_fraction_corrected);
}

// The synthetic surface has exactly the spectrum of its formula, H = 0.95.
// Rings average over wavevectors of unequal length: 0.03.
TEST_F(Claims, MeasureTheSurface) {
  EXPECT_NEAR(of("fem", "fractal_dimension").value, 2.05, 0.03);
  EXPECT_NEAR(of("fem", "rms_height").value, 34e-9, 1e-22);
  EXPECT_EQ(of("fem", "highest_asperity").value,
            result.surfaces[0].highest / result.surfaces[0].rms_height);
  EXPECT_FALSE(of("theory", "rms_height").has_value());
}

// The theory of the formula has the gap of the asperity model at its lightest
// load: inserted into the model it gives that load. Tolerance: that of the
// root, 40 bits. It also has the expected height of the cell of the case.
TEST_F(Claims, HaveTheTailOfAnInfiniteSurface) {
  const theory::HeightSpectrum spectrum =
      synthetic::contact_of(rough.surface).spectrum();
  const auto& first = result.methods[0].realizations[0].points.front();

  const double gap = first.mean_gap - of("theory", "asperity_shortfall").value *
                                          spectrum.rms_height();

  EXPECT_NEAR(theory::bush_gibson_thomas(spectrum.profile_moments(),
                                         synthetic::contact_modulus, gap)
                      .nominal_pressure /
                  first.nominal_pressure,
              1.0, 1e-10);
  EXPECT_NEAR(of("theory", "highest_asperity").value,
              theory::expected_highest(spectrum.profile_moments(),
                                       synthetic::length * synthetic::length),
              1e-9);
}

TEST_F(Claims, AreExplained) {
  for (const char* name :
       {"epsilon", "departure_high", "gamma_slope", "area_fraction@p=1 MPa"})
    EXPECT_NE(meaning_of(name), "") << name;
  EXPECT_EQ(meaning_of("of_my_own"), "");
}

// The drawn density integrates to 1 over its bins, and its second moment is
// h_rms^2, to the printed digits and the bins' own width^2/12.
TEST_F(Claims, DrawADensityOfHeights) {
  const ReportEntry entry = entry_of(result, rough);

  const std::vector<Figure> found = drawn(figures::height_distribution, entry);

  ASSERT_EQ(found.size(), 1U);
  double total = 0.0;
  double second = 0.0;
  std::istringstream lines(found[0].data);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("realisation") == std::string::npos)
      continue;
    std::istringstream numbers(line.substr(line.find(',') + 1));
    double index = 0.0;
    double height = 0.0;
    double density = 0.0;
    char comma = ',';
    numbers >> index >> comma >> height >> comma >> density;
    total += 0.2 * density;
    second += 0.2 * density * height * height;
  }
  EXPECT_NEAR(total, 1.0, 1e-4);
  EXPECT_NEAR(second, 1.0 + 0.04 / 12.0, 0.01);
}

TEST_F(Claims, DrawNoHeightsThatAreNotThere) {
  result.surfaces[0].heights.clear();
  const ReportEntry entry = entry_of(result, rough);

  EXPECT_TRUE(drawn(figures::height_distribution, entry).empty());
}

} // namespace asperity::reports::claims_test
