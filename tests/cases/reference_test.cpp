// Tests of input/types/reference.hpp.
#include "input/input_error.hpp"
#include "input/types/reference.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::cases::reference_test {

const std::string head = "quantity,value,unit,uncertainty,source\n";

std::string mistakes_of(const std::string& text) {
  try {
    (void)read_reference_text(text, "reference.csv");
  } catch (const input::InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find('\n') + 1);
  }
  return "";
}

TEST(Reference, ReadsQuotedFieldsAndSkipsComments) {
  const std::vector<ReferenceValue> values = read_reference_text(
      "# published numbers\r\n" + head +
          "\ngamma_slope,0.4,1,0.02,\"Yang, Persson: \"\"about\"\" 0.4\"\r\n",
      "reference.csv");

  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0].quantity, "gamma_slope");
  EXPECT_EQ(values[0].value, 0.4);
  EXPECT_EQ(values[0].unit, "1");
  EXPECT_EQ(values[0].uncertainty, 0.02);
  EXPECT_EQ(values[0].source, "Yang, Persson: \"about\" 0.4");
}

// The columns after the required ones are optional.
TEST(Reference, ReadsTheOptionalColumns) {
  const std::string line = "height,1,m,0,s";
  const auto plain = read_reference_text(head + line + "\n", "r");
  const auto why = read_reference_text(
      "quantity,value,unit,uncertainty,source,why\n" + line + ",lost\n", "r");
  const auto input =
      read_reference_text("quantity,value,unit,uncertainty,source,why,input\n" +
                              line + ",,rms_height of [surface]\n",
                          "r");

  EXPECT_EQ(plain.at(0).why + plain.at(0).input, "");
  EXPECT_EQ(why.at(0).why, "lost");
  EXPECT_EQ(why.at(0).input, "");
  EXPECT_EQ(input.at(0).why, "");
  EXPECT_EQ(input.at(0).input, "rms_height of [surface]");
  EXPECT_NE(mistakes_of("quantity,value,unit,uncertainty,source,input\n"), "");
}

TEST(Reference, NamesEveryMistakeWithItsLine) {
  EXPECT_EQ(mistakes_of(head + "a,x,1,0,s\nb,1,1,-1,s\nc,1\nd,1,,0,\n"
                               "e,1,1,0,\"s\n"),
            "  reference.csv:2: value = x, but must be a number\n"
            "  reference.csv:3: uncertainty = -1, but must be a number >= 0\n"
            "  reference.csv:4: must have the fields " +
                head.substr(0, head.size() - 1) +
                ", but has 2\n"
                "  reference.csv:5: has no unit\n"
                "  reference.csv:5: has no source\n"
                "  reference.csv:6: must have the fields " +
                head.substr(0, head.size() - 1) +
                ", but a quote is not closed\n");
}

// A name with '@' is a quantity at a load or a mistake; any other is free.
TEST(Reference, ReadsQuantitiesAtALoad) {
  const auto values = read_reference_text(
      head + "area_fraction@p=0.0129 E*,0.1089,1,0,s\nmine,1,1,0,s\n", "r");

  EXPECT_EQ(values.at(0).quantity, "area_fraction@p=0.0129 E*");
  EXPECT_EQ(mistakes_of(head + "area@p=1 Pa,1,1,0,s\n"),
            "  reference.csv:2: area@p=1 Pa asks for area at a load, which is "
            "not a known quantity; nearest: area_excess\n");
}

// A sixth field is there for all lines or for none; it may be empty.
TEST(Reference, MayStateWhyANumberCannotFollow) {
  const std::string with_why = "quantity,value,unit,uncertainty,source,why\n";

  const auto values = read_reference_text(
      with_why + "a,1,1,0,s,\"not stated, but drawn\"\nb,1,1,0,s,\n", "r");

  EXPECT_EQ(values.at(0).why, "not stated, but drawn");
  EXPECT_EQ(values.at(1).why, "");
  EXPECT_EQ(mistakes_of(with_why + "a,1,1,0,s\n"),
            "  reference.csv:2: must have the fields "
            "quantity,value,unit,uncertainty,source,why, but has 5\n");
  EXPECT_NE(mistakes_of(head + "a,1,1,0,s,w\n"), "");
}

// A byte that is not text is refused with its line, because the page and the
// JSON that quote the source could not contain it.
TEST(Reference, IsUtf8) {
  EXPECT_EQ(mistakes_of(head + "a,1,1,0,J\xF6rg\n"),
            "  reference.csv:2: is not UTF-8 text without control "
            "characters\n");
}

TEST(Reference, NeedsItsHeader) {
  EXPECT_EQ(mistakes_of("a,1,1,0,s\n"),
            "  reference.csv:1: \"a,1,1,0,s\", but the first line must be " +
                head);
  EXPECT_EQ(mistakes_of(""),
            "  reference.csv:1: is empty, but must begin with " + head);
  EXPECT_THROW(read_reference("no/such/reference.csv"), input::InputError);
  EXPECT_THROW(read_reference("/dev/zero"), input::InputError);
}

} // namespace asperity::cases::reference_test
