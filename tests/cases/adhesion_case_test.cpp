// Tests of the keys of contact with adhesion.
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace asperity::cases::adhesion_case_test {

/// A wave of a half-space with further keys, under given loads.
std::string sticky(const std::string& keys, const std::string& load) {
  return "schema = 1\n[surface]\nkind = \"wave-1d\"\nlength = 1e-6\n"
         "points = 64\namplitude = 1e-8\nwavelength = \"1 length\"\n"
         "[material]\ncontact_modulus = \"2 GPa\"\npoisson_ratio = 0.3\n"
         "[load]\n" +
         load + "\n[halfspace]\n" + keys;
}

const std::string law = "contact = \"exponential\"\n"
                        "work_of_adhesion = \"50 mJ/m^2\"\nrange = \"0.5 h\"\n";
const std::string pressed = "nominal_pressure = \"1 MPa\"";

void expect_mistake(const std::string& text, const std::string& words) {
  const std::string answer = mistakes_of(text);
  EXPECT_NE(answer.find(words), std::string::npos) << answer;
}

TEST(AdhesionCase, ReadsTheLaw) {
  const Case read = read_case_text(sticky(law, pressed), "it/case.toml");

  const auto& contact =
      std::get<mechanics::HalfspaceSettings>(read.methods.at(0).settings)
          .contact;
  const mechanics::ContactInterface found =
      contact.in_si({.length = 1e-6, .spacing = 4e-9});
  EXPECT_EQ(found.law, mechanics::ContactLaw::exponential);
  EXPECT_EQ(found.work_of_adhesion, 0.05);
  EXPECT_DOUBLE_EQ(found.adhesion_range, 2e-9);
  EXPECT_TRUE(read.methods.at(0).is_adhesive());
}

TEST(AdhesionCase, MayBePulled) {
  const Case listed = read_case_text(
      sticky(law, "nominal_pressure = [\"1 MPa\", 0, \"-1 MPa\"]"),
      "it/case.toml");
  const Case swept = read_case_text(
      sticky(law, "nominal_pressure = { from = \"1 MPa\", to = \"-1 MPa\", "
                  "steps = 3, spacing = \"linear\" }"),
      "it/case.toml");

  for (const Case& read : {listed, swept}) {
    ASSERT_EQ(read.load.targets.size(), 3U);
    EXPECT_EQ(read.load.targets[1].value, 0.0);
    EXPECT_EQ(read.load.targets[2].value, -1e6);
    EXPECT_EQ(read.load.is_unloading, std::vector({false, true, true}));
  }
}

// Loads that are lighter than an earlier one are on the way back where the
// answer depends on the path, and nowhere else.
TEST(AdhesionCase, IsUnloadedByAListThatFalls) {
  const auto is_unloading = [](const std::string& contact,
                               const std::string& load) {
    return read_case_text(sticky(contact, load), "it/case.toml")
        .load.is_unloading;
  };
  const std::string gaps = "mean_gap = [\"2 h_rms\", \"1 h_rms\", \"2 "
                           "h_rms\", \"1 h_rms\"]";
  const std::string pressures =
      "nominal_pressure = [\"1e-3 E*\", \"1e-2 E*\", 0, \"1e-3 E*\"]";

  EXPECT_EQ(is_unloading(law, gaps), std::vector({false, false, true, false}));
  EXPECT_EQ(is_unloading(law, pressures),
            std::vector({false, false, true, true}));
  EXPECT_EQ(is_unloading("contact = \"hard\"\n", gaps),
            std::vector({false, false, false, false}));
}

TEST(AdhesionCase, MayHaveFreeBoundariesOrNoWall) {
  const std::string tension = "nominal_pressure = [\"1 MPa\", \"-1 MPa\"]";
  EXPECT_EQ(mistakes_of(sticky(law + "boundaries = \"free\"\n", tension)), "");
  for (const std::string name : {"lennard-jones-10-4", "morse"})
    EXPECT_EQ(mistakes_of(sticky("contact = \"" + name +
                                     "\"\nwork_of_adhesion = \"50 mJ/m^2\"\n",
                                 tension)),
              "");
}

TEST(AdhesionCase, MayBeHeldByASpring) {
  const Case read = read_case_text(
      sticky(law, "mean_gap = [\"9 nm\", \"1 nm\"]\nspring = \"1e15 Pa/m\""),
      "it/case.toml");
  const mechanics::LoadTarget target = read.load.target(1, {});
  EXPECT_EQ(target.control, mechanics::Control::mean_gap);
  EXPECT_EQ(target.amount, 1e-9);
  EXPECT_EQ(target.spring, 1e15);

  // The far end of a soft spring is beyond the surface; a gap is not.
  for (const char* const ends :
       {"[\"-9 nm\", 0.0]",
        "{ from = \"-9 nm\", to = \"-1 nm\", steps = 2, spacing = "
        "\"linear\" }"})
    EXPECT_LT(read_case_text(sticky(law, std::string("mean_gap = ") + ends +
                                             "\nspring = \"1e9 Pa/m\""),
                             "case.toml")
                  .load.target(0, {})
                  .amount,
              0.0);
  expect_mistake(sticky(law, "mean_gap = \"-9 nm\""),
                 "load.mean_gap = \"-9 nm\", but must be");
  expect_mistake(sticky(law, "nominal_pressure = 0\nspring = \"1e15 Pa/m\""),
                 "load.spring = \"1e15 Pa/m\", but needs mean_gap");
  expect_mistake(sticky("contact = \"hard\"\n",
                        "mean_gap = \"1 nm\"\nspring = \"1e15 Pa/m\""),
                 "load.spring = \"1e15 Pa/m\", but needs adhesion in all "
                 "methods, none of them [md]");
}

TEST(AdhesionCase, IsPulledByEqualStepsOnly) {
  expect_mistake(sticky(law, "nominal_pressure = { from = \"1 MPa\", to = "
                             "\"-1 MPa\", steps = 3, spacing = \"log\" }"),
                 "load.nominal_pressure.to = \"-1 MPa\", but must be > 0, or "
                 "needs spacing = \"linear\"");
}

TEST(AdhesionCase, IsNeededForTension) {
  expect_mistake(
      sticky("contact = \"hard\"\n",
             "nominal_pressure = [\"1 MPa\", \"-1 MPa\"]"),
      "load.nominal_pressure = \"-1 MPa\", but must be > 0 [Pa], unless all "
      "methods have adhesion, none of them [md]");
  expect_mistake(sticky(law + "[winkler]\nstiffness = \"0.05 E*/h\"\n",
                        "nominal_pressure = 0"),
                 "load.nominal_pressure = 0, but must be > 0 [Pa], unless all "
                 "methods have adhesion, none of them [md]");
  expect_mistake(sticky(law + "[md]\npotential = \"lennard-jones\"\n",
                        "nominal_pressure = 0"),
                 "load.nominal_pressure = 0, but must be > 0 [Pa]");
}

TEST(AdhesionCase, NeedsItsKeys) {
  expect_mistake(sticky("contact = \"dugdale\"\nrange = \"1 nm\"\n", pressed),
                 "halfspace.work_of_adhesion is missing, which this contact "
                 "needs");
  expect_mistake(sticky("work_of_adhesion = \"50 mJ/m^2\"\n", pressed),
                 "halfspace.work_of_adhesion = \"50 mJ/m^2\", but needs a "
                 "contact with adhesion: contact = \"exponential\", "
                 "\"dugdale\", \"cubic\", \"lennard-jones\", "
                 "\"lennard-jones-10-4\" or \"morse\"");
  expect_mistake(sticky("contact = \"cubic\"\nrange = -1\n"
                        "work_of_adhesion = \"50 mJ/m^2\"\n",
                        pressed),
                 "halfspace.range = -1, but must be > 0 [m]");
}

TEST(AdhesionCase, IsRefusedWhereNoSolverHasIt) {
  expect_mistake(sticky(law + "boundaries = \"free\"\n", "mean_gap = \"1 nm\""),
                 "halfspace has free boundaries (here or by surface.edges = "
                 "\"free\"), but [load] prescribes mean gaps: please prescribe "
                 "nominal_pressure");
  expect_mistake(sticky("\n[fem]\nelement = \"Q2\"\n" + law, pressed),
                 "fem.contact = \"exponential\", but only blocks with element "
                 "= \"Q1\" and solver = \"condensed\" have adhesion in this "
                 "version");
}

} // namespace asperity::cases::adhesion_case_test
