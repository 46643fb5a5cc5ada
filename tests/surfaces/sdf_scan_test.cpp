// Tests of the reader of ISO 25178-71 (SDF), with files that the tests write
// according to the standard.
#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "tests/message_of.hpp"
#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/map_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace asperity::surfaces::sdf_scan_test {

using namespace tests_of_formats;

Scan sdf_scan(const std::string& bytes) {
  return read_scan_bytes(bytes, "map.sdf", {});
}

std::string sdf_refusal(const std::string& bytes) {
  return tests::message_of<input::InputError>([&] { sdf_scan(bytes); });
}

const std::string text_header = "aISO-1.0\r\nManufacID = x\r\nNumPoints = 3\r\n"
                                "NumProfiles = 2\r\nXscale = 1.0E-6\r\n"
                                "Yscale = 2.0E-6\r\nZscale = 1.0E-9\r\n"
                                "Compression = 0\r\nDataType = 7\r\n*\r\n";

void expect_points(const Scan& scan, double tolerance) {
  ASSERT_EQ(scan.map.grid.points_x, 3);
  ASSERT_EQ(scan.map.grid.points_y, 2);
  EXPECT_NEAR(scan.map.grid.length_x, 3e-6, 1e-20);
  EXPECT_NEAR(scan.map.grid.length_y, 4e-6, 1e-20);
  const std::vector<double> nm{1, -2, 3, 4, 0, 60};
  for (std::size_t i = 0; i < 6; ++i)
    if (i != 4) {
      EXPECT_NEAR(scan.map.heights[i], nm[i] * 1e-9, tolerance) << i;
    }
  EXPECT_EQ(missing_of(scan), (std::vector<char>{0, 0, 0, 0, 1, 0}));
}

TEST(SdfScan, ReadsText) {
  const Scan scan =
      sdf_scan(text_header + "1.0 -2 3\r\n4 BAD\r\n60\r\n*\r\nTrailer\r\n*");
  expect_points(scan, 1e-22);
  EXPECT_EQ(scan.reader, "own reader of SDF (ASCII)");
}

/// A text of 7 by 6 points with a number of them in each line.
std::string sdf_text(int per_line, const std::string& line_end) {
  std::string text = fmt::format(
      "aISO-1.0{0}ManufacID = x{0}NumPoints = 7{0}NumProfiles = 6{0}Xscale = "
      "1e-6{0}Yscale = 2e-6{0}Zscale = 1e-9{0}*{0}",
      line_end);
  for (int i = 0; i < 42; ++i)
    text += (i % 17 == 5 ? "BAD" : fmt::format("{}", i)) +
            ((i + 1) % per_line == 0 ? line_end : " ");
  return text;
}

TEST(SdfScan, MayEndItsLinesAnywhere) {
  for (const std::string line_end : {"\n", " \t\r\n"})
    for (const int per_line : {1, 5, 7, 14, 100})
      for (const std::string& end :
           {std::string(), line_end + "*" + line_end + "the end 7 x"}) {
        const Scan scan = sdf_scan(sdf_text(per_line, line_end) + end);
        ASSERT_EQ(scan.map.grid.points_x, 7);
        EXPECT_EQ(count_missing(scan), 3U);
        for (std::size_t i = 0; i < 42; ++i)
          if (i % 17 != 5) {
            EXPECT_EQ(scan.map.heights[i], 1e-9 * static_cast<double>(i));
          }
      }
}

TEST(SdfScan, ReadsEveryBinaryTypeWithMissingPoints) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  expect_points(
      sdf_scan(binary_sdf<std::int8_t>(4, {1, -2, 3, 4, -128, 60}, 1e-9)),
      1e-22);
  expect_points(
      sdf_scan(binary_sdf<std::int16_t>(5, {1, -2, 3, 4, -32768, 60}, 1e-9)),
      1e-22);
  expect_points(sdf_scan(binary_sdf<std::int32_t>(
                    6, {10, -20, 30, 40, INT32_MIN, 600}, 1e-10)),
                1e-22);
  expect_points(
      sdf_scan(binary_sdf<float>(
          3, {1, -2, 3, 4, std::numeric_limits<float>::quiet_NaN(), 60}, 1e-9)),
      1e-22);
  const Scan scan =
      sdf_scan(binary_sdf<double>(7, {1, -2, 3, 4, none, 60}, 1e-9));
  expect_points(scan, 1e-22);
  EXPECT_EQ(scan.reader, "own reader of SDF (binary)");
  const Scan counts =
      sdf_scan(binary_sdf<std::uint16_t>(1, {1, 2, 3, 4, 5, 65535}, 1e-9));
  EXPECT_NEAR(counts.map.heights[5], 65535e-9, 1e-18);
}

TEST(SdfScan, NamesTheMistake) {
  EXPECT_EQ(sdf_refusal(text_header + "1 2 3 4 5\n*\n"),
            "map.sdf: has 5 numbers, but the header says 6");
  EXPECT_EQ(sdf_refusal(text_header + "1 2 3\n4 5 6 7\n*\n"),
            "map.sdf:12: more than the 6 numbers of the header");
  EXPECT_EQ(sdf_refusal(text_header + "1 2 x\n4 5 6\n*\n"),
            "map.sdf:11: found 'x', but must be a finite number or BAD");
  EXPECT_EQ(sdf_refusal(text_header + "1 2\r 3"),
            "map.sdf:11: found '2?', but must be a finite number or BAD");
  EXPECT_EQ(sdf_refusal(text_header + "1 2 3 4 5\n *\n"),
            "map.sdf:12: found '*', but must be a finite number or BAD");
  EXPECT_EQ(sdf_refusal(text_header + "*\n1 2 3 4 5 6\n"),
            "map.sdf: has 0 numbers, but the header says 6");
  for (const std::string& text :
       {text_header.substr(0, 60), text_header.substr(0, 8)})
    EXPECT_EQ(sdf_refusal(text),
              "map.sdf: the header has no end, a line with *");
  EXPECT_EQ(sdf_refusal("aISO-1.0\nNumPoints = 3\n*\n"),
            "map.sdf: the header has no line 'NumProfiles = number'");
  const std::string whole =
      binary_sdf<std::int16_t>(5, {1, 2, 3, 4, 5, 6}, 1e-9);
  EXPECT_EQ(sdf_refusal(whole.substr(0, whole.size() - 1)),
            "map.sdf: has 3 x 2 points according to its header, which need 12 "
            "bytes, but only 11 follow");
  EXPECT_EQ(sdf_refusal(whole.substr(0, 50)),
            "map.sdf: byte 46: ends here, but 4 more bytes must follow");
  EXPECT_EQ(sdf_refusal(binary_sdf<std::int16_t>(9, {1}, 1e-9)),
            "map.sdf: DataType = 9, but must lie between 0 and 7");
  EXPECT_NE(sdf_refusal(binary_sdf<std::int16_t>(5, {1}, 0.0))
                .find("Zscale = 0 m, but must be > 0"),
            std::string::npos);
}

// The header cannot make the program allocate more than the file could fill.
TEST(SdfScan, ChecksTheSizesInItsHeader) {
  std::string text = text_header;
  text.replace(text.find("NumPoints = 3"), 13, "NumPoints = 999999");
  text.replace(text.find("NumProfiles = 2"), 15, "NumProfiles = 999999");
  EXPECT_NE(sdf_refusal(text + "1 2 3\n*\n").find("but only"),
            std::string::npos);
}

} // namespace asperity::surfaces::sdf_scan_test
