// Tests of plans: counts and structure.
#include "results/result_reader.hpp"
#include "run/plan/needs.hpp"
#include "run/run_case.hpp"
#include "tests/run/planned_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
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
  RunOptions options{folder / "out", {methods}, false, 1, "", &cache};
  const auto bytes = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = overrides;
    all.insert(all.end(), more.begin(), more.end());
    return make_plan(read(all), options).memory;
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

TEST_F(PlannedRun, CountsWhatTheCacheHas) {
  run_case(read(), {folder / "out", {{"halfspace"}}, false, 1, "", &cache});

  const Plan planned = plan();

  EXPECT_EQ(planned.methods[1].kept_steps, 8);
  EXPECT_EQ(planned.methods[2].kept_steps, 0);
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

// Twice the points per side are four times the unknowns and the memory.
TEST_F(PlannedRun, MemoryIsProportionalToTheNodes) {
  const cases::Case contact_case = read();
  const Grid small{32, 32, 1e-6, 1e-6};
  const Grid large{64, 64, 1e-6, 1e-6};
  for (const std::size_t method : {1u, 2u}) {
    const MethodNeeds one =
        needs_of(contact_case, contact_case.methods[method], small);
    const MethodNeeds four =
        needs_of(contact_case, contact_case.methods[method], large);

    EXPECT_EQ(four.unknowns, 4.0 * one.unknowns);
    EXPECT_NEAR(four.memory / one.memory, 4.0, 1e-14);
  }
}

// Three of the four images have heights and answers only.
TEST_F(PlannedRun, AMirroredMapNeedsLessMemory) {
  const Grid cell{64, 64, 1e-6, 1e-6};
  cases::Case contact_case = read();
  for (const std::size_t method : {1u, 2u}) {
    contact_case.surface.edges = mechanics::Edges::periodic;
    const MethodNeeds periodic =
        needs_of(contact_case, contact_case.methods[method], cell);
    contact_case.surface.edges = mechanics::Edges::mirror;
    const MethodNeeds mirrored =
        needs_of(contact_case, contact_case.methods[method], cell);

    EXPECT_LT(mirrored.memory, 0.8 * periodic.memory);
    EXPECT_GT(mirrored.memory, 0.25 * periodic.memory);
  }
}

// The result lists the work that the cache saved.
TEST_F(PlannedRun, TheResultStatesWhatTheCacheSaved) {
  const RunOptions options{folder / "out", {{"halfspace"}}, false, 1, "",
                           &cache};
  run_case(read(), options);
  EXPECT_FALSE(
      find(results::read_result(folder / "out").skipped, "halfspace: 8 steps"));
  run_case(read(), options);

  const results::Result second = results::read_result(folder / "out");

  const Skipped* kept = find(second.skipped, "halfspace: 8 steps");
  ASSERT_NE(kept, nullptr);
  EXPECT_TRUE(kept->why.starts_with("in the cache; took ")) << kept->why;
  EXPECT_TRUE(find(second.skipped, "fem")); // not among --methods
}

TEST_F(PlannedRun, IsPrintedAsATable) {
  const std::string text = plan_text(plan(), read());

  for (const char* words :
       {"halfspace", "32 x 32", "formula", "predicted: memory ",
        "within a factor of 2 on 2 threads", "skipped:\n"})
    EXPECT_NE(text.find(words), std::string::npos) << words << '\n' << text;
}

} // namespace asperity::run::plan_test
