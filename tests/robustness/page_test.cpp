// Tests of robustness/page.hpp and robustness/locking.hpp: the output of a run
// states how it ended, and Q1 locks where Q2 does not.
#include "robustness/page.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::robustness::page_test {

Matrix small_matrix() {
  Matrix matrix;
  for (int index = 0; index < 50; ++index) {
    InstanceResult result{draw_instance(2, index), {}};
    result.report.index = index;
    if (index == 20) {
      result.report.outcome = Outcome::check_failed;
      result.report.check = "energy";
      result.report.reason = "U < p du & more";
    }
    matrix.add(result);
  }
  return matrix;
}

const RunDescription words{"asperity robustness --seed 2", "abc", "a machine",
                           1.0, 2};

TEST(Page, NamesTheInstanceWithAnotherOutcome) {
  const std::string page = page_of(small_matrix(), words, {});

  EXPECT_NE(page.find("50 problem instances: 49 converged and verified, 0 "
                      "refused with a reason, 1 with any other outcome."),
            std::string::npos);
  EXPECT_NE(page.find("asperity robustness --seed 2 --instance 20"),
            std::string::npos);
  EXPECT_NE(page.find("check failed: energy"), std::string::npos);
  EXPECT_NE(page.find("U &lt; p du &amp; more"), std::string::npos);
  EXPECT_NE(page.find("hsl(4,"), std::string::npos); // the red cells of 20
}

TEST(Tables, HoldTheSameCounts) {
  const auto root = nlohmann::json::parse(json_of(small_matrix(), words, {}));

  EXPECT_EQ(root["instances"], 50);
  EXPECT_EQ(root["anything_else"], 1);
  EXPECT_EQ(root["outcomes"]["verified"], 49);
  EXPECT_EQ(root["others"][0]["instance"], 20);
  EXPECT_EQ(root["others"][0]["check"], "energy");
}

// The reason, which is quoted, may contain commas; no other column may.
TEST(Tables, HaveAsManyColumnsAsHeads) {
  InstanceResult result{draw_instance(2, 0), {}};
  result.report.reason = "no commas";
  const std::string line = csv_line(result);
  const std::string head = csv_header();
  EXPECT_EQ(std::count(line.begin(), line.end(), ','),
            std::count(head.begin(), head.end(), ','));
}

// First-order elements lock: every wave on every block is stiffer by more than
// half at nu = 0.4999, and by 4 % at most up to 0.3. Second order has a quarter
// of that or less, wherever first order locks.
TEST(Locking, IsOfFirstOrder) {
  int n_locked = 0;
  for (const LockingRow& row : locking_table()) {
    if (row.poisson_ratio <= 0.3) {
      EXPECT_LT(std::abs(row.q1), 0.04);
      EXPECT_LT(std::abs(row.q2), 0.01);
    }
    if (row.poisson_ratio > 0.499) {
      EXPECT_LT(row.q1, -0.5);
      EXPECT_LT(std::abs(row.q2), 0.25 * std::abs(row.q1));
      ++n_locked;
    }
  }
  EXPECT_EQ(n_locked, 4);
}

} // namespace asperity::robustness::page_test
