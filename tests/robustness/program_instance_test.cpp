// Tests of suite/robustness/program_instance.cpp: an instance runs through the
// program itself, and errors of the program are detected.
#include "suite/robustness/flaws.hpp"
#include "suite/robustness/run_instance.hpp"

#include <gtest/gtest.h>

namespace asperity::robustness::program_instance_test {

const std::filesystem::path program = ASPERITY_PROGRAM;

/// The first problem of a seed with these labels whose heights a map may have,
/// on a path.
Instance drawn(const std::string& filter, const std::string& path) {
  for (int index = 0;; ++index) {
    Instance instance = draw_instance(5, index);
    if (instance.label("points") != "16" ||
        instance.label("shortest-wave") == "2" ||
        instance.label("length") == "1e-12..1e-09" ||
        !InstanceFilter(filter).takes(instance))
      continue;
    instance.labels["path"] = path;
    // The second run of a pair is not what the program is compared with.
    instance.labels["metamorphic pair"] =
        instance.label("family") == "full-block" ? "none" : "decimal-units";
    instance.threads = 2;
    return instance;
  }
}

TEST(ProgramInstance, AgreesWithTheLibrary) {
  for (const char* const filter :
       {"edges=free", "slab", "condensed-q2", "study=flow"}) {
    const Instance instance = drawn(filter, "program");
    const InstanceReport report = run_instance(instance, program);

    EXPECT_EQ(report.outcome, Outcome::verified)
        << report.check << ": " << report.reason << "\n"
        << text_of(instance);
  }
}

TEST(ProgramInstance, HasAReport) {
  const InstanceReport report =
      run_instance(drawn("halfspace", "report"), program);

  EXPECT_EQ(report.outcome, Outcome::verified) << report.reason;
}

TEST(ProgramInstance, RunsOnTwoRanks) {
  const InstanceReport report =
      run_instance(drawn("full-block", "two-ranks"), program);

  EXPECT_EQ(report.outcome, Outcome::verified) << report.reason;
}

/// A problem with this flaw.
Instance flawed(const std::string& flaw, const std::string& path) {
  for (int index = 0;; ++index)
    if (Instance instance = draw_instance(6, index);
        instance.label("flaw") == flaw) {
      instance.labels["path"] = path;
      return instance;
    }
}

void expect_refused(const std::string& flaw, const std::string& path) {
  const InstanceReport report = run_instance(flawed(flaw, path), program);

  EXPECT_EQ(report.outcome, Outcome::refused)
      << flaw << " by " << path << ": " << report.check << " " << report.reason;
  EXPECT_FALSE(report.reason.empty());
}

// The program has the sentences of the library: one from the reader of cases,
// one of a map, one of a method.
TEST(ProgramInstance, IsRefusedWithEveryFlaw) {
  for (const std::string& flaw : flaw_names())
    expect_refused(flaw, "library");
  for (const char* const flaw : {"nan-length", "nan-in-map", "sliver"})
    expect_refused(flaw, "program");
}

// A flaw that is in fact valid is not refused, which must be detected, as must
// a program that fails and one that leaves no result.
TEST(ProgramInstance, FailsByName) {
  for (const char* const path : {"library", "program"}) {
    Instance valid = drawn("slab", path);
    valid.labels["flaw"] = "none";
    EXPECT_EQ(run_instance(valid, program).check, "refusal") << path;
  }
  const Instance instance = drawn("slab", "program");
  EXPECT_EQ(run_instance(instance, "/bin/false").check, "program");
  EXPECT_FALSE(is_good(run_instance(instance, "/bin/true").outcome));
}

} // namespace asperity::robustness::program_instance_test
