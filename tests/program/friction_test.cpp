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
  EXPECT_NE(text_of(folder / "slip/report.html").find("load P of 43.96 MPa A_0"),
            std::string::npos);
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
