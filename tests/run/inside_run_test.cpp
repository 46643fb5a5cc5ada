// Tests of runs of full 3-D blocks with the stress inside: the tables of the
// result have the block's own values, with and without a cache.
#include "input/reader/read_case.hpp"
#include "results/result_reader.hpp"
#include "results/types/method_columns.hpp"
#include "run/run_case.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

namespace asperity::run::inside_run_test {

const std::string block_case = R"(schema = 1
title = "a wave"
[surface]
kind = "wave-1d"
length = "1 um"
points = 8
amplitude = "10 nm"
wavelength = "1 length"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = [ "1e-3 E*", "2e-2 E*", "4e-3 E*" ]
[halfspace]
contact = "hard"
[fem]
solver = "full"
contact = "hard"
[report]
fields = 3
)";

class InsideRun : public tests::FolderTest {
protected:
  RunOutcome run(const std::string& out,
                 const std::vector<std::string>& overrides = {
                     "report.stress_inside=true"}) {
    const cases::Case read = cases::read_case_text(
        block_case, (folder / "block.toml").string(), overrides);
    return run_case(read, {folder / out, {}, false, 1, "", &cache});
  }

  results::Result result(const std::string& out) const {
    return results::read_result(folder / out);
  }

  methods::Cache cache{folder / "cache", 100'000'000};
};

// The table of a full block has the numbers of its own curve in each row and
// those from its pressure beside them; that of the half-space has the latter
// alone. On a mesh of eight cells per wave the two differ by far less than a
// factor of two.
TEST_F(InsideRun, HasTheBlocksOwnMaxima) {
  EXPECT_EQ(run("out").failed_steps, 0);
  const results::Result found = result("out");

  const results::Table* const own = found.table("stress-inside-fem");
  const results::Table* const other = found.table("stress-inside-halfspace");
  ASSERT_TRUE(own != nullptr && other != nullptr);
  const auto& rows = found.methods.at(1).realizations.at(0).points;
  ASSERT_EQ(own->values("von_mises").size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(own->values("nominal_pressure")[i], rows[i].nominal_pressure);
    EXPECT_EQ(own->values("von_mises")[i], rows[i][columns::von_mises]);
    EXPECT_EQ(own->values("depth")[i], rows[i][columns::von_mises_depth]);
    const double ratio =
        own->values("von_mises_from_pressure")[i] / rows[i][columns::von_mises];
    EXPECT_NE(ratio, 1.0);
    EXPECT_NEAR(ratio, 1.0, 0.5);
  }
  EXPECT_TRUE(other->values("von_mises_from_pressure").empty());
}

// The section is the block's own, at the largest load, which is neither the
// first nor the last; that of the half-space is from its pressure. Averages at
// the vertices of such a coarse mesh are within a factor of two of the maximum.
TEST_F(InsideRun, HasTheBlocksOwnSection) {
  run("out");
  const results::Result found = result("out");

  const results::Table* const own = found.table("stress-section-fem");
  const results::Table* const other = found.table("stress-section-halfspace");
  ASSERT_TRUE(own != nullptr && other != nullptr);
  EXPECT_NE(own->title.find("from its cells"), std::string::npos) << own->title;
  EXPECT_NE(other->title.find("from its pressure"), std::string::npos);
  EXPECT_EQ(own->title.substr(0, own->title.find(" Pa")),
            other->title.substr(0, other->title.find(" Pa")));
  const results::Table* const all = found.table("stress-sections-halfspace");
  ASSERT_NE(all, nullptr);
  const std::vector<double> of_all = all->values("von_mises");
  const std::vector<double> heaviest = other->values("von_mises");
  ASSERT_EQ(of_all.size(), 3 * heaviest.size());
  EXPECT_TRUE(std::ranges::equal(
      heaviest, std::span(of_all).subspan(heaviest.size(), heaviest.size())));
  const std::vector<double> strength = own->values("von_mises");
  const auto& row = found.methods.at(1).realizations.at(0).points.at(1);
  const double highest = *std::max_element(strength.begin(), strength.end());
  EXPECT_LT(highest, 2.0 * row[columns::von_mises]);
  EXPECT_GT(highest, 0.5 * row[columns::von_mises]);
}

// A run from the cache has the same tables, and steps of a run without the
// stress are computed again where the section is missing.
TEST_F(InsideRun, KeepsTheSectionInTheCache) {
  run("before", {});
  EXPECT_EQ(result("before").table("stress-section-fem"), nullptr);

  const RunOutcome first = run("first");
  const RunOutcome second = run("second");

  EXPECT_EQ(first.computed_steps, 1);
  EXPECT_EQ(second.computed_steps, 0);
  const results::Result one = result("first");
  const results::Result two = result("second");
  for (const char* name : {"stress-section-fem", "stress-inside-fem"}) {
    ASSERT_TRUE(one.table(name) != nullptr && two.table(name) != nullptr);
    EXPECT_EQ(one.table(name)->title, two.table(name)->title);
    EXPECT_EQ(one.table(name)->values("von_mises"),
              two.table(name)->values("von_mises"));
  }
  run("after", {});
  EXPECT_EQ(result("after").table("stress-section-fem"), nullptr);
}

} // namespace asperity::run::inside_run_test
