// Tests of [magnification] and [adhesion]: what is read, and the messages about
// invalid values.
#include "input/types/quantity_at_load.hpp"
#include "input/types/reference.hpp"
#include "studies/adhesion/adhesion.hpp"
#include "studies/magnification/magnification.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

namespace asperity::studies::keys_test {

using namespace cases;

const std::string studies_case = R"(schema = 1
[surface]
kind = "self-affine"
length = "10 um"
rms_height = "34 nm"
hurst = 0.95
wavelength_long = "0.5 length"
wavelength_roll_off = "0.25 length"
wavelength_short = "0.0078125 length"
[material]
contact_modulus = "2 GPa"
[load]
nominal_pressure = "10 MPa"
[theory]
gamma = 0.38
[magnification]
nominal_pressure = ["1 MPa", "0.005 E*"]
from = 1.0
to = 128.0
points = 57
[adhesion]
work_of_adhesion = "0.1 J/m^2"
from = 0.5
to = 1.5
points = 21
[expect]
adhesion_flip = { above = 0.1 }
)";

constexpr double two_pi = 2.0 * std::numbers::pi;

Case read(const std::vector<std::string>& overrides = {}) {
  return read_case_text(studies_case, "case.toml", overrides);
}

std::string mistakes_in(const std::vector<std::string>& overrides) {
  return mistakes_of(studies_case, overrides);
}

TEST(Studies, AreOptional) {
  const Case plain = read_case_text(contact_case, "case.toml");

  EXPECT_EQ(plain.study<MagnificationStudy>(), nullptr);
  EXPECT_EQ(plain.study<AdhesionStudy>(), nullptr);
}

// Tolerance: two roundings of 2 pi over a length.
TEST(Studies, OfMagnificationsCountFromTheRollOff) {
  const Case study_case = read();

  const MagnificationStudy& study = *study_case.study<MagnificationStudy>();
  ASSERT_EQ(study.nominal_pressures.size(), 2U);
  EXPECT_EQ(study.nominal_pressures[0].value, 1e6);
  EXPECT_EQ(study.nominal_pressures[1].in_si({2e9, 0.0, 0.0, 0.0}), 1e7);
  EXPECT_EQ(study.from, 1.0);
  EXPECT_EQ(study.to, 128.0);
  EXPECT_EQ(study.points, 57);
  EXPECT_DOUBLE_EQ(study.reference_wavevector, two_pi / 2.5e-6);
  EXPECT_FALSE(study.leak.has_value());
}

TEST(Studies, TakeAReferenceWaveOfTheirOwn) {
  const Case by_length = read({"magnification.reference_wavelength=1 length"});
  const Case by_wavevector = read({"magnification.reference_wavevector=7e5"});

  EXPECT_DOUBLE_EQ(by_length.study<MagnificationStudy>()->reference_wavevector,
                   two_pi / 1e-5);
  EXPECT_EQ(by_wavevector.study<MagnificationStudy>()->reference_wavevector,
            7e5);
}

TEST(Studies, ReadTheSealedFluid) {
  const Case with_leak = read({"magnification.leak.density=998 kg/m^3",
                               "magnification.leak.viscosity=2 mPa s",
                               "magnification.leak.pressure_drop=3 kPa",
                               "magnification.leak.critical_area=0.42"});

  const LeakStudy& leak = with_leak.study<MagnificationStudy>()->leak.value();
  EXPECT_EQ(leak.density, 998.0);
  EXPECT_EQ(leak.viscosity, 2e-3);
  EXPECT_EQ(leak.pressure_drop, 3e3);
  EXPECT_EQ(leak.critical_area, 0.42);
}

TEST(Studies, OfAdhesionHaveTheirDefaults) {
  const Case plain = read();
  const Case all = read({"adhesion.detachment_factor=0.5",
                         "adhesion.sphere_radius=2 mm", "adhesion.steps=50"});

  EXPECT_EQ(plain.study<AdhesionStudy>()->work_of_adhesion, 0.1);
  EXPECT_EQ(plain.study<AdhesionStudy>()->points, 21);
  EXPECT_EQ(plain.study<AdhesionStudy>()->steps, 400);
  EXPECT_FALSE(plain.study<AdhesionStudy>()->detachment_factor.has_value());
  EXPECT_FALSE(plain.study<AdhesionStudy>()->sphere_radius.has_value());
  EXPECT_EQ(all.study<AdhesionStudy>()->detachment_factor, 0.5);
  EXPECT_EQ(all.study<AdhesionStudy>()->sphere_radius, 2e-3);
  EXPECT_EQ(all.study<AdhesionStudy>()->steps, 50);
}

TEST(Studies, NeedATheoryWithThePapersLossFactor) {
  EXPECT_EQ(mistakes_in({"theory.loss_factor=xu",
                         "adhesion=", "expect.adhesion_flip="}),
            "  case.toml:16: magnification needs a [theory] whose spectrum is "
            "\"formula\", or a measured surface, and whose loss_factor is "
            "\"yang-persson\"\n");
}

TEST(Studies, NeedATheoryByTheFormula) {
  EXPECT_EQ(mistakes_in({"theory.spectrum=surface", "surface.points=256",
                         "surface.seed=1", "adhesion="}),
            "  case.toml:16: magnification needs a [theory] whose spectrum is "
            "\"formula\", or a measured surface, and whose loss_factor is "
            "\"yang-persson\"\n"
            "  case.toml:27: expect.adhesion_flip needs the table [adhesion]\n"
            "  case.toml:27: expect.adhesion_flip is computed by none of the "
            "case's methods\n");
}

TEST(Studies, NameTheMistakeInTheirValues) {
  EXPECT_EQ(mistakes_in({"adhesion.to=0.5"}),
            "  --set: adhesion.to = 0.5, but must be above adhesion.from\n");
  EXPECT_EQ(
      mistakes_in({"magnification.points=1"}),
      "  --set: magnification.points = 1, but must be between 2 and 10000 "
      "[1]\n");
  EXPECT_EQ(mistakes_in({"magnification.leak=true"}),
            "  --set: magnification.leak = true, but must be a table: "
            "[magnification.leak]\n");
  EXPECT_EQ(mistakes_in({"magnification.reference_wavevector=7e5",
                         "magnification.reference_wavelength=1 um"}),
            "  --set: magnification.reference_wavelength and "
            "magnification.reference_wavevector are both given; give only one "
            "of them\n");
  EXPECT_EQ(
      mistakes_in({"magnification=4"}),
      "  --set: magnification = 4, but must be a table: [magnification]\n");
}

// A map has no formula, and its theory evaluates the lines of its spectrum.
TEST(Studies, AreThoseOfTheMapOfAMeasuredSurface) {
  const Case measured = read(
      {"surface.kind=measured", "surface.file=map.txt", "surface.level=plane",
       "surface.length=10 um", "surface.height_unit=1 nm",
       "surface.rms_height=", "surface.hurst=", "surface.wavelength_long=",
       "surface.wavelength_roll_off=", "surface.wavelength_short=",
       "magnification.reference_wavelength=10 um",
       "adhesion=", "expect.adhesion_flip="});

  EXPECT_EQ(study_theory(measured.surface, measured.methods),
            &measured.methods[0]);
  EXPECT_DOUBLE_EQ(measured.study<MagnificationStudy>()->reference_wavevector,
                   two_pi / 1e-5);
}

TEST(Studies, OfAdhesionAreNotOfMaps) {
  const std::string mistakes = mistakes_in(
      {"surface.kind=measured", "surface.file=map.txt", "surface.level=plane",
       "surface.length=10 um", "surface.height_unit=1 nm",
       "surface.rms_height=", "surface.hurst=", "surface.wavelength_long=",
       "surface.wavelength_roll_off=", "surface.wavelength_short=",
       "magnification="});
  EXPECT_NE(mistakes.find("adhesion needs a [theory] whose spectrum is "
                          "\"formula\", and whose loss_factor"),
            std::string::npos)
      << mistakes;
}

TEST(Studies, AnswerTheirQuantitiesByTheTheoryAlone) {
  const Case study_case = read();

  ASSERT_EQ(study_case.expectations.size(), 1U);
  EXPECT_EQ(study_case.expectations[0].methods,
            std::vector<std::string>{"theory"});
  EXPECT_EQ(study_theory(study_case.surface, study_case.methods),
            &study_case.methods[0]);
}

// Studies of the maps of a contact: an override of a case with all methods, and
// the words of its refusal.
TEST(Studies, OfContactsNameWhatTheyLack) {
  const std::vector<std::string> theory_alone = {
      "fem=", "halfspace=", "expect="};
  const auto refused = [](std::vector<std::string> overrides,
                          const std::string& words) {
    const std::string answer = mistakes_of(contact_case, overrides);
    EXPECT_NE(answer.find(words), std::string::npos) << answer;
  };
  const auto with = [&](const std::string& entry) {
    std::vector<std::string> all = theory_alone;
    all.push_back(entry);
    return all;
  };
  const std::string water = "viscosity = 1e-3, pressure_drop = 1e4";
  const std::string heat =
      "thermal_conductivity = 5.0, counter_thermal_conductivity = 20.0";

  refused(with("flow={ " + water + " }"), "flow needs a method with a gap");
  refused({"flow={ " + water + ", width = 1e-3 }"},
          "flow.length is missing: a seal has both");
  refused({"conductance={ resistivity = 2e-8 }"},
          "conductance.counter_resistivity is missing");
  refused({"conductance={ resistivity = \"2 Pa s\" }"}, "nOhm m");
  refused({"conductance={ " + heat + ", gap_conductivity = 0.026 }"},
          "conductance.smallest_gap is missing");
  refused({"spots={ smallest = 0 }"}, "spots.smallest = 0, but must be");
  refused(with("spots={}"), "spots needs a method with a contact map");
  refused({"friction={ coefficient = 0.5, normal_load = \"1 E* h'\" }"},
          "must be in E* h' where the loads are");
  refused({"friction={ coefficient = 0.5, tangential_load = 1 }"},
          "must be between 0 and 1");
  refused({"friction={ coefficient = 0.5 }",
           "theory=", "expect=", "halfspace.thickness=1 length"},
          "needs a [theory] or a [halfspace] without thickness");
}

TEST(QuantityAtMagnification, IsReadWithItsLoad) {
  for (const char* text : {"mean_gap_ratio@p=10 MPa@zeta=12.5",
                           " mean_gap_ratio @ p = 1e7 Pa @ zeta = 12.5 "}) {
    const auto reading = read_quantity_at_load(text);

    ASSERT_TRUE(reading.at_load.has_value()) << reading.mistake;
    EXPECT_EQ(reading.at_load->quantity, "mean_gap_ratio");
    EXPECT_EQ(reading.at_load->nominal_pressure.value, 1e7);
    EXPECT_EQ(reading.at_load->magnification, 12.5);
    ASSERT_NE(expectation_called(text), nullptr);
    EXPECT_EQ(expectation_called(text)->study, "magnification");
  }
  EXPECT_FALSE(read_quantity_at_load("area_fraction@p=1 Pa")
                   .at_load->magnification.has_value());
}

TEST(QuantityAtMagnification, IsDistinguishedFromAnyOtherName) {
  for (const char* text :
       {"area_fraction@p=1 Pa@", "area_fraction@p=1 Pa@zeta",
        "area_fraction@p=1 Pa@zeta=0", "area_fraction@p=1 Pa@zeta=2 m",
        "area_fraction@zeta=2", "area_fraction@p=1 Pa@zeta=2@",
        "area_excess@p=1 Pa@zeta=2", "mean_gap_ratio@p=1 Pa"}) {
    const auto reading = read_quantity_at_load(text);

    EXPECT_FALSE(reading.at_load.has_value()) << text;
    EXPECT_FALSE(reading.mistake.empty()) << text;
  }
}

} // namespace asperity::studies::keys_test
