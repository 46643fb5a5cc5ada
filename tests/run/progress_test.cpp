// Tests of the remaining time of a run against values that are computed here,
// and of messages during long steps.
#include "base/shown_number.hpp"
#include "base/special_numbers.hpp"
#include "run/method_job.hpp"
#include "run/progress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>

namespace asperity::run::progress_test {

// Two short steps and two long ones.
RemainingWork mixed_work() {
  return RemainingWork({{"cheap", 2}, {"dear", 2}});
}

// Steps of 1 s and 10 s of CPU time on two threads: a step counts as the mean
// of its method, or of the dearest one where none of its own is done.
TEST(RemainingWork, FollowsTheStepsThatAreDone) {
  RemainingWork work = mixed_work();
  EXPECT_FALSE(work.seconds_left(4.0, 4.0));
  work.add_done("cheap", 1.0);
  EXPECT_DOUBLE_EQ(work.seconds_left(0.5, 0.0).value(), 1.5);
  work.add_done("cheap", 1.0);
  work.add_done("dear", 10.0);

  EXPECT_DOUBLE_EQ(work.seconds_left(6.0, 0.0).value(), 5.0);
  EXPECT_DOUBLE_EQ(work.seconds_left(9.0, 3.0).value(), 2.0);
  EXPECT_FALSE(work.seconds_left(12.0, 6.0)) << "longer than the other";
  work.add_done("dear", 10.0);
  EXPECT_EQ(work.seconds_left(12.0, 0.0), 0.0);
  EXPECT_EQ(work.steps_done(), 4);
}

TEST(RemainingWork, LeavesOutWhatTheCacheHas) {
  RemainingWork work = mixed_work();
  work.add_kept("dear", 2);
  work.add_done("cheap", 1.0);

  EXPECT_DOUBLE_EQ(work.seconds_left(2.0, 0.0).value(), 2.0);
  EXPECT_EQ(work.steps_done(), 3);
}

// A step whose residual has fallen by a quarter of the orders of magnitude
// takes three times as long again, as do those after it while none is done.
TEST(RemainingWork, FollowsTheResidualOfAStepAtWork) {
  RemainingWork work = mixed_work();
  const StepAtWork step{"dear", 20.0, share_done(1e-2, 1e-8)};

  EXPECT_DOUBLE_EQ(step.share, 0.25);
  EXPECT_DOUBLE_EQ(work.seconds_left(20.0, 20.0, step).value(),
                   60.0 + 3.0 * 80.0);
  work.add_done("cheap", 1.0);
  work.add_done("cheap", 1.0);
  work.add_done("dear", 10.0);
  EXPECT_DOUBLE_EQ(work.seconds_left(26.0, 20.0, step).value(), 60.0);
  EXPECT_DOUBLE_EQ(work.seconds_left(6.1, 0.1, {"dear", 0.1, 0.25}).value(),
                   4.9)
      << "the other step was longer";
  EXPECT_EQ(share_done(NAN, 1e-8), 0.0);
  EXPECT_EQ(share_done(3.0, 1e-8), 0.0);
  EXPECT_EQ(share_done(1e-9, 1e-8), 1.0);
}

TEST(RemainingWork, HasReadableUnits) {
  EXPECT_EQ(remaining_text(8.2), "about 8.2 s left");
  EXPECT_EQ(remaining_text(240.0), "about 4 min left");
  EXPECT_EQ(remaining_text(9000.0), "about 2.5 h left");
  EXPECT_EQ(remaining_text(std::nullopt), "time left unknown");
}

// A line on a terminal never reaches the last column, because it could not be
// overwritten then.
TEST(Progress, DrawsLinesShorterThanTheTerminal) {
  const std::string words = "about 5 s left  halfspace r0 step 5";

  EXPECT_EQ(bar_line(28, 48, words, 80), "[#######.....] 28/48  " + words);
  EXPECT_EQ(bar_line(24, 48, words, 200),
            "[############............] 24/48  " + words);
  for (const int columns : {1, 2, 20, 40, 80})
    EXPECT_LT(bar_line(0, 0, words + words + words, columns).size(),
              static_cast<std::size_t>(columns))
        << columns;
}

// In full contact the mean gap is roundoff of either sign.
TEST(Progress, ShowsNoNegativeZero) {
  testing::internal::CaptureStdout();
  {
    Progress progress(mixed_work(), 1.0);
    results::CurvePoint point;
    point.nominal_pressure = 1.0;
    point.mean_gap = -1e-9;
    progress.step_done("dear", 0, point, 1.0);
  }
  const std::string printed = testing::internal::GetCapturedStdout();

  EXPECT_NE(printed.find("u = +0.0000 h_rms"), std::string::npos) << printed;
}

TEST(ShownNumber, HasTheSignOfWhatIsPrinted) {
  EXPECT_EQ(fmt::format("{:+.2f}|{:.0f}|{:g}", Shown{-0.001}, Shown{-0.4},
                        Shown{-0.0}),
            "+0.00|0|0");
  EXPECT_EQ(fmt::format("{:+9.2f}|{:.1e}|{}", Shown{-0.006}, Shown{-2e-9},
                        Shown{-1.5}),
            "    -0.01|-2.0e-09|-1.5");
  EXPECT_EQ(fmt::format("{:.1e}|{:.2f}", Shown{-0.0}, Shown{-infinity}),
            "0.0e+00|-inf");
}

// A long step is mentioned in a pipe. The test waits for the line as long as
// necessary.
TEST(Progress, MentionsALongStepInAPipe) {
  testing::internal::CaptureStdout();
  std::string printed;
  {
    Progress progress(mixed_work(), 1.0, std::chrono::milliseconds(1));
    const Progress::Activity activity(progress, "dear, realization 0, step 1");
    for (int tries = 0; printed.empty() && tries < 10000; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      printed = testing::internal::GetCapturedStdout();
      testing::internal::CaptureStdout();
    }
  }
  testing::internal::GetCapturedStdout();

  EXPECT_EQ(printed.find("  dear, realization 0, step 1: at work for "), 0U)
      << printed;
  EXPECT_NE(printed.find("; 0 of 4 steps done\n"), std::string::npos)
      << printed;
}

// So is the state of the solver in this step.
TEST(Progress, MentionsTheStateOfTheSolverInAPipe) {
  testing::internal::CaptureStdout();
  std::string printed;
  {
    Progress progress(mixed_work(), 1.0, std::chrono::milliseconds(50));
    progress.at_work("dear", 0, "lost: nothing is at work");
    const Progress::Activity other(progress, "dear, realization 1, step 0");
    const Progress::Activity activity(progress,
                                      Progress::job_text("dear", 0) + "step 1");
    progress.at_work("dear", 1, "Newton step 7");
    for (int tries = 0; printed.empty() && tries < 10000; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      printed = testing::internal::GetCapturedStdout();
      testing::internal::CaptureStdout();
    }
  }
  testing::internal::GetCapturedStdout();

  EXPECT_EQ(printed.find("  dear, realization 1, step 0: at work for "), 0U)
      << printed;
  EXPECT_NE(printed.find("; Newton step 7; "), std::string::npos) << printed;
  EXPECT_EQ(printed.find("lost"), std::string::npos) << printed;
}

// The words on a full block; the residual of no step is not known.
TEST(Progress, DescribesAFullBlock) {
  EXPECT_EQ(progress_text({.unknowns = 81, .linear_iterations = 2}),
            "Newton step 0, 2 CG iterations, 81 unknowns");
  EXPECT_EQ(progress_text({1, 375, 4, 56, 1.2e-3, 7}),
            "Newton step 4, residual 1.2e-03, 7 points changed, 56 CG "
            "iterations, mesh pass 2, 375 unknowns");
}

TEST(Progress, IsSilentWithoutWork) {
  testing::internal::CaptureStdout();
  {
    Progress progress(mixed_work(), 1.0, std::chrono::milliseconds(1));
    { const Progress::Activity ended(progress, "ended"); }
    testing::internal::GetCapturedStdout();
    testing::internal::CaptureStdout();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

} // namespace asperity::run::progress_test
