// Claim: a run killed at any moment leaves a result file that opens and holds
// every step that was reported done before the kill.
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/results/sample_result.hpp"

namespace asperity::results {
namespace {

using ResultKill = ResultFolder;

const Grid grid{64, 64, 1e-6, 1e-6};

Fields sample_fields(int step) {
  Fields fields;
  fields.step = step;
  fields.pressure.assign(grid.size(), 1e6 + step);
  fields.gap.assign(grid.size(), 1e-9 * step);
  return fields;
}

/// Appends steps for ever, and writes each to `report` when it is done; every
/// fifth has its maps. Goes on from what the file holds.
[[noreturn]] void run_for_ever(const std::filesystem::path& folder,
                               int report) {
  ResultWriter writer(folder, sample_case(), ResultWriter::Mode::resume);
  writer.begin_method("fem", "fem", "");
  for (int step = 0;; ++step) {
    if (writer.has_step("fem", 0, step))
      continue;
    if (step % 5 == 0)
      writer.append_step_with_fields("fem", 0, sample_point(step), grid,
                                     sample_fields(step));
    else
      writer.append_step("fem", 0, sample_point(step));
    if (::write(report, &step, sizeof step) != sizeof step)
      ::_exit(1);
  }
}

/// Starts a run, kills it `delay` after its `n_steps`-th step is reported; the
/// last step it reported.
int last_step_of_killed_run(const std::filesystem::path& folder, int n_steps,
                            std::chrono::microseconds delay) {
  int ends[2];
  if (::pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    run_for_ever(folder, ends[1]);
  }
  ::close(ends[1]);
  int last = -1;
  int step = -1;
  const auto read_report = [&] {
    return ::read(ends[0], &step, sizeof step) == sizeof step;
  };
  for (int i = 0; i < n_steps && read_report(); ++i)
    last = step;
  std::this_thread::sleep_for(delay);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the run ended by itself";
  while (read_report())
    last = step;
  ::close(ends[0]);
  return last;
}

// Each run resumes what the one before left, so a file that a kill had spoilt
// would show in the next. A step may be in the file and not yet reported.
TEST_F(ResultKill, AtAnyMomentKeepsEveryStepThatWasDone) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> delay_us(0, 4'000); // one step: ~2 ms
  std::uniform_int_distribution<int> n_steps(1, 3);
  int last_reported = -1;
  int n_kills_in_a_step = 0;

  for (int run = 0; run < 30; ++run) {
    const int last = last_step_of_killed_run(
        folder_, n_steps(random), std::chrono::microseconds(delay_us(random)));
    EXPECT_GT(last, last_reported);
    n_kills_in_a_step += std::filesystem::exists(folder_ / ".result.h5.part");

    const Result result = read_result(folder_);
    EXPECT_EQ(result.case_text, sample_case().text);
    const Curve& curve = result.methods.at(0).realizations.at(0);
    const int n_points = static_cast<int>(curve.points.size());
    EXPECT_GE(n_points, last + 1);
    EXPECT_LE(n_points, last + 2);
    for (int step = 0; step < n_points; ++step)
      expect_same(curve.points[static_cast<std::size_t>(step)],
                  sample_point(step));
    EXPECT_EQ(static_cast<int>(curve.fields.size()), (n_points + 4) / 5);
    last_reported = n_points - 1;
  }

  EXPECT_GT(n_kills_in_a_step, 5) << "the kills did not hit a step";
}

} // namespace
} // namespace asperity::results
