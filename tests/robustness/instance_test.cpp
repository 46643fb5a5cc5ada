// Tests of suite/robustness/instance.hpp and matrix.hpp: an instance follows
// from its seed and its index, every label is a bin of its axis, a filter
// selects what it names, and the counts sum to the total.
#include "input/reader/read_case.hpp"
#include "suite/robustness/matrix.hpp"
#include "suite/robustness/shapes.hpp"
#include "surfaces/maps/statistics.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace asperity::robustness::instance_test {

TEST(Instance, IsItsSeedAndItsIndex) {
  std::set<std::string> different;
  for (int index = 0; index < 200; ++index) {
    EXPECT_EQ(text_of(draw_instance(7, index)),
              text_of(draw_instance(7, index)));
    different.insert(text_of(draw_instance(7, index)));
    different.insert(text_of(draw_instance(8, index)));
  }
  EXPECT_EQ(different.size(), 400u);
  EXPECT_THROW(draw_instance(7, -1), std::domain_error);
}

// Every label is one of its axis, and no axis has a bin that no instance
// reaches.
TEST(Instance, ReachesEveryBinOfEveryAxisAndNoOther) {
  std::map<std::string, std::set<std::string>> reached;
  for (int index = 0; index < 6000; ++index)
    for (const auto& [axis, label] : draw_instance(2, index).labels)
      reached[axis].insert(label);
  for (const Axis& axis : axes())
    EXPECT_EQ(reached[axis.name],
              std::set(axis.labels.begin(), axis.labels.end()))
        << axis.name;
  EXPECT_EQ(reached.size(), axes().size());
}

TEST(Instance, InOtherUnitsHasScaledNumbers) {
  for (int index = 0; index < 40; ++index) {
    const Instance one = draw_instance(3, index);
    const Instance other = draw_instance(3, index, nullptr, {1024.0, 0.5});
    if (!one.label("flaw").empty())
      continue;
    const auto length = [](const Instance& instance) {
      const std::string key = "surface.length = ";
      return std::stod(
          instance.text.substr(instance.text.find(key) + key.size()));
    };
    EXPECT_EQ(length(other), 1024.0 * length(one));
    EXPECT_EQ(one.labels, other.labels);
  }
}

// About a case, some settings are those of the case and others are drawn.
TEST(Instance, AboutACaseKeepsHalfOfItsSettings) {
  const cases::Case read =
      cases::read_case(std::string(ASPERITY_CASES) + "/layered/case.toml");
  const std::vector<Base> bases = bases_of(read);
  ASSERT_FALSE(bases.empty());
  int kept = 0;
  constexpr int draws = 60;
  for (int index = 0; index < draws; ++index) {
    const Instance instance = draw_instance(5, index, &bases.front());
    EXPECT_EQ(instance.file, read.path);
    kept += std::ranges::none_of(instance.overrides, [](const auto& entry) {
      return entry.starts_with("material=");
    });
    EXPECT_TRUE(std::ranges::any_of(instance.overrides, [](const auto& entry) {
      return entry.starts_with("load={");
    }));
  }
  EXPECT_GT(kept, draws / 4);
  EXPECT_LT(kept, 3 * draws / 4);
}

TEST(Instance, FilterSelectsWhatItNames) {
  const InstanceFilter slabs("slab");
  const InstanceFilter stiff("penalty=1e+06..1e+09");
  int n_slabs = 0;
  for (int index = 0; index < 500; ++index) {
    const Instance instance = draw_instance(2, index);
    EXPECT_TRUE(InstanceFilter().takes(instance));
    EXPECT_EQ(slabs.takes(instance), instance.label("family") == "slab");
    n_slabs += slabs.takes(instance);
    EXPECT_EQ(stiff.takes(instance),
              instance.label("penalty") == bin_of("penalty", 2e6));
  }
  EXPECT_GT(n_slabs, 0);
}

TEST(Instance, FilterListsTheChoices) {
  try {
    InstanceFilter("control=soft");
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(error.what(), "only = control=soft, but must be one of: "
                               "control=pressure, control=gap");
  }
  EXPECT_THROW(InstanceFilter("colour=red"), std::domain_error);
}

// Tolerance: roundoff of a transform and a scaling.
TEST(Shapes, HaveTheirHeightsAndTheRequestedSlope) {
  const Draft draft(1, 0, nullptr, {});
  for (const auto& [shape, n_heights] : {std::pair{"spike", 2u},
                                         {"step", 2u},
                                         {"checkerboard", 2u},
                                         {"terraces", 4u},
                                         {"sawtooth", 8u}}) {
    const surfaces::HeightMap map = map_of_shape(shape, 32, 1e-9, 0.37, draft);

    EXPECT_NEAR(surfaces::statistics(map).rms_slope / 0.37, 1.0, 1e-12)
        << shape;
    EXPECT_EQ(std::set(map.heights.begin(), map.heights.end()).size(),
              n_heights)
        << shape;
  }
}

Matrix small_matrix() {
  Matrix matrix;
  for (int index = 0; index < 300; ++index) {
    InstanceResult result{draw_instance(2, index), {}};
    result.report.index = index;
    if (index % 100 == 7) {
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

TEST(Matrix, CountsEveryInstanceInEachOfItsBins) {
  const Matrix matrix = small_matrix();

  EXPECT_EQ(matrix.total().all(), 300);
  EXPECT_EQ(matrix.total().others(), 3);
  ASSERT_EQ(matrix.others().size(), 3u);
  EXPECT_EQ(matrix.others()[1].report.index, 107);
  int in_families = 0;
  for (const std::string& family : axes().front().labels)
    in_families += matrix.of("family", family).all();
  EXPECT_EQ(in_families, 300);
}

TEST(Matrix, IsWrittenWithTheSameCounts) {
  const auto root = nlohmann::json::parse(json_of(small_matrix(), words, {}));
  const std::string text = text_of(small_matrix(), words);

  EXPECT_EQ(root["instances"], 300);
  EXPECT_EQ(root["anything_else"], 3);
  EXPECT_EQ(root["outcomes"]["verified"], 297);
  EXPECT_EQ(root["others"][1]["instance"], 107);
  EXPECT_EQ(root["others"][1]["check"], "energy");
  EXPECT_NE(text.find("asperity robustness --seed 2 --instance 107: check "
                      "failed: energy U < p du & more"),
            std::string::npos)
      << text;
}

// Quoted fields may contain commas; no other column may.
TEST(Matrix, HasAsManyColumnsAsHeads) {
  Instance instance = draw_instance(2, 0);
  instance.text = "no commas";
  InstanceResult result{instance, {}};
  result.report.reason = "no commas";
  const std::string line = csv_line(result);
  const std::string head = csv_header();
  EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(head, ','));
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

} // namespace asperity::robustness::instance_test
