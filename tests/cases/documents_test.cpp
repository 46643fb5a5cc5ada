// Tests of the documents that are generated from the vocabulary: schema,
// template and docs/reference/case.md.
#include "input/reader/case_schema.hpp"
#include "input/reader/documents.hpp"
#include "input/reader/read_case.hpp"
#include "input/reader/vocabulary.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace asperity::cases::documents_test {

const nlohmann::json& schema() {
  static const nlohmann::json parsed = nlohmann::json::parse(json_schema());
  return parsed;
}

/// The keys of a table in the schema; null if it has no such table.
nlohmann::json properties_of(const std::string& table) {
  const auto at = [](const std::string& pointer) {
    const nlohmann::json::json_pointer place(pointer);
    return schema().contains(place) ? schema().at(place) : nlohmann::json();
  };
  if (table.empty())
    return at("/properties");
  if (table == "expect.band" || table == "material.layer")
    return at("/$defs/" + table + "/properties");
  if (table == "load.sweep")
    return at("/properties/load/properties/mean_gap/anyOf/2/properties");
  if (const auto dot = table.find('.'); dot != std::string::npos)
    return at("/properties/" + table.substr(0, dot) + "/properties/" +
              table.substr(dot + 1) + "/properties");
  return at("/properties/" + table + "/properties");
}

TEST(JsonSchema, HasEveryKeyOfTheVocabulary) {
  for (const Table& table : vocabulary()) {
    const nlohmann::json properties = properties_of(table.name);
    for (const Key& key : table.keys) {
      ASSERT_TRUE(properties.contains(key.name))
          << table.name << "." << key.name;
      EXPECT_TRUE(properties.at(key.name).contains("description"));
    }
  }
}

TEST(JsonSchema, StatesRangesWordsAndDefaults) {
  const nlohmann::json fem = properties_of("fem");

  EXPECT_EQ(schema().at("$schema"),
            "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(fem.at("element").at("enum"), nlohmann::json({"Q1", "Q2"}));
  EXPECT_EQ(fem.at("growth").at("minimum"), 1.0);
  EXPECT_EQ(fem.at("tolerance").at("minimum"), 1e-15);
  EXPECT_EQ(properties_of("material").at("poisson_ratio").at("minimum"),
            -0.999);
  EXPECT_EQ(properties_of("theory").at("gamma").at("exclusiveMinimum"), 0.0);
  EXPECT_EQ(fem.at("depth").at("default"), "1 length");
  EXPECT_EQ(schema().at("/properties/theory/required"_json_pointer),
            nlohmann::json({"gamma"}));
}

// A layer inherits nothing, so the schema requires its keys, as the reader
// does; and both limit whole numbers.
TEST(JsonSchema, ForbidsWhatTheReaderRefuses) {
  const nlohmann::json count = properties_of("surface").at("realizations");

  EXPECT_EQ(schema().at("/$defs/material.layer/required"_json_pointer),
            nlohmann::json({"thickness", "youngs_modulus", "poisson_ratio"}));
  EXPECT_EQ(count.at("minimum"), 1.0);
  EXPECT_EQ(count.at("maximum"), 1000.0);

  for (const char* change :
       {"material.layers=[{ thickness = 1e-6, youngs_modulus = 1e9 }]",
        "surface.realizations=0", "surface.realizations=1001"})
    EXPECT_NE(mistakes_of(contact_case, {change}), "") << change;
}

// A variant has no required keys: it inherits them.
TEST(JsonSchema, LetsAVariantLeaveOutWhatItInherits) {
  EXPECT_FALSE(
      schema().at("/$defs/theory.variant"_json_pointer).contains("required"));
}

TEST(Vocabulary, NamesEachKeyOnceAndDescribesIt) {
  for (const Table& table : vocabulary()) {
    std::set<std::string> seen;
    for (const Key& key : table.keys) {
      EXPECT_TRUE(seen.insert(key.name).second) << key.name;
      EXPECT_EQ(key.description.back(), '.') << key.name;
      EXPECT_FALSE(key.need == Need::conditional && key.when.empty())
          << key.name;
    }
  }
}

TEST(Template, ReadsWithoutAMistake) {
  const std::string text = case_template("my \"own\" \\ case");

  const Case read = read_case_text(text, "case.toml");

  EXPECT_EQ(read.title, "my \"own\" \\ case");
  EXPECT_EQ(read.methods.size(), 3U);
}

// The commented examples of the template are valid too, each line separately.
// Only alternatives of a key that is present are expected to be refused.
TEST(Template, ShowsGoodExamplesInItsComments) {
  std::istringstream lines(case_template("x"));
  std::string table;
  int examples = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind('[', 0) == 0)
      table = line.substr(1, line.size() - 2) + ".";
    const auto equals = line.find(" = ");
    const bool is_example =
        line.rfind("# ", 0) == 0 && equals != std::string::npos &&
        line.substr(2, equals - 2).find(' ') == std::string::npos;
    if (!is_example)
      continue;
    ++examples;
    try {
      (void)read_case_text(case_template("x"), "case.toml",
                           {table + line.substr(2)});
    } catch (const input::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("are both given"),
                std::string::npos)
          << line << "\n"
          << error.what();
    }
  }
  EXPECT_GE(examples, 20);
}

// Golden test of the format only. ASPERITY_UPDATE_GOLDEN=1 writes the page
// again.
TEST(CaseReference, IsTheCommittedPage) {
  const std::string path = "docs/reference/case.md";
  if (std::getenv("ASPERITY_UPDATE_GOLDEN") != nullptr)
    std::ofstream(path) << case_reference_markdown();

  std::ostringstream committed;
  committed << std::ifstream(path).rdbuf();

  EXPECT_EQ(committed.str(), case_reference_markdown())
      << "write it anew: ASPERITY_UPDATE_GOLDEN=1 ctest -R cases/documents";
}

} // namespace asperity::cases::documents_test
