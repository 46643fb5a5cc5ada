// Tests of surfaces/formats/npy.hpp. The files are written byte by byte as
// numpy.lib.format describes them.
#include "input/input_error.hpp"
#include "surfaces/formats/npy.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace asperity::surfaces::npy_test {

using namespace std::string_literals;

std::string file_with(const std::string& header, const std::string& data,
                      char version = '\1') {
  std::string length{static_cast<char>(header.size() % 256),
                     static_cast<char>(header.size() / 256)};
  if (version != '\1')
    length += "\0\0"s;
  return "\x93NUMPY"s + version + '\0' + length + header + data;
}

std::string header_of(const std::string& type, const std::string& shape,
                      const std::string& order = "False") {
  return "{'descr': '" + type + "', 'fortran_order': " + order +
         ", 'shape': (" + shape + "), }\n";
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers, bool is_swapped) {
  std::string bytes;
  for (const Number number : numbers) {
    std::string one(sizeof(Number), '\0');
    std::memcpy(one.data(), &number, sizeof(Number));
    bytes += is_swapped ? std::string(one.rbegin(), one.rend()) : one;
  }
  return bytes;
}

std::string message_of(const std::string& bytes) {
  return tests::message_of<input::InputError>(
      [&] { read_npy_text(bytes, "p.npy"); });
}

// Numbers of both widths and byte orders, by row and by column, are read
// exactly, in each version of the format.
TEST(Npy, ReadsEveryOrder) {
  const std::vector<double> numbers{
      1.5, -2.0, 1e-300, 4.0, 5.0, std::numeric_limits<double>::infinity()};
  for (const char version : {'\1', '\2', '\3'}) {
    const Matrix rows = read_npy_text(
        file_with(header_of("<f8", "2, 3"), bytes_of(numbers, false), version),
        "p.npy");
    EXPECT_EQ(rows.rows, 2U);
    EXPECT_EQ(rows.columns, 3U);
    EXPECT_EQ(rows.numbers, numbers);
  }
  EXPECT_EQ(
      read_npy_text(
          file_with(header_of(">f8", "2, 3"), bytes_of(numbers, true)), "p.npy")
          .numbers,
      numbers);
  const std::vector<double> by_column{1.0, 4.0, 2.0, 5.0, 3.0, 6.0};
  EXPECT_EQ(read_npy_text(file_with(header_of("<f8", "2, 3", "True"),
                                    bytes_of(by_column, false)),
                          "p.npy")
                .numbers,
            (std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}));
  const std::vector<float> singles{0.1F, 2.0F};
  for (const bool is_swapped : {false, true})
    EXPECT_EQ(
        read_npy_text(file_with(header_of(is_swapped ? ">f4" : "<f4", "1, 2"),
                                bytes_of(singles, is_swapped)),
                      "p.npy")
            .numbers,
        (std::vector<double>{0.1F, 2.0}));
}

// What is written is read again, bit by bit, and the numbers begin at a
// multiple of 64 bytes, as the format asks.
TEST(Npy, IsReadAsWritten) {
  const std::vector<double> numbers{0.1, -0.0, 1e300, 5e-324};
  const std::string bytes = npy_bytes(numbers, 4, 1);
  const Matrix matrix = read_npy_text(bytes, "p.npy");
  EXPECT_EQ(matrix.rows, 4U);
  EXPECT_EQ(matrix.numbers, numbers);
  EXPECT_EQ((bytes.size() - 4 * sizeof(double)) % 64, 0U);
  EXPECT_THROW(npy_bytes(numbers, 3, 1), std::domain_error);
}

// A file that cannot be read is refused with what was found.
TEST(Npy, RefusesWhatItCannotRead) {
  const std::string data(48, 'x');
  EXPECT_NE(message_of("PK\3\4 a zip file").find("is no .npy file"),
            std::string::npos);
  EXPECT_NE(message_of(file_with(header_of("<i8", "2, 3"), data))
                .find("type '<i8'; allowed are"),
            std::string::npos);
  EXPECT_NE(message_of(file_with(header_of("<c16", "2, 3"), data))
                .find("type '<c16'"),
            std::string::npos);
  EXPECT_NE(message_of(file_with(header_of("<f8", "6,"), data))
                .find("has 1 dimensions, shape (6,)"),
            std::string::npos);
  EXPECT_NE(message_of(file_with(header_of("<f8", "2, 4"), data))
                .find("48 bytes of numbers"),
            std::string::npos);
  EXPECT_NE(
      message_of(file_with(header_of("<f8", "0, 3"), "")).find("shape (0, 3)"),
      std::string::npos);
  EXPECT_NE(message_of(file_with(header_of("<f8", "2, x"), data))
                .find("no list of sizes"),
            std::string::npos);
  EXPECT_NE(message_of(file_with("{}", data)).find("header without descr"),
            std::string::npos);
  EXPECT_NE(message_of(file_with(header_of("<f8", "2, 3"), data, '\4'))
                .find("version 4"),
            std::string::npos);
  const std::string whole = file_with(header_of("<f8", "2, 3"), data);
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_NE(message_of(whole.substr(0, length)), "accepted") << length;
  // Sizes whose product overflows to the right number.
  EXPECT_NE(
      message_of(file_with(header_of("<f8", "4294967296, 4294967296"), "")),
      "accepted");
}

} // namespace asperity::surfaces::npy_test
