// Tests of the exact messages about invalid cases.
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace asperity::cases::mistakes_test {

/// The messages about a case with a rough surface and these overrides, one per
/// line.
std::string mistakes_in(const std::vector<std::string>& overrides) {
  return mistakes_of(contact_case, overrides);
}

TEST(Mistakes, AreShownAllAtOnceInTheOrderOfTheFile) {
  const std::string text = "schema = 2\n"
                           "[surfaces]\n"
                           "[surface]\n"
                           "kind = \"wave-1d\"\n"
                           "lenght = \"1 um\"\n"
                           "points = 7\n"
                           "amplitude = \"1 MPa\"\n"
                           "wavelength = \"0.5 um\"\n"
                           "[material]\n"
                           "poisson_ratio = 0.7\n"
                           "[load]\n"
                           "cycle = \"lode\"\n"
                           "[halfspace]\n"
                           "contact = 3\n";

  EXPECT_EQ(
      mistakes_of(text),
      "  case.toml:1: schema = 2, but must be 1 [1]\n"
      "  case.toml:2: surfaces is not a table of a case file; nearest: "
      "surface\n"
      "  case.toml:3: surface.length is missing: a number [m] or a string with "
      "one of: m, mm, um, nm, angstrom\n"
      "  case.toml:5: surface.lenght is not a key of this table; nearest: "
      "length\n"
      "  case.toml:6: surface.points = 7, but must be even\n"
      "  case.toml:7: surface.amplitude = \"1 MPa\" has the unit MPa of a "
      "pressure, but must have one of: m, mm, um, nm, angstrom, length, h\n"
      "  case.toml:9: material.youngs_modulus is missing (or contact_modulus): "
      "a number [Pa] or a string with one of: Pa, kPa, MPa, GPa\n"
      "  case.toml:10: material.poisson_ratio = 0.7, but must be between "
      "-0.999 and 0.4999 [1]\n"
      "  case.toml:11: load.nominal_pressure is missing (or mean_gap): a "
      "quantity, a list of them, or { from, to, steps, spacing }\n"
      "  case.toml:12: load.cycle = \"lode\", but must be load | load-unload; "
      "nearest: load\n"
      "  case.toml:14: halfspace.contact = 3, but must be penalty | hard | "
      "augmented | exponential | dugdale | cubic | lennard-jones | "
      "lennard-jones-10-4 | morse\n");
}

TEST(Mistakes, NameTheMissingTables) {
  EXPECT_EQ(mistakes_of("schema = 1\n"),
            "  case.toml:1: the table [surface] is missing\n"
            "  case.toml:1: no method is given; allowed: [theory], "
            "[halfspace], [fem], [md], [winkler]\n"
            "  case.toml:1: the table [material] is missing\n"
            "  case.toml:1: the table [load] is missing\n");
}

TEST(Mistakes, NameTheTableOfAKey) {
  EXPECT_EQ(mistakes_in({"fem.gamma=0.4"}),
            "  --set: fem.gamma is not a key of this table; it belongs to "
            "[theory]\n");
  EXPECT_EQ(mistakes_in({"theory.seed=1"}),
            "  --set: theory.seed is not a key of this table; it belongs to "
            "[surface] or [material.variation] or [md]\n");
}

TEST(Mistakes, NameTheValueOfAKey) {
  EXPECT_EQ(mistakes_in({"load.steps=3"}),
            "  --set: load.steps is not a key of this table; it belongs to "
            "the value of nominal_pressure or mean_gap\n");
}

TEST(Mistakes, OfAnInheritedKeyAreSaidOnce) {
  EXPECT_EQ(mistakes_in({"fem.growth=9", "fem.hard.contact=hard"}),
            "  --set: fem.growth = 9, but must be between 1 and 4 [1]\n");
}

// One override and one message for every kind of mistake in a case with a rough
// surface.
TEST(Mistakes, StateWhatIsFoundAndWhatIsAllowed) {
  const std::vector<std::pair<std::string, std::string>> answers = {
      {"surface.seed=-1", "surface.seed = -1, but must be a whole number >= 0"},
      {"surface.points=12.5",
       "surface.points = 12.5, but must be a whole number"},
      {"surface.points=2",
       "surface.points = 2, but must be between 4 and 65536 [1]"},
      {"surface.hurst=nan",
       "surface.hurst = nan, but must be > 0 and <= 1 [1]"},
      {"halfspace.tolerance=1e-30",
       "halfspace.tolerance = 1e-30, but must be between 1e-15 and 0.01 [1]"},
      {"surface.length=0", "surface.length = 0, but must be > 0 [m]"},
      {"surface.length=1e-17", "surface.length = 1e-17, but must have "
                               "a magnitude between 1e-16 and 1e+16 [m]"},
      {"material.youngs_modulus=1e22 Pa",
       "material.youngs_modulus = \"1e22 Pa\", but must have a "
       "magnitude between 1e-15 and 1e+21 [Pa]"},
      {"load.nominal_pressure=1e-16 E*",
       "load.nominal_pressure = \"1e-16 E*\", but must have a "
       "magnitude between 1e-15 and 1000000000 [E*]"},
      {"surface.length=\"3 h\"",
       "surface.length = \"3 h\" has the unit h of a length, but must have one "
       "of: m, mm, um, nm, angstrom"},
      {"surface.rescale=yes",
       "surface.rescale = \"yes\", but must be true | false"},
      {"surface.rms_slope=0.1", "surface.rms_slope and surface.rms_height are "
                                "both given; give only one of them"},
      {"surface.wavevector_low=1.3e6",
       "surface.wavelength_long and surface.wavevector_low are both given; "
       "give only one of them"},
      {"surface.wavelength_long=20 um",
       "surface.wavelength_long = \"20 um\", but the longest wavelength that "
       "fits is \"1 length\", 628318.5 1/m"},
      {"surface.wavelength_short=1.9 h",
       "surface.wavelength_short = \"1.9 h\", but the shortest wavelength of "
       "the grid is \"2 h\", 1.608495e+08 1/m"},
      {"surface.kind=rough",
       "surface.kind = \"rough\", but must be self-affine | spectrum | "
       "measured | sphere | wave-1d | wave-2d | punch | cone | rounded-punch; "
       "nearest: punch"},
      {"surface.radius=1",
       "surface.radius = 1 does not apply to kind = "
       "\"self-affine\"; it belongs to sphere, punch, rounded-punch"},
      {"surface=3", "surface = 3, but must be a table: [surface]"},
      {"material.contact_modulus=1e9",
       "material.youngs_modulus and material.contact_modulus are both given; "
       "give only one of them"},
      {"material.counter=1",
       "material.counter = 1, but must be a table: [material.counter]"},
      {"load.mean_gap=1e-8", "load.mean_gap and load.nominal_pressure are both "
                             "given; give only one of them"},
      {"load.nominal_pressure=[]",
       "load.nominal_pressure = [], but must be a quantity, a list of them, or "
       "{ from, to, steps, spacing }"},
      {"load.nominal_pressure=[1e6, \"-1 Pa\"]",
       "load.nominal_pressure = \"-1 Pa\", but must be > 0 [Pa], unless all "
       "methods have adhesion, none of them [md]"},
      {"load.nominal_pressure.to=1 GPa",
       "load.nominal_pressure.to = \"1 GPa\", but must have the same kind of "
       "unit as from: both in SI or both in the same unit of the problem"},
      {"load.nominal_pressure.steps=1",
       "load.nominal_pressure.steps = 1, but must be between 2 and 10000 [1]"},
      {"load.nominal_pressure.step=4",
       "load.nominal_pressure.step is not a key of this table; nearest: steps"},
      {"theory.gamma=", "theory.gamma is missing: a number"},
      {"theory.gamma=0", "theory.gamma = 0, but must be > 0 and <= 1 [1]"},
      {"theory.loss_factor=\"wang\"",
       "theory.loss_factor = \"wang\", but must be yang-persson | wang-mueser "
       "| xu; nearest: xu"},
      {"fem.penalty=", "fem.penalty is missing, which this contact needs: a "
                       "number [Pa/m] or a string with one of: Pa/m, E*/h"},
      {"fem.Hard.contact=hard", "fem.Hard names a variant, but must consist of "
                                "the letters a-z, digits and hyphens"},
      {"fem.tolerance=1",
       "fem.tolerance = 1, but must be between 1e-15 and 0.01 [1]"},
      {"fem.growth=1979-05-27", "fem.growth = a date or time, but must be a "
                                "number"},
      {"halfspace=true", "halfspace = true, but must be a table: [halfspace]"},
      {"report.fields=some", "report.fields = \"some\", but must be a whole "
                             "number, \"none\" or \"all\""},
      {"report.fields=-1",
       "report.fields = -1, but must be between 0 and 1000000 [1]"},
      {"title=[3]", "title = [3], but must be a string"},
  };
  for (const auto& [entry, answer] : answers) {
    const std::string mistakes = mistakes_in({entry});
    ASSERT_NE(mistakes.find(answer.substr(0, 6)), std::string::npos)
        << entry << "\n"
        << mistakes;
    const std::string last_line =
        mistakes.substr(mistakes.find(answer.substr(0, 6)));
    EXPECT_NE(mistakes.find(": " + answer + "\n"), std::string::npos)
        << entry << "\n"
        << last_line;
  }
}

TEST(Mistakes, NameTheMistakeOfAnExpectation) {
  const std::vector<std::pair<std::string, std::string>> answers = {
      {"expect.gamma_theory={ below = 1 }",
       "expect.gamma_theory is not a key of this table; since version 0.2 it "
       "is "
       "gamma_curve"},
      {"expect.gama_slope={ below = 1 }",
       "expect.gama_slope is not a key of this table; nearest: gamma_slope"},
      {"expect.kappa=2", "expect.kappa = 2, but must be { value, within } or "
                         "{ below } or { above }, or a list of such bands"},
      {"expect.kappa={ value = 2, below = 3 }",
       "expect.kappa must have value and within, or below, or above (or both "
       "of these)"},
      {"expect.kappa={ value = 2 }",
       "expect.kappa.within is missing: a number or a string like \"5 %\""},
      {"expect.kappa={ value = 2, within = \"5\" }",
       "expect.kappa.within = \"5\", but must be a number >= 0 or a string "
       "like \"5 %\""},
      {"expect.kappa={ above = 2, below = 1 }",
       "expect.kappa is empty: above exceeds below"},
      {"expect.kappa={ above = 2, methods = [\"fam\"] }",
       "expect.kappa.methods names \"fam\", but the methods of this case that "
       "compute kappa are: theory, halfspace, fem; nearest: fem"},
      {"expect.penetration={ below = 1, methods = [\"theory\"] }",
       "expect.penetration.methods names \"theory\", but the methods of this "
       "case that compute penetration are: halfspace, fem; nearest: fem"},
      {"expect.pressure_difference={ below = 1, methods = [\"fem.hard\"] }",
       "expect.pressure_difference.methods names methods, but none of this "
       "case computes pressure_difference"},
      {"expect.kappa={ above = 2, if_undecided = \"passed\" }",
       "expect.kappa.if_undecided = \"passed\", but must be fail | pass; "
       "nearest: pass"},
      {"expect.kappa={ above = 2, methods = \"fem\" }",
       "expect.kappa.methods = \"fem\", but must be a list of strings"},
      {"expect.mean_gap_error={ below = 1 }",
       "expect.mean_gap_error is defined only for the surfaces wave-1d, "
       "wave-2d"},
  };
  for (const auto& [entry, answer] : answers)
    EXPECT_EQ(mistakes_in({entry}), "  --set: " + answer + "\n") << entry;
}

TEST(Mistakes, StateThatAnExpectationNeedsTheTheory) {
  const std::string mistakes =
      mistakes_in({"theory=", "expect=", "expect.area_excess={ below = 1 }"});

  EXPECT_EQ(mistakes, "  --set: expect.area_excess is a comparison with "
                      "theory, but the table [theory] is missing\n");
}

// Ranges and tensions are no mistakes of a law that is only misspelt.
TEST(Mistakes, DoNotFollowFromAnUnknownContactLaw) {
  EXPECT_EQ(
      mistakes_in({"theory=", "fem=", "expect=", "halfspace.contact=exponental",
                   "halfspace.work_of_adhesion=0.05", "halfspace.range=1 nm",
                   "load.nominal_pressure=[1e6, \"-1e3 Pa\"]"}),
      "  --set: halfspace.contact = \"exponental\", but must be penalty | hard "
      "| augmented | exponential | dugdale | cubic | lennard-jones | "
      "lennard-jones-10-4 | morse; "
      "nearest: exponential\n");
}

TEST(Mistakes, StateThatTheWavevectorsAreOutOfOrder) {
  EXPECT_EQ(mistakes_in({"surface.wavelength_roll_off=6 um"}),
            "  case.toml:3: surface has its wavevectors in the wrong order: "
            "q_L = 1.25664e+06 1/m, but must not exceed q_0 = 1.0472e+06 "
            "1/m\n");
}

TEST(Mistakes, RefuseASecondBodyBesideThePairsModulus) {
  EXPECT_EQ(
      mistakes_in({"material.youngs_modulus=", "material.contact_modulus=1e9",
                   "material.counter={ youngs_modulus = 1e9, poisson_ratio = "
                   "0.3 }"}),
      "  --set: material.counter cannot be combined with "
      "material.contact_modulus, which is that of both bodies together\n");
}

TEST(Mistakes, RequirePoissonsRatioOnlyWhereItMatters) {
  const std::vector<std::string> modulus_alone = {
      "material.youngs_modulus=", "material.poisson_ratio=",
      "material.contact_modulus=1e9"};
  std::vector<std::string> without_fem = modulus_alone;
  without_fem.insert(without_fem.end(), {"fem=", "expect="});
  std::vector<std::string> with_slab = without_fem;
  with_slab.emplace_back("halfspace.thickness=1 length");
  const std::string answer =
      "  case.toml:14: material.poisson_ratio is missing, which a block of "
      "finite depth needs: a number\n";

  EXPECT_EQ(mistakes_in(modulus_alone), answer);
  EXPECT_EQ(mistakes_in(with_slab), answer);
  EXPECT_EQ(mistakes_in(without_fem), "");
  without_fem.emplace_back("report.stress_inside=true");
  EXPECT_EQ(mistakes_in(without_fem),
            "  --set: report.stress_inside needs material.poisson_ratio, which "
            "is missing\n");
}

// A result names tables after a method, and its reader takes names of up to 100
// characters.
TEST(Mistakes, OfANameThatAResultCannotHold) {
  const auto named = [](std::size_t length) {
    return "halfspace." + std::string(length - 10, 'x') + "={}";
  };
  EXPECT_EQ(mistakes_in({named(80)}), "");
  EXPECT_NE(mistakes_in({named(81)})
                .find("is a name of 81 characters, but that of a method must "
                      "have at most 80"),
            std::string::npos)
      << mistakes_in({named(81)});
}

} // namespace asperity::cases::mistakes_test
