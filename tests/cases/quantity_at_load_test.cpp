// Tests of input/types/quantity_at_load.hpp: the spelling, and that [expect]
// and the schema take it.
#include "input/reader/case_schema.hpp"
#include "input/reader/read_case.hpp"
#include "input/types/quantity_at_load.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace asperity::cases::quantity_at_load_test {

TEST(QuantityAtLoad, IsReadInAnyUnitOfAPressure) {
  const mechanics::Scales scales{2e9, 1.0, 1.0, 1.0};
  for (const char* text : {"area_excess@p=0.005 E*", "area_excess@p=10 MPa",
                           " area_excess @ p = 1e7 Pa "}) {
    const auto reading = read_quantity_at_load(text);

    ASSERT_TRUE(reading.at_load.has_value()) << reading.mistake;
    EXPECT_EQ(reading.at_load->quantity, "area_excess");
    EXPECT_DOUBLE_EQ(reading.at_load->nominal_pressure.in_si(scales), 1e7);
  }
}

TEST(QuantityAtLoad, IsDistinguishedFromAnyOtherName) {
  EXPECT_FALSE(names_a_load("area_excess"));
  EXPECT_TRUE(names_a_load("nonsense@"));
  for (const char* text :
       {"area_excess", "area_excess@", "area_excess@p", "@p=1 Pa",
        "area_excess@p=", "area_excess@p=1", "area_excess@p=0 Pa",
        "area_excess@p=1 E*/h", "gamma_slope@p=1 Pa", ""}) {
    const auto reading = read_quantity_at_load(text);

    EXPECT_FALSE(reading.at_load.has_value()) << text;
    EXPECT_FALSE(reading.mistake.empty()) << text;
  }
}

TEST(QuantityAtLoad, IsFoundByItsName) {
  ASSERT_NE(expectation_called("area_fraction@p=1 Pa"), nullptr);
  EXPECT_TRUE(expectation_called("area_fraction@p=1 Pa")->theory_answers);
  EXPECT_FALSE(expectation_called("area_fraction_fit@p=1 Pa")->theory_answers);
  EXPECT_EQ(expectation_called("area_fraction"), nullptr);
  EXPECT_EQ(expectation_called("gamma_slope@p=1 Pa"), nullptr);
}

// The contact at a magnification is known to the theory alone; these two flags
// state it for the reports.
TEST(QuantityAtLoad, AtAMagnificationIsTheTheorys) {
  for (const ExpectationName& quantity :
       expectation_names(QuantityOf::magnification)) {
    EXPECT_TRUE(quantity.theory_answers) << quantity.name;
    EXPECT_TRUE(quantity.theory_only) << quantity.name;
  }
}

const std::string band = "\" = { value = 0.1, within = 0.02 }\n";

TEST(QuantityAtLoad, IsAKeyOfExpect) {
  const Case read = read_case_text(
      contact_case + "\"area_fraction@p=0.01 E*" + band, "case.toml");

  const Expectation& expectation = read.expectations.back();
  EXPECT_EQ(expectation.quantity, "area_fraction@p=0.01 E*");
  EXPECT_DOUBLE_EQ(expectation.high, 0.12);
  EXPECT_EQ(expectation.methods,
            (std::vector<std::string>{"theory", "halfspace", "fem"}));
}

TEST(QuantityAtLoad, IsRefusedWithTheMistake) {
  const std::vector<std::pair<std::string, std::string>> answers = {
      {"area_fracton@p=0.01 E*",
       " asks for area_fracton at a load, which is not a known quantity; "
       "nearest: area_fraction"},
      {"area_fraction@p=0.01 nm",
       " has a p that has the unit nm of a length, but must have one of: Pa, "
       "kPa, MPa, GPa, E*"},
      {"area_fraction@p=-1 Pa", " has a p that is not > 0"},
      {"area_fraction@u=1 nm", " must have the form area_fraction@p=0.01 E*"}};
  for (const auto& [key, answer] : answers)
    EXPECT_EQ(mistakes_of(contact_case + '"' + key + band),
              "  case.toml:28: expect." + key + answer + "\n");
  EXPECT_EQ(mistakes_of(contact_case +
                        "\"area_fraction_fit@p=1 Pa\" = { below = "
                        "1, methods = [\"theory\"] }\n"),
            "  case.toml:28: expect.area_fraction_fit@p=1 Pa.methods names "
            "\"theory\", but the methods of this case that compute "
            "area_fraction_fit are: halfspace, fem; nearest: fem\n");
}

// The schema accepts the key, and nothing that the reader refuses.
TEST(QuantityAtLoad, IsAKeyOfTheSchema) {
  const auto patterns =
      nlohmann::json::parse(json_schema())
          .at("/properties/expect/patternProperties"_json_pointer);

  ASSERT_EQ(patterns.size(), 1U);
  const std::regex pattern(patterns.begin().key());
  EXPECT_TRUE(std::regex_search("area_fraction_fit@p=0.01 E*", pattern));
  EXPECT_FALSE(std::regex_search("area@p=0.01 E*", pattern));
  EXPECT_FALSE(std::regex_search("area_fraction", pattern));
}

} // namespace asperity::cases::quantity_at_load_test
