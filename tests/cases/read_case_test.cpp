// Tests of input/reader/read_case.hpp with valid cases.
#include "input/reader/case_hash.hpp"
#include "input/reader/read_case.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace asperity::cases::read_case_test {

constexpr double pi = std::numbers::pi;

Case rough(const std::vector<std::string>& overrides = {}) {
  return read_case_text(contact_case, "some/rough/case.toml", overrides);
}

const mechanics::FemSettings& fem_of(const Case& read, std::size_t index) {
  return std::get<mechanics::FemSettings>(read.methods.at(index).settings);
}

// Tolerances of this file: one rounding per product, DOUBLE_EQ's four ulp.
TEST(ReadCase, GivesTheSurfaceInSi) {
  const Case read = rough();

  EXPECT_EQ(read.name, "rough");
  EXPECT_EQ(read.title, "A rough block");
  EXPECT_EQ(read.surface.kind, mechanics::SurfaceKind::self_affine);
  EXPECT_EQ(read.surface.length, 10e-6);
  EXPECT_EQ(read.surface.points, 512);
  EXPECT_EQ(read.surface.seed, 7U);
  EXPECT_EQ(read.surface.realizations, 3);
  EXPECT_EQ(read.surface.rms_height, 34e-9);
  EXPECT_FALSE(read.surface.rms_slope);
  EXPECT_EQ(read.surface.hurst, 0.95);
  EXPECT_DOUBLE_EQ(read.surface.wavevector_low, 2.0 * pi / 5e-6);
  EXPECT_DOUBLE_EQ(read.surface.wavevector_roll_off, 2.0 * pi / 2.5e-6);
  EXPECT_DOUBLE_EQ(read.surface.wavevector_high, 2.0 * pi / (8e-5 / 512));
}

TEST(ReadCase, TakesWavevectorsAsTheyAre) {
  const Case read = rough(
      {"surface.wavelength_long=", "surface.wavevector_low=1.2566e6 1/m"});

  EXPECT_EQ(read.surface.wavevector_low, 1.2566e6);
}

TEST(ReadCase, SpacesALoadingPathAsRequested) {
  const mechanics::LoadingPath logarithmic = rough().load;
  const mechanics::LoadingPath linear =
      rough({"load.nominal_pressure.spacing=linear"}).load;

  ASSERT_EQ(logarithmic.targets.size(), 3U);
  EXPECT_EQ(logarithmic.control, mechanics::Control::nominal_pressure);
  EXPECT_EQ(logarithmic.targets[0].value, 1e-3);
  EXPECT_EQ(logarithmic.targets[0].reference,
            mechanics::ReferenceUnit::contact_modulus);
  EXPECT_DOUBLE_EQ(logarithmic.targets[1].value, 1e-2);
  EXPECT_EQ(logarithmic.targets[2].value, 0.1);
  EXPECT_DOUBLE_EQ(linear.targets[1].value, 0.0505);
}

// With spacing = "area" the ratio of successive contact areas erf(sqrt(2) p) is
// constant. Tolerance: the roundoff of erf and its inverse.
TEST(ReadCase, SpacesContactAreasEvenly) {
  const std::string program = "load.nominal_pressure={from=\"0.01 E* h'\", "
                              "to=\"2 E* h'\", steps=9, spacing=\"area\"}";
  const std::vector<mechanics::Quantity> loads = rough({program}).load.targets;

  ASSERT_EQ(loads.size(), 9U);
  EXPECT_EQ(loads.front().value, 0.01);
  EXPECT_EQ(loads.back().value, 2.0);
  const auto area = [&](std::size_t step) {
    EXPECT_EQ(loads[step].reference,
              mechanics::ReferenceUnit::contact_modulus_times_slope);
    return std::erf(std::sqrt(2.0) * loads[step].value);
  };
  const double ratio = std::pow(area(8) / area(0), 1.0 / 8.0);
  EXPECT_GT(ratio, 1.5);
  for (std::size_t step = 0; step + 1 < loads.size(); ++step)
    EXPECT_NEAR(area(step + 1) / area(step), ratio, 1e-8) << step;
}

TEST(ReadCase, RefusesAreasOfPressuresThatHaveNone) {
  const auto refusal = [](const std::string& from, const std::string& to) {
    return mistakes_of(contact_case,
                       {"load.nominal_pressure={from=\"" + from + "\", to=\"" +
                        to + "\", steps=3, spacing=\"area\"}"});
  };
  EXPECT_EQ(refusal("0.01 E*", "0.1 E*"),
            "  --set: load.nominal_pressure.from = \"0.01 E*\", but spacing = "
            "\"area\" needs pressures in E* h'\n");
  EXPECT_EQ(refusal("0.01 E* h'", "4 E* h'"),
            "  --set: load.nominal_pressure.to = \"4 E* h'\", but spacing = "
            "\"area\" needs pressures of at most 3 E* h', where contact is "
            "complete\n");
}

TEST(ReadCase, WritesTheUnloadingSteps) {
  const mechanics::LoadingPath load =
      rough({"load.nominal_pressure=[1e6, \"2 MPa\", \"0.5 E*\"]",
             "load.cycle=load-unload"})
          .load;

  ASSERT_EQ(load.targets.size(), 5U);
  EXPECT_EQ(load.targets[1].value, 2e6);
  EXPECT_EQ(load.targets[2].value, 0.5);
  EXPECT_EQ(load.targets[3].value, 2e6);
  EXPECT_EQ(load.targets[4].value, 1e6);
  EXPECT_EQ(load.is_unloading,
            (std::vector<bool>{false, false, false, true, true}));
}

TEST(ReadCase, ControlsTheMeanGapToo) {
  const mechanics::LoadingPath load =
      rough({"load.nominal_pressure=", "load.mean_gap=2 h_rms"}).load;

  ASSERT_EQ(load.targets.size(), 1U);
  EXPECT_EQ(load.control, mechanics::Control::mean_gap);
  EXPECT_EQ(load.targets[0].reference, mechanics::ReferenceUnit::rms_height);
}

// E* of the block is E / (1 - nu^2), and 1/E* of two bodies the sum.
TEST(ReadCase, ReducesTheMaterialToItsContactModulus) {
  const std::vector<std::string> alone = {"material.youngs_modulus=",
                                          "material.contact_modulus=3 GPa"};
  const double one = 2e9 / (1.0 - 0.09);
  const double two = 5e9 / (1.0 - 0.04);

  EXPECT_DOUBLE_EQ(rough().material.contact_modulus, one);
  EXPECT_EQ(rough().material.poisson_ratio, 0.3);
  EXPECT_EQ(rough(alone).material.contact_modulus, 3e9);
  EXPECT_DOUBLE_EQ(rough({"material.counter.youngs_modulus=5e9",
                          "material.counter.poisson_ratio=0.2"})
                       .material.contact_modulus,
                   one * two / (one + two));
}

TEST(ReadCase, LetsAVariantInheritItsTable) {
  const Case read = rough({"fem.hard.contact=hard", "theory.g42.gamma=0.42"});

  ASSERT_EQ(read.methods.size(), 5U);
  EXPECT_EQ(read.methods[0].name, "theory");
  EXPECT_EQ(read.methods[1].name, "halfspace");
  EXPECT_EQ(read.methods[2].name, "fem");
  EXPECT_EQ(read.methods[3].name, "theory.g42");
  EXPECT_EQ(read.methods[4].name, "fem.hard");
  EXPECT_EQ(fem_of(read, 2).contact.law, mechanics::ContactLaw::penalty);
  EXPECT_EQ(fem_of(read, 4).contact.law, mechanics::ContactLaw::hard);
  EXPECT_EQ(fem_of(read, 4).block.growth, 1.3);
}

TEST(ReadCase, KeepsTheRequestedNumberOfMaps) {
  EXPECT_EQ(rough({"report.fields=none"}).report.fields, 0);
  EXPECT_EQ(rough({"report.fields=5"}).report.fields, 5);
  EXPECT_EQ(rough({"report.fields=all"}).report.fields, all_fields);
}

TEST(ReadCase, GivesAnExpectationItsBandAndMethods) {
  const Case read = rough({"expect.kappa={ value = 2, within = \"5 %\" }",
                           "expect.penetration={ below = 0.1 }"});

  ASSERT_EQ(read.expectations.size(), 3U);
  EXPECT_EQ(read.expectations[0].quantity, "gamma_slope");
  EXPECT_DOUBLE_EQ(read.expectations[0].low, 0.35);
  EXPECT_DOUBLE_EQ(read.expectations[0].high, 0.45);
  EXPECT_EQ(read.expectations[0].methods,
            (std::vector<std::string>{"fem", "theory"}));
  EXPECT_DOUBLE_EQ(read.expectations[1].low, 1.9);
  EXPECT_DOUBLE_EQ(read.expectations[1].high, 2.1);
  EXPECT_EQ(read.expectations[1].methods,
            (std::vector<std::string>{"theory", "halfspace", "fem"}));
  EXPECT_TRUE(std::isinf(read.expectations[2].low));
  EXPECT_EQ(read.expectations[2].high, 0.1);
  EXPECT_EQ(read.expectations[2].methods,
            (std::vector<std::string>{"halfspace", "fem"}));
}

TEST(ReadCase, TakesABandForEachMethod) {
  const Case read =
      rough({"expect={}", "expect.kappa=[{ below = 2, methods = [\"fem\"] }, "
                          "{ above = 1, methods = [\"theory\"] }]"});

  ASSERT_EQ(read.expectations.size(), 2U);
  EXPECT_EQ(read.expectations[0].quantity, "kappa");
  EXPECT_EQ(read.expectations[0].methods, std::vector<std::string>{"fem"});
  EXPECT_EQ(read.expectations[1].quantity, "kappa");
  EXPECT_EQ(read.expectations[1].low, 1.0);
}

// A theory with the spectrum of a formula builds no surface and needs no grid.
TEST(ReadCase, NeedsNoGridForATheoryFromAFormula) {
  const Case read =
      rough({"fem=", "halfspace=", "expect=", "surface.length=",
             "surface.points=", "surface.seed=", "surface.wavelength_long=5 um",
             "surface.wavelength_short=80 nm"});

  EXPECT_FALSE(read.surface.length);
  EXPECT_FALSE(read.surface.points);
  EXPECT_EQ(read.methods.size(), 1U);
}

// A theory with the spectrum of the surface builds it and needs its grid.
TEST(ReadCase, NeedsTheGridForATheoryOfTheSurface) {
  const std::vector<std::string> theory_alone = {
      "fem=",          "halfspace=",      "expect=",
      "surface.seed=", "surface.points=", "surface.wavelength_short=80 nm"};
  std::vector<std::string> of_the_surface = theory_alone;
  of_the_surface.emplace_back("theory.spectrum=surface");

  EXPECT_EQ(mistakes_of(contact_case, theory_alone), "");
  EXPECT_EQ(mistakes_of(contact_case, of_the_surface),
            "  case.toml:3: surface.points is missing: a whole number\n"
            "  case.toml:3: surface.seed is missing: a whole number\n");
}

// Line ends and a byte order mark of other systems change nothing.
TEST(ReadCase, ReadsTextFromOtherSystems) {
  std::string foreign = "\xEF\xBB\xBF";
  for (const char letter : contact_case)
    foreign += letter == '\n' ? std::string("\r\n") : std::string(1, letter);

  const Case read =
      read_case_text(foreign + "#--set surface.seed=9\r\n", "case.toml");

  EXPECT_EQ(read.surface.seed, 9U);
  EXPECT_EQ(read.title, "A rough block");
}

// The text of a case is complete: reading it again gives the same text, hash
// and numbers, and an override changes the hash.
TEST(ReadCase, RoundTripsThroughItsText) {
  const std::vector<std::string> overrides = {"surface.points=256",
                                              "surface.length=20 um"};
  const Case first = rough(overrides);

  const Case second = read_case_text(first.text, first.path);
  const Case third = read_case_text(first.text, first.path, {"surface.seed=8"});

  EXPECT_EQ(second.surface.points, 256);
  EXPECT_EQ(second.surface.length, 20e-6);
  EXPECT_EQ(second.surface.wavevector_high, first.surface.wavevector_high);
  EXPECT_EQ(second.text, first.text);
  EXPECT_EQ(case_hash(second), case_hash(first));
  EXPECT_EQ(third.surface.points, 256);
  EXPECT_EQ(third.surface.seed, 8U);
  EXPECT_NE(case_hash(third), case_hash(first));
}

TEST(ReadCase, ReportsAMissingFile) {
  const auto mistakes_in = [](const std::string& path,
                              const std::vector<std::string>& overrides) {
    try {
      (void)read_case(path, overrides);
    } catch (const input::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string head = "1 mistake(s) in the case file\n  ";

  EXPECT_EQ(mistakes_in("no/case.toml", {}),
            head + "no/case.toml: there is no such file\n");
  EXPECT_EQ(mistakes_in("cases", {}),
            head + "cases: is a folder, but must be a regular file\n");
  EXPECT_EQ(
      mistakes_in("cases/wave-1d/case.toml",
                  {"surface={ kind = \"measured\", file = \"no.txt\", level = "
                   "\"none\", edges = \"periodic\" }",
                   "expect="}),
      head + "--set: surface.file: there is no file "
             "cases/wave-1d/no.txt (a relative path is resolved from the "
             "case file's folder)\n");
  EXPECT_EQ(mistakes_in(
                "cases/wave-1d/case.toml",
                {"surface={ kind = \"measured\", file = \"/dev/zero\", level = "
                 "\"none\", edges = \"periodic\" }",
                 "expect="}),
            head + "--set: surface.file: /dev/zero: is a "
                   "device, but must be a regular file\n");
}

// The digest of FIPS 180's example "abc", by sha1sum and by the standard.
TEST(CaseHash, IsSha1OfTheText) {
  Case read;
  read.text = "abc";

  EXPECT_EQ(case_hash(read), "a9993e364706816aba3e25717850c26c9cd0d89d");
  read.text =
      "case 0"; // the fifth word of its hash begins with a zero; by sha1sum
  EXPECT_EQ(case_hash(read), "82fcb544fbd702b51a2174c4ec6a200c09bb501a");
}

} // namespace asperity::cases::read_case_test
