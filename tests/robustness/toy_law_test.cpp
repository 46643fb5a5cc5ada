// A contact law that a test adds to the list is drawn by the random problems,
// solved and verified like the others.
#include "mechanics/contact_law.hpp"
#include "suite/robustness/run_instance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace asperity::robustness::toy_law_test {

using mechanics::ContactInterface;

/// 1 - g/rho where g < rho
double depth(const ContactInterface& own, double gap) {
  return std::max(0.0, 1.0 - gap / own.adhesion_range);
}

/// A hard wall with W = -w (1 - g/rho)^4 up to the gap rho.
/// @param share  of the pressure -W' that the law states; 1 is right
template <int share>
mechanics::ContactLawTraits quartic() {
  mechanics::ContactLawTraits law;
  law.name = "quartic";
  law.words = "a hard wall with quartic adhesion";
  law.has_wall = true;
  law.surface_solver = mechanics::SurfaceSolver::adhesive;
  law.energy = [](const ContactInterface& own, double gap) {
    const double x = depth(own, gap);
    return -own.work_of_adhesion * x * x * x * x;
  };
  law.pressure = [](const ContactInterface& own, double gap) {
    const double x = depth(own, gap);
    return -4.0 * share * own.work_of_adhesion / own.adhesion_range * x * x * x;
  };
  law.stiffness = [](const ContactInterface& own, double gap) {
    const double x = depth(own, gap);
    return -12.0 * share * own.work_of_adhesion /
           (own.adhesion_range * own.adhesion_range) * x * x;
  };
  law.pressure_bounds = [](const ContactInterface& own) {
    return mechanics::PressureBounds{own.pressure(0.0),
                                     std::numeric_limits<double>::infinity()};
  };
  law.range = [](const ContactInterface& own) { return own.adhesion_range; };
  law.least_gap =
      law.strongest_gap = [](const ContactInterface&) { return 0.0; };
  return law;
}

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
  const mechanics::RegisteredLaw law(quartic<1>());
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
  const mechanics::RegisteredLaw law(quartic<2>());

  EXPECT_TRUE(std::ranges::any_of(reports(6), [](const InstanceReport& report) {
    return !is_good(report.outcome);
  }));
}

} // namespace asperity::robustness::toy_law_test
