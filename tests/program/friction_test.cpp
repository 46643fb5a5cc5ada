// [friction] of a case: load steps, figures, the table of the page, mistakes.
#include "results/result_reader.hpp"
#include "studies/friction/friction.hpp"
#include "tests/program/program.hpp"
#include "tests/rough_case.hpp"
#include "theory/exact/westergaard.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

namespace asperity::program::friction_test {
namespace {

using FrictionTest = ProgramTest;

std::string rough(const std::string& friction,
                  const std::string& halfspace = "") {
  return tests::rough_case("Friction", 32, tests::four_loads,
                           "[halfspace]\ncontact = \"hard\"\n" + halfspace +
                               "[friction]\ncoefficient = 0.5\n" + friction);
}

/// The numbers after the beginning of a line.
std::vector<double> numbers_at(const std::string& table,
                               const std::string& begin) {
  std::vector<double> numbers;
  const std::size_t at = table.find(begin);
  if (at == std::string::npos)
    return numbers;
  std::istringstream line(table.substr(
      at + begin.size(), table.find('\n', at) - at - begin.size()));
  for (std::string word; std::getline(line, word, ',');)
    numbers.push_back(std::stod(word));
  return numbers;
}

} // namespace

// P = 0.02 E* and P - Q/mu = 0.01 E*, of which the case has the second.
TEST_F(FrictionTest, TangentialLoadsAddTheStepsThatTheyNeed) {
  write("slip.toml",
        rough("normal_load = \"0.02 E*\"\ntangential_load = [0.5, 0.25]\n"));
  const Ended slip = run("run slip.toml --out slip");
  ASSERT_EQ(slip.exit_code, 0) << slip.output;

  // Two realisations and the theory.
  EXPECT_NE(slip.output.find("18 steps: 18 computed"), std::string::npos)
      << slip.output;
  const std::string table = text_of(folder / "slip/figures/partial-slip.csv");
  EXPECT_NE(table.find("\"halfspace\",1,0.25,"), std::string::npos) << table;
  EXPECT_NE(table.find("\"halfspace\",1,0.5,"), std::string::npos) << table;
  EXPECT_NE(table.find("\"theory\",0,0.5,"), std::string::npos) << table;
  EXPECT_TRUE(std::filesystem::exists(folder / "slip/figures/"
                                               "traction-halfspace.svg"));
  EXPECT_NE(
      text_of(folder / "slip/report.html").find("load P of 43.96 MPa A_0"),
      std::string::npos);
}

// What a method has no answer to is said at the top, in its row, in
// summary.json and in the list of skipped work.
TEST_F(FrictionTest, TheTheoryAloneIsSaid) {
  write("alone.toml",
        rough("", "hardness = \"0.2 E*\"\n[halfspace.sticky]\nhardness = "
                  "\"1 E*\"\n"));
  const Ended alone = run("run alone.toml --out alone");
  ASSERT_EQ(alone.exit_code, 0) << alone.output;
  const std::string why = "needs a contact without hardness";
  const std::string warning = "[friction] is computed by the theory alone: "
                              "halfspace " +
                              why + ", halfspace.sticky " + why;
  const std::string omission = "[friction] is not computed: " + why;
  const std::string page = text_of(folder / "alone/report.html");
  EXPECT_LT(alone.output.find("warning: " + warning),
            alone.output.find(" step "))
      << alone.output;
  EXPECT_NE(alone.output.find("halfspace.sticky: " + omission),
            std::string::npos)
      << alone.output;
  EXPECT_LT(page.find(warning), page.find("<figure")) << page.size();
  EXPECT_NE(page.find("; " + omission + "</td>"), std::string::npos);
  EXPECT_NE(page.find("<td>halfspace: [friction]</td><td>" + why + "</td>"),
            std::string::npos);
  const std::string summary = text_of(folder / "alone/summary.json");
  EXPECT_NE(summary.find('"' + omission + '"'), std::string::npos) << summary;
  EXPECT_NE(summary.find("\"kind\": \"omitted\""), std::string::npos);

  for (const char* const option : {"--hardness", "--work-of-adhesion"}) {
    const Ended both = run("run alone.toml --out both --friction 0.5 " +
                           std::string(option) + " 1e9");
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_NE(both.output.find(std::string("--friction cannot be combined "
                                           "with ") +
                               option),
              std::string::npos)
        << both.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "both"));
  }
}

// A wave front of rigid ridges along y, on nu = 0.3. Westergaard's normal
// contact is that of each row of nodes; along the ridges the tangential
// compliance is 1/(1 - nu) times the normal one, and across them it is the
// normal one. So at Q = mu P/2 the displacements are mu (D - D') and that over
// 0.7.
TEST_F(FrictionTest, RidgesYieldMoreAlongThanAcross) {
  write("ridges.toml", R"(schema = 1
title = "a wave front pulled across its ridges"
[surface]
kind = "wave-1d"
length = "1 mm"
points = 128
amplitude = "1 um"
wavelength = "1 mm"
[material]
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = ["5 MPa", "10 MPa", "20 MPa"]
[halfspace]
contact = "hard"
[friction]
coefficient = 0.3
)");
  const Ended ridges = run("run ridges.toml --out ridges");
  ASSERT_EQ(ridges.exit_code, 0) << ridges.output;
  const results::Result result =
      results::read_result((folder / "ridges/result.h5").string());
  const std::vector<results::CurvePoint>& rows =
      result.methods.front().realizations.front().points;
  ASSERT_EQ(rows.size(), 3U);

  // Westergaard: p_0/p* = sin^2(pi a/L), and u = A [..] of theory/exact; its
  // difference is that of the approaches.
  const theory::WestergaardContact exact(1e-6, 1e-3, 200e9 / 0.91);
  const double across = 0.3 * (exact.mean_gap(10e6) - exact.mean_gap(20e6));
  EXPECT_NEAR(0.3 * (rows[1].mean_gap - rows[2].mean_gap), across,
              2e-3 * across);
  const std::string table = text_of(folder / "ridges/figures/partial-slip.csv");
  const std::vector<double> row = numbers_at(table, "\"halfspace\",0,0.5,");
  ASSERT_GE(row.size(), 10U) << table;
  EXPECT_NEAR(row[0], 1e9 * across, 0.04);
  EXPECT_NEAR(row[9], 1e9 * across / 0.7, 0.06);
  // One linear solve: the contact of a row is a strip of half-width a, whose
  // stiffness is pi E*/(2 L ln(1/sin(pi a/L))).
  const double half = rows[1].area_fraction / 2.0;
  const double stiffness =
      std::numbers::pi * (200e9 / 0.91) /
      (2e-3 * -std::log(std::sin(std::numbers::pi * half)));
  EXPECT_NEAR(rows[1][columns::stick_stiffness.x] / stiffness, 1.0, 0.05);
  EXPECT_NEAR(rows[1][columns::stick_stiffness.y] /
                  rows[1][columns::stick_stiffness.x],
              0.7, 1e-9);
}

} // namespace asperity::program::friction_test
