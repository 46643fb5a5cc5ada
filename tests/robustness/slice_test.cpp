// Claim: a slice of the stability matrix has nothing but scenes that converged
// and were verified, and scenes that were refused with a reason. The whole is
// run by `asperity robustness`.
#include <gtest/gtest.h>

#include <algorithm>

#include "robustness/run_scene.hpp"

namespace asperity::robustness {
namespace {

TEST(Slice, HoldsNothingElse) {
  int verified = 0;
  int refused = 0;
  for (int index = 0; index < 160; ++index) {
    Scene scene = draw_scene(11, index);
    if (scene.family == Family::full_block)
      continue;
    scene.points = std::min(scene.points, 32);
    scene.path = Path::library; // the program's: robustness/program_scene
    const SceneReport report = run_scene(within_reach(scene));
    EXPECT_TRUE(is_good(report.outcome))
        << name_of(report.outcome) << " " << report.check << ": "
        << report.reason << "\n"
        << in_words(scene);
    EXPECT_FALSE(report.outcome == Outcome::refused && report.reason.empty());
    verified += report.outcome == Outcome::verified;
    refused += report.outcome == Outcome::refused;
  }
  EXPECT_GT(verified, 100);
  EXPECT_GT(refused, 10);
}

TEST(Slice, RefusesEveryFlaw) {
  for (int flaw = 1; flaw <= static_cast<int>(Flaw::infinite_modulus); ++flaw)
    for (const int index : {0, 1}) {
      Scene scene;
      scene.index = index;
      scene.family = Family::flawed;
      scene.flaw = static_cast<Flaw>(flaw);

      const SceneReport report = run_scene(scene);

      EXPECT_EQ(report.outcome, Outcome::refused)
          << name_of(scene.flaw) << ": " << report.reason;
    }
}

// Thin slabs with a free back, which both iterations leave unsolved: the
// solver's active set answers them.
TEST(Slice, HoldsPlates) {
  for (const int index : {519, 944, 1738}) {
    const SceneReport report = run_scene(draw_scene(1, index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << index << " " << report.check << ": " << report.reason;
  }
}

// Flat faces of second order held apart from a hard wall, which the solver
// once pressed with 1e13 Pa: its own rounding hid the error.
TEST(Slice, LeavesAFlatFaceApart) {
  for (const int index : {739, 928}) {
    const SceneReport report = run_scene(draw_scene(101, index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << index << " " << report.check << ": " << report.reason;
    EXPECT_EQ(report.area, 0.0) << index;
  }
}

// A flawed scene that nothing is wrong with is not refused, and that is seen.
TEST(Slice, SeesWhatWasNotRefused) {
  Scene scene;
  scene.family = Family::flawed;
  scene.flaw = Flaw::none;

  const SceneReport report = run_scene(scene);

  EXPECT_EQ(report.outcome, Outcome::check_failed);
  EXPECT_EQ(report.check, "refusal");
}

// Small blocks with every unknown: one of each order.
TEST(Slice, HoldsFullBlocks) {
  for (const int index : {0, 1}) {
    Scene scene;
    scene.index = index;
    scene.family = Family::full_block;
    scene.law = mechanics::ContactLaw::penalty;
    scene.penalty = 1e9;
    scene.load = 0.3;
    scene.thickness = 0.3;

    const SceneReport report = run_scene(within_reach(scene));

    EXPECT_EQ(report.outcome, Outcome::verified) << report.reason;
  }
}

} // namespace
} // namespace asperity::robustness
