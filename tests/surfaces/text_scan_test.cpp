// Tests of text files of instruments: headers in any language, decimal commas,
// missing points, units and orientation of a matrix, and the messages about an
// invalid file.
#include "tests/surfaces/map_files.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace asperity::surfaces::text_scan_test {

using namespace tests_of_formats;

Scan text_scan(const std::string& text, const MapScale& scale = {},
               const std::string& format = "auto") {
  return read_scan_bytes(text, "map.txt", {format, {}, scale});
}

std::string refusal(const std::string& text, const MapScale& scale = {},
                    const std::string& format = "auto") {
  return tests::message_of<input::InputError>(
      [&] { text_scan(text, scale, format); });
}

const MapScale list_scale{{}, 1e-9, {}, 1e-6};

// Gwyddion's header is read in every language into which it is translated, with
// decimal commas and with a no-break space before the unit.
TEST(TextScan, ReadsTranslatedHeaders) {
  for (const std::string header :
       {"# Kanal: Topo\n# Breite: 12,5 um\n# H\xC3\xB6he: 8 um\n# Werteinheit: "
        "nm\n",
        "# Canal : Topo\n# Largeur : 12,5\xC2\xA0um\n# Hauteur : 8,0 um\n"
        "# Unit\xC3\xA9s : nm\n",
        "# Kan\xC3\xA1l: Topo\n# \xC5\xA0\xC3\xAD\xC5\x99ka: 12,5 um\n"
        "# V\xC3\xBD\xC5\xA1ka: 8 um\n# Jednotky hodnot: nm\n"}) {
    const Scan scan = text_scan(header + "1,5\t2,5\n3,5\t-4,25\n");
    EXPECT_NEAR(scan.map.grid.length_x, 12.5e-6, 1e-20) << header;
    EXPECT_NEAR(scan.map.grid.length_y, 8e-6, 1e-20) << header;
    EXPECT_NEAR(scan.map.heights[3], -4.25e-9, 1e-23) << header;
    EXPECT_EQ(scan.channel, "Topo");
    EXPECT_EQ(scan.reader, "own reader of Gwyddion text");
  }
}

// Spreadsheets write cells in quotes, COMSOL its header behind '%'.
TEST(TextScan, ReadsTheCellsOfSpreadsheets) {
  const MapScale scale{2e-6, 1e-9};
  for (const std::string text :
       {"\"1.5\",\"2.5\"\n\"3.5\",\"-4.25\"\n",
        "\"1,5\",\"2,5\"\n\"3,5\",\"-4,25\"\n", "1.5,\"2.5\"\n\"3.5\",-4.25\n",
        "\"1,5\";2,5\r\n3,5;\"-4,25\"\r\n",
        "% Model: a.mph\n% Nodes: 4\n1.5 2.5\n3.5 -4.25\n"}) {
    const Scan scan = text_scan(text, scale);
    EXPECT_EQ(scan.map.grid.points_x, 2) << text;
    EXPECT_NEAR(scan.map.heights[1], 2.5e-9, 1e-23) << text;
    EXPECT_NEAR(scan.map.heights[3], -4.25e-9, 1e-23) << text;
  }
  EXPECT_EQ(
      missing_of(text_scan("\"1\",\"2\"\n\"3\",\"\"\n\"5\",\"6\"\n", scale)),
      (std::vector<char>{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(refusal("\"1\",\"2\"\n\"3\",\"four\"\n", scale),
            "map.txt:2: column 2: found 'four', but must be a finite number");
}

// The header of interferometers gives counts, pixel size and the factor of the
// heights.
TEST(TextScan, ReadsTheHeaderOfAMatrix) {
  const std::string header = "h=2 w=3\npixel size=5e-007 m\ndata unit=rad\n"
                             "height conversion factor (-> m)=2e-009\n";
  const Scan scan = text_scan(header + "1 2 3\n4 5 6\n");
  EXPECT_NEAR(scan.map.grid.length_x, 1.5e-6, 1e-20);
  EXPECT_NEAR(scan.map.grid.length_y, 1e-6, 1e-20);
  EXPECT_NEAR(scan.map.heights[5], 12e-9, 1e-22);
  EXPECT_EQ(refusal(header + "1 2\n4 5\n"),
            "map.txt:1: found 'w=3', but the file has 2 columns");
  EXPECT_EQ(refusal("pixel size = 0.5\n1 2 3\n4 5 6\n"),
            "map.txt:1: pixel size: found '0.5', but must be a number > 0 and "
            "a unit of m, mm, um, nm, angstrom");
  EXPECT_EQ(refusal(header + "1 2 3\n4 5 6\n", {1e-6, {}}),
            "surface.length = 1e-06 m, but must be left out: the header of "
            "map.txt gives it");
}

// Lengths of SPIP are in nm.
TEST(TextScan, ReadsTheHeaderOfSpip) {
  const std::string header = "# File Format = ASCII\n# Created by SPIP\n"
                             "# x-pixels = 3\n# y-pixels = 2\n"
                             "# x-length = 2000\n# y-length = 500.5\n";
  const std::string numbers = "# Start of Data:\n1 2 3\n4 5 6\n";
  const Scan scan = text_scan(header + "# z-unit = pm\n" + numbers);
  EXPECT_NEAR(scan.map.grid.length_x, 2e-6, 1e-20);
  EXPECT_NEAR(scan.map.grid.length_y, 0.5005e-6, 1e-20);
  EXPECT_NEAR(scan.map.heights[5], 6e-12, 1e-25);
  EXPECT_NEAR(text_scan(header + "# Bit2nm = 0.5\n" + numbers).map.heights[5],
              3e-9, 1e-22);
  EXPECT_NE(refusal(header + numbers).find("surface.height_unit is missing"),
            std::string::npos);
  EXPECT_EQ(refusal(header + "# z-unit = nm\n1 2\n4 5\n"),
            "map.txt:3: found 'x-pixels 3', but the file has 2 columns");
  EXPECT_NE(
      refusal(header + "# voidpixels = 7\n" + numbers).find("a second matrix"),
      std::string::npos);
}

// The unit of a grid of ESRI is that of its map projection, which the file does
// not state.
TEST(TextScan, ReadsTheHeaderOfAnEsriGrid) {
  const std::string grid = "ncols 3\nNROWS 2\nxllcorner 1000.5\n"
                           "yllcorner -7\ncellsize 0.5\n"
                           "NODATA_value -9999\n1 2 -9999\n4 5 6\n";
  const MapScale scale{{}, 1e-3, {}, 1.0};
  const Scan scan = text_scan(grid, scale);
  EXPECT_NEAR(scan.map.grid.length_x, 1.5, 1e-15);
  EXPECT_NEAR(scan.map.grid.length_y, 1.0, 1e-15);
  EXPECT_NEAR(scan.map.heights[5], 6e-3, 1e-17);
  EXPECT_EQ(missing_of(scan), (std::vector<char>{0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(refusal(grid, {{}, 1e-3}),
            "surface.length_unit is missing: the header of map.txt gives "
            "cellsize = 0.5 without a unit");
  EXPECT_EQ(refusal(grid, {1.5, 1e-3, {}, 1.0}),
            "surface.length = 1.5 m, but must be left out: the header of "
            "map.txt gives it");
  EXPECT_EQ(refusal(grid + "7 8 9\n", scale),
            "map.txt:2: found 'nrows 2', but the file has 3 rows");
}

TEST(TextScan, ReadsTheHeaderOfKeyence) {
  const std::string header = "\"XY Calibration\",\"250\",\"nm/pixel\"\n"
                             "\"Horizontal\",\"3\"\n\"Unit\",\"um\"\n";
  const Scan scan = text_scan(header + "1,2,3\n4,5,6\n");
  EXPECT_NEAR(scan.map.grid.length_x, 750e-9, 1e-21);
  EXPECT_NEAR(scan.map.heights[5], 6e-6, 1e-20);
}

// A header line that names a size or a unit is never ignored silently.
TEST(TextScan, RefusesHeaderLinesThatItDoesNotUnderstand) {
  const std::string numbers = "1 2 3\n4 5 6\n";
  const MapScale scale{6e-6, 1e-9};
  for (const std::string line :
       {"# Scan size: 5 um", "x-length = 2000", "# dx = 0.1", "# pitch: 5",
        "# 5um x 10um", "# Bildbreite 5 \xC2\xB5m", "# dx 0.1",
        "# Scan size 5 5", "X [mm]", "Height unit: um",
        "# Magass\xC3\xA1g: 3 nm",
        "# Scan size: 5 um\n# Z range: 200 nm\n# Unit: nm"}) {
    const std::string first = line.substr(0, line.find('\n'));
    EXPECT_NE(
        refusal(line + "\n" + numbers, scale)
            .find("map.txt:1: '" + first.substr(first.find_first_not_of("# "))),
        std::string::npos)
        << line;
    EXPECT_EQ(
        text_scan(line + "\n" + numbers, scale, "plain").map.grid.length_x,
        6e-6)
        << line;
  }
  for (const std::string line :
       {"# Scan size: 6 um", "# Size: 6 um x 4um", "# Heights [nm]",
        "# made by a script on 3.4.2025 12:30", "# at 10:30 pm", "# sample 12",
        "a b c", "# Pixels of 2 um; heights in nm"})
    EXPECT_EQ(refusal(line + "\n" + numbers, scale), "accepted") << line;
}

TEST(TextScan, ComparesTheUnitsOfTheColumnsOfAList) {
  const std::string points = "0 0 1\n0 1 2\n1 0 3\n1 1 4\n";
  EXPECT_EQ(refusal("x[um] y[um] z[nm]\n" + points, list_scale), "accepted");
  for (const std::string line :
       {"x[nm] y[nm] z[um]", "x[mm] y[mm] z[nm]", "# unit: mm"})
    EXPECT_NE(refusal(line + "\n" + points, list_scale)
                  .find("the case does not repeat"),
              std::string::npos)
        << line;
}

TEST(TextScan, TakesTheSidesOfPixelsThatAreNotSquare) {
  const Scan scan = text_scan("1 2 3\n4 5 6\n", {6e-6, 1e-9, 1e-6});
  EXPECT_EQ(scan.map.grid.length_x, 6e-6);
  EXPECT_EQ(scan.map.grid.length_y, 1e-6);
}

TEST(TextScan, MarksMissingPoints) {
  const Scan scan = text_scan("1 NaN\nBAD 4\n*** ---\n", {1.0, 1.0});
  EXPECT_EQ(or_zero(scan), (std::vector<double>{1, 0, 0, 4, 0, 0}));
  EXPECT_EQ(missing_of(scan), (std::vector<char>{0, 1, 1, 0, 1, 1}));
  EXPECT_EQ(count_missing(scan), 4U);
  EXPECT_EQ(count_missing(text_scan("1 2\n3 4\n", {1.0, 1.0})), 0U);
  EXPECT_EQ(refusal("nan nan\nnan nan\n", {1.0, 1.0}),
            "map.txt: all points are missing");
}

// An empty cell is a missing point: the columns behind it stay where they are,
// whatever separates them, also at the ends of a row and in a row without
// numbers.
TEST(TextScan, KeepsTheColumnsBesideEmptyCells) {
  for (const std::string separator : {",", ";", "\t", ", ", " ;\t"}) {
    std::string text;
    for (const std::string row :
         {"1|2|3|4", "|6|7|8", "9||11|12", "13|14|15|", "|||", "21|22||"}) {
      for (const char letter : row)
        text += letter == '|' ? separator : std::string(1, letter);
      text += "\n";
    }
    const Scan scan = text_scan(text, {4.0, 1.0});
    EXPECT_EQ(scan.map.grid.points_x, 4) << text;
    EXPECT_EQ(or_zero(scan),
              (std::vector<double>{1,  2,  3,  4, 0, 6, 7, 8, 9,  0,  11, 12,
                                   13, 14, 15, 0, 0, 0, 0, 0, 21, 22, 0,  0}))
        << text;
    EXPECT_EQ(count_missing(scan), 9U) << text;
  }
}

// Separators at the end of every row add no column, and a row of another length
// is refused.
TEST(TextScan, RefusesRowsOfOtherLengths) {
  EXPECT_EQ(text_scan("1,2,3,\n4,5,6,\n", {1.0, 1.0}).map.grid.points_x, 3);
  EXPECT_EQ(text_scan("1,5;2;;\n4;5,5;;\n", {1.0, 1.0}).map.heights,
            (std::vector<double>{1.5, 2, 4, 5.5}));
  EXPECT_EQ(text_scan("  1 2\n\t3 4\t\n\t\t\n", {1.0, 1.0}).map.heights,
            (std::vector<double>{1, 2, 3, 4}));
  for (const std::string rows :
       {"1,2,3\n4,5\n", "1;2;\n3;4;5\n", "1\t2\t3\n\t5\n", "1,2\n3,,4\n"})
    EXPECT_NE(refusal(rows, {1.0, 1.0}).find("map.txt:2: "), std::string::npos)
        << rows;
}

// Lines end with CR, LF or both.
TEST(TextScan, ReadsEveryEndOfALine) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const Scan scan =
        text_scan("# a map" + end + "1 2 3" + end + end + "4 5 6", {3.0, 1.0});
    EXPECT_EQ(scan.map.grid.points_x, 3);
    EXPECT_EQ(scan.map.grid.points_y, 2);
    EXPECT_EQ(refusal("1 2" + end + end + "3 x" + end, {1.0, 1.0}),
              "map.txt:3: column 2: found 'x', but must be a finite number");
  }
}

// The only channel of a file is also that with the number 1.
TEST(TextScan, HasOneChannel) {
  const auto with = [](const std::string& channel) {
    return read_scan_bytes("1 2\n3 4\n", "map.txt",
                           {"auto", channel, {1.0, 1.0}});
  };
  EXPECT_EQ(with("1").map.grid.points_x, 2);
  EXPECT_THROW(with("2"), input::InputError);
}

/// Lines of 2 cos(x) + 3 sin(2 x + y), and a mean of 5; x and y in 0 to 2 pi.
std::string fourier_lines(bool has_both, int points) {
  const auto index = [&](int q) {
    return std::to_string(q < 0 ? q + points : q) + " ";
  };
  std::string text = "# qX qY Re Im\n0 0 5 0\n" + index(1) + "0 1 0\n" +
                     index(2) + index(1) + "0 -1.5\n";
  if (has_both || points > 0)
    text += index(-1) + "0 1 0\n";
  if (has_both)
    text += index(-2) + index(-1) + "0 1.5\n";
  return text;
}

// Coefficients of a sum of waves give these waves, whether both of q and -q are
// there, and with the signs or the order of FFTW. Tolerance: roundoff.
TEST(FourierScan, HasTheWavesOfItsCoefficients) {
  for (const bool has_both : {true, false})
    for (const int fftw_points : {0, 16}) {
      if (!has_both && fftw_points == 0)
        continue; // no pair tells that these are coefficients
      const Scan scan =
          text_scan(fourier_lines(has_both, fftw_points), {1e-4, 1e-6});
      ASSERT_EQ(scan.map.grid.points_x, 8);
      ASSERT_EQ(scan.map.grid.points_y, 8);
      EXPECT_EQ(scan.map.grid.length_y, 1e-4);
      for (int iy = 0; iy < 8; ++iy)
        for (int ix = 0; ix < 8; ++ix) {
          const double x = ix * std::numbers::pi / 4.0;
          const double y = iy * std::numbers::pi / 4.0;
          EXPECT_NEAR(
              scan.map.heights[scan.map.grid.index(ix, iy)],
              1e-6 * (5.0 + 2.0 * std::cos(x) + 3.0 * std::sin(2.0 * x + y)),
              1e-20)
              << has_both << fftw_points << ' ' << ix << ' ' << iy;
        }
    }
}

// A half spectrum has all coefficients on one axis, whichever that is: the
// other index of FFTW runs to N/2.
TEST(FourierScan, HasAHalfSpectrumAlongEitherAxis) {
  for (const std::string text : {"1 0 1 0\n15 0 1 0\n14 1 0 -1.5\n",
                                 "0 1 1 0\n0 15 1 0\n1 14 0 -1.5\n"}) {
    const Scan scan = text_scan(text, {1e-4, 1e-6});
    ASSERT_EQ(scan.map.grid.points_x, 8) << text;
    const bool is_along_x = text[0] == '1';
    const int ix = is_along_x ? 1 : 4, iy = is_along_x ? 4 : 1;
    // 2 cos(pi/4) + 3 sin(-2 pi/4 + pi)
    EXPECT_NEAR(scan.map.heights[scan.map.grid.index(ix, iy)],
                1e-6 * (std::numbers::sqrt2 + 3.0), 1e-20)
        << text;
  }
}

// A table of four columns without such pairs is a matrix, as is any with the
// format plain.
TEST(FourierScan, IsNoOtherTable) {
  for (const std::string text :
       {"1 0 1 0\n-1 0 1 1\n0 0 1 1\n", "1 0 1 0\n1 0 1 0\n-1 0 1 0\n",
        "1 0 1 0\n1.5 0 1 1\n-1 0 1 0\n", "1 2 3 4\n5 6 7 8\n"})
    EXPECT_EQ(text_scan(text, {1.0, 1.0}).map.grid.points_x, 4) << text;
  EXPECT_EQ(
      text_scan("1 0 1 2\n-1 0 1 -2\n", {1.0, 1.0}, "plain").map.grid.points_y,
      2);
  EXPECT_EQ(refusal("1 0 1 2\n-1 0 1 -2\n"),
            "surface.length is missing: map.txt is a list of Fourier "
            "coefficients, which does not give its width\n"
            "surface.height_unit is missing: map.txt is a list of Fourier "
            "coefficients, which does not give the unit of its heights");
  EXPECT_NE(refusal("5000 0 1 0\n-5000 0 1 0\n", {1.0, 1.0})
                .find("of more than the 2048 waves"),
            std::string::npos);
}

const std::string gwyddion = "# Channel: Topography\n"
                             "# Width: 12.0 \xC2\xB5m\n"
                             "# Height: 8000 nm\n"
                             "# Value units: nm\n"
                             "1.0\t2.0\t3.5\n"
                             "-4.0\t5e1\t6.0\n";

TEST(TextScan, ReadsAGwyddionMatrixWithItsOwnUnits) {
  const HeightMap map = text_scan(gwyddion).map;

  EXPECT_EQ(map.grid.points_x, 3);
  EXPECT_EQ(map.grid.points_y, 2);
  EXPECT_NEAR(map.grid.length_x, 12e-6, 1e-20);
  EXPECT_NEAR(map.grid.length_y, 8e-6, 1e-20);
  EXPECT_NEAR(map.heights[map.grid.index(2, 0)], 3.5e-9, 1e-23);
  EXPECT_NEAR(map.heights[map.grid.index(0, 1)], -4e-9, 1e-23);
  EXPECT_NEAR(map.heights[map.grid.index(1, 1)], 50e-9, 1e-23);
}

TEST(TextScan, ReadsEverySpellingOfALengthUnit) {
  const auto width = [](const std::string& unit) {
    return text_scan("# Width: 2 " + unit +
                     "\n# Height: 1m\n# Value units: m\n"
                     "1 2\n3 4\n")
        .map.grid.length_x;
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

TEST(TextScan, ReadsAPlainMatrixWithTheUnitsOfTheCase) {
  const HeightMap map = text_scan("\xEF\xBB\xBF# made by a script\r\n"
                                  "1, 2, 3\r\n4, 5, 6\r\n",
                                  {6e-6, 1e-9})
                            .map;

  EXPECT_EQ(map.grid.points_x, 3);
  EXPECT_EQ(map.grid.points_y, 2);
  EXPECT_NEAR(map.grid.length_x, 6e-6, 1e-20);
  EXPECT_NEAR(map.grid.length_y, 4e-6, 1e-20); // square pixels
  EXPECT_NEAR(map.heights[5], 6e-9, 1e-23);
}

// Atoms need a square; 6.24 nm times 24 over 24 is another number.
TEST(TextScan, OfAsManyRowsAsColumnsIsASquare) {
  std::string text;
  for (int row = 0; row < 24; ++row)
    text += "0 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9 0 1 2 3\n";

  const Grid grid = text_scan(text, {6.24e-9, 1e-9}).map.grid;

  EXPECT_EQ(grid.length_y, 6.24e-9);
  EXPECT_TRUE(grid.is_square());
}

TEST(TextScan, ReadsAGwyddionFileAsPlainOnRequest) {
  const HeightMap map = text_scan(gwyddion, {3.0, 1.0}, "plain").map;

  EXPECT_EQ(map.grid.length_x, 3.0);
  EXPECT_EQ(map.heights[0], 1.0);
}

// A matrix that is written with 17 digits and any separator is read back bit
// for bit.
TEST(TextScan, ReadsBackTheNumbersThatWereWritten) {
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
    RC_ASSERT(text_scan(text, {1.0, 1.0}, "plain").map.heights == numbers);
  });
  EXPECT_TRUE(holds);
}

TEST(TextScan, NamesTheLineThatIsNotAMatrix) {
  const MapScale scale{1.0, 1.0};

  EXPECT_EQ(refusal("1 2\n3 x4\n", scale),
            "map.txt:2: column 2: found 'x4', but must be a finite number");
  for (const std::string word : {"3x", "0x10", "1.5.2", "--1", "+-1", "."})
    EXPECT_EQ(refusal("1 " + word + "\n", scale),
              "map.txt:1: column 2: found '" + word +
                  "', but must be a finite number");
  EXPECT_EQ(refusal("1 inf\n", scale),
            "map.txt:1: column 2: found 'inf', but must be a finite number");
  EXPECT_EQ(refusal("1 1e999\n", scale),
            "map.txt:1: column 2: found '1e999', but must be a finite number");
  EXPECT_EQ(refusal("1 2 3\n4 5\n", scale),
            "map.txt:2: 2 numbers in this row, but 3 in line 1; every row must "
            "have the same number");
  EXPECT_EQ(refusal("1,5\t2.5\n", scale),
            "map.txt:1: found decimal commas and decimal points in one file; "
            "use a dot as the decimal separator");
  EXPECT_EQ(refusal("1 2 3\n", scale),
            "map.txt: 3 column(s) and 1 row(s), but a map must have at least "
            "two of each");
  EXPECT_EQ(refusal("", scale), "map.txt: contains no numbers");
}

TEST(TextScan, NamesTheMistakeInTheHeader) {
  const std::string rows = "1 2\n3 4\n";

  EXPECT_EQ(refusal(rows, {}, "gwyddion"),
            "map.txt: no line '# Width: 20 um', which a Gwyddion text matrix "
            "begins with");
  EXPECT_EQ(refusal("# Width: 1 um\n" + rows),
            "map.txt: no line '# Height: 20 um', which a Gwyddion text matrix "
            "begins with");
  for (const std::string width : {"1 V", "wide", "-1 um", "1", "0 um"})
    EXPECT_EQ(refusal("# Width: " + width + "\n" + rows),
              "map.txt:1: Width: found '" + width +
                  "', but must be a number > 0 and a unit of m, mm, um, nm, "
                  "angstrom");
  EXPECT_EQ(refusal("# Width: 1 um\n# Height: 1 um\n# Value units: V\n" + rows),
            "map.txt:3: Value units: found 'V', but must be one of m, mm, um, "
            "nm, angstrom");
}

TEST(TextScan, NamesMissingAndSuperfluousKeysOfTheCase) {
  EXPECT_EQ(refusal("1 2\n3 4\n"),
            "surface.length is missing: map.txt is a plain matrix, which does "
            "not give its width\n"
            "surface.height_unit is missing: map.txt is a plain matrix, which "
            "does not give the unit of its heights");
  EXPECT_EQ(refusal("# Width: 1 um\n# Height: 1 um\n1 2\n3 4\n"),
            "surface.height_unit is missing: map.txt has no line '# Value "
            "units: m'");
  EXPECT_EQ(refusal(gwyddion, {1e-6, {}}),
            "surface.length = 1e-06 m, but must be left out: line 2 of map.txt "
            "gives '12.0 \xC2\xB5m'");
  EXPECT_EQ(refusal(gwyddion, {{}, 1e-9}),
            "surface.height_unit = 1e-09 m, but must be left out: line 4 of "
            "map.txt gives 'nm'");
}

// A message quotes the start of the text that was found, without its control
// characters, which could move a terminal's cursor.
TEST(TextScan, QuotesTextShortenedAndWithoutControlCharacters) {
  EXPECT_EQ(refusal("1 2\n3 \x1B[2J" + std::string(100000, 'x') + "\n",
                    {1e-6, 1e-9}, "plain"),
            "map.txt:2: column 2: found '?[2J" + std::string(56, 'x') +
                "...', but must be a finite number");
}

TEST(TextScan, ReadsFromDiskAndRefusesWhatIsNotAFile) {
  const std::string path = written("map.txt", gwyddion);
  EXPECT_EQ(read_scan(path, {}).map.heights.size(), 6u);

  std::filesystem::remove(path);
  for (const std::string& bad :
       {path, testing::TempDir(), std::string("/dev/zero")})
    EXPECT_THROW(read_scan(bad, {}), input::InputError) << bad;
}

} // namespace asperity::surfaces::text_scan_test
