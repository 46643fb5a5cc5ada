// Tests of bench/settings/sweep.hpp: the settings that a benchmark runs.
#include "cases/reader/read_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "bench/settings/sweep.hpp"
#include "tests/bench/rough_case.hpp"

namespace asperity::app {
namespace {

const std::string rough = rough_case("[fem]\n");
const std::string wave =
    bench_case("kind = \"wave-1d\"\nwavelength = \"1 length\"\n"
               "amplitude = \"0.01 length\"\n",
               "[fem]\n");

Sweep sweep_of_text(const std::string& text) {
  return sweep_of(cases::read_case_text(text, "case.toml"), {});
}

// The reference solution is the half-space on the grids of the case and
// on one twice as fine; a wave with an exact solution has none.
TEST(Sweep, HasAReferenceSolutionOnAFinerGrid) {
  const Sweep sweep = sweep_of_text(rough);

  ASSERT_LT(sweep.reference_series, sweep.series.size());
  const reports::BenchSeries& series = sweep.series[sweep.reference_series];
  EXPECT_EQ(series.method, "halfspace");
  std::vector<int> grids;
  for (const std::size_t point : series.points) {
    EXPECT_TRUE(sweep.points[point].is_reference);
    grids.push_back(sweep.points[point].points);
  }
  EXPECT_EQ(grids, (std::vector<int>{64, 128, 256, 512}));
  EXPECT_EQ(sweep_of_text(wave).reference_series, Sweep::no_reference);
}

// A setting on another grid than that of the case says so to the run,
// and no other one does.
TEST(Sweep, ChangesThePointsOfOtherGridsAlone) {
  for (const std::string& text : {rough, wave})
    for (const reports::BenchPoint& point : sweep_of_text(text).points)
      EXPECT_EQ(std::any_of(point.overrides.begin(), point.overrides.end(),
                            [](const std::string& one) {
                              return one.starts_with("surface.points=");
                            }),
                point.points != 256)
          << point.label;
}

} // namespace
} // namespace asperity::app
