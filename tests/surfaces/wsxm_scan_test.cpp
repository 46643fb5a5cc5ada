// WSxM files: a header of lines, then numbers.
#include "base/child_process.hpp"
#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/map_files.hpp"

namespace asperity::surfaces::wsxm_scan_test {

using namespace tests_of_formats;
using tests_of_formats::little_endian;

/// A map of 3 x 2 points.
struct WsxmFile {
  std::string x = "2 um", y = "600 nm", z = "12 nm", type = "short";
  std::string kind = "SxM Image file";
  std::vector<double> numbers = {10, 12, 14, 16, 18, 34};

  std::string bytes() const {
    std::string all = "WSxM file copyright UAM\r\n" + kind +
                      "\r\nImage header size: 99\r\n[Control]\r\n"
                      "    X Amplitude: " +
                      x + "\r\n    Y Amplitude: " + y +
                      "\r\n[General Info]\r\n    Image Data Type: " + type +
                      "\r\n    Number of columns: 3\r\n"
                      "    Number of rows: 2\r\n    Z Amplitude: " +
                      z + "\r\n\r\n[Header end]\r\n";
    for (const double number : numbers)
      all += type == "double"  ? little_endian(number)
             : type == "float" ? little_endian(static_cast<float>(number))
                               : little_endian(static_cast<short>(number));
    return all;
  }
};

// The difference of the largest and the least number is the amplitude along z,
// and the units of the three amplitudes are independent. Gwyddion and WSxM show
// the first number of the file at the other end of the map.
TEST(WsxmScan, UnitsOfTheThreeDirections) {
  const std::string path = written("short.top", WsxmFile().bytes());

  const Scan scan = read_scan(path, {});

  EXPECT_NEAR(scan.map.grid.length_x, 2e-6, 1e-21);
  EXPECT_NEAR(scan.map.grid.length_y, 0.6e-6, 1e-21);
  const std::vector<double> expected = {17e-9, 9e-9, 8e-9, 7e-9, 6e-9, 5e-9};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(scan.map.heights[i], expected[i], 1e-22);
  EXPECT_EQ(scan.reader, "own reader of WSxM");
}

TEST(WsxmScan, FloatingPointNumbersHaveTheUnitOfZ) {
  for (const char* const type : {"float", "double"}) {
    WsxmFile file;
    file.type = type;
    file.z = "24 \xC5";
    const std::string path = written("double.stp", file.bytes());

    const Scan scan = read_scan(path, {});

    EXPECT_NEAR(scan.map.heights[0], 34e-10, 1e-22);
    EXPECT_NEAR(scan.map.heights[5], 10e-10, 1e-22);
  }
}

TEST(WsxmScan, ContradictionsAreRefused) {
  const auto message = [](const WsxmFile& file, std::string_view behind = "") {
    return refusal_of(written("bad.stp", file.bytes() + std::string(behind)),
                      {});
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  WsxmFile amplitude;
  amplitude.type = "double";
  EXPECT_TRUE(contains(message(amplitude), "differ by up to 2.4e-08 m"));
  WsxmFile current;
  current.z = "3 nA";
  EXPECT_TRUE(contains(message(current), "Z Amplitude: found '3 nA'"));
  WsxmFile angle;
  angle.x = "3 V";
  EXPECT_TRUE(contains(message(angle), "X Amplitude: found '3 V'"));
  WsxmFile type;
  type.type = "complex";
  EXPECT_TRUE(contains(message(type), "short, integer, float or double"));
  WsxmFile curve;
  curve.kind = "IV curve file";
  EXPECT_TRUE(contains(message(curve), ":2: found 'IV curve file'"));
  EXPECT_TRUE(contains(message(WsxmFile(), "xx"), "has 14 bytes"));
  WsxmFile flat;
  flat.numbers.assign(6, 3.0);
  EXPECT_TRUE(contains(message(flat), "all of its numbers are equal"));
}

// Gwyddion 2.62 takes the unit of z for x and y as well.
TEST(WsxmScan, LengthsThatGwyddionReadsAreThoseOfTheHeader) {
  if (program_on_path("gwyddion").empty())
    GTEST_SKIP() << "skipped: needs gwyddion";
  const std::string path = written("units.stp", WsxmFile().bytes());

  EXPECT_EQ(tests::message_of<input::InputError>([&] {
              read_scan(path, {"convert", {}, {}});
            }),
            path + ": Gwyddion reads a side of 2e-09 m along x, but the header "
                   "of the file states 'X Amplitude:' 2e-06 m");
}

// Where the three units are equal, Gwyddion reads the same map.
TEST(WsxmScan, AgreesWithGwyddion) {
  if (program_on_path("gwyddion").empty())
    GTEST_SKIP() << "skipped: needs gwyddion";
  WsxmFile file;
  file.x = "900 nm";
  const std::string path = written("equal.stp", file.bytes());

  const Scan own = read_scan(path, {});
  const Scan other = read_scan(path, {"convert", {}, {}});

  EXPECT_NEAR(own.map.grid.length_x, other.map.grid.length_x, 1e-20);
  EXPECT_NEAR(own.map.grid.length_y, other.map.grid.length_y, 1e-20);
  ASSERT_EQ(own.map.heights.size(), other.map.heights.size());
  for (std::size_t i = 0; i < own.map.heights.size(); ++i)
    EXPECT_NEAR(own.map.heights[i] - own.map.heights[0],
                other.map.heights[i] - other.map.heights[0], 1e-22)
        << i;
}

} // namespace asperity::surfaces::wsxm_scan_test
