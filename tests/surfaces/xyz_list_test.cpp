// Tests of lists x y z, whose points may be in any order, and of narrow
// matrices that are none. Tolerance: none.
#include "surfaces/formats/npy.hpp"
#include "tests/surfaces/map_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>

namespace asperity::surfaces::xyz_list_test {

using namespace tests_of_formats;

constexpr int n_columns = 7;
constexpr int n_rows = 5;

const ScanRequest as_list{"xyz", {}, {{}, 1e-9, {}, 1e-6}};
const ScanRequest automatic{"auto", {}, {{}, 1e-9, {}, 1e-6}};

/// Points of a grid by rows, with positions that are rounded in each point.
/// @param rounding  of the spacing
std::vector<std::string> points(double rounding = 0.0) {
  std::vector<std::string> lines;
  for (int y = 0; y < n_rows; ++y)
    for (int x = 0; x < n_columns; ++x) {
      const int i = y * n_columns + x;
      const double off = rounding * std::sin(static_cast<double>(i));
      lines.push_back(fmt::format("{} {} {}\n", 0.5 * (x + off) - 1.0,
                                  (y - off) / 3.0, std::sin(i + 0.3)));
    }
  return lines;
}

std::string text_of(const std::vector<std::string>& lines) {
  return std::accumulate(lines.begin(), lines.end(), std::string());
}

/// By columns, the last one first.
std::vector<std::string> by_column(const std::vector<std::string>& lines) {
  std::vector<std::string> sorted;
  for (int x = n_columns - 1; x >= 0; --x)
    for (int y = 0; y < n_rows; ++y)
      sorted.push_back(lines[static_cast<std::size_t>(y * n_columns + x)]);
  return sorted;
}

std::vector<std::string> shuffled(std::vector<std::string> lines) {
  std::ranges::shuffle(lines, std::mt19937(1));
  return lines;
}

/// The map of some points, also by the format of the case.
Scan map_of(const std::vector<std::string>& lines) {
  const std::string path =
      written("list.txt", "x y z\n" + text_of(lines) + "# the end\n");
  Scan scan = read_scan(path, automatic);
  EXPECT_EQ(missing_of(read_scan(path, as_list)), missing_of(scan));
  return scan;
}

TEST(XyzList, HasTheHeightsOfItsPoints) {
  const Scan scan = map_of(shuffled(points()));

  ASSERT_EQ(scan.map.grid.points_x, n_columns);
  ASSERT_EQ(scan.map.grid.points_y, n_rows);
  EXPECT_EQ(scan.reader, "own reader of lists x y z");
  for (int i = 0; i < n_columns * n_rows; ++i)
    EXPECT_EQ(scan.map.heights[static_cast<std::size_t>(i)],
              std::sin(i + 0.3) * 1e-9);
}

TEST(XyzList, MayHaveItsPointsInAnyOrder) {
  for (const double rounding : {0.0, 0.009}) {
    std::vector<std::string> lines = points(rounding);
    const Scan expected = map_of(lines);
    std::vector<std::vector<std::string>> others{by_column(lines),
                                                 shuffled(lines), lines};
    std::ranges::reverse(others.back());
    for (const auto& other : others) {
      const Scan scan = map_of(other);
      EXPECT_EQ(scan.map.grid, expected.map.grid);
      EXPECT_EQ(scan.map.heights, expected.map.heights);
    }
  }
}

TEST(XyzList, MayHaveMissingPoints) {
  std::vector<std::string> lines = points(0.01);
  lines[9] = lines[9].substr(0, lines[9].rfind(' ')) + " nan\n";
  lines.erase(lines.begin() + 20);
  std::vector<char> expected(n_columns * n_rows, 0);
  expected[9] = expected[20] = 1;
  EXPECT_EQ(missing_of(map_of(lines)), expected);
  lines.resize(21);
  std::fill(expected.begin() + 22, expected.end(), 1);
  expected.resize(28); // the last row is absent
  EXPECT_EQ(missing_of(map_of(lines)), expected);
  EXPECT_EQ(missing_of(map_of(shuffled(lines))), expected);
}

TEST(XyzList, IsRefusedWithoutAColumn) {
  std::vector<std::string> lines = points();
  for (std::size_t y = n_rows; y-- > 0;)
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(7 * y + 2));
  EXPECT_NE(refusal_of(written("gap.txt", text_of(lines)), automatic)
                .find("may be a list x y z"),
            std::string::npos);
  EXPECT_NE(refusal_of(written("gap.txt", text_of(lines)), as_list)
                .find("are not the points of a regular grid; interpolate"),
            std::string::npos);
}

TEST(XyzList, NamesTheMistake) {
  std::vector<std::string> lines = by_column(points());
  lines[30] = lines[11];
  const std::string repeated = written("repeated.txt", text_of(lines));
  EXPECT_EQ(refusal_of(repeated, as_list),
            repeated + ":31: the point of line 12 again: each point of the "
                       "grid may occur once");
  EXPECT_NE(refusal_of(repeated, automatic).find("may be a list x y z"),
            std::string::npos);
  const auto expect_refusal = [](const std::string& text,
                                 const ScanRequest& request,
                                 const std::string& part) {
    const std::string found = refusal_of(written("refused.txt", text), request);
    EXPECT_NE(found.find(part), std::string::npos) << found;
  };
  expect_refusal(text_of(by_column(points(0.05))), as_list,
                 "are not the points of a regular grid");
  expect_refusal(text_of(lines) + "1 2 x\n", automatic, "36: column 3");
  expect_refusal(text_of(lines) + "1 2\n", automatic, "36: 2 numbers");
  expect_refusal(text_of(lines) + "nan 2 3\n", as_list, "regular grid");
  expect_refusal("1 2 3 4\n1 2 3 5\n", as_list, "4 columns, but a list");
  expect_refusal("1 2\n1 2\n2 3\n2 4\n", automatic, "a line scan x z");
  expect_refusal("1\n1\n2\n2\n", automatic, "1 column(s) and 4 row(s)");
  expect_refusal("x y z\n", as_list, "contains no numbers");
  ScanRequest unscaled = automatic;
  unscaled.scale.length_unit = std::nullopt;
  const std::string good = text_of(by_column(points()));
  expect_refusal(good, unscaled, "surface.length_unit is missing");
  unscaled = automatic;
  unscaled.scale.length = 1.0;
  expect_refusal(good, unscaled, "surface.length = 1 m, but must be left out");
}

// Texts of two and three columns that are no lists.
TEST(XyzList, IsNoNarrowMatrix) {
  const ScanRequest matrix{"auto", {}, {1e-6, 1e-9}};
  const auto expect_matrix = [](const std::string& text, int columns,
                                const ScanRequest& request) {
    const Scan scan = read_scan(written("narrow.txt", text), request);
    EXPECT_EQ(scan.map.grid.points_x, columns);
    EXPECT_EQ(scan.map.heights[1], 2e-9);
  };
  expect_matrix("1 2 3\n4 5 6\n1 nan 3\n", 3, matrix);
  expect_matrix("1 2\n3 4\n", 2, matrix);
  const std::string list = "0 2 1\n1 2 2\n0 1 3\n1 1 4\n";
  expect_matrix(list, 3, {"plain", {}, {1e-6, 1e-9}});
  const std::string header =
      "# Width: 3 um\n# Height: 4 um\n# Value units: nm\n";
  expect_matrix(header + list, 3, {});
  expect_matrix(list + header, 3, {});
}

TEST(XyzList, MayBeAMatrixOfThreeColumns) {
  std::vector<double> numbers;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 3; ++y)
      numbers.insert(numbers.end(), {0.1 * x, 0.2 * y, std::sin(x + 5.0 * y)});
  numbers[5] = std::numeric_limits<double>::quiet_NaN();
  const std::string path = written("list.npy", npy_bytes(numbers, 12, 3));
  const Scan scan = read_scan(path, automatic);
  EXPECT_EQ(scan.map.grid.points_x, 4);
  EXPECT_EQ(scan.reader, "own reader of .npy");
  EXPECT_EQ(scan.map.heights[1], std::sin(1.0) * 1e-9);
  EXPECT_EQ(count_missing(scan), 1U);
  // Row 3 of the map, column 2: an infinite height is no missing one.
  std::vector<double> infinite = numbers;
  infinite[5] = -std::numeric_limits<double>::infinity();
  EXPECT_NE(
      refusal_of(written("inf.npy", npy_bytes(infinite, 12, 3)), automatic)
          .find("inf.npy: the height in row"),
      std::string::npos);
  EXPECT_NE(refusal_of(written("two.npy", npy_bytes(numbers, 18, 2)), automatic)
                .find("a line scan x z"),
            std::string::npos);
  numbers[0] += 0.05;
  EXPECT_NE(
      refusal_of(written("moved.npy", npy_bytes(numbers, 12, 3)), automatic)
          .find("may be a list x y z"),
      std::string::npos);
  const std::string three = written(
      "three.npy", npy_bytes(std::vector<double>{1, 2, 3, 5, 4, 6}, 2, 3));
  EXPECT_EQ(read_scan(three, {"auto", {}, {1e-6, 1e-9}}).map.grid.points_x, 3);
}

// The number of the case, or that of a header, marks missing points of lists
// and matrices alike.
TEST(XyzList, HasNumbersThatMarkMissingPoints) {
  std::vector<std::string> lines = points();
  lines[8] = "-0.5 0.3333333 -9999\n";
  lines[20] = "2.0 0.6666667 -9999.00\n";
  ScanRequest request = as_list;
  request.missing_value = -9999.0;
  for (const bool is_reversed : {false, true}) {
    if (is_reversed)
      std::ranges::reverse(lines);
    std::string text;
    for (const std::string& line : lines)
      text += line;
    const std::string path = written("marked.txt", text);
    EXPECT_EQ(count_missing(read_scan(path, request)), 2U);
  }
  const std::string grid =
      written("grid.asc", "ncols 4\nnrows 3\ncellsize 2\nNODATA_value -1\n"
                          "1 2 -1 4\n5 6 7 8\n-1 10 11 12\n");
  EXPECT_EQ(count_missing(read_scan(grid, automatic)), 2U);
}

// Gwyddion writes positions with five digits: those of 1024 points over 40 um,
// to 1e-9 m, are off by up to 1.3 % of the spacing, and of 1600 points over 42
// um by 1.9 %, both ends of a distance together by 3.8 %. The grid is that of
// the printed digits. Positions that are off by more than their digits are
// refused, and so are those of a list whose digits tell nothing.
TEST(XyzList, MayBeRoundedToTheirPrintedDigits) {
  const auto list_of = [](int points, double spacing, double moved) {
    std::string text;
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < points; ++x)
        text += fmt::format("{:.5g} {:.5g} {}\n",
                            (x + (x == points / 2 ? moved : 0.0)) * spacing,
                            y * spacing, x + y);
    return text;
  };
  const ScanRequest in_metres{"auto", {}, {{}, 1e-9, {}, 1.0}};
  for (const int points : {1024, 1600}) {
    const double spacing = points == 1024 ? 40e-6 / 1024 : 42e-6 / 1600;
    const std::string path = written("five.txt", list_of(points, spacing, 0.0));
    EXPECT_NEAR(read_scan(path, in_metres).map.grid.length_x /
                    (points * spacing),
                1.0, 1e-4);
    EXPECT_NE(refusal_of(written("moved.txt", list_of(points, spacing, 0.1)),
                         in_metres)
                  .find("may be a list x y z"),
              std::string::npos);
  }
  EXPECT_NE(refusal_of(written("coarse.txt",
                               "0 0 1\n1 0 2\n5 0 3\n0 4 4\n1 4 5\n5 4 6\n"),
                       in_metres)
                .find("may be a list x y z"),
            std::string::npos);
}

} // namespace asperity::surfaces::xyz_list_test
