// Tests of lists x y z in any order, and of matrices in Fortran order, whose
// rows are read separately: bits, missing points and messages are those of the
// file as a whole. Tolerance: none.
#include "surfaces/formats/npy.hpp"
#include "surfaces/formats/text/list_points.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>
#include <random>

#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/row_file_check.hpp"

namespace asperity::surfaces::list_rows_test {

using namespace tests_of_rows;
using mechanics::MapFormat;

constexpr int n_columns = 7;
constexpr int n_rows = 5;

const ScanRequest as_list{MapFormat::xyz, {}, {{}, 1e-9, {}, 1e-6}};
const ScanRequest automatic{MapFormat::automatic, {}, {{}, 1e-9, {}, 1e-6}};

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

void expect_list(const std::vector<std::string>& lines) {
  const std::string path =
      written("list.txt", "x y z\n" + text_of(lines) + "# the end\n");
  expect_rows_of(path, automatic);
  expect_rows_of(path, as_list);
}

TEST(ListRows, InAnyOrderAreThoseOfTheWholeFile) {
  for (const double rounding : {0.0, 0.009}) {
    std::vector<std::string> lines = points(rounding);
    expect_list(by_column(lines));
    expect_list(shuffled(lines));
    std::ranges::reverse(lines);
    expect_list(lines);
    lines = by_column(lines);
    std::ranges::reverse(lines);
    expect_list(lines);
  }
}

TEST(ListRows, WithMissingPointsAreThoseOfTheWholeFile) {
  std::vector<std::string> lines = points(0.01);
  lines[9] = lines[9].substr(0, lines[9].rfind(' ')) + " nan\n";
  lines.erase(lines.begin() + 20);
  expect_list(lines);
  lines.resize(21);
  expect_list(lines);
  expect_list(shuffled(lines));
  expect_list(by_column(points()));
}

// Positions of a whole column or row may be absent: then there is no grid, or
// a coarser one.
TEST(ListRows, WithoutAColumnAreReadAsTheWholeFileIs) {
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

TEST(ListRows, AreRefusedAsTheWholeFileIs) {
  std::vector<std::string> lines = by_column(points());
  lines[30] = lines[11];
  const std::string repeated = written("repeated.txt", text_of(lines));
  EXPECT_EQ(refusal_of(repeated, as_list),
            repeated + ":31: the point of line 12 again: each point of the "
                       "grid may occur once");
  EXPECT_NE(refusal_of(repeated, automatic).find("may be a list x y z"),
            std::string::npos);
  refusal_of(written("rounded.txt", text_of(by_column(points(0.05)))), as_list);
  refusal_of(written("word.txt", text_of(lines) + "1 2 x\n"), automatic);
  refusal_of(written("short.txt", text_of(lines) + "1 2\n"), automatic);
  refusal_of(written("nan.txt", text_of(lines) + "nan 2 3\n"), as_list);
  refusal_of(written("four.txt", "1 2 3 4\n1 2 3 5\n"), as_list);
  refusal_of(written("two.txt", "1 2\n1 2\n2 3\n2 4\n"), automatic);
  refusal_of(written("one.txt", "1\n1\n2\n2\n"), automatic);
  refusal_of(written("empty.txt", "x y z\n"), as_list);
  ScanRequest unscaled = automatic;
  unscaled.scale.length_unit = std::nullopt;
  const std::string good = written("good.txt", text_of(by_column(points())));
  refusal_of(good, unscaled);
  unscaled = automatic;
  unscaled.scale.length = 1.0;
  refusal_of(good, unscaled);
}

// Texts of two and three columns that are no lists.
TEST(ListRows, OfNarrowMatricesAreThoseOfTheWholeFile) {
  const ScanRequest matrix{MapFormat::automatic, {}, {1e-6, 1e-9}};
  expect_rows_of(written("three.txt", "1 2 3\n4 5 6\n1 nan 3\n"), matrix);
  expect_rows_of(written("two.txt", "1 2\n3 4\n"), matrix);
  expect_rows_of(written("list.txt", "0 0 1\n1 0 2\n0 1 3\n1 1 4\n"),
                 {MapFormat::plain, {}, {1e-6, 1e-9}});
  const std::string header =
      "# Width: 3 um\n# Height: 4 um\n# Value units: nm\n";
  expect_rows_of(
      written("gwyddion.txt", header + "0 0 1\n1 0 2\n0 1 3\n1 1 4\n"), {});
  expect_rows_of(
      written("gwyddion.txt", "0 0 1\n1 0 2\n1 1 3\n0 1 4\n" + header), {});
}

// More positions than intervals that are kept: the axis is found from intervals
// or by a second pass.
TEST(ListRows, OfManyPositionsHaveTheAxisOfTheWholeFile) {
  for (const std::size_t most : {16, 64, 1000}) {
    AxisPositions positions(most);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> rounding(-0.009, 0.009);
    double least = 1.0, largest = 1.0;
    for (int i = 0; i < 5000; ++i) {
      const double at = 1.0 + 0.1 * (i * 7 % 13 + rounding(random));
      least = std::min(least, at);
      largest = std::max(largest, at);
      positions.take(at);
    }
    EXPECT_EQ(positions.is_resolved(), most > 16);
    const auto axis = positions.axis(0.0);
    ASSERT_EQ(axis.has_value(), most > 16);
    if (axis) {
      EXPECT_EQ(axis->points, 13U);
      EXPECT_EQ(axis->first, least);
      EXPECT_EQ(axis->spacing, (largest - least) / 12.0);
    }
  }
}

TEST(ListRows, OfALongAxisAreThoseOfTheWholeFile) {
  constexpr int length = 70000;
  std::string text;
  for (const int y : {1, 0})
    for (int i = 0; i < length; ++i)
      text += fmt::format("{} {} {}\n", i * 3 % length, y, i % 11);
  const std::string path = written("long.txt", text);
  const auto file = row_file(path, automatic);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->grid.points_x, length);
  const Scan whole = read_scan(path, automatic);
  EXPECT_EQ(file->grid, whole.map.grid);
  expect_rows(*file, whole, 1, 1);
}

TEST(ListRows, OfAFileThatChangesAreRefused) {
  std::vector<std::string> lines = by_column(points());
  const std::string path = written("changes.txt", text_of(lines));
  const auto file = row_file(path, as_list);
  ASSERT_TRUE(file);
  const std::string expected = path + ": has changed since the run began";
  const auto time = std::filesystem::last_write_time(path);
  const auto message = [&](const std::string& text) {
    std::ofstream(path) << text;
    std::filesystem::last_write_time(path, time);
    return tests::message_of<input::InputError>([&] { file->rows(1, 2); });
  };

  EXPECT_EQ(message(text_of({lines.begin(), lines.end() - 1})), expected);
  EXPECT_EQ(message(text_of(lines) + lines[0]), expected);
  std::vector<std::string> same_size = lines;
  same_size[3][0] = '7';
  EXPECT_EQ(message(text_of(same_size)), expected);
  same_size = lines;
  same_size[3][0] = '#'; // a comment
  EXPECT_EQ(message(text_of(same_size)), expected);
  EXPECT_EQ(message("1 2\n3 4\n"), expected);
  EXPECT_EQ(message(text_of(lines)), "accepted");
  std::filesystem::last_write_time(path, time + std::chrono::seconds(2));
  EXPECT_EQ(tests::message_of<input::InputError>([&] { file->rows(1, 2); }),
            expected);
}

/// An .npy file in Fortran order.
template <class Number>
std::string fortran_npy(const std::vector<Number>& numbers, int rows,
                        int columns, const std::string& type) {
  std::string header = fmt::format(
      "{{'descr': '{}', 'fortran_order': True, 'shape': ({}, {}), }}", type,
      rows, columns);
  header.resize(118, ' ');
  std::string bytes = "\x93NUMPY";
  bytes += {'\1', '\0', 118, '\0'};
  bytes += header;
  for (const Number number : numbers) {
    std::string one = tests_of_formats::little_endian(number);
    if (type.front() == '>')
      std::ranges::reverse(one);
    bytes += one;
  }
  return bytes;
}

TEST(FortranRows, AreThoseOfTheWholeFile) {
  const ScanRequest request{MapFormat::automatic, {}, {1e-6, 1e-9}};
  std::vector<double> numbers(9 * 13);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = i == 50 ? std::nan("") : std::sin(static_cast<double>(i));
  const std::vector<float> singles(numbers.begin(), numbers.end());
  for (const std::string type : {"<f8", ">f8"})
    expect_rows_of(written("f8.npy", fortran_npy(numbers, 9, 13, type)),
                   request);
  expect_rows_of(written("f4.npy", fortran_npy(singles, 13, 9, "<f4")),
                 request);
  // Columns of more than a page.
  std::vector<double> high(6000);
  std::iota(high.begin(), high.end(), 0.5);
  expect_rows_of(written("high.npy", fortran_npy(high, 1500, 4, "<f8")),
                 request);
  const std::string path =
      written("shorter.npy", fortran_npy(high, 1500, 4, "<f8"));
  const auto file = row_file(path, request);
  ASSERT_TRUE(file);
  std::filesystem::resize_file(path, 20000);
  EXPECT_EQ(tests::message_of<input::InputError>([&] { file->rows(0, 9); }),
            path + ": cannot be read to its end");
}

TEST(ListRows, OfAnNpyFileAreThoseOfTheWholeFile) {
  std::vector<double> numbers;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 3; ++y)
      numbers.insert(numbers.end(), {0.1 * x, 0.2 * y, std::sin(x + 5.0 * y)});
  numbers[5] = std::numeric_limits<double>::infinity();
  expect_rows_of(written("list.npy", npy_bytes(numbers, 12, 3)), automatic);
  std::vector<double> by_columns;
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t i = column; i < numbers.size(); i += 3)
      by_columns.push_back(numbers[i]);
  expect_rows_of(written("list.npy", fortran_npy(by_columns, 12, 3, "<f8")),
                 automatic);
  refusal_of(written("two.npy", npy_bytes(numbers, 18, 2)), automatic);
  numbers[0] += 0.05;
  refusal_of(written("moved.npy", npy_bytes(numbers, 12, 3)), automatic);
  const ScanRequest matrix{MapFormat::automatic, {}, {1e-6, 1e-9}};
  expect_rows_of(
      written("three.npy",
              npy_bytes(std::vector<double>{1, 2, 3, 5, 4, 6}, 2, 3)),
      matrix);
}

// The number of the case, or that of a header, marks missing points of lists
// and matrices alike.
TEST(ListRows, NumbersThatMarkMissingPoints) {
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
    expect_rows_of(path, request);
    EXPECT_EQ(count_missing(read_scan(path, request)), 2U);
  }
  const std::string grid =
      written("grid.asc", "ncols 4\nnrows 3\ncellsize 2\nNODATA_value -1\n"
                          "1 2 -1 4\n5 6 7 8\n-1 10 11 12\n");
  expect_rows_of(grid, automatic);
  EXPECT_EQ(count_missing(read_scan(grid, automatic)), 2U);
}

// Gwyddion writes positions with five digits: those of 1024 points over 40 um,
// to 1e-9 m, are off by up to 1.3 % of the spacing, and of 1600 points over 42
// um by 1.9 %, both ends of a distance together by 3.8 %. The grid is that of
// the printed digits. Positions that are off by more than their digits are
// refused, and so are those of a list whose digits tell nothing.
TEST(ListRows, MayBeRoundedToTheirPrintedDigits) {
  const auto list_of = [](int points, double spacing, double moved) {
    std::string text;
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < points; ++x)
        text += fmt::format("{:.5g} {:.5g} {}\n",
                            (x + (x == points / 2 ? moved : 0.0)) * spacing,
                            y * spacing, x + y);
    return text;
  };
  const ScanRequest in_metres{MapFormat::automatic, {}, {{}, 1e-9, {}, 1.0}};
  for (const int points : {1024, 1600}) {
    const double spacing = points == 1024 ? 40e-6 / 1024 : 42e-6 / 1600;
    const std::string path = written("five.txt", list_of(points, spacing, 0.0));
    expect_rows_of(path, in_metres);
    EXPECT_NEAR(read_scan(path, in_metres).map.grid.length_x /
                    (points * spacing),
                1.0, 1e-4);
    refusal_of(written("moved.txt", list_of(points, spacing, 0.1)), in_metres);
  }
  refusal_of(
      written("coarse.txt", "0 0 1\n1 0 2\n5 0 3\n0 4 4\n1 4 5\n5 4 6\n"),
      in_metres);
}

// Empty cells and CR line ends are those of the whole file.
TEST(TextRows, WithEmptyCellsAreThoseOfTheWholeFile) {
  const ScanRequest scaled{MapFormat::automatic, {}, {1e-6, 1e-9}};
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    expect_rows_of(written("cells.csv", "a header" + end + "1,2,3,4" + end +
                                            ",6,7,8" + end + "9,,,12" + end +
                                            ",,," + end + "5,6,7," + end),
                   scaled);
    expect_rows_of(written("cells.txt", "1\t2\t3\t4" + end + "\t6\t7\t" + end +
                                            "\t\t\t" + end + "5\t6\t\t8"),
                   scaled);
  }
}

} // namespace asperity::surfaces::list_rows_test
