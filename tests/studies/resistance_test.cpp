// The resistances of the contact are the inverse conductances, after these, and
// are said on the page.
#include "reports/pages/html_report.hpp"
#include "studies/conductance/conductance.hpp"
#include "studies/resistance/resistance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::studies::resistance_test {

cases::Case conducting() {
  cases::Case asked;
  ConductanceStudy study;
  study.thermal_conductivity = 100.0;
  study.counter_thermal_conductivity = 300.0; // mean 150
  asked.studies.ask(study);
  return asked;
}

TEST(Resistance, FollowsFromTheConductance) {
  results::CurvePoint row;
  row[columns::relative_conductance] = 20.0;

  rescale_studies(conducting(), row);

  EXPECT_DOUBLE_EQ(row[columns::thermal_conductance], 3000.0);
  EXPECT_DOUBLE_EQ(row[columns::thermal_resistance], 1.0 / 3000.0);
  EXPECT_TRUE(std::isnan(row[columns::electrical_resistance]));
}

TEST(Resistance, IsNaNWithoutContact) {
  results::CurvePoint row;
  row[columns::relative_conductance] = 0.0;

  rescale_studies(conducting(), row);

  EXPECT_EQ(row[columns::thermal_conductance], 0.0);
  EXPECT_TRUE(std::isnan(row[columns::thermal_resistance]));
}

TEST(Resistance, IsAnAnswerAtTheHeaviestLoad) {
  const cases::Case asked = conducting();
  results::Result result;
  results::Curve curve;
  for (const double load : {1e6, 3e6, 2e6}) {
    results::CurvePoint row;
    row.step = static_cast<int>(curve.points.size());
    row.nominal_pressure = load;
    row[columns::relative_conductance] = load / 1e4;
    rescale_studies(asked, row);
    curve.points.push_back(row);
  }
  result.methods = {{"halfspace", "halfspace", "", {curve}}};

  EXPECT_EQ(resistance_pages().answer({&result, &asked, {}}),
            "Thermal resistance 2.22e-05 m² K/W at 3 MPa.");
  for (const double factor : {2.0, 3.0}) {
    result.methods[0].realizations.push_back(curve);
    for (results::CurvePoint& row :
         result.methods[0].realizations.back().points)
      row[columns::thermal_resistance] *= factor;
  }
  EXPECT_EQ(resistance_pages().answer({&result, &asked, {}}),
            "Thermal resistance 4.44e-05 m² K/W at 3 MPa, median of 3 "
            "realisations.");
  result.methods.clear();
  EXPECT_EQ(resistance_pages().answer({&result, &asked, {}}), "");
}

} // namespace asperity::studies::resistance_test
