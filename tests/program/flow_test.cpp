// [flow] of a case: columns of the curve, the cache, and mistakes.
#include "tests/program/program.hpp"

namespace asperity::program::flow_test {
namespace {

const std::string problem = R"(schema = 1
title = "Flow"
[surface]
kind = "self-affine"
length = "10 um"
points = 64
seed = 3
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.25 length"
wavelength_short = "8 h"
[material]
contact_modulus = "2 GPa"
[load]
nominal_pressure = ["2e-3 E*", "0.15 E*"]
[theory]
gamma = 0.42
spectrum = "surface"
)";

const std::string halfspace = R"([halfspace]
contact = "hard"
)";

std::string water(double viscosity) {
  return "[flow]\nviscosity = " + std::to_string(viscosity) +
         "\npressure_drop = \"10 kPa\"\n";
}

using FlowTest = ProgramTest;

TEST_F(FlowTest, RowsHaveFlowAndTheCacheKeepsItForAnotherFluid) {
  write("thin.toml", problem + halfspace + water(1e-3));
  write("thick.toml", problem + halfspace + water(4e-3));
  const Ended thin = run("run thin.toml --out thin");
  ASSERT_EQ(thin.exit_code, 0) << thin.output;
  const Ended thick = run("run thick.toml --out thick");
  ASSERT_EQ(thick.exit_code, 0) << thick.output;
  EXPECT_NE(thick.output.find("4 steps: 0 computed, 4 from the cache"),
            std::string::npos)
      << thick.output;
  for (const std::string method : {"halfspace", "theory"}) {
    auto first = columns_of(text_of(folder / "thin/curves.csv"), method);
    auto second = columns_of(text_of(folder / "thick/curves.csv"), method);
    for (const std::string leak :
         {"leak_rate_x [m^3/s]", "leak_rate_y [m^3/s]"}) {
      ASSERT_EQ(first[leak].size(), 2U);
      EXPECT_GT(std::stod(first[leak][0]), 0.0);
      EXPECT_EQ(std::stod(first[leak][0]), 4.0 * std::stod(second[leak][0]));
    }
    // At the second load contact is nearly full: nothing joins the sides.
    EXPECT_EQ(std::stod(first["leak_rate_x [m^3/s]"][1]), 0.0) << method;
    EXPECT_EQ(std::stod(first["critical_gap_x [m]"][1]), 0.0) << method;
    EXPECT_LT(std::stod(first["flow_factor_x [1]"][0]), 1.0);
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "thin/figures/leak-rate.svg"));
}

TEST_F(FlowTest, NoFlowNoColumns) {
  write("dry.toml", problem + halfspace);
  const Ended dry = run("run dry.toml --out dry");
  ASSERT_EQ(dry.exit_code, 0) << dry.output;
  const std::string csv = text_of(folder / "dry/curves.csv");
  EXPECT_NE(csv.find("area_fraction"), std::string::npos);
  EXPECT_EQ(csv.find("flow_factor"), std::string::npos);
}

} // namespace
} // namespace asperity::program::flow_test
