// Verifies that the page shows stiffness and centre of pressure of the steps
// that have them, and no such table otherwise.
#include <gtest/gtest.h>

#include <string>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::stiffness_rows_test {

using StiffnessRows = ReportFolder;

TEST_F(StiffnessRows, AreOnThePageOfStiffContacts) {
  results::Result result = synthetic::rough_result(rough, 1);
  results::CurvePoint& point =
      result.methods[1].realizations.front().points.front();
  point.normal_stiffness = 2e5;
  point.tangential_stiffness = 1.5e5;
  point.pressure_centre_x = 3e-8;
  point.pressure_centre_y = 1e-22;
  write(result);

  const std::string html = text_of(folder / "report.html");

  ASSERT_NE(html.find("Stiffness and centre of the contact"),
            std::string::npos);
  EXPECT_NE(html.find(">2e+05</td><td class=\"number\">1.5e+05</td>"
                      "<td class=\"number\">0.75</td>"
                      "<td class=\"number\">0.03</td>"
                      "<td class=\"number\">0</td>"),
            std::string::npos);
}

TEST_F(StiffnessRows, AreAbsentWithoutAStiffness) {
  results::Result result = synthetic::rough_result(rough, 1);
  for (results::MethodRecord& method : result.methods)
    for (results::CurvePoint& point : method.realizations.front().points)
      point.pressure_centre_x = point.pressure_centre_y = 0.0;
  // A surface method has the stiffness of a standing contact, of no block.
  result.methods[1].realizations.front().points.front().normal_stiffness = 2e5;
  write(result);

  EXPECT_EQ(text_of(folder / "report.html")
                .find("Stiffness and centre of the contact"),
            std::string::npos);
}

} // namespace asperity::reports::stiffness_rows_test
