// Verifies that methods/timed_operator.hpp changes no result that a solver
// obtains from the operator, in particular none that determines how it solves.
#include "contact/operators/halfspace.hpp"
#include "methods/timed_operator.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace asperity::methods::timed_operator_test {

TEST(TimedOperator, EqualsTheOperatorThatItMeasures) {
  const Grid grid{64, 64, 1.0, 1.0};
  contact::FourierOperator plain =
      contact::halfspace_operator(grid, {1.0, 0.3, 0.2});
  const auto tally = std::make_shared<TimedOperator::Tally>();
  TimedOperator timed(plain.clone(), tally, 1);

  EXPECT_TRUE(plain.is_shift_invariant());
  EXPECT_TRUE(timed.is_shift_invariant());
  EXPECT_TRUE(timed.clone()->is_shift_invariant());
  ASSERT_NE(timed.coarsened(), nullptr);
  EXPECT_EQ(timed.coarsened()->grid(), plain.coarsened()->grid());
  EXPECT_EQ(timed.short_wave_compliance(), plain.short_wave_compliance());
  EXPECT_EQ(timed.nodal_weights().size(), plain.nodal_weights().size());
  EXPECT_EQ(timed.threads(), plain.threads());

  std::vector<double> pressure(grid.size());
  pressure[17] = 1.0;
  std::vector<double> one(grid.size()), other(grid.size());
  plain.displacement(pressure, one);
  timed.displacement(pressure, other);
  EXPECT_EQ(one, other);
  EXPECT_GE(tally->cpu_time, 0.0);
}

} // namespace asperity::methods::timed_operator_test
