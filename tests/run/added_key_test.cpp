// A key of a case is a member and a row: a row that a test adds is read,
// refused by its place, documented, in the schema, in the template, in what
// `asperity describe` lists, and in the keys of the cache.
#include "input/input_error.hpp"
#include "input/reader/bound_key.hpp"
#include "input/reader/case_schema.hpp"
#include "input/reader/documents.hpp"
#include "input/reader/read_case.hpp"
#include "input/reader/resolved_keys.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "tests/message_of.hpp"
#include "tests/rough_case.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace asperity::run::added_key_test {

using Winkler = mechanics::WinklerSettings;

const std::string springs =
    tests::rough_case("springs", 32, tests::four_loads, R"([winkler]
stiffness = "0.1 E*/h"
)");

class AddedRow : public ::testing::Test {
protected:
  static cases::Case read(const std::string& entry) {
    return cases::read_case_text(springs, "case.toml",
                                 entry.empty()
                                     ? std::vector<std::string>{}
                                     : std::vector<std::string>{entry});
  }

  static std::string answer(const std::string& entry) {
    return tests::message_of<input::InputError>([&] { (void)read(entry); });
  }

  static std::string cache_key(const std::string& entry) {
    const cases::Case one = read(entry);
    return methods::CaseKeys(one, "program")
        .steps(*std::ranges::find(one.methods, "winkler",
                                  &cases::MethodSpec::name),
               0)
        .front();
  }

  // The stiffness again, under another name, as what a developer would add.
  const cases::AddedKey row{
      "winkler",
      cases::key<&Winkler::stiffness>(
          "bedding",
          {cases::Dimension::stiffness,
           cases::positive(),
           {mechanics::ReferenceUnit::contact_modulus_per_spacing}},
          "Bedding of the springs.", cases::eg("3 E*/h", "default: none"))};
};

TEST_F(AddedRow, IsReadIntoItsMember) {
  const cases::Case one = read("winkler.bedding=7 E*/h");

  EXPECT_EQ(std::get<Winkler>(one.methods.back().settings).stiffness.value,
            7.0);
}

TEST_F(AddedRow, IsRefusedByPlaceRangeAndNearestWord) {
  EXPECT_NE(answer("winkler.bedding=-1")
                .find("--set: winkler.bedding = -1, but must be > 0 [Pa/m]"),
            std::string::npos)
      << answer("winkler.bedding=-1");
  EXPECT_NE(
      answer("winkler.beding=1")
          .find("winkler.beding is not a key of this table; nearest: bedding"),
      std::string::npos)
      << answer("winkler.beding=1");
  EXPECT_NE(answer("theory.bedding=1").find("it belongs to [winkler]"),
            std::string::npos)
      << answer("theory.bedding=1");
}

TEST_F(AddedRow, IsOnThePageAndInTheSchema) {
  EXPECT_NE(cases::case_reference_markdown().find("| `bedding` | a number"),
            std::string::npos);
  EXPECT_EQ(
      nlohmann::json::parse(cases::json_schema())
          .at("/properties/winkler/properties/bedding/description"_json_pointer),
      "Bedding of the springs. Needed or default: default: none");
}

TEST_F(AddedRow, IsListedWithTheKeysOfACaseAndKeysTheCache) {
  const cases::Case one = read("winkler.bedding=7 E*/h");
  const auto keys = cases::resolved_keys(one, {});

  EXPECT_EQ(
      std::ranges::count(keys, "winkler.bedding", &cases::ResolvedKey::path),
      1);
  EXPECT_NE(cache_key("winkler.bedding=7 E*/h"), cache_key(""));
  EXPECT_NE(cache_key("winkler.bedding=7 E*/h"),
            cache_key("winkler.bedding=8 E*/h"));
}

TEST(AddedRows, LeaveTheVocabularyAsItWas) {
  EXPECT_EQ(cases::find_key("winkler", "bedding"), nullptr);
}

} // namespace asperity::run::added_key_test
