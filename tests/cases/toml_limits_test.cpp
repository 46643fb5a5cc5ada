// Tests of input/text/toml_limits.hpp: text that would overflow the stack of
// the TOML library, or occupy it for minutes, is refused with its line before
// it is parsed; text that a person writes is not.
#include "input/reader/case_text.hpp"
#include "input/reader/read_case.hpp"
#include "input/text/toml_limits.hpp"
#include "input/text/toml_text.hpp"
#include "tests/cases/case_samples.hpp"
#include "tests/message_of.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace asperity::cases::toml_limits_test {

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += part;
  return text;
}

std::string error_of(const std::string& text) {
  return tests::message_of<input::InputError>(
      [&] { (void)parse_toml(text, "case.toml"); });
}

std::string one_mistake(const std::string& what) {
  return "1 mistake(s) in the case file\n  " + what + "\n";
}

// Nested tables and lists of any depth are parsed or refused.
TEST(TomlLimits, RefuseNestingThatOverflowsTheStack) {
  const std::string answer =
      one_mistake("case.toml:2: is nested more than 32 levels deep");

  for (const int depth : {33, 5000, 20000, 100000}) {
    EXPECT_EQ(error_of("\na = " + repeated("{ a = ", depth) + "1" +
                       repeated("}", depth)),
              answer)
        << depth;
    EXPECT_EQ(error_of("\na = " + repeated("[", depth) + repeated("]", depth)),
              answer)
        << depth;
    EXPECT_EQ(error_of("\na = " + repeated("[", depth)), answer) << depth;
    EXPECT_EQ(error_of("\n" + repeated("[", depth) + "a"), answer) << depth;
  }
}

// A dotted key, in a header or before a value, is a nested table.
TEST(TomlLimits, RefuseLongDottedKeys) {
  const std::string answer =
      one_mistake("case.toml:1: is a key of more than 32 parts");

  for (const int parts : {33, 100000}) {
    EXPECT_EQ(error_of(repeated("a.", parts) + "a = 1\n"), answer) << parts;
    EXPECT_EQ(error_of(repeated("\"x=\" . ", parts) + "a = 1\n"), answer)
        << parts;
    EXPECT_EQ(error_of("[" + repeated("a.", parts) + "a]\n"), answer) << parts;
  }
}

// 50 000 dotted keys are refused at once instead of being parsed for minutes.
TEST(TomlLimits, RefuseMoreValuesThanACaseCanHave) {
  std::string keys;
  for (int i = 0; i < 50000; ++i)
    keys += fmt::format("a.b{}.c = 1\n", i);

  EXPECT_EQ(error_of(keys),
            one_mistake("case.toml:20001: has more than 20000 values"));
}

TEST(TomlLimits, RefuseTextThatIsTooLong) {
  EXPECT_EQ(error_of("a = 1\n#" + std::string(largest_case_text, 'x')),
            one_mistake("case.toml: has 1048583 bytes, but must have at most "
                        "1048576 (1 MiB)"));
}

// Brackets, dots and equals signs inside strings and comments do not count,
// however the string is quoted.
TEST(TomlLimits, LeaveStringsAndCommentsAlone) {
  const std::string many = repeated("[{.=,", 30000);

  EXPECT_EQ(error_of("a = \"\\\"" + many + "\"\nb = 1 # \"" + many + "\n" +
                     "c = '" + many + "\\'\nd = \"\"\"\n\"" + many +
                     "\n\\\"\"\"\"\"\"\ne = '''\n''" + many + "\n'''''\n" +
                     "f = \"\"\ng = ''\n"),
            "accepted");
}

// A list of two thousand loads and tables of depth 32 are valid.
TEST(TomlLimits, AllowLargeOrdinaryFiles) {
  EXPECT_EQ(error_of("a = [" + repeated("1.5e-3, ", 2000) + "]"), "accepted");
  EXPECT_EQ(error_of("a = " + repeated("{ a = ", 32) + "1" + repeated("}", 32)),
            "accepted");
}

// The case text inside a result and the overrides have the same limits.
TEST(TomlLimits, HoldForOverridesToo) {
  const std::string lists = repeated("[", 20000);

  for (const std::string& entry :
       {"load.nominal_pressure=" + lists, repeated("a.", 100000) + "a=1",
        "surface." + repeated("a.", 40) + "a=1"})
    try {
      (void)read_case_text(text_with_overrides(contact_case, {entry}),
                           "case.toml");
      ADD_FAILURE() << entry.substr(0, 60);
    } catch (const input::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("--set: "), std::string::npos)
          << std::string(error.what()).substr(0, 200);
    }
}

// A text with 50 000 "#--set" lines is refused at once.
TEST(TomlLimits, HoldForTheNumberOfOverrides) {
  std::string text = contact_case;
  for (int i = 0; i < 50000; ++i)
    text += fmt::format("#--set a{}=1\n", i);

  try {
    (void)read_case_text(text, "case.toml");
    ADD_FAILURE() << "accepted";
  } catch (const input::InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              one_mistake("case.toml: has more than 2000 overridden keys (by "
                          "--set or over a base case)"));
  }
}

// TOML is UTF-8, so that other text is refused with its line; it could not be
// written into a report or JSON.
TEST(TomlLimits, RefuseWhatIsNotUtf8) {
  EXPECT_EQ(error_of("# \xC3\xBC \xE2\x82\xAC \xF0\x9D\x84\x9E\na = '\xFC'\n"),
            one_mistake("case.toml:2: is not UTF-8 text without "
                        "control characters"));
  EXPECT_EQ(error_of(std::string("a = 1\n#\0\n", 9)),
            one_mistake("case.toml:2: is not UTF-8 text without "
                        "control characters"));
  EXPECT_EQ(error_of("\xEF\xBB\xBF# \xC3\xBC\n"), "accepted");
}

} // namespace asperity::cases::toml_limits_test
