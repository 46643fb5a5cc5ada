// Tests of surfaces/formats/text/map_file.hpp: units, orientation, and the
// messages about an invalid file.
#include "input/input_error.hpp"
#include "surfaces/formats/text/map_file.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace asperity::surfaces::map_file_test {

using mechanics::MapFormat;
using namespace std::string_literals;

HeightMap read(const std::string& text, const MapScale& scale = {},
               MapFormat format = MapFormat::automatic) {
  return read_height_map_text(text, "map.txt", format, scale);
}

const std::string gwyddion = "# Channel: Topography\n"
                             "# Width: 12.0 \xC2\xB5m\n"
                             "# Height: 8000 nm\n"
                             "# Value units: nm\n"
                             "1.0\t2.0\t3.5\n"
                             "-4.0\t5e1\t6.0\n";

TEST(MapFile, ReadsAGwyddionMatrixWithItsOwnUnits) {
  const HeightMap map = read(gwyddion);

  EXPECT_EQ(map.grid.points_x, 3);
  EXPECT_EQ(map.grid.points_y, 2);
  EXPECT_NEAR(map.grid.length_x, 12e-6, 1e-20);
  EXPECT_NEAR(map.grid.length_y, 8e-6, 1e-20);
  EXPECT_NEAR(map.heights[map.grid.index(2, 0)], 3.5e-9, 1e-23);
  EXPECT_NEAR(map.heights[map.grid.index(0, 1)], -4e-9, 1e-23);
  EXPECT_NEAR(map.heights[map.grid.index(1, 1)], 50e-9, 1e-23);
}

TEST(MapFile, ReadsEverySpellingOfALengthUnit) {
  const auto width = [](const std::string& unit) {
    return read("# Width: 2 " + unit +
                "\n# Height: 1m\n# Value units: m\n"
                "1 2\n3 4\n")
        .grid.length_x;
  };

  EXPECT_EQ(width("m"), 2.0);
  EXPECT_EQ(width("mm"), 2e-3);
  for (const char* micro : {"um", "\xC2\xB5m", "\xCE\xBCm", "\xB5m"})
    EXPECT_EQ(width(micro), 2e-6) << micro;
  EXPECT_EQ(width("nm"), 2e-9);
  EXPECT_EQ(width("pm"), 2e-12);
  EXPECT_EQ(width("in"), 2.0 * 0.0254);
  for (const char* angstrom : {"angstrom", "\xC3\x85", "\xE2\x84\xAB", "\xC5"})
    EXPECT_EQ(width(angstrom), 2e-10) << angstrom;
}

TEST(MapFile, ReadsAPlainMatrixWithTheUnitsOfTheCase) {
  const HeightMap map = read("\xEF\xBB\xBF# made by a script\r\n"
                             "1, 2, 3\r\n4, 5, 6\r\n",
                             {6e-6, 1e-9});

  EXPECT_EQ(map.grid.points_x, 3);
  EXPECT_EQ(map.grid.points_y, 2);
  EXPECT_NEAR(map.grid.length_x, 6e-6, 1e-20);
  EXPECT_NEAR(map.grid.length_y, 4e-6, 1e-20); // square pixels
  EXPECT_NEAR(map.heights[5], 6e-9, 1e-23);
}

// Atoms need a square; 6.24 nm times 24 over 24 is another number.
TEST(MapFile, OfAsManyRowsAsColumnsIsASquare) {
  std::string text;
  for (int row = 0; row < 24; ++row)
    text += "0 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9 0 1 2 3\n";

  const Grid grid = read(text, {6.24e-9, 1e-9}).grid;

  EXPECT_EQ(grid.length_y, 6.24e-9);
  EXPECT_TRUE(grid.is_square());
}

TEST(MapFile, ReadsAGwyddionFileAsPlainOnRequest) {
  const HeightMap map = read(gwyddion, {3.0, 1.0}, MapFormat::plain);

  EXPECT_EQ(map.grid.length_x, 3.0);
  EXPECT_EQ(map.heights[0], 1.0);
}

// A matrix that is written with 17 digits and any separator is read back bit
// for bit.
TEST(MapFile, ReadsBackTheNumbersThatWereWritten) {
  const bool holds = rc::check([](bool has_commas) {
    const int columns = *rc::gen::inRange(2, 6);
    const int rows = *rc::gen::inRange(2, 6);
    const auto size = static_cast<std::size_t>(columns * rows);
    const auto numbers = *rc::gen::container<std::vector<double>>(
        size, rc::gen::arbitrary<double>());
    std::string text;
    for (std::size_t i = 0; i < size; ++i) {
      char number[40];
      std::snprintf(number, sizeof number, "%.17g", numbers[i]);
      const bool ends_row = (i + 1) % static_cast<std::size_t>(columns) == 0;
      text += number + std::string(ends_row ? "\n" : has_commas ? "," : " ");
    }
    RC_ASSERT(read(text, {1.0, 1.0}, MapFormat::plain).heights == numbers);
  });
  EXPECT_TRUE(holds);
}

std::string message_of(const std::string& text, const MapScale& scale = {},
                       MapFormat format = MapFormat::automatic) {
  return tests::message_of<input::InputError>(
      [&] { read(text, scale, format); });
}

TEST(MapFile, NamesTheLineThatIsNotAMatrix) {
  const MapScale scale{1.0, 1.0};

  EXPECT_EQ(message_of("1 2\n3 x4\n", scale),
            "map.txt:2: column 2: found 'x4', but must be a finite number");
  for (const std::string word : {"3x", "0x10", "1.5.2", "--1", "+-1", "."})
    EXPECT_EQ(message_of("1 " + word + "\n", scale),
              "map.txt:1: column 2: found '" + word +
                  "', but must be a finite number");
  EXPECT_EQ(message_of("1 2\n\n# missing\nnan 4\n", scale),
            "map.txt: 1 of 4 points are missing, but none must be");
  EXPECT_EQ(message_of("1 inf\n", scale),
            "map.txt:1: column 2: found 'inf', but must be a finite number");
  EXPECT_EQ(message_of("1 1e999\n", scale),
            "map.txt:1: column 2: found '1e999', but must be a finite number");
  EXPECT_EQ(message_of("1 2 3\n4 5\n", scale),
            "map.txt:2: 2 numbers in this row, but 3 in line 1; every row must "
            "have the same number");
  EXPECT_EQ(message_of("1,5\t2.5\n", scale),
            "map.txt:1: found decimal commas and decimal points in one file; "
            "use a dot as the decimal separator");
  EXPECT_EQ(message_of("1 2 3\n", scale),
            "map.txt: 3 column(s) and 1 row(s), but a map must have at least "
            "two of each");
  EXPECT_EQ(message_of("", scale), "map.txt: contains no numbers");
}

TEST(MapFile, NamesTheMistakeInTheHeader) {
  const std::string rows = "1 2\n3 4\n";

  EXPECT_EQ(message_of(rows, {}, MapFormat::gwyddion),
            "map.txt: no line '# Width: 20 um', which a Gwyddion text matrix "
            "begins with");
  EXPECT_EQ(message_of("# Width: 1 um\n" + rows),
            "map.txt: no line '# Height: 20 um', which a Gwyddion text matrix "
            "begins with");
  for (const std::string width : {"1 V", "wide", "-1 um", "1", "0 um"})
    EXPECT_EQ(message_of("# Width: " + width + "\n" + rows),
              "map.txt:1: Width: found '" + width +
                  "', but must be a number > 0 and a unit of m, mm, um, nm, "
                  "angstrom");
  EXPECT_EQ(
      message_of("# Width: 1 um\n# Height: 1 um\n# Value units: V\n" + rows),
      "map.txt:3: Value units: found 'V', but must be one of m, mm, um, "
      "nm, angstrom");
}

TEST(MapFile, NamesMissingAndSuperfluousKeysOfTheCase) {
  EXPECT_EQ(message_of("1 2\n3 4\n"),
            "surface.length is missing: map.txt is a plain matrix, which does "
            "not give its width");
  EXPECT_EQ(message_of("# Width: 1 um\n# Height: 1 um\n1 2\n3 4\n"),
            "surface.height_unit is missing: map.txt has no line '# Value "
            "units: m'");
  EXPECT_EQ(message_of(gwyddion, {1e-6, {}}),
            "surface.length = 1e-06 m, but must be left out: line 2 of map.txt "
            "gives '12.0 \xC2\xB5m'");
  EXPECT_EQ(message_of(gwyddion, {{}, 1e-9}),
            "surface.height_unit = 1e-09 m, but must be left out: line 4 of "
            "map.txt gives 'nm'");
}

// A message quotes the start of the text that was found, without its control
// characters, which could move a terminal's cursor.
TEST(MapFile, QuotesTextShortenedAndWithoutControlCharacters) {
  EXPECT_EQ(message_of("1 2\n3 \x1B[2J" + std::string(100000, 'x') + "\n",
                       {1e-6, 1e-9}),
            "map.txt:2: column 2: found '?[2J" + std::string(56, 'x') +
                "...', but must be a finite number");
}

TEST(MapFile, ReadsFromDiskAndRefusesWhatIsNotAFile) {
  const std::filesystem::path folder = testing::TempDir();
  const std::string path = folder / "asperity_map_file_test.txt";
  std::ofstream(path) << gwyddion;

  EXPECT_EQ(read_scan(path, {}).map.heights.size(), 6u);

  std::filesystem::remove(path);
  for (const std::string& bad : {path, folder.string(), "/dev/zero"s})
    EXPECT_THROW(read_scan(bad, {}), input::InputError) << bad;
}

} // namespace asperity::surfaces::map_file_test
