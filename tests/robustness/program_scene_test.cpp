// Claims about robustness/program_scene.cpp and robustness/written_case.hpp: a
// scene goes through the program itself, and what the program gets wrong is
// seen.
#include <gtest/gtest.h>

#include "robustness/kinds.hpp"
#include "robustness/run_scene.hpp"

namespace asperity::robustness {
namespace {

const std::filesystem::path program = ASPERITY_PROGRAM;

Scene scene_of(Family family, Path path) {
  Scene scene;
  scene.family = family;
  scene.path = path;
  scene.law = mechanics::ContactLaw::penalty;
  scene.penalty = 1e3;
  scene.load = 0.1;
  scene.points = 16;
  scene.threads = 2;
  return within_reach(scene);
}

TEST(ProgramScene, AgreesWithTheLibrary) {
  for (const Family family : {Family::halfspace, Family::slab,
                              Family::condensed_q1, Family::condensed_q2}) {
    const SceneReport report =
        run_scene(scene_of(family, Path::program), program);

    EXPECT_EQ(report.outcome, Outcome::verified)
        << name_of(family) << " " << report.check << ": " << report.reason;
  }
}

TEST(ProgramScene, HasAReport) {
  const SceneReport report =
      run_scene(scene_of(Family::halfspace, Path::report), program);

  EXPECT_EQ(report.outcome, Outcome::verified) << report.reason;
}

TEST(ProgramScene, RunsOnTwoRanks) {
  const SceneReport report =
      run_scene(scene_of(Family::full_block, Path::two_ranks), program);

  EXPECT_EQ(report.outcome, Outcome::verified) << report.reason;
}

TEST(ProgramScene, IsRefusedWithEveryFlaw) {
  for (int flaw = 1; flaw <= static_cast<int>(Flaw::infinite_modulus); ++flaw) {
    Scene scene = scene_of(Family::flawed, Path::program);
    scene.flaw = static_cast<Flaw>(flaw);

    const SceneReport report = run_scene(scene, program);

    EXPECT_EQ(report.outcome, Outcome::refused)
        << name_of(scene.flaw) << ": " << report.reason;
  }
}

// A gap that is off by ten tolerances, a program that fails and one that
// leaves no result behind.
TEST(ProgramScene, FailsByName) {
  const Scene scene = scene_of(Family::halfspace, Path::program);
  SceneReport library = run_scene(scene_of(Family::halfspace, Path::library));
  library.reduced_gap += 10.0 * library.reduced_tolerance;

  run_program(scene, program, library);

  EXPECT_EQ(library.outcome, Outcome::check_failed);
  EXPECT_EQ(library.check, "program");
  EXPECT_EQ(run_scene(scene, "/bin/false").check, "program");
  EXPECT_FALSE(is_good(run_scene(scene, "/bin/true").outcome));
}

TEST(ProgramScene, IsNotRefusedWithoutAFlaw) {
  const SceneReport report =
      run_scene(scene_of(Family::flawed, Path::program), program);

  EXPECT_EQ(report.check, "refusal") << report.reason;
}

} // namespace
} // namespace asperity::robustness
