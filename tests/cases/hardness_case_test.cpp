// Tests of the key hardness.
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace asperity::cases::hardness_case_test {

std::string yielding(const std::string& halfspace, const std::string& theory) {
  return "schema = 1\n[surface]\nkind = \"self-affine\"\nlength = 1e-6\n"
         "points = 64\nseed = 1\nrms_slope = 0.1\nhurst = 0.8\n"
         "wavelength_long = \"1 length\"\n"
         "wavelength_roll_off = \"1 length\"\nwavelength_short = \"8 h\"\n"
         "[material]\ncontact_modulus = \"2 GPa\"\n"
         "[load]\nnominal_pressure = \"1 MPa\"\n"
         "[theory]\ngamma = 0.42\n" +
         theory + "[halfspace]\n" + halfspace;
}

TEST(HardnessCase, IsReadInUnitsOfPressureAndSlope) {
  const Case read = read_case_text(
      yielding("hardness = \"0.3 E* h'\"\n", "hardness = \"200 MPa\"\n"),
      "it/case.toml");
  const mechanics::Scales scales{.contact_modulus = 2e9, .rms_slope = 0.1};
  for (const MethodSpec& method : read.methods)
    EXPECT_DOUBLE_EQ(method.hardness().value().in_si(scales),
                     method.name == "theory" ? 2e8 : 6e7);
  const auto& contact =
      std::get<mechanics::HalfspaceSettings>(read.methods.back().settings)
          .contact;
  EXPECT_DOUBLE_EQ(contact.in_si(scales).pressure_bounds().largest, 6e7);
}

TEST(HardnessCase, IsOneOfHardContact) {
  const std::string answer = mistakes_of(yielding(
      "contact = \"penalty\"\npenalty = \"1 E*/h\"\nhardness = 1e9\n", ""));
  EXPECT_NE(answer.find("needs contact = \"hard\""), std::string::npos)
      << answer;
}

TEST(HardnessCase, IsPositive) {
  const std::string answer = mistakes_of(yielding("hardness = 0\n", ""));
  EXPECT_NE(answer.find("hardness"), std::string::npos) << answer;
}

} // namespace asperity::cases::hardness_case_test
