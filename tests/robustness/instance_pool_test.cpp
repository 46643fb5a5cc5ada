// Tests of suite/robustness/instance_pool.hpp and of the line with which a
// report is sent: every instance is reported once, whatever happens to the
// processes.
#include "suite/robustness/instance_pool.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <stdexcept>

namespace asperity::robustness::instance_pool_test {

Instance numbered(int index) {
  Instance instance;
  instance.index = index;
  return instance;
}

std::map<int, InstanceReport> run(int count, const PoolSettings& settings,
                                  const RunOne& run_one) {
  std::map<int, InstanceReport> reports;
  InstanceSequence instances(numbered, InstanceFilter(), 0,
                             static_cast<std::size_t>(count));
  run_instances(
      instances, settings,
      [&](const Instance& instance, const InstanceReport& report) {
        EXPECT_EQ(instance.index, report.index);
        EXPECT_TRUE(reports.emplace(report.index, report).second);
      },
      run_one);
  return reports;
}

InstanceReport verified(const Instance& instance) {
  InstanceReport report;
  report.index = instance.index;
  report.iterations = 10 * instance.index;
  return report;
}

TEST(InstancePool, ReportsEveryInstanceOnceFromAnyNumberOfProcesses) {
  for (const int processes : {1, 3, 50}) {
    const auto reports = run(20, {processes, 60.0}, verified);

    ASSERT_EQ(reports.size(), 20u);
    for (const auto& [index, report] : reports)
      EXPECT_EQ(report.iterations, 10 * index);
  }
  EXPECT_TRUE(run(0, {2, 60.0}, verified).empty());
}

TEST(InstancePool, SurvivesCrashes) {
  const auto reports = run(12, {2, 60.0}, [](const Instance& instance) {
    if (instance.index == 0 || instance.index == 7)
      std::abort();
    if (instance.index == 11)
      std::_Exit(5);
    return verified(instance);
  });

  ASSERT_EQ(reports.size(), 12u);
  for (const auto& [index, report] : reports) {
    const bool is_killed = index == 0 || index == 7 || index == 11;
    EXPECT_EQ(report.outcome == Outcome::crashed, is_killed) << index;
  }
  EXPECT_EQ(reports.at(7).reason, "signal 6 (Aborted)");
  EXPECT_EQ(reports.at(11).reason, "exit code 5");
}

TEST(InstancePool, StopsAnEndlessInstance) {
  const auto reports = run(6, {2, 0.2}, [](const Instance& instance) {
    for (volatile bool is_running = instance.index == 3; is_running;) {
    }
    return verified(instance);
  });

  ASSERT_EQ(reports.size(), 6u);
  EXPECT_EQ(reports.at(3).outcome, Outcome::timed_out);
  EXPECT_EQ(reports.at(5).outcome, Outcome::verified);
}

// Problems run while later ones have not been drawn.
TEST(InstancePool, DrawsAnInstanceWhenItIsRun) {
  int drawn = 0;
  InstanceSequence instances(
      [&](int index) {
        ++drawn;
        return numbered(index);
      },
      InstanceFilter(), 0, 1000);
  int drawn_at_first = 0;
  run_instances(
      instances, {2, 60.0},
      [&](const Instance&, const InstanceReport&) {
        if (drawn_at_first == 0)
          drawn_at_first = drawn;
      },
      verified);

  EXPECT_EQ(drawn_at_first, 2); // one for each process
  EXPECT_EQ(drawn, 1000);
}

// The same problems in the same order as if all had been drawn before.
TEST(InstanceSequence, HasTheInstancesThatMatch) {
  InstanceSequence coarse(
      [](int index) {
        Instance instance = numbered(index);
        instance.labels["points"] = index % 3 == 0 ? "8" : "16";
        return instance;
      },
      InstanceFilter("points=8"), 1, 3);

  EXPECT_EQ(coarse.at(1)->index, 6);
  EXPECT_EQ(coarse.at(0)->index, 3);
  EXPECT_EQ(coarse.at(2)->index, 9);
  EXPECT_EQ(coarse.at(3), nullptr);

  InstanceSequence none(numbered, InstanceFilter("points=8"), 0, 3);
  EXPECT_EQ(none.at(0), nullptr);
}

TEST(InstancePool, RefusesAnInvalidTimeLimit) {
  EXPECT_THROW(run(1, {1, 0.0}, verified), std::domain_error);
}

TEST(InstanceReport, IsReadBackUnchanged) {
  InstanceReport report;
  report.index = 12;
  report.outcome = Outcome::check_failed;
  report.check = "energy";
  report.reason = "\"quoted\", 3 < 4\nand a second line";
  report.iterations = 7;
  report.area = 0.1;
  report.reduced_gap = -1.0 / 3.0;
  report.has_pair = true;
  report.pair_difference = 1e-17;

  const std::string line = to_line(report);
  const InstanceReport read = from_line(line);

  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(to_line(read), line);
  EXPECT_EQ(read.reason, report.reason);
  EXPECT_EQ(read.reduced_gap, report.reduced_gap);
  EXPECT_FALSE(is_good(read.outcome));

  report.area = std::nan("");
  EXPECT_EQ(from_line(to_line(report)).area, 0.0);
}

} // namespace asperity::robustness::instance_pool_test
