// Tests of robustness/axes.hpp and robustness/matrix.hpp: every label is a bin
// of its axis, a filter selects what it names, and the counts sum to the total.
#include "robustness/axes.hpp"
#include "robustness/matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace asperity::robustness::axes_test {

TEST(Axes, HoldEveryLabelOfEveryInstance) {
  for (int index = 0; index < 2000; ++index) {
    const std::vector<std::string> labels = labels_of(draw_instance(2, index));
    ASSERT_EQ(labels.size(), axes().size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto& known = axes()[i].labels;
      EXPECT_TRUE(labels[i].empty() || std::find(known.begin(), known.end(),
                                                 labels[i]) != known.end())
          << axes()[i].name << "=" << labels[i];
    }
  }
}

// No axis has a bin that no instance reaches.
TEST(Axes, HaveNoEmptyBin) {
  std::vector<std::set<std::string>> reached(axes().size());
  for (int index = 0; index < 5000; ++index) {
    const std::vector<std::string> labels = labels_of(draw_instance(2, index));
    for (std::size_t i = 0; i < labels.size(); ++i)
      reached[i].insert(labels[i]);
  }
  for (std::size_t i = 0; i < axes().size(); ++i)
    for (const std::string& label : axes()[i].labels)
      EXPECT_TRUE(reached[i].contains(label)) << axes()[i].name << "=" << label;
}

TEST(Axes, FilterSelectsWhatItNames) {
  const InstanceFilter slabs("slab");
  const InstanceFilter stiff("penalty=1e+06..1e+09");
  int n_slabs = 0;
  for (int index = 0; index < 500; ++index) {
    const Instance instance = draw_instance(2, index);
    EXPECT_TRUE(InstanceFilter().takes(instance));
    EXPECT_EQ(slabs.takes(instance), instance.family == Family::slab);
    n_slabs += slabs.takes(instance);
    if (stiff.takes(instance)) {
      EXPECT_GE(instance.penalty, 1e6);
      EXPECT_LT(instance.penalty, 1e9);
    }
  }
  EXPECT_GT(n_slabs, 0);
}

TEST(Axes, FilterListsTheChoices) {
  try {
    InstanceFilter("law=soft");
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(error.what(),
                 "only = law=soft, but must be one of: "
                 "law=penalty, law=hard, law=augmented, law=exponential, "
                 "law=dugdale, law=cubic, law=lennard-jones, "
                 "law=lennard-jones-10-4, law=morse");
  }
  EXPECT_THROW(InstanceFilter("colour=red"), std::domain_error);
}

TEST(Matrix, CountsEveryInstanceInEachOfItsBins) {
  Matrix matrix;
  for (int index = 0; index < 300; ++index) {
    InstanceResult result{draw_instance(2, index), {}};
    result.report.index = index;
    result.report.iterations = index;
    result.report.outcome =
        index % 100 == 7 ? Outcome::crashed : Outcome::verified;
    matrix.add(result);
  }

  EXPECT_EQ(matrix.total().all(), 300);
  EXPECT_EQ(matrix.total().others(), 3);
  ASSERT_EQ(matrix.others().size(), 3u);
  EXPECT_EQ(matrix.others()[1].report.index, 107);
  int in_families = 0;
  for (const std::string& family : axes().front().labels)
    in_families += matrix.of("family", family).all();
  EXPECT_EQ(in_families, 300);
  EXPECT_EQ(matrix.of("family", "slab", "law", "hard").all(),
            matrix.of("law", "hard", "family", "slab").all());
  EXPECT_LT(matrix.of("family", "slab", "law", "hard").all(),
            matrix.of("family", "slab").all());
  ASSERT_EQ(matrix.slowest().size(), 10u);
  EXPECT_EQ(matrix.slowest().front().report.iterations, 299);
}

} // namespace asperity::robustness::axes_test
