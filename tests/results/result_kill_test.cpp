// Verifies that a run that is killed at any moment leaves a result file that
// opens and contains every step that was reported as done before.
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <poll.h>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/results/sample_result.hpp"

namespace asperity::results::result_kill_test {

using ResultKill = ResultFolder;

const Grid grid{64, 64, 1e-6, 1e-6};

Fields sample_fields(int step) {
  Fields fields;
  fields.step = step;
  fields.nominal_pressure = sample_point(step).nominal_pressure;
  fields.pressure.assign(grid.size(), 1e6 + step);
  fields.gap.assign(grid.size(), 1e-9 * step);
  return fields;
}

/// Appends steps without end and writes each to `report` when it is done; every
/// fifth has maps. Continues from the content of the file.
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

/// Until the run copies its file, or reports a step.
void wait_for_copy(const std::filesystem::path& folder, int report) {
  pollfd watched{report, POLLIN, 0};
  while (!std::filesystem::exists(folder / ".result.h5.part") &&
         ::poll(&watched, 1, 0) == 0) {
  }
}

/// Starts a run and kills it `delay` after its `n_steps`-th step is reported; 0
/// is the copy with which it begins, and has no delay.
///
/// @return  the last step it reported, -1 if there was none
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
  if (n_steps == 0)
    wait_for_copy(folder, ends[0]);
  else
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

// Each run resumes what the one before left, so that a file that was damaged
// would fail the next. A step may be in the file and not yet reported. A third
// of the kills are made while the journal is merged into the file.
TEST_F(ResultKill, AtAnyMomentLosesNoFinishedStep) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> delay_us(0, 3'000);
  { const ResultWriter first(folder_, sample_case()); }
  int n_before = 0;
  int n_kills_in_a_copy = 0;

  for (int run = 0; run < 60; ++run) {
    const int last = last_step_of_killed_run(
        folder_, run % 3, std::chrono::microseconds(delay_us(random)));
    n_kills_in_a_copy += std::filesystem::exists(folder_ / ".result.h5.part");

    const Result result = read_result(folder_);
    EXPECT_EQ(result.case_text, sample_case().text);
    if (result.methods.empty() || result.methods[0].realizations.empty())
      continue; // killed before the first step
    const Curve& curve = result.methods[0].realizations[0];
    const int n_points = static_cast<int>(curve.points.size());
    EXPECT_GE(n_points, std::max(n_before, last + 1));
    EXPECT_LE(n_points, std::max(n_before, last + 1) + 1);
    for (int step = 0; step < n_points; ++step)
      expect_same(curve.points[static_cast<std::size_t>(step)],
                  sample_point(step));
    EXPECT_EQ(static_cast<int>(curve.fields.size()), (n_points + 4) / 5);
    n_before = n_points;
  }

  EXPECT_GT(n_before, 50) << "the kills came before the steps";
  EXPECT_GT(n_kills_in_a_copy, 0) << "no kill hit a copy of the file";
}

} // namespace asperity::results::result_kill_test
