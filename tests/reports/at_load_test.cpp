// Tests of reports/analysis/at_load.hpp: the value of a curve at a load is that
// of the formula from which it was made, and a missing value has a reason.
#include "reports/analysis/at_load.hpp"
#include "reports/analysis/verdict.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "synthetic.hpp"

namespace asperity::reports::at_load_test {

const std::string header = "quantity,value,unit,uncertainty,source\n";

// The "fem" is the theory with its area times 1.25, its fitted area times 1.5,
// and its gap shifted by 0.02 h_rms, times 0.8 and 1 in the two realisations.
class AtLoad : public ::testing::Test {
protected:
  AtLoad() {
    for (results::Curve& curve : result.methods[1].realizations)
      for (results::CurvePoint& point : curve.points)
        point[columns::area_fraction_fit] =
            1.5 * contact.area_fraction(point.nominal_pressure);
  }

  /// The numbers of one name, for each method.
  const Estimate& at(const std::string& name, std::size_t method) {
    result.reference = header + name + ",1,1,0,s\n";
    summary = summarize(result, rough);
    return summary.methods.at(method).quantities.at(name);
  }

  const cases::Case rough = synthetic::contact_case();
  const theory::PerssonContact contact = synthetic::contact_of(rough.surface);
  results::Result result = synthetic::rough_result(rough, 2);
  Summary summary;
};

// Between two rows the curve is that of the formula. Tolerance: 16 rows to 500
// are 0.41 apart in ln p; a monotone cubic with slopes by differences is of
// second order at least, 0.41^2/8 of the second derivative of ln A, which for
// erf is below 0.1 at these loads: 2e-3. The gap's second derivative is 0.2
// h_rms: 4e-3 h_rms.
TEST_F(AtLoad, IsTheValueOfTheFormula) {
  const double pressure = 0.0129 * synthetic::contact_modulus;
  const double height = *rough.surface.rms_height;
  const double area = contact.area_fraction(pressure);
  const double gap = contact.mean_gap(pressure) / height;

  EXPECT_NEAR(at("area_fraction@p=0.0129 E*", 0).value, area, 2e-3 * area);
  EXPECT_NEAR(at("area_fraction@p=25.8 MPa", 1).value, 1.25 * area,
              2.5e-3 * area);
  EXPECT_NEAR(at("area_fraction_fit@p=0.0129 E*", 1).value, 1.5 * area,
              3e-3 * area);
  EXPECT_NEAR(at("reduced_mean_gap@p=0.0129 E*", 0).value, gap, 4e-3);
  EXPECT_NEAR(at("reduced_mean_gap@p=0.0129 E*", 1).value, gap + 0.02 * 0.9,
              4e-3);
}

// An excess is a ratio of two curves at one pressure, so that the error of the
// interpolation cancels: both are the same function except for a factor.
// Tolerance: roundoff of exp and ln.
TEST_F(AtLoad, HasTheExcessTheMethodWasMadeWith) {
  EXPECT_NEAR(at("area_excess@p=0.003 E*", 1).value, 0.25, 1e-12);
  EXPECT_NEAR(at("area_excess_fit@p=0.003 E*", 1).value, 0.5, 1e-12);
  EXPECT_NEAR(summarize(result, rough)
                  .methods[1]
                  .quantities.at("area_excess_fit")
                  .value,
              0.5, 1e-12);
}

TEST_F(AtLoad, LeavesOutWhatAMethodDoesNotAnswer) {
  at("area_fraction_fit@p=0.003 E*", 1);
  EXPECT_FALSE(
      summary.methods[0].quantities.contains("area_fraction_fit@p=0.003 E*"));
  ASSERT_EQ(summary.published.size(), 1U);
  ASSERT_EQ(summary.published[0].ours.size(), 1U);
  EXPECT_EQ(summary.published[0].ours[0].method, "fem");

  result.methods.erase(result.methods.begin());
  result.reference = header + "area_excess@p=0.003 E*,1,1,0,s\n";
  EXPECT_TRUE(summarize(result, rough).published[0].ours.empty());
}

TEST_F(AtLoad, StatesWhyThereIsNoNumber) {
  const Estimate beyond = at("area_fraction@p=0.2 E*", 1);
  EXPECT_FALSE(beyond.has_value());
  EXPECT_EQ(beyond.remark,
            "no area_fraction at p/E* = 0.2, nor at two loads within a decade "
            "around it");
  EXPECT_EQ(at("area_fraction_moment@p=1 MPa", 1).remark,
            "no area_fraction_moment at p/E* = 0.0005, nor at two loads within "
            "a decade around it");
}

// An expectation at a load has a verdict like any other.
TEST_F(AtLoad, HasAVerdict) {
  cases::Case expecting = rough;
  expecting.expectations = {
      {"area_excess@p=0.003 E*", 0.2, 0.3, {"fem"}},
      {"area_excess@p=0.003 E*", 0.3, 0.4, {"fem"}},
      {"area_excess@p=0.9 E*", 0.3, 0.4, {"fem"}},
  };

  const Summary checked = summarize(result, expecting);

  ASSERT_EQ(checked.verdicts.size(), 3U);
  EXPECT_EQ(checked.verdicts[0].outcome, Outcome::ok);
  EXPECT_EQ(checked.verdicts[1].outcome, Outcome::failed);
  EXPECT_EQ(checked.verdicts[2].outcome, Outcome::missing);
}

} // namespace asperity::reports::at_load_test
