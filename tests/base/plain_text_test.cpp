// Tests of base/plain_text.hpp, with the bounds of RFC 3629.
#include "base/plain_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::plain_text_test {

constexpr std::size_t plain = std::string_view::npos;

TEST(PlainText, IsUtf8OfAnyLength) {
  EXPECT_EQ(find_not_plain(""), plain);
  EXPECT_EQ(find_not_plain("a\tb\r\n\xC3\xBC"), plain);
  EXPECT_EQ(find_not_plain("\xE2\x82\xAC\xEF\xBF\xBD\xED\x9F\xBF"), plain);
  EXPECT_EQ(find_not_plain("\xF0\x90\x80\x80\xF4\x8F\xBF\xBF"), plain);
}

// Truncated, overlong, surrogate, beyond U+10FFFF or stray bytes: each is found
// where it begins.
TEST(PlainText, IsNoOtherByte) {
  for (const std::string bad :
       {"\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80",
        "\xF8\x88\x80\x80\x80", "\x80", "\xFF"})
    EXPECT_EQ(find_not_plain("ab" + bad + "c"), 2U) << bad;
}

TEST(PlainText, HasNoControlCharacters) {
  for (const char bad : {'\x01', '\x1B', '\x7F'})
    EXPECT_EQ(find_not_plain(std::string("ab") + bad), 2U);
  EXPECT_EQ(find_not_plain(std::string_view("ab\0", 3)), 2U);
  EXPECT_EQ(find_not_plain("ab\xC2\x9B"), 2U); // CSI of terminals
}

// Text that a message quotes cannot move the cursor of a terminal, break the
// line or fill the screen.
TEST(Printable, IsShortAndPlain) {
  EXPECT_EQ(printable("3,5 \xC2\xB5m"), "3,5 \xC2\xB5m");
  EXPECT_EQ(printable("a\x1B[2J\nb\x9F"), "a?[2J?b?");
  EXPECT_EQ(printable("\xC2\x9B"), "\xC3\x82?"); // CSI of terminals
  EXPECT_EQ(printable("\xE2\x82\xAC\xE2\x82\xAC", 4), "\xE2\x82\xAC?...");
}

// The letters of Latin-1 have the same numbers in Unicode.
TEST(Printable, ShowsLettersOfLatin1) {
  EXPECT_EQ(printable("H\xF6he in \xB5m"), "H\xC3\xB6he in \xC2\xB5m");
  EXPECT_EQ(printable("\xE4\xF6\xFC\xDF-----", 6),
            "\xC3\xA4\xC3\xB6\xC3\xBC?--...");
}

TEST(PlainText, KeepsLineEndsOnly) {
  EXPECT_EQ(plain_text("a\x1B[2J\nb\xFF\r"), "a?[2J\nb?\r");
  EXPECT_EQ(plain_text(std::string(1 << 20, '\x01')),
            std::string(1 << 20, '?'));
}

// What is written as a name is accepted as a name.
TEST(Names, AreMadeOfLettersThatAllReadersTake) {
  for (const std::string_view text :
       {std::string_view("a\n#SBATCH --x"), std::string_view("\0", 1),
        std::string_view("\xC3\xBC/../\"'`$"), std::string_view("")}) {
    EXPECT_TRUE(is_good_name(good_name(text))) << text;
    EXPECT_FALSE(is_good_name(text)) << text;
  }
  EXPECT_EQ(good_name("polymer v1.2_a+b"), "polymer v1.2_a+b");
  EXPECT_EQ(good_name(std::string(300, 'a')).size(), longest_name);
  EXPECT_FALSE(is_good_name(std::string(longest_name + 1, 'a')));
}

TEST(OneLine, HasALimitAndNoControlCharacters) {
  EXPECT_EQ(line_mistake("version 1.2 \xC2\xB5"), "");
  EXPECT_EQ(line_mistake(std::string(longest_line, 'x')), "");
  for (const std::string& text :
       {std::string(longest_line + 1, 'x'), std::string(), std::string("a\nb"),
        std::string("a\0b", 3), std::string("\x1B")})
    EXPECT_NE(line_mistake(text), "") << text.size();
}

} // namespace asperity::plain_text_test
