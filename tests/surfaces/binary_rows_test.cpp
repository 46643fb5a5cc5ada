// Tests of the rows of maps in binary formats: those of the whole file, and
// mistakes. Tolerance: none.
#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "tests/message_of.hpp"
#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/rows_check.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

namespace asperity::surfaces::binary_rows_test {

using namespace tests_of_formats;
using namespace tests_of_rows;

// A file that becomes shorter after it was opened is refused when its rows are
// read.
TEST(BinaryRows, OfAFileThatBecomesShorterAreRefused) {
  const std::string path = written(
      "shorter.sdf", binary_sdf(7, std::vector(37 * 24, 0.5), 1e-11, 37));
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
