// Tests of base/maximum.hpp and of the comparison of fields that uses it: a NaN
// is never overlooked, wherever it is.
#include "base/maximum.hpp"
#include "base/special_numbers.hpp"
#include "tests/base/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity::maximum_test {

TEST(Maximum, IsTheLargerOrNaN) {
  EXPECT_EQ(maximum(1.0, 2.0), 2.0);
  EXPECT_EQ(maximum(2.0, -3.0), 2.0);
  EXPECT_EQ(maximum(-infinity, infinity), infinity);
  EXPECT_TRUE(std::isnan(maximum(not_a_number, 1.0)));
  EXPECT_TRUE(std::isnan(maximum(1.0, not_a_number)));
  EXPECT_TRUE(std::isnan(maximum(not_a_number, infinity)));
  EXPECT_TRUE(std::isnan(maximum(infinity, not_a_number)));
}

TEST(LargestMagnitude, DetectsANaNAnywhere) {
  EXPECT_EQ(largest_magnitude(std::vector<double>{}), 0.0);
  EXPECT_EQ(largest_magnitude(std::vector{1.0, -3.0, 2.0}), 3.0);
  for (std::size_t at = 0; at < 4; ++at) {
    std::vector<double> values{1.0, -3.0, 2.0, infinity};
    values[at] = not_a_number;
    EXPECT_TRUE(std::isnan(largest_magnitude(values))) << at;
  }
}

TEST(LargestDifference, IsSmallForEqualFieldsOnly) {
  const std::vector<double> field{1.0, 2.0, 3.0};
  EXPECT_EQ(tests::largest_difference(field, field), 0.0);
  EXPECT_EQ(tests::largest_difference(field, std::vector{1.0, 2.5, 3.0}), 0.5);
  for (std::size_t at = 0; at < field.size(); ++at) {
    std::vector<double> broken = field;
    broken[at] = not_a_number;
    EXPECT_FALSE(tests::largest_difference(field, broken) < 1e300) << at;
    EXPECT_FALSE(tests::largest_difference(broken, broken) < 1e300) << at;
  }
  const std::vector<double> none;
  EXPECT_FALSE(tests::largest_difference(none, none) < 1e300);
  EXPECT_FALSE(tests::largest_difference(field, none) < 1e300);
  EXPECT_FALSE(
      tests::largest_difference(std::span(field).subspan(0, 2), field) < 1e300);
}

} // namespace asperity::maximum_test
