// [spots] and [conductance] of a case: columns of the curve, the cache, and
// mistakes.
#include "tests/program/program.hpp"

#include <numbers>

namespace asperity::program::conductance_test {
namespace {

/// The sphere of Hertz, pressed once on a half-space.
const std::string sphere = R"(schema = 1
title = "Conductance"
[surface]
kind = "sphere"
radius = "1 mm"
length = "100 um"
points = 64
[material]
contact_modulus = "2 GPa"
[load]
nominal_pressure = ["2 MPa", "8 MPa"]
)";

const std::string free_halfspace = R"([halfspace]
contact = "hard"
boundaries = "free"
)";

std::string heat(const std::string& conductivity) {
  return "[conductance]\nthermal_conductivity = \"" + conductivity +
         "\"\ncounter_thermal_conductivity = \"20 W/(m K)\"\n"
         "resistivity = \"20 nOhm m\"\ncounter_resistivity = \"60 nOhm m\"\n";
}

/// The numbers of a column of curves.csv.
std::vector<double> column_of(const std::string& csv, const std::string& name) {
  const auto columns = columns_of(csv, "halfspace");
  std::vector<double> column;
  for (const std::string& cell : columns.at(name))
    column.push_back(std::stod(cell));
  return column;
}

using ConductanceTest = ProgramTest;

// One spot of radius a has the stiffness 2 E* a and Holm's conductance 2 a k.
// Tolerance: the border of the spot is a staircase of 4 % of its radius.
TEST_F(ConductanceTest, OfASphereIsThatOfHolm) {
  const std::string text = sphere + free_halfspace + "[spots]\n";
  write("poor.toml", text + heat("5 W/(m K)"));
  write("good.toml", text + heat("20 W/(m K)"));
  const Ended poor = run("run poor.toml --out poor");
  ASSERT_EQ(poor.exit_code, 0) << poor.output;
  const Ended good = run("run good.toml --out good");
  ASSERT_EQ(good.exit_code, 0) << good.output;
  EXPECT_NE(good.output.find("2 steps: 0 computed, 2 from the cache"),
            std::string::npos)
      << good.output;
  const std::string csv = text_of(folder / "poor/curves.csv");
  const std::string other = text_of(folder / "good/curves.csv");
  const auto radii = column_of(csv, "spot_radii [1/m]");
  const auto relative = column_of(csv, "relative_conductance [1/m]");
  const auto stiffness = column_of(csv, "normal_stiffness [N/m]");
  const auto thermal = column_of(csv, "thermal_conductance [W/(m^2 K)]");
  const auto better = column_of(other, "thermal_conductance [W/(m^2 K)]");
  const auto electrical =
      column_of(csv, "electrical_conductance [1/(Ohm m^2)]");
  ASSERT_EQ(relative.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(relative[i] / (2.0 * radii[i]), 1.0, 0.02);
    EXPECT_DOUBLE_EQ(stiffness[i], relative[i] * 2e9 * 1e-8);
    EXPECT_DOUBLE_EQ(thermal[i], relative[i] * 8.0); // 2/(1/5 + 1/20)
    EXPECT_DOUBLE_EQ(better[i], relative[i] * 20.0);
    EXPECT_DOUBLE_EQ(electrical[i], relative[i] * 2.0 / 80e-9);
    EXPECT_EQ(column_of(csv, "spot_count [1]")[i], 1.0);
    EXPECT_NEAR(std::numbers::pi * radii[i] * radii[i] * 1e-8 /
                    column_of(csv, "area_fraction [1]")[i],
                1.0, 1e-9);
    // The gap of a free border reaches its sides, the spot none.
    EXPECT_EQ(column_of(csv, "spots_percolate_x [1]")[i], 0.0);
    EXPECT_EQ(column_of(csv, "gap_percolates_y [1]")[i], 1.0);
  }
  for (const char* figure : {"conductance", "spots-halfspace"})
    EXPECT_TRUE(std::filesystem::exists(folder / "poor/figures" /
                                        (std::string(figure) + ".svg")))
        << figure;
}

// A medium adds to the spots, the more the better it conducts. A full block
// conducts by Laplace's equation on its own mesh. Tolerance: its border of the
// contact against that of the half-space.
TEST_F(ConductanceTest, OfTheGapAndOfAFullBlock) {
  const std::string text =
      "schema = 1\ntitle = \"Heat\"\n[surface]\nkind = \"sphere\"\n"
      "radius = \"1 mm\"\nlength = \"100 um\"\npoints = 32\n"
      "[material]\nyoungs_modulus = \"2 GPa\"\npoisson_ratio = 0.3\n"
      "[load]\nnominal_pressure = \"8 MPa\"\n"
      "[halfspace]\ncontact = \"hard\"\n"
      "[fem]\nsolver = \"full\"\nelement = \"Q2\"\ncontact = \"hard\"\n"
      "depth = \"1 length\"\n" +
      heat("5 W/(m K)") + "smallest_gap = \"1 um\"\ngap_conductivity = ";
  std::vector<double> added;
  for (const char* medium : {"0.026", "0.6"}) {
    write("case.toml", text + medium + "\n");
    const Ended ended = run("run case.toml --out " + std::string(medium));
    ASSERT_EQ(ended.exit_code, 0) << ended.output;
    const std::string csv = text_of(folder / medium / "curves.csv");
    std::vector<double> spots;
    for (const char* method : {"halfspace", "fem"}) {
      const auto columns = columns_of(csv, method);
      const auto number = [&](const char* name) {
        return std::stod(columns.at(name).front());
      };
      spots.push_back(number("relative_conductance [1/m]"));
      added.push_back(number("relative_gap_conductance [1/m]"));
      EXPECT_DOUBLE_EQ(number("thermal_conductance [W/(m^2 K)]"),
                       8.0 * (spots.back() + added.back()));
      EXPECT_GT(added.back(), 0.0);
    }
    EXPECT_NE(spots[1], spots[0]);
    EXPECT_NEAR(spots[1] / spots[0], 1.0, 0.05);
  }
  ASSERT_EQ(added.size(), 4U);
  EXPECT_GT(added[2], 10.0 * added[0]);
}

} // namespace
} // namespace asperity::program::conductance_test
