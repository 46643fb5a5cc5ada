// Tests of SDF files as text whose rows are read separately: bits, missing
// points and messages are those of the file as a whole. Tolerance: none.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/surfaces/row_file_check.hpp"

namespace asperity::surfaces::sdf_rows_test {

using namespace tests_of_rows;

std::string header(int points, int profiles, const std::string& line_end) {
  return fmt::format("aISO-1.0{0}ManufacID = x{0}NumPoints = {1}{0}NumProfiles "
                     "= {2}{0}Xscale = 1e-6{0}Yscale = 2e-6{0}Zscale = "
                     "1.1e-9{0}*{0}",
                     line_end, points, profiles);
}

/// @param per_line  numbers of a line, which need not be those of a row
std::string numbers(int count, int per_line, const std::string& line_end) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += (i % 17 == 5 ? "BAD" : fmt::format("{:.7f}", std::sin(0.3 * i))) +
            ((i + 1) % per_line == 0 ? line_end : " ");
  return text;
}

TEST(SdfRows, AreThoseOfTheWholeFileWhereverItsLinesEnd) {
  for (const std::string line_end : {"\n", " \t\r\n"})
    for (const int per_line : {1, 5, 7, 14, 100})
      expect_rows_of(written("lines.sdf", header(7, 6, line_end) +
                                              numbers(42, per_line, line_end) +
                                              line_end + line_end + "*" +
                                              line_end + "the end 7 x"),
                     {});
  expect_rows_of(written("open.sdf", header(7, 6, "\n") + numbers(42, 9, "\n")),
                 {});
}

// One line is longer than what is in memory.
TEST(SdfRows, OfALongLineAreThoseOfTheWholeFile) {
  const int count = 700 * 300;
  const std::string text =
      header(700, 300, "\r\n") + numbers(count, count, " \r \r\n");
  ASSERT_GT(text.size(), 2000000U);
  expect_rows_of(written("long.sdf", text + "*"), {});
  std::string blanks;
  while (blanks.size() < 3500000)
    blanks += " \r";
  expect_rows_of(
      written("blanks.sdf", header(7, 6, "\n") + numbers(42, 50, "") + blanks),
      {});
  const std::string path = written("late.sdf", text + "7");
  EXPECT_EQ(refusal_of(path, {}),
            path + ":10: more than the 210000 numbers of the header");
}

TEST(SdfRows, AreRefusedAsTheWholeFileIs) {
  const std::string good = header(7, 6, "\n") + numbers(42, 7, "\n");
  refusal_of(written("more.sdf", good + "3\n"), {});
  refusal_of(written("star.sdf", good + " *\n"), {});
  refusal_of(written("return.sdf", header(7, 6, "\n") + "1 2\r 3\n"), {});
  refusal_of(written("word.sdf", header(7, 6, "\n") + "1 2 x\n"), {});
  refusal_of(written("fewer.sdf", good.substr(0, good.size() - 11)), {});
  refusal_of(written("short.sdf", good.substr(0, 60)), {});
  refusal_of(written("version.sdf", good.substr(0, 8)), {});
  refusal_of(written("sizes.sdf", header(999999, 999999, "\n") + "1\n"), {});
  refusal_of(written("side.sdf", header(1, 6, "\n") + "1\n"), {});
  refusal_of(
      written("half.sdf", header(7, 6, "\n") + "*\n" + numbers(42, 7, "\n")),
      {});
  refusal_of(written("scale.sdf", good),
             {mechanics::MapFormat::automatic, {}, {1e-6, {}}});
}

TEST(SdfRows, OfAFileThatBecomesShorterAreRefused) {
  const std::string text = header(7, 6, "\n") + numbers(42, 7, "\n");
  const std::string path = written("shorter.sdf", text);
  const auto file = row_file(path, {});
  ASSERT_TRUE(file);
  std::filesystem::resize_file(path, text.size() - 30);
  EXPECT_EQ(tests::message_of<input::InputError>([&] { file->rows(4, 2); }),
            path + ": has fewer rows than when the run began");
}

} // namespace asperity::surfaces::sdf_rows_test
