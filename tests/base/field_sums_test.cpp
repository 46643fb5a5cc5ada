// Tests of base/field_sums.hpp.
#include "base/field_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity::field_sums_test {

TEST(RmsHeight, IsThatAboutTheMean) {
  EXPECT_DOUBLE_EQ(rms_height(std::vector{1.0, -1.0}), 1.0);
  EXPECT_DOUBLE_EQ(rms_height(std::vector{1001.0, 999.0}), 1.0);
  EXPECT_EQ(rms_height(std::vector{5.0, 5.0, 5.0}), 0.0);
}

TEST(RmsHeight, IsNaNWithoutNumbers) {
  EXPECT_TRUE(std::isnan(rms_height({})));
  EXPECT_TRUE(std::isnan(rms_height(std::vector{1.0, std::nan("")})));
  EXPECT_TRUE(std::isnan(rms_height(std::vector{1.0, HUGE_VAL})));
}

} // namespace asperity::field_sums_test
