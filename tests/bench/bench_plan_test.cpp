// Tests of suite/bench/settings/bench_plan.hpp: the settings that a benchmark
// runs.
#include "input/reader/read_case.hpp"
#include "suite/bench/settings/bench_plan.hpp"
#include "tests/bench/rough_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::bench::bench_plan_test {

const std::string rough = rough_case("[fem]\n");
const std::string wave =
    bench_case("kind = \"wave-1d\"\nwavelength = \"1 length\"\n"
               "amplitude = \"0.01 length\"\n",
               "[fem]\n");

BenchPlan plan_of_text(const std::string& text) {
  return bench_plan_of(cases::read_case_text(text, "case.toml"), {});
}

// The reference solution is the half-space on the grids of the case and
// on one twice as fine; a wave with an exact solution has none.
TEST(BenchPlan, HasAReferenceSolutionOnAFinerGrid) {
  const BenchPlan plan = plan_of_text(rough);

  ASSERT_LT(plan.reference_series, plan.series.size());
  const BenchSeries& series = plan.series[plan.reference_series];
  EXPECT_EQ(series.method, "halfspace");
  std::vector<int> grids;
  for (const std::size_t point : series.points) {
    EXPECT_TRUE(plan.points[point].is_reference);
    grids.push_back(plan.points[point].points);
  }
  EXPECT_EQ(grids, (std::vector<int>{64, 128, 256, 512}));
  EXPECT_EQ(plan_of_text(wave).reference_series, BenchPlan::no_reference);
}

// A setting on another grid than that of the case says so to the run,
// and no other one does.
TEST(BenchPlan, ChangesThePointsOfOtherGridsAlone) {
  for (const std::string& text : {rough, wave})
    for (const BenchPoint& point : plan_of_text(text).points)
      EXPECT_EQ(std::any_of(point.overrides.begin(), point.overrides.end(),
                            [](const std::string& one) {
                              return one.starts_with("surface.points=");
                            }),
                point.points != 256)
          << point.label;
}

const BenchPoint& point_of(const BenchPlan& plan, const std::string& method,
                           int points) {
  const auto found =
      std::ranges::find_if(plan.points, [&](const BenchPoint& point) {
        return point.method == method && point.points == points;
      });
  if (found == plan.points.end())
    throw std::out_of_range(method);
  return *found;
}

/// Overrides of a sphere under a block on a mesh, by method and points.
std::vector<std::string> overrides_on(const std::string& mesh,
                                      const std::string& method, int points,
                                      const std::string& more = "") {
  const std::string text =
      bench_case("kind = \"sphere\"\nradius = \"10 length\"\n",
                 "[mesh]\n" + mesh +
                     "\n[fem]\nsolver = \"full\"\ncontact = \"hard\"\n" + more);
  return point_of(plan_of_text(text), method, points).overrides;
}

using Texts = std::vector<std::string>;

// A block on an adaptive mesh is compared with uniform layers and with the
// condensed block. The coarsest cells of the mesh stay, for every method,
// because all of them read the case.
TEST(BenchPlan, ComparesAnAdaptiveBlockWithUniformAndCondensedOnes) {
  const std::string mesh = "kind = \"adaptive\"\nhalvings = 4";

  EXPECT_EQ(overrides_on(mesh, "fem", 256), Texts{});
  EXPECT_EQ(overrides_on(mesh, "fem", 64),
            (Texts{"surface.points=64", "mesh.halvings=2"}));
  EXPECT_EQ(overrides_on(mesh, "fem.uniform", 128),
            (Texts{"fem.uniform.mesh=layers", "surface.points=128",
                   "mesh.halvings=3"}));
  EXPECT_EQ(overrides_on(mesh, "fem.condensed", 256),
            Texts{"fem.condensed.solver=condensed"});
}

// All cells of a gmsh mesh follow the grid: those in node spacings do so by
// themselves, and the others are scaled.
TEST(BenchPlan, ScalesAGmshMeshWithThePoints) {
  EXPECT_EQ(overrides_on("kind = \"gmsh\"\ngeometry = \"indentation\"\n"
                         "size_at_contact = \"2 h\"\n"
                         "size_far = \"0.125 length\"",
                         "fem", 128),
            (Texts{"surface.points=128", "mesh.size_far=0.25 length"}));
}

// A finite block with free sides is another problem for the condensed solver
// and has no such method beside it.
TEST(BenchPlan, ComparesNoBlockWithFreeSides) {
  EXPECT_THROW(overrides_on("kind = \"adaptive\"\nhalvings = 4",
                            "fem.condensed", 256, "sides = \"free\"\n"),
               std::out_of_range);
}

} // namespace asperity::bench::bench_plan_test
