// A contact law that a test adds to the list is drawn by the random problems,
// solved and verified like the others.
#include "suite/robustness/run_instance.hpp"
#include "tests/contact/power_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity::robustness::toy_law_test {

/// The first small problems with the law, verified in the library.
std::vector<InstanceReport> reports(int count) {
  std::vector<InstanceReport> found;
  for (int index = 0; static_cast<int>(found.size()) < count && index < 20000;
       ++index) {
    Instance instance = draw_instance(5, index);
    if (instance.label("law") != "quartic" || instance.label("points") != "16")
      continue;
    EXPECT_NE(instance.text.find("contact = \"quartic\""), std::string::npos);
    instance.labels["path"] = "library";
    found.push_back(run_instance(instance));
  }
  return found;
}

TEST(ToyLaw, IsDrawnAndVerified) {
  const mechanics::RegisteredLaw law(tests::power_law<4>("quartic"));
  const std::vector<InstanceReport> found = reports(6);

  ASSERT_EQ(found.size(), 6U);
  for (const InstanceReport& report : found)
    EXPECT_TRUE(is_good(report.outcome))
        << name_of(report.outcome) << " " << report.check << ": "
        << report.reason;
  EXPECT_GE(
      std::ranges::count(found, Outcome::verified, &InstanceReport::outcome),
      4);
}

// The checks ask the law itself: pressures that are no derivative of its energy
// are found.
TEST(ToyLaw, IsRefutedIfItsPressureIsNotThatOfItsEnergy) {
  const mechanics::RegisteredLaw law(tests::power_law<4, 2>("quartic"));

  EXPECT_TRUE(std::ranges::any_of(reports(6), [](const InstanceReport& report) {
    return !is_good(report.outcome);
  }));
}

} // namespace asperity::robustness::toy_law_test
