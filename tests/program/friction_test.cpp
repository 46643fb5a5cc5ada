// [friction] of a case: load steps, figures, the table of the page, mistakes.
#include "tests/program/program.hpp"
#include "tests/rough_case.hpp"

namespace asperity::program::friction_test {
namespace {

using FrictionTest = ProgramTest;

std::string rough(const std::string& friction,
                  const std::string& halfspace = "") {
  return tests::rough_case("Friction", 32, tests::four_loads,
                           "[halfspace]\ncontact = \"hard\"\n" + halfspace +
                               "[friction]\ncoefficient = 0.5\n" + friction);
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

TEST_F(FrictionTest, MistakesAreAnswered) {
  const auto refused = [&](const std::string& text, const std::string& reason) {
    write("wrong.toml", text);
    const Ended wrong = run("run wrong.toml");
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_NE(wrong.output.find(reason), std::string::npos) << wrong.output;
  };
  refused(rough("normal_load = \"1 E* h'\"\n"), "must be in E* h' where");
  refused(rough("tangential_load = 1\n"), "must be between 0 and 1");
  refused(rough("tangential_load = 0.5\n[load.x]\n"), "load.x");
  std::string slab = rough("", "thickness = \"1 length\"\n");
  slab.replace(slab.find("[theory]\ngamma = 0.42\n"), 22, "");
  refused(slab, "[halfspace] without thickness");
}

} // namespace asperity::program::friction_test
