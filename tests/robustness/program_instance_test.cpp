// Tests of robustness/program_instance.cpp and robustness/written_case.hpp: an
// instance runs through the program itself, and errors of the program are
// detected.
#include "robustness/kinds.hpp"
#include "robustness/run_instance.hpp"

#include <gtest/gtest.h>

namespace asperity::robustness::program_instance_test {

const std::filesystem::path program = ASPERITY_PROGRAM;

Instance instance_of(Family family, Path path) {
  Instance instance;
  instance.family = family;
  instance.path = path;
  instance.law = mechanics::ContactLaw::penalty;
  instance.penalty = 1e3;
  instance.load = 0.1;
  instance.points = 16;
  instance.threads = 2;
  return within_reach(instance);
}

TEST(ProgramInstance, AgreesWithTheLibrary) {
  for (const Family family : {Family::halfspace, Family::slab,
                              Family::condensed_q1, Family::condensed_q2}) {
    const InstanceReport report =
        run_instance(instance_of(family, Path::program), program);

    EXPECT_EQ(report.outcome, Outcome::verified)
        << name_of(family) << " " << report.check << ": " << report.reason;
  }
}

TEST(ProgramInstance, HasAReport) {
  const InstanceReport report =
      run_instance(instance_of(Family::halfspace, Path::report), program);

  EXPECT_EQ(report.outcome, Outcome::verified) << report.reason;
}

TEST(ProgramInstance, RunsOnTwoRanks) {
  const InstanceReport report =
      run_instance(instance_of(Family::full_block, Path::two_ranks), program);

  EXPECT_EQ(report.outcome, Outcome::verified) << report.reason;
}

TEST(ProgramInstance, IsRefusedWithEveryFlaw) {
  for (int flaw = 1; flaw <= static_cast<int>(Flaw::infinite_modulus); ++flaw) {
    Instance instance = instance_of(Family::flawed, Path::program);
    instance.flaw = static_cast<Flaw>(flaw);

    const InstanceReport report = run_instance(instance, program);

    EXPECT_EQ(report.outcome, Outcome::refused)
        << name_of(instance.flaw) << ": " << report.reason;
  }
}

// A gap that is wrong by ten tolerances, a program that fails and one that
// leaves no result.
TEST(ProgramInstance, FailsByName) {
  const Instance instance = instance_of(Family::halfspace, Path::program);
  InstanceReport library =
      run_instance(instance_of(Family::halfspace, Path::library));
  library.reduced_gap += 10.0 * library.reduced_tolerance;

  run_program(instance, program, library);

  EXPECT_EQ(library.outcome, Outcome::check_failed);
  EXPECT_EQ(library.check, "program");
  EXPECT_EQ(run_instance(instance, "/bin/false").check, "program");
  EXPECT_FALSE(is_good(run_instance(instance, "/bin/true").outcome));
}

TEST(ProgramInstance, IsNotRefusedWithoutAFlaw) {
  const InstanceReport report =
      run_instance(instance_of(Family::flawed, Path::program), program);

  EXPECT_EQ(report.check, "refusal") << report.reason;
}

} // namespace asperity::robustness::program_instance_test
