// Tests of reports/sweeps/sweep_axis.hpp: the values of a swept key lie at
// their numbers, also in different units of one dimension.
#include "reports/sweeps/sweep_axis.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity::reports::sweep_axis_test {

FigureAxis axis_with(const std::vector<std::string>& values) {
  cases::SweptKey key;
  key.key = "surface.length";
  key.values = values;
  return axis_of(key);
}

TEST(SweepAxis, HasOneUnit) {
  const FigureAxis axis =
      axis_with({"\"500 nm\"", "\"1 um\"", "\"2 \u00b5m\"", "\"0.1 mm\""});

  ASSERT_TRUE(axis.is_numeric);
  EXPECT_EQ(axis.title, "surface.length [nm]");
  const std::vector<double> positions{500.0, 1000.0, 2000.0, 1e5};
  ASSERT_EQ(axis.positions.size(), positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    EXPECT_NEAR(axis.positions[i] / positions[i], 1.0, 1e-15);
}

TEST(SweepAxis, HasThePlacesOfOtherValues) {
  for (const std::vector<std::string>& values :
       {std::vector<std::string>{"\"1 um\"", "\"2 h\""},
        std::vector<std::string>{"\"hard\"", "\"dugdale\""},
        std::vector<std::string>{"\"1 nm\"", "\"1 MPa\""}}) {
    const FigureAxis axis = axis_with(values);

    EXPECT_FALSE(axis.is_numeric) << values[0];
    EXPECT_EQ(axis.positions, (std::vector<double>{0.0, 1.0}));
  }
  EXPECT_EQ(axis_with({"0.5", "0.7"}).positions,
            (std::vector<double>{0.5, 0.7}));
  EXPECT_EQ(axis_with({"\"0.1 E*\"", "\"0.2 E*\""}).title,
            "surface.length [E*]");
}

} // namespace asperity::reports::sweep_axis_test
