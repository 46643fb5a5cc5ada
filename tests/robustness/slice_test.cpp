// Verifies that all instances of a slice of the random problems converged and
// were verified, or were refused with a reason, and so do problems that once
// had another outcome: the folders of tests/robustness/problems.
#include "base/read_file.hpp"
#include "suite/robustness/run_instance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

namespace asperity::robustness::slice_test {

void expect_good(const InstanceReport& report, const Instance& instance) {
  EXPECT_TRUE(is_good(report.outcome))
      << name_of(report.outcome) << " " << report.check << ": " << report.reason
      << "\n"
      << text_of(instance);
}

TEST(Slice, HasNoOtherOutcome) {
  int verified = 0;
  int refused = 0;
  for (int index = 0; index < 48; ++index) {
    Instance instance = draw_instance(11, index);
    if (instance.label("family") == "full-block" ||
        instance.label("points") == "64")
      continue;
    instance.labels["path"] = "library"; // for those of the program see
                                         // suite/robustness/program_instance
    const InstanceReport report = run_instance(instance);
    expect_good(report, instance);
    verified += report.outcome == Outcome::verified;
    refused += report.outcome == Outcome::refused;
  }
  EXPECT_GT(verified, 20);
  EXPECT_GT(refused, 2);
}

// Small elastic blocks with every unknown, equal to the direct solver: the
// first one of each mesh and counter-body that no kept problem has.
TEST(Slice, SolvesFullBlocks) {
  int index = 0;
  for (const auto& [kind, element] :
       {std::pair{"layers", "Q1"}, {"gmsh", "Q2"}, {"cuboid", "Q1"}}) {
    Instance instance;
    for (bool is_found = false; !is_found; ++index) {
      instance = draw_instance(12, index);
      is_found = InstanceFilter(kind).takes(instance) &&
                 instance.label("family") == "full-block" &&
                 instance.label("material-law") != "plastic" &&
                 instance.label("element") == element &&
                 instance.label("points") == "8" &&
                 instance.label("shortest-wave") != "2" &&
                 instance.label("path") == "library";
    }
    const InstanceReport report = run_instance(instance);
    expect_good(report, instance);
    EXPECT_TRUE(report.has_pair || report.outcome == Outcome::refused);
  }
}

/// A problem that is kept as a case.
Instance kept(const std::string& name) {
  Instance instance;
  instance.file =
      (std::filesystem::path(ASPERITY_PROBLEMS) / name / "case.toml").string();
  instance.text = read_file(instance.file, 1U << 20U);
  const bool is_full =
      instance.text.find("solver = \"full\"") != std::string::npos;
  instance.method =
      instance.text.find("[fem]") != std::string::npos ? "fem" : "halfspace";
  instance.labels["metamorphic pair"] = is_full ? "direct-solver" : "threads";
  return instance;
}

class KeptProblem : public testing::TestWithParam<const char*> {};

TEST_P(KeptProblem, IsVerified) {
  const InstanceReport report = run_instance(kept(GetParam()));

  EXPECT_EQ(report.outcome, Outcome::verified)
      << report.check << ": " << report.reason;
  EXPECT_TRUE(report.has_pair);
  // Linear systems solved to 1e-3 took 129 Newton steps on the cylinder.
  const std::string name = GetParam();
  const int most = name == "soft-cylinder"   ? 80
                   : name == "stiff-coating" ? 100
                                             : 10000;
  EXPECT_LT(report.iterations, most);
}

std::string name_of_kept(const testing::TestParamInfo<const char*>& one) {
  std::string name = one.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Slice, KeptProblem,
    testing::Values("active-set-fails", "adaptive-small-gap-1",
                    "adaptive-small-gap-2", "adhesion-jump-from-afar",
                    "adhesion-small-gap", "ball-first-order",
                    "ball-second-order", "cycling-set", "direct-goes-on-1",
                    "direct-goes-on-2", "direct-goes-on-3", "direct-goes-on-4",
                    "first-load-too-large", "flat-cells", "gap-above-least",
                    "many-layers", "no-contact-2", "no-tension-hanging",
                    "soft-cylinder", "soft-working-penalty-1",
                    "soft-working-penalty-3", "stiff-coating"),
    name_of_kept);

// Some ten seconds each: in CI alone (robustness/slow_problems).
INSTANTIATE_TEST_SUITE_P(DISABLED_Slow, KeptProblem,
                         testing::Values("no-contact-1",
                                         "soft-working-penalty-2"),
                         name_of_kept);

// Full steps of Newton's method on a coating that yields leave for 2e4 times
// the load.
TEST(Slice, FindsTheContactOfAYieldingCoating) {
  Instance instance = kept("yielding-coating");
  instance.labels["metamorphic pair"] = "none"; // no direct solver flows
  const InstanceReport report = run_instance(instance);

  EXPECT_EQ(report.outcome, Outcome::verified)
      << report.check << ": " << report.reason;
  EXPECT_LT(report.iterations, 200);
}

// Problems without a solution, or whose forces cannot be represented, say so.
// Of the last one, a gap three times as large is found (gap-above-least).
TEST(Slice, SaysWhyThereIsNoSolution) {
  for (const auto& [name, words] :
       {std::pair{"refused-forces", "roundoff of the displacements"},
        {"refused-stationary", "its mean must be at least"},
        {"refused-gap-below-least", "must be at least "}}) {
    const InstanceReport report = run_instance(kept(name));

    EXPECT_EQ(report.outcome, Outcome::refused) << name;
    EXPECT_NE(report.reason.find(words), std::string::npos) << report.reason;
  }
}

} // namespace asperity::robustness::slice_test
