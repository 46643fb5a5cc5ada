// Tests of robustness/verify_observables.hpp: a correct solution passes, and
// each number that is not finite or out of its range is named.
#include "base/special_numbers.hpp"
#include "robustness/verify_observables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::robustness::verify_observables_test {

class VerifyObservables : public ::testing::Test {
protected:
  VerifyObservables() {
    for (int iy = 0; iy < 16; ++iy)
      for (int ix = 0; ix < 16; ++ix) {
        const double excess =
            0.3 + std::cos(2.0 * std::numbers::pi * ix / 16.0) *
                      std::cos(2.0 * std::numbers::pi * iy / 16.0);
        answer_.pressure.push_back(1e6 * std::max(0.0, excess));
        answer_.gap.push_back(1e-9 * std::max(0.0, -excess));
        answer_.displacement.push_back(1e-9 * excess);
      }
  }

  std::string found() const {
    const AskedContact asked;
    const auto failure = verify_observables(grid_, asked, answer_, 1e9);
    return failure ? failure->detail : "";
  }

  Grid grid_{16, 16, 1e-6, 1e-6};
  contact::ContactSolution answer_;
};

TEST_F(VerifyObservables, PassACorrectSolution) {
  EXPECT_EQ(found(), "");
}

TEST_F(VerifyObservables, FailOnFieldsThatAreNotFinite) {
  for (const double value : {not_a_number, infinity}) {
    const contact::ContactSolution whole = answer_;
    answer_.pressure[0] = value;
    EXPECT_NE(found(), "") << value;
    answer_ = whole;
    answer_.displacement[0] = -value;
    EXPECT_NE(found().find("elastic energy"), std::string::npos) << found();
    answer_ = whole;
  }
}

TEST_F(VerifyObservables, FailOnAnEnergyThatIsGained) {
  for (double& value : answer_.displacement)
    value = -value;

  EXPECT_NE(found().find("elastic energy = -"), std::string::npos) << found();
}

TEST_F(VerifyObservables, FailOnAnException) {
  answer_.displacement.pop_back();

  EXPECT_NE(found().find("an exception"), std::string::npos) << found();
}

results::CurvePoint good_row() {
  results::CurvePoint row;
  row.nominal_pressure = 1e6;
  row.mean_gap = -1e-9;
  row.area_fraction = 1.0;
  row.area_fraction_corrected = not_a_number; // not determined
  return row;
}

// Each member of a row, with the values that it must not have.
TEST(VerifyRow, NamesWhatIsOutOfItsRange) {
  using Row = results::CurvePoint;

  const struct {
    double Row::*member;
    const char* name;
    std::vector<double> wrong;
  } members[] = {
      {&Row::nominal_pressure,
       "nominal_pressure",
       {not_a_number, infinity, -1.0}},
      {&Row::mean_gap, "mean_gap", {not_a_number, infinity, -infinity}},
      {&Row::area_fraction, "area_fraction", {not_a_number, -1e308, 1.1}},
      {&Row::area_fraction_corrected, "corrected", {infinity, -0.1, 1.1}},
      {&Row::area_fraction_fit, "area_fraction_fit", {infinity, -0.1, 1.1}},
      {&Row::area_fraction_moment, "moment", {infinity, -0.1, 1.1}},
      {&Row::contact_perimeter,
       "contact_perimeter",
       {not_a_number, infinity, -1.0}},
      {&Row::elastic_energy, "elastic_energy", {not_a_number, infinity}},
      {&Row::contact_energy, "contact_energy", {not_a_number, infinity, -1.0}},
      {&Row::residual, "residual", {not_a_number, infinity, -1.0}},
      {&Row::cpu_time, "cpu_time", {not_a_number, -1.0}}};

  EXPECT_FALSE(verify_row(good_row()));
  for (const auto& [member, name, wrong] : members)
    for (const double value : wrong) {
      Row row = good_row();
      row.*member = value;
      const auto failure = verify_row(row);
      ASSERT_TRUE(failure) << name << " = " << value;
      EXPECT_NE(failure->detail.find(name), std::string::npos)
          << failure->detail;
    }
}

TEST(VerifyRow, FailsOnIterationsBelowZeroAndOnAStepThatDidNotConverge) {
  results::CurvePoint row = good_row();
  row.iterations = -5;
  EXPECT_TRUE(verify_row(row));

  row = good_row();
  row.status = results::StepStatus::not_converged;
  EXPECT_TRUE(verify_row(row));
}

} // namespace asperity::robustness::verify_observables_test
