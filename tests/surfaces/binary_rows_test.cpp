// Tests of the rows of maps in binary formats of instruments: the heights have
// the bits of one process, and mistakes its messages. Tolerance: none.
#include "input/input_error.hpp"
#include "surfaces/formats/row_file.hpp"
#include "surfaces/measured_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "tests/message_of.hpp"
#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/measured_files.hpp"

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

/// A channel of another kind before that of the heights, which has a mask.
std::string masked_gwy() {
  std::vector<double> heights = heights_of_file();
  for (double& number : heights)
    number *= 1e-3;
  std::vector<double> mask(heights.size(), 0.25);
  for (const std::size_t i : {3, 80, 81, 500})
    mask[i] = 0.5;
  return gwy_file(
      gwy_channel("0", "Deflection", "V", 10) +
      gwy_part("/2/data", 'o', gwy_field("um", heights, width, height)) +
      gwy_part("/2/data/title", 's', std::string("Height\0", 7)) +
      gwy_part("/2/mask", 'o', gwy_field("", mask, width, height)));
}

TEST(BinaryRows, OfGwyHaveTheBitsOfOneProcess) {
  const SurfaceSpec masked = scaled(file_of("masked.gwy", masked_gwy()));
  expect_bits_of_one_process(masked);
  EXPECT_EQ(described_map(masked).missing, 4U);
  EXPECT_EQ(described_map(masked).channel, "Height");
  EXPECT_EQ(described_map(masked).reader, "own reader of .gwy");

  SurfaceSpec plain = scaled(file_of(
      "plain.gwy",
      gwy_file(gwy_part("/0/data", 'o',
                        gwy_field("nm", heights_of_file(), width, height)))));
  plain.edges = mechanics::Edges::mirror;
  expect_bits_of_one_process(plain);
}

TEST(BinaryRows, AreRefusedAsInOneProcess) {
  const std::string sdf = binary_sdf(7, numbers_as<double>(), 1e-11, columns);
  const std::string gwy = masked_gwy();
  const std::vector<SurfaceSpec> refused{
      scaled(file_of("short.sdf", sdf.substr(0, sdf.size() - 1))),
      scaled(file_of("header.sdf", sdf.substr(0, 60))),
      scaled(file_of("type.sdf", binary_sdf<double>(9, {1, 2, 3, 4, 5, 6}, 1))),
      measured(file_of("scales.sdf", sdf)),
      scaled(file_of("short.gwy", gwy.substr(0, gwy.size() - 1))),
      scaled(file_of("volt.gwy", gwy_file(gwy_channel("0", "a", "V", 10)))),
      scaled(file_of(
          "mask.gwy",
          gwy_file(gwy_channel("0", "a", "m", 10) +
                   gwy_part("/0/mask", 'o', gwy_field("", {1, 2}, 2, 1))))),
      measured(file_of("scales.gwy", gwy))};
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
  const auto file = row_file(path, {});
  ASSERT_TRUE(file);
  std::filesystem::resize_file(path, 200);

  EXPECT_EQ(tests::message_of<input::InputError>([&] { file->rows(1, 2); }),
            path + ": cannot be read to its end");
}

} // namespace asperity::surfaces::binary_rows_test
