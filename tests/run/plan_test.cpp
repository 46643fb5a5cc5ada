// Tests of plans: counts and structure. No test asserts a time.
#include "results/result_reader.hpp"
#include "run/run_case.hpp"
#include "tests/run/planned_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>

namespace asperity::run::plan_test {

using results::Skipped;

/// The first entry whose `what` begins so; null if there is none.
const Skipped* find(const std::vector<Skipped>& list, const std::string& what) {
  const auto found = std::ranges::find_if(
      list, [&](const Skipped& one) { return one.what.starts_with(what); });
  return found == list.end() ? nullptr : &*found;
}

TEST_F(PlannedRun, CountsWhatTheCaseRequests) {
  const Plan planned = plan();

  ASSERT_EQ(planned.methods.size(), 3u);
  EXPECT_EQ(planned.methods[0].steps, 4); // one formula
  EXPECT_EQ(planned.methods[1].steps, 8);
  EXPECT_EQ(planned.methods[1].realizations, 2);
  EXPECT_EQ(planned.methods[1].grid.points_x, 32);
  EXPECT_EQ(planned.methods[1].unknowns, 32 * 32);
  EXPECT_EQ(planned.threads, 2);
  EXPECT_GT(planned.cpu_time, 0.0);
}

// The result is read again for a report: the heights of two surfaces, and
// pressure and gap of two methods at twelve steps, which exceed the fields of
// the solvers. Maps from 2^20 nodes on are read by pieces, which do not. The
// stresses inside hold 15 fields of one map, and 16 bytes for its layer.
TEST_F(PlannedRun, CountsTheMapsOfAReport) {
  const std::vector<std::string> overrides = {
      "surface.points=1000", "report.fields=\"all\"",
      "load.nominal_pressure={ from = \"1e-3 E*\", to = \"0.1 E*\", steps = "
      "12, spacing = \"log\" }"};
  const std::vector<std::string> methods = {"halfspace", "fem"};
  RunOptions options{folder / "out", methods, false, 1, "", &cache};
  const auto bytes = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = overrides;
    all.insert(all.end(), more.begin(), more.end());
    return make_plan(read(all), options, 32).memory;
  };
  const double with_report = bytes({});
  options.has_report = false;
  const double without_report = bytes({});
  const double large_without = bytes({"surface.points=2048"});
  options.has_report = true;
  const double by_pieces = bytes({"surface.points=2048"});
  const double stresses = bytes({"report.stress_inside=true"});

  const double maps = 8.0 * (2.0 + 2.0 * 2.0 * 12.0) * 1000.0 * 1000.0;
  EXPECT_GE(with_report, maps);
  EXPECT_LT(with_report, maps + 2e8); // and the program
  EXPECT_LT(without_report, maps);
  EXPECT_EQ(by_pieces, large_without);
  EXPECT_DOUBLE_EQ(stresses - with_report,
                   (8.0 * 15.0 + 16.0) * 1000.0 * 1000.0);
}

// Nothing is written: neither a result nor a cache.
TEST_F(PlannedRun, LeavesTheDiskAlone) {
  plan();

  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

// The times of the parts sum to the total. Work of 1/2 s for the program, 1/4 s
// for the tables, 2 + 6 s and 1 + 3 s shared by two threads, 5 s alone; every
// number is exact in binary.
TEST(PlannedTimes, AddUp) {
  Plan plan;
  plan.threads = 2;
  plan.base_time = 0.5;
  plan.study_time = 0.25;
  plan.methods.resize(3);
  plan.methods[0].realizations = 2;
  plan.methods[0].setup_time = 2.0;
  plan.methods[0].step_time = 6.0;
  plan.methods[1].realizations = 1;
  plan.methods[1].setup_time = 1.0;
  plan.methods[1].step_time = 3.0;
  plan.methods[2].realizations = 1;
  plan.methods[2].step_time = 5.0;
  plan.methods[2].runs_alone = true;

  add_up_times(plan);

  EXPECT_EQ(plan.cpu_time, 17.75);
  EXPECT_EQ(plan.wall_time, 0.5 + 5.0 + (0.25 + 8.0 + 4.0) / 2.0);

  plan.methods[0].realizations = 1; // now one job of 8 s is the longest

  add_up_times(plan);

  EXPECT_EQ(plan.cpu_time, 17.75);
  EXPECT_EQ(plan.wall_time, 0.5 + 5.0 + 8.0);
}

// The times of a plan are those of its parts, and every method that is not in
// the cache has one.
TEST_F(PlannedRun, HasATimeForEveryPart) {
  const Plan planned = plan();
  Plan added = planned;

  add_up_times(added);

  EXPECT_EQ(planned.cpu_time, added.cpu_time);
  EXPECT_EQ(planned.wall_time, added.wall_time);
  EXPECT_GT(planned.base_time, 0.0);
  for (const PlannedMethod& method : planned.methods)
    EXPECT_GT(method.step_time, 0.0) << method.name;
}

TEST_F(PlannedRun, CountsWhatTheCacheHas) {
  run_case(read(), {folder / "out", {"halfspace"}, false, 1, "", &cache});

  const Plan planned = plan();

  EXPECT_EQ(planned.methods[1].kept_steps, 8);
  EXPECT_EQ(planned.methods[1].step_time, 0.0);
  EXPECT_EQ(planned.methods[2].kept_steps, 0);
  EXPECT_GT(planned.methods[2].step_time, 0.0);
}

TEST_F(PlannedRun, SkipsWhatIsNotComputedAndNothingElse) {
  const Plan planned = plan();
  const Plan alone = plan({}, {"theory"});
  const Plan all_maps =
      plan({"report.fields=\"all\"", "surface.realizations=1"});

  EXPECT_TRUE(find(planned.skipped, "theory on 1 realisation"));
  EXPECT_TRUE(find(planned.skipped, "pressure and gap fields of 14 steps"));
  EXPECT_FALSE(find(planned.skipped, "2 surfaces"));
  EXPECT_TRUE(find(alone.skipped, "2 surfaces"));
  EXPECT_TRUE(find(alone.skipped, "halfspace"));
  EXPECT_TRUE(find(alone.skipped, "fem"));
  EXPECT_FALSE(find(all_maps.skipped, "pressure and gap fields"));
  EXPECT_FALSE(find(all_maps.skipped, "theory on"));

  const Plan fewer = plan({"fem.realizations=1"});
  const Skipped* omitted = find(fewer.skipped, "fem on 1 realisation");
  ASSERT_TRUE(omitted);
  EXPECT_EQ(omitted->why, "its number of realizations");
  EXPECT_EQ(fewer.methods.at(2).steps, 4);
  EXPECT_FALSE(find(planned.skipped, "fem on"));
}

// Each iteration removes the same part of the error, after those that find the
// contact, which are as many as for three decades: 1e-4 takes 7/11 of the
// iterations of 1e-8.
TEST_F(PlannedRun, IterationsFollowTheTolerance) {
  MachineRates rates(32);
  const Grid grid{32, 32, 1e-6, 1e-6};
  const auto time = [&](const std::string& tolerance) {
    const cases::Case contact_case = read({"halfspace.tolerance=" + tolerance});
    return cost_of(contact_case, contact_case.methods.at(1), grid, rates)
        .step_time;
  };

  EXPECT_NEAR(time("1e-4") / time("1e-8"), 7.0 / 11.0, 1e-14);
  EXPECT_GT(time("1e-9"), time("1e-8"));
}

// The model scales correctly: with the same rates, twice the points per side
// are four times the unknowns and the memory.
TEST_F(PlannedRun, MemoryIsProportionalToTheNodes) {
  const cases::Case contact_case = read();
  MachineRates rates(32);
  const Grid small{32, 32, 1e-6, 1e-6};
  const Grid large{64, 64, 1e-6, 1e-6};
  for (const std::size_t method : {1u, 2u}) {
    const MethodCost one =
        cost_of(contact_case, contact_case.methods[method], small, rates);
    const MethodCost four =
        cost_of(contact_case, contact_case.methods[method], large, rates);

    EXPECT_EQ(four.unknowns, 4.0 * one.unknowns);
    EXPECT_NEAR(four.memory / one.memory, 4.0, 1e-14);
    EXPECT_GT(four.step_time, 4.0 * one.step_time);
  }
}

// The result lists the work that the cache saved, at the cost in its own rows.
// Tolerance: roundoff of a sum of nine times.
TEST_F(PlannedRun, TheResultStatesWhatTheCacheSaved) {
  const RunOptions options{folder / "out", {"halfspace"}, false, 1, "", &cache};
  run_case(read(), options);
  EXPECT_FALSE(
      find(results::read_result(folder / "out").skipped, "halfspace: 8 steps"));
  run_case(read(), options);

  const results::Result second = results::read_result(folder / "out");

  const Skipped* kept = find(second.skipped, "halfspace: 8 steps");
  ASSERT_NE(kept, nullptr);
  EXPECT_EQ(kept->why, "in the cache");
  double cost = 0.0;
  for (const results::Curve& curve : second.methods.at(0).realizations) {
    cost += curve.setup_cpu_time;
    for (const results::CurvePoint& point : curve.points)
      cost += point.cpu_time;
  }
  EXPECT_NEAR(kept->cpu_time / cost, 1.0, 1e-14);
  EXPECT_TRUE(find(second.skipped, "fem")); // not among --methods
}

TEST_F(PlannedRun, IsPrintedAsATable) {
  const std::string text = plan_text(plan(), read());

  for (const char* words :
       {"halfspace", "32 x 32", "formula", "predicted: CPU ", "on 2 threads",
        "skipped, with the cost where it is predicted:"})
    EXPECT_NE(text.find(words), std::string::npos) << words << '\n' << text;
}

// Sizes are written without exponents, and for skipped work only the known
// costs are listed.
TEST_F(PlannedRun, IsPrintedWithReadableNumbers) {
  EXPECT_EQ(size_text(4.2e6), "4.2 MB");
  EXPECT_EQ(size_text(2.64e8), "264 MB");
  EXPECT_EQ(size_text(6.18e10), "61.8 GB");
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  Plan planned = plan();
  planned.skipped = {{"one", "why", unknown, unknown},
                     {"two", "why", 2.0, unknown},
                     {"three", "why", unknown, 4.2e6},
                     {"four", "why", 2.0, 4.2e6}};

  const std::string text = plan_text(planned, read());

  EXPECT_NE(text.find("  one: why\n  two: why (CPU 2 s)\n"
                      "  three: why (4.2 MB)\n  four: why (CPU 2 s, 4.2 MB)\n"),
            std::string::npos)
      << text;
}

} // namespace asperity::run::plan_test
