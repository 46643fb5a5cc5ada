// Tests of input/text/toml_text.hpp and case_text.hpp: positions, syntax
// errors, and overrides of a file.
#include "input/reader/case_text.hpp"
#include "input/text/toml_text.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::cases::toml_text_test {

std::string error_of(const std::string& text) {
  return tests::message_of<input::InputError>(
      [&] { (void)parse_toml(text, "case.toml"); });
}

struct Overridden {
  Node file;
  std::string mistakes;
};

Overridden with_override(const std::string& text, const std::string& entry) {
  Overridden result{parse_toml(text, "case.toml"), ""};
  Mistakes mistakes;
  apply_override(result.file, entry, mistakes);
  try {
    mistakes.throw_if_any();
  } catch (const input::InputError& error) {
    result.mistakes = error.what();
  }
  return result;
}

TEST(TomlText, KnowsThePositionOfEachValue) {
  const Node file =
      parse_toml("# a comment\n\n[load]\nsweep = { to = 2 }\n", "case.toml");

  const Node* const load = file.find("load");
  const Node* const end = load->find("sweep")->find("to");
  EXPECT_EQ(load->place.text, "case.toml:3");
  EXPECT_EQ(end->place.text, "case.toml:4");
  EXPECT_EQ(end->path, "load.sweep.to");
  EXPECT_EQ(end->integer, 2);
}

TEST(TomlText, KeepsTheOrderOfTheFile) {
  const Node file = parse_toml("b = 1\nc = 2\na = 3\n", "case.toml");

  ASSERT_EQ(file.entries.size(), 3U);
  EXPECT_EQ(file.entries[0].key, "b");
  EXPECT_EQ(file.entries[1].key, "c");
  EXPECT_EQ(file.entries[2].key, "a");
}

TEST(TomlText, NamesTheLineThatIsNotToml) {
  EXPECT_EQ(error_of("schema = 1\nlength = 10 um\n"),
            "1 mistake(s) in the case file\n"
            "  case.toml:2: is not TOML: invalid line format (expected "
            "newline, but got 'u'.)\n");
  EXPECT_EQ(error_of("\n\na = 1\na = 2\n"),
            "1 mistake(s) in the case file\n"
            "  case.toml:4: is not TOML: value (\"a\") already exists. (value "
            "defined twice)\n");
}

TEST(TomlText, RefusesAnIntegerThatDoesNotFit) {
  const Node file = parse_toml("a = 99999999999999999999\n", "case.toml");

  EXPECT_EQ(file.find("a")->type, NodeType::other);
  EXPECT_EQ(written(*file.find("a")), "an integer beyond 64 bits");
}

TEST(Overrides, AreTomlOrElseStrings) {
  EXPECT_EQ(with_override("", "a.b = 3").file.find("a")->find("b")->integer, 3);
  EXPECT_EQ(with_override("", "a=0.5").file.find("a")->floating, 0.5);
  EXPECT_EQ(with_override("", "a=20 um").file.find("a")->text, "20 um");
  EXPECT_EQ(with_override("", "a=\"20 um\"").file.find("a")->text, "20 um");
  EXPECT_EQ(with_override("", "a=hard").file.find("a")->text, "hard");
  EXPECT_TRUE(with_override("", "a={}").file.find("a")->is_table());
  EXPECT_EQ(with_override("", "a=[1, 2]").file.find("a")->list.size(), 2U);
}

TEST(Overrides, ReplaceReachIntoInlineTablesAndRemove) {
  const std::string text = "[load]\nsweep = { from = 1, steps = 3 }\n";

  const Node replaced = with_override(text, "load.sweep.steps=4").file;
  const Node removed = with_override(text, "load.sweep=").file;

  EXPECT_EQ(replaced.find("load")->find("sweep")->find("steps")->integer, 4);
  EXPECT_EQ(replaced.find("load")->find("sweep")->find("from")->integer, 1);
  EXPECT_EQ(removed.find("load")->find("sweep"), nullptr);
}

TEST(Overrides, AreNamedInTheirMistakes) {
  const Node file = with_override("", "fem.depth={ a = [1] }").file;

  EXPECT_EQ(file.find("fem")->place.text, "--set");
  EXPECT_EQ(file.find("fem")->find("depth")->find("a")->place.text, "--set");
  EXPECT_EQ(file.find("fem")->find("depth")->find("a")->path, "fem.depth.a");
}

TEST(Overrides, RefuseInvalidOverrides) {
  const std::string head = "1 mistake(s) in the case file\n  --set: ";

  EXPECT_EQ(with_override("", "gamma").mistakes,
            head + "\"gamma\" must have the form key.path=value on one line\n");
  EXPECT_EQ(with_override("", "=3").mistakes,
            head + "\"=3\" must have the form key.path=value on one line\n");
  EXPECT_EQ(with_override("", "a..b=3").mistakes,
            head +
                "\"a..b=3\" must have the form key.path=value on one line\n");
  EXPECT_EQ(with_override("a = 1\n", "a.b=3").mistakes,
            head + "a is not a table, but 1\n");
  EXPECT_NE(with_override("", "a=1\nb=2").mistakes, "");
}

// The overrides of a text are those in its last lines, in order; the same words
// further up are a comment.
TEST(CaseText, CarriesItsOverridesInItsLastLines) {
  const std::string text = "#--set x=1\na = 1";

  const std::string whole = text_with_overrides(text, {"a=2", "b=\"3 nm\""});

  EXPECT_EQ(whole, text + "\n#--set a=2\n#--set b=\"3 nm\"\n");
  EXPECT_EQ(overrides_in(whole),
            (std::vector<std::string>{"a=2", "b=\"3 nm\""}));
  EXPECT_TRUE(overrides_in(text).empty());
  EXPECT_EQ(text_with_overrides(text, {}), text);
}

} // namespace asperity::cases::toml_text_test
