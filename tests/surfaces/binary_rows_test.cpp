// Tests of the rows of maps in binary formats: the heights have the bits of one
// process, and mistakes its messages. Tolerance: none.
#include "input/input_error.hpp"
#include "surfaces/measured_rows.hpp"
#include "tests/message_of.hpp"
#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/measured_files.hpp"
#include "tests/surfaces/rows_check.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace asperity::surfaces::binary_rows_test {

using namespace tests_of_rows;
using namespace tests_of_formats;

constexpr auto width = static_cast<std::int32_t>(columns);
constexpr auto height = static_cast<std::int32_t>(rows_of_file);

std::string file_of(const std::string& name, const std::string& bytes) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("binary_rows_" + name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

/// A map whose file gives all scales.
SurfaceSpec scaled(const std::string& file) {
  SurfaceSpec surface = measured(file);
  surface.length = surface.height_unit = std::nullopt;
  return surface;
}

template <class Number>
std::vector<Number> numbers_as() {
  std::vector<Number> numbers;
  for (const double number : heights_of_file())
    numbers.push_back(static_cast<Number>(100.0 * number));
  return numbers;
}

TEST(BinaryRows, OfSdfHaveTheBitsOfOneProcess) {
  expect_bits_of_one_process(scaled(file_of(
      "double.sdf", binary_sdf(7, numbers_as<double>(), 1e-11, columns))));
  SurfaceSpec window = scaled(
      file_of("float.sdf", binary_sdf(3, numbers_as<float>(), 1e-11, columns)));
  window.crop = mechanics::MapWindow{3e-6, 4e-6, 20e-6, 0.0};
  window.level = mechanics::Levelling::bow;
  expect_bits_of_one_process(window);
}

TEST(BinaryRows, OfSdfWithMissingPointsHaveTheBitsOfOneProcess) {
  std::vector<std::int16_t> numbers = numbers_as<std::int16_t>();
  for (const std::size_t i : {0, 40, 41, 400, 887})
    numbers[i] = std::numeric_limits<std::int16_t>::min();
  const SurfaceSpec surface =
      scaled(file_of("holes.sdf", binary_sdf(5, numbers, 1e-11, columns)));

  expect_bits_of_one_process(surface);
  EXPECT_EQ(described_map(surface).missing, 5U);
  EXPECT_EQ(described_map(surface).reader, "own reader of SDF (binary)");
}

TEST(BinaryRows, AreRefusedAsInOneProcess) {
  const std::string sdf = binary_sdf(7, numbers_as<double>(), 1e-11, columns);
  const std::vector<SurfaceSpec> refused{
      scaled(file_of("short.sdf", sdf.substr(0, sdf.size() - 1))),
      scaled(file_of("header.sdf", sdf.substr(0, 60))),
      scaled(file_of("type.sdf", binary_sdf<double>(9, {1, 2, 3, 4, 5, 6}, 1))),
      measured(file_of("scales.sdf", sdf))};
  for (const SurfaceSpec& surface : refused) {
    SCOPED_TRACE(surface.file);
    const std::string expected = tests::message_of<input::InputError>(
        [&] { build_surface(surface, 0); });
    ASSERT_NE(expected, "");
    EXPECT_EQ(tests::message_of<input::InputError>(
                  [&] { reason_for_whole_map(surface); }),
              expected);
  }
}

// A file that becomes shorter after it was opened is refused when its rows are
// read.
TEST(BinaryRows, OfAFileThatBecomesShorterAreRefused) {
  const std::string path = file_of(
      "shorter.sdf", binary_sdf(7, numbers_as<double>(), 1e-11, columns));
  const OpenMap file = open_map(path, {});
  std::filesystem::resize_file(path, 200);

  EXPECT_EQ(tests::message_of<input::InputError>([&] { file.rows(1, 2); }),
            path + ": cannot be read to its end");
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
    std::string one = little_endian(number);
    if (type.front() == '>')
      std::ranges::reverse(one);
    bytes += one;
  }
  return bytes;
}

TEST(FortranRows, AreThoseOfTheWholeFile) {
  const ScanRequest request{mechanics::MapFormat::automatic, {}, {1e-6, 1e-9}};
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
  const OpenMap file = open_map(path, request);
  std::filesystem::resize_file(path, 20000);
  EXPECT_EQ(tests::message_of<input::InputError>([&] { file.rows(0, 9); }),
            path + ": cannot be read to its end");
}

} // namespace asperity::surfaces::binary_rows_test
