// Digital Surf files, built byte by byte from the published layout of their
// header.
#include "base/child_process.hpp"
#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/map_files.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::surfaces::sur_scan_test {

using namespace tests_of_formats;
using tests_of_formats::little_endian;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A file of one surface; steps of 2 um, 3 mm and 0.5 nm along x, y and z.
struct SurFile {
  std::string signature = "DIGITAL SURF";
  std::uint16_t objects = 1, type = 2, special_points = 0, inversion = 0;
  std::uint16_t bits = 32;
  std::int32_t least = -5, largest = 7, columns = 3, rows = 2;
  float height_of_0 = 0.0F;
  std::string unit_x = "\xB5m", unit_y = "mm", unit_z = "nm";
  std::string comment = {}, private_zone = {};
  std::vector<std::int32_t> numbers = {1, 2, 3, 4, -5, 7};
  bool is_big_endian = false;

  template <class Number>
  std::string number(Number value) const {
    std::string bytes = little_endian(value);
    if (is_big_endian)
      std::ranges::reverse(bytes);
    return bytes;
  }

  static std::string text(std::string of, std::size_t size) {
    of.resize(size, ' ');
    return of;
  }

  std::string header() const {
    std::string bytes =
        signature + number<std::uint16_t>(is_big_endian ? 257 : 0) +
        number(objects) + number<std::uint16_t>(1) + number(type) +
        text("plate", 30) + text("name", 30) + std::string(6, '\0') +
        number(special_points) + std::string(10, '\0') + number(bits) +
        number(least) + number(largest) + number(columns) + number(rows) +
        number(static_cast<std::uint32_t>(columns * rows)) + number(2.0F) +
        number(3.0F) + number(0.5F);
    for (const char* const name : {"X", "Y", "Z"})
      bytes += text(name, 16);
    for (const std::string& unit : {unit_x, unit_y, unit_z, unit_x, unit_y})
      bytes += text(unit, 16);
    bytes += text(unit_z, 16) + number(1.0F) + number(1.0F) + number(1.0F) +
             number<std::uint16_t>(0) + number(inversion);
    bytes.resize(334, '\0');
    bytes += number(static_cast<std::uint16_t>(comment.size())) +
             number(static_cast<std::uint16_t>(private_zone.size()));
    bytes.resize(474, '\0');
    bytes += number(height_of_0);
    bytes.resize(512, '\0');
    return bytes;
  }

  std::string bytes() const {
    std::string all = header() + comment + private_zone;
    for (const std::int32_t height : numbers)
      all += bits == 16 ? number(static_cast<std::int16_t>(height))
                        : number(height);
    return all;
  }
};

/// The heights [nm], NaN where a point is missing.
std::vector<double> heights_of(const Scan& scan) {
  std::vector<double> heights;
  for (const double height : scan.map.heights)
    heights.push_back(height * 1e9);
  return heights;
}

void expect_heights(const std::vector<double>& found,
                    const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    if (std::isnan(expected[i]))
      EXPECT_TRUE(std::isnan(found[i])) << i;
    else
      EXPECT_NEAR(found[i], expected[i], 1e-14) << i; // a few eps
}

TEST(SurScan, NumbersOfBothWidthsAndByteOrders) {
  for (const bool is_big_endian : {false, true})
    for (const auto bits : {std::uint16_t{16}, std::uint16_t{32}}) {
      SurFile file;
      file.is_big_endian = is_big_endian;
      file.bits = bits;
      file.height_of_0 = 0.25F;
      const std::string path = written("both.sur", file.bytes());

      const Scan scan = read_scan(path, {});

      expect_heights(heights_of(scan), {0.75, 1.25, 1.75, 2.25, -2.25, 3.75});
      EXPECT_NEAR(scan.map.grid.length_x, 6e-6, 1e-21);
      EXPECT_NEAR(scan.map.grid.length_y, 6e-3, 1e-18);
      EXPECT_EQ(scan.reader, "own reader of Digital Surf");
    }
}

// The standard value of a point that was not measured is Zmin - 2; saturated
// ones are Zmin - 1 and Zmax + 1.
TEST(SurScan, SpecialPointsAreMissing) {
  for (const auto bits : {std::uint16_t{16}, std::uint16_t{32}}) {
    SurFile file;
    file.bits = bits;
    file.special_points = 1;
    file.numbers = {1, -7, 3, 8, -5, 7};
    const std::string path = written("special.sur", file.bytes());

    const Scan scan = read_scan(path, {});

    expect_heights(heights_of(scan), {0.5, missing, 1.5, missing, -2.5, 3.5});
  }
}

TEST(SurScan, GwyddionIsNotAskedForSpecialPoints) {
  if (program_on_path("gwyddion").empty())
    GTEST_SKIP() << "skipped: needs gwyddion";
  SurFile file;
  file.special_points = 1;
  const std::string path = written("convert.sur", file.bytes());

  const std::string message = tests::message_of<input::InputError>([&] {
    read_scan(path, {"convert", {}, {}});
  });

  EXPECT_NE(message.find("announces special points"), std::string::npos);
}

TEST(SurScan, NoSpecialPointsWithoutTheFlag) {
  SurFile file;
  file.numbers = {1, -7, 3, 4, -5, 7};

  const Scan scan = read_scan(written("flag.sur", file.bytes()), {});

  expect_heights(heights_of(scan), {0.5, -3.5, 1.5, 2.0, -2.5, 3.5});
}

TEST(SurScan, CommentAndPrivateZoneAreBeforeTheNumbers) {
  SurFile file;
  file.comment = "a comment";
  file.private_zone = std::string(77, '\3');
  const std::string path = written("comment.sur", file.bytes());

  expect_heights(heights_of(read_scan(path, {})),
                 {0.5, 1.0, 1.5, 2.0, -2.5, 3.5});
}

TEST(SurScan, MicroSignOfDos) {
  SurFile file;
  file.unit_x = "\xE6m";

  const Scan scan = read_scan(written("dos.sur", file.bytes()), {});

  EXPECT_NEAR(scan.map.grid.length_x, 6e-6, 1e-21);
}

std::string refusal_of_file(const SurFile& file,
                            const std::string& bytes_behind = "") {
  return refusal_of(written("bad.sur", file.bytes() + bytes_behind), {});
}

TEST(SurScan, OtherKindsAreRefusedByName) {
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  SurFile compressed;
  compressed.signature = "DSCOMPRESSED";
  EXPECT_TRUE(contains(refusal_of_file(compressed), "compressed"));
  SurFile profile;
  profile.type = 1;
  EXPECT_TRUE(contains(refusal_of_file(profile), "a profile (type 1)"));
  SurFile series;
  series.type = 5;
  series.objects = 4;
  EXPECT_TRUE(contains(refusal_of_file(series), "a series of surfaces"));
  SurFile inverted;
  inverted.inversion = 1;
  EXPECT_TRUE(contains(refusal_of_file(inverted), "inversion 1"));
  SurFile angle;
  angle.unit_y = "deg";
  EXPECT_TRUE(contains(refusal_of_file(angle), "the step along y is in 'deg'"));
  SurFile wide;
  wide.bits = 64;
  EXPECT_TRUE(contains(refusal_of_file(wide), "numbers of 64 bits"));
  EXPECT_TRUE(contains(refusal_of_file(SurFile(), "rest"), "ends at byte 540"));
  SurFile no_range;
  no_range.special_points = 1;
  no_range.largest = no_range.least;
  EXPECT_TRUE(contains(refusal_of_file(no_range), "leave no heights"));
  SurFile short_file;
  short_file.numbers.pop_back();
  EXPECT_TRUE(contains(refusal_of_file(short_file), "only 20 follow"));
}

TEST(SurScan, AllPointsMissing) {
  SurFile file;
  file.special_points = 1;
  file.numbers.assign(6, -7);
  const std::string path = written("all.sur", file.bytes());

  EXPECT_EQ(tests::message_of<input::InputError>([&] { read_scan(path, {}); }),
            path + ": all points are missing");
}

// A file without special points is read by Gwyddion with the same sizes and
// heights.
TEST(SurScan, AgreesWithGwyddionWithoutSpecialPoints) {
  if (program_on_path("gwyddion").empty())
    GTEST_SKIP() << "skipped: needs gwyddion";
  for (const auto bits : {std::uint16_t{16}, std::uint16_t{32}}) {
    SurFile file;
    file.bits = bits;
    file.height_of_0 = 3.0F;
    file.columns = 8;
    file.rows = 6;
    file.numbers.clear();
    for (int i = 0; i < 48; ++i)
      file.numbers.push_back(i * i % 13 - 5);
    const std::string path = written("gwyddion.sur", file.bytes());

    const Scan own = read_scan(path, {});
    const Scan other = read_scan(path, {"convert", {}, {}});

    EXPECT_NEAR(own.map.grid.length_x, other.map.grid.length_x, 1e-19);
    EXPECT_NEAR(own.map.grid.length_y, other.map.grid.length_y, 1e-16);
    ASSERT_EQ(own.map.heights.size(), other.map.heights.size());
    for (std::size_t i = 0; i < own.map.heights.size(); ++i)
      EXPECT_NEAR(own.map.heights[i], other.map.heights[i], 1e-23) << i;
  }
}

} // namespace asperity::surfaces::sur_scan_test
