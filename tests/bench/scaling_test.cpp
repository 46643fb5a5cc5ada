// Tests of bench/settings/scaling_settings.hpp and bench/analysis/scaling.hpp:
// the runs on several threads and ranks, and what follows from their times.
#include "bench/analysis/scaling.hpp"
#include "bench/settings/scaling_settings.hpp"
#include "cases/reader/read_case.hpp"
#include "input/input_error.hpp"
#include "tests/bench/rough_case.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

namespace asperity::bench::scaling_test {

const std::string methods = "[theory]\ngamma = 0.4\n[halfspace]\n";

BenchPlan scaling(const std::string& text, const ScalingOptions& options) {
  return scaling_of(cases::read_case_text(text, "case.toml"), options);
}

/// Each setting of a series as "256 1 1 1": points, threads, ranks and nodes
/// per node of the case's surface.
std::vector<std::string> runs_of(const BenchPlan& plan,
                                 const ScalingSeries& series) {
  std::vector<std::string> runs;
  for (const std::size_t i : series.points) {
    const BenchPoint& point = plan.points[i];
    runs.push_back(std::to_string(point.points) + " " +
                   std::to_string(point.threads) + " " +
                   std::to_string(point.ranks) + " " +
                   std::to_string(std::lround(point.nodes / 256 / 256 * 100)));
  }
  return runs;
}

// 256 sqrt(2) = 362.04 and 256 sqrt(3) = 443.4 are rounded up to 364 and 444,
// and then to multiples of 16 without factors above 5: 384 and 480. The theory
// is not run, and the run on one thread is shared by both series.
TEST(ScalingSettings, WorkGrowsWithTheThreads) {
  const BenchPlan plan =
      scaling(rough_case(methods), {.threads = {1, 2, 3, 4}});

  ASSERT_EQ(plan.scaling.size(), 2U);
  EXPECT_FALSE(plan.scaling[0].is_weak);
  EXPECT_EQ(runs_of(plan, plan.scaling[0]),
            (std::vector<std::string>{"256 1 1 100", "256 2 1 100",
                                      "256 3 1 100", "256 4 1 100"}));
  EXPECT_TRUE(plan.scaling[1].is_weak);
  EXPECT_EQ(runs_of(plan, plan.scaling[1]),
            (std::vector<std::string>{"256 1 1 100", "384 2 1 225",
                                      "480 3 1 352", "512 4 1 400"}));
  EXPECT_EQ(plan.points.size(), 7U);
  for (const BenchPoint& point : plan.points)
    EXPECT_EQ(point.method, "halfspace");
}

// Ranks share the realisations: all of the case, or one for each rank. A full
// block is shared itself, so that its points grow.
TEST(ScalingSettings, RanksShareRealisationsOrAFullBlock) {
  std::string text = rough_case("[halfspace]\n[fem]\nsolver = \"full\"\n");
  text.replace(text.find("seed = 3"), 8, "seed = 3\nrealizations = 4");

  const BenchPlan plan = scaling(text, {.ranks = {1, 4}});

  ASSERT_EQ(plan.scaling.size(), 4U);
  const auto of = [&](const std::string& method, bool is_weak) {
    for (const ScalingSeries& series : plan.scaling)
      if (series.method == method && series.is_weak == is_weak)
        return runs_of(plan, series);
    return std::vector<std::string>{};
  };
  EXPECT_EQ(of("halfspace", false),
            (std::vector<std::string>{"256 1 1 400", "256 1 4 400"}));
  EXPECT_EQ(of("halfspace", true),
            (std::vector<std::string>{"256 1 1 100", "256 1 4 400"}));
  EXPECT_EQ(of("fem", false),
            (std::vector<std::string>{"256 1 1 100", "256 1 4 100"}));
  EXPECT_EQ(of("fem", true),
            (std::vector<std::string>{"256 1 1 100", "512 1 4 400"}));
}

// One realisation with at least 512^2 nodes: the ranks share its rows. 512
// sqrt(2) = 724.1 is rounded up to 768, because 736 and 752 have factors above
// 5 (and 750 is no multiple of 16); 512 sqrt(3) = 886.8 to 960 = 64 15.
TEST(ScalingSettings, RanksShareTheRowsOfOneRealisation) {
  std::string text = rough_case("[halfspace]\n[fem]\nelement = \"Q1\"\n");
  text.replace(text.find("points = 256"), 12, "points = 512");

  const BenchPlan plan = scaling(text, {.ranks = {1, 2, 3, 4}});

  ASSERT_EQ(plan.scaling.size(), 4U);
  for (const ScalingSeries& series : plan.scaling) {
    std::vector<int> points;
    for (const std::size_t i : series.points) {
      points.push_back(plan.points[i].points);
      for (const std::string& one : plan.points[i].overrides)
        EXPECT_EQ(one.find("realizations"), std::string::npos) << one;
    }
    EXPECT_EQ(points, series.is_weak ? (std::vector{512, 768, 960, 1024})
                                     : (std::vector{512, 512, 512, 512}));
  }
}

// A mesh with four halvings of quadratic elements needs multiples of 32.
TEST(ScalingSettings, TakesPointsThatAnAdaptiveMeshPermits) {
  const std::string text =
      rough_case("[fem]\nsolver = \"full\"\nelement = \"Q2\"\n"
                 "mesh = \"case\"\n[mesh]\nkind = \"adaptive\"\n"
                 "halvings = 4\n");

  const BenchPlan plan = scaling(text, {.threads = {1, 2, 3}});

  ASSERT_EQ(plan.scaling.size(), 2U);
  EXPECT_EQ(
      runs_of(plan, plan.scaling[1]),
      (std::vector<std::string>{"256 1 1 100", "384 2 1 225", "480 3 1 352"}));
}

TEST(ScalingSettings, RefusesWhatCannotScale) {
  const auto refusal = [](const std::string& text,
                          const ScalingOptions& options) {
    return tests::message_of<input::InputError>(
        [&] { (void)scaling(text, options); });
  };
  EXPECT_NE(refusal(rough_case(methods), {.ranks = {1, 2}})
                .find("--set surface.realizations=2"),
            std::string::npos);
  EXPECT_NE(
      refusal(rough_case(methods), {.methods = {"theory"}, .threads = {1, 2}})
          .find("theory"),
      std::string::npos);
}

// Two threads in 0.6 of the time, then 2.25 times the nodes in 1.5 times.
TEST(ScalingRows, AreRelativeToTheFirstRun) {
  Bench bench;
  for (const auto& [threads, nodes, wall, cpu] :
       {std::tuple{1, 100.0, 10.0, 10.0}, std::tuple{2, 100.0, 6.0, 11.0},
        std::tuple{2, 225.0, 15.0, 27.0}}) {
    BenchPoint point;
    point.threads = threads;
    point.nodes = nodes;
    point.wall.median = wall;
    point.cpu.median = cpu;
    point.answer.values["mean_gap"] = {nodes == 100.0 ? 1.0 : 2.0};
    bench.points.push_back(point);
  }

  const auto strong = scaling_rows(bench, {"fem", false, false, {0, 1}});
  const auto weak = scaling_rows(bench, {"fem", false, true, {0, 2}});

  ASSERT_EQ(strong.size(), 2U);
  EXPECT_DOUBLE_EQ(strong[1].speed_up, 10.0 / 6.0);
  EXPECT_DOUBLE_EQ(strong[1].efficiency, 5.0 / 6.0);
  EXPECT_DOUBLE_EQ(strong[1].cpu_ratio, 1.1);
  EXPECT_TRUE(strong[1].has_same_bits);
  ASSERT_EQ(weak.size(), 2U);
  EXPECT_DOUBLE_EQ(weak[1].speed_up, 1.5);
  EXPECT_DOUBLE_EQ(weak[1].efficiency, 0.75);
  EXPECT_DOUBLE_EQ(weak[1].cpu_ratio, 1.2);
  EXPECT_TRUE(weak[1].has_same_bits) << "other surfaces are not compared";

  bench.points[1].answer.values["mean_gap"] = {std::nextafter(1.0, 2.0)};
  EXPECT_FALSE(
      scaling_rows(bench, {"fem", false, false, {0, 1}})[1].has_same_bits);
  bench.points[0].problem = "ended with exit code 2";
  EXPECT_TRUE(scaling_rows(bench, {"fem", false, false, {0, 1}}).empty());
}

} // namespace asperity::bench::scaling_test
