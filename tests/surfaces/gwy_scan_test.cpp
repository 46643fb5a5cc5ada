// Tests of the reader of Gwyddion's native format: units, masks, the choice of
// a channel, and damaged files. The tests write the files themselves.
#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "tests/message_of.hpp"
#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/map_files.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace asperity::surfaces::gwy_scan_test {

using namespace tests_of_formats;

Scan gwy_scan(const std::string& bytes,
              const std::optional<std::string>& channel = {}) {
  return read_scan_bytes(bytes, "map.gwy", {"auto", channel, {}});
}

std::string gwy_refusal(const std::string& bytes,
                        const std::optional<std::string>& channel = {}) {
  return tests::message_of<input::InputError>(
      [&] { gwy_scan(bytes, channel); });
}

const std::string several = gwy_file(
    gwy_channel("0", "Deflection", "V", 10) +
    gwy_channel("1", "AmplitudeTrace", "m", 11) +
    gwy_channel("2", "Z", "m", 12) + gwy_channel("10", "HeightTrace", "m", 13));

// Heights are chosen by unit and title, not by the order of channels.
TEST(GwyScan, ChoosesTheHeights) {
  const Scan chosen = gwy_scan(several);
  EXPECT_EQ(chosen.channel, "HeightTrace");
  EXPECT_EQ(chosen.map.heights[0], 13.0);
  EXPECT_EQ(chosen.map.grid.points_x, 3);
  EXPECT_EQ(chosen.map.grid.length_x, 3e-6);
  EXPECT_EQ(chosen.map.grid.length_y, 1e-6);
  EXPECT_EQ(chosen.reader, "own reader of .gwy");
  EXPECT_EQ(gwy_scan(gwy_file(gwy_channel("0", "AmplitudeTrace", "m", 1) +
                              gwy_channel("1", "Z", "m", 2)))
                .channel,
            "Z");
  EXPECT_EQ(gwy_scan(several, "AmplitudeTrace").map.heights[0], 11.0);
  EXPECT_EQ(gwy_scan(several, "amplitudetrace").map.heights[0], 11.0);
  EXPECT_EQ(gwy_scan(several, "3").channel, "Z");
}

TEST(GwyScan, ListsTheChannelsInItsMessages) {
  EXPECT_EQ(gwy_refusal(several, "Height"),
            "surface.channel = \"Height\": map.gwy has no such channel; its "
            "channels are \"Deflection\" [V], \"AmplitudeTrace\" [m], \"Z\" "
            "[m], \"HeightTrace\" [m]");
  EXPECT_NE(gwy_refusal(several, "Deflection").find("is in 'V', but must be"),
            std::string::npos);
  EXPECT_EQ(gwy_refusal(gwy_file(gwy_channel("0", "Phase", "deg", 1))),
            "map.gwy: no channel contains heights; its channels are \"Phase\" "
            "[deg]");
  EXPECT_EQ(gwy_refusal(gwy_file("")),
            "map.gwy: no channel contains heights; its channels are none");
}

TEST(GwyScan, ListsTheChannelsOfAFile) {
  const std::string path = testing::TempDir() + "asperity_gwy_scan_test.gwy";
  std::ofstream(path, std::ios::binary) << several;
  const std::vector<ChannelInfo> channels = list_channels(path);
  ASSERT_EQ(channels.size(), 4U);
  EXPECT_EQ(channels[0].title, "Deflection");
  EXPECT_EQ(channels[0].unit, "V");
  EXPECT_EQ(channels[3].title, "HeightTrace");
  EXPECT_EQ(channels[3].points_x, 3);
  EXPECT_EQ(channels[3].points_y, 2);
}

// Masked points are missing, whatever height the file has there.
TEST(GwyScan, RespectsTheMask) {
  const std::string mask =
      gwy_part("/0/mask", 'o', gwy_field("", {0, 1, 0, 0.4, 0, 1}));
  const Scan scan =
      gwy_scan(gwy_file(mask + gwy_channel("0", "Height", "m", 1)));
  EXPECT_EQ(missing_of(scan), (std::vector<char>{0, 1, 0, 0, 0, 1}));
}

TEST(GwyScan, SkipsWhatItDoesNotNeed) {
  const std::string others =
      gwy_part("/0/show", 'o', gwy_object("GwyBrick", "anything")) +
      gwy_part("flag", 'b', "\1") + gwy_part("letter", 'c', "x") +
      gwy_part("long", 'q', little_endian(std::int64_t{1})) +
      gwy_part("texts", 'S',
               little_endian(std::uint32_t{2}) + "a" + '\0' + "b" + '\0') +
      gwy_part("objects", 'O',
               little_endian(std::uint32_t{1}) + gwy_object("GwyNull", ""));
  EXPECT_EQ(
      gwy_scan(gwy_file(others + gwy_channel("0", "Z", "m", 7))).map.heights[0],
      7.0);
}

// A file that is truncated anywhere is refused; the message states the byte
// where it ends.
TEST(GwyScan, RefusesEveryTruncation) {
  for (std::size_t length = 4; length < several.size(); ++length)
    EXPECT_EQ(gwy_refusal(several.substr(0, length)).find("map.gwy: byte "), 0U)
        << length;
}

TEST(GwyScan, RefusesSizesThatDoNotAgree) {
  EXPECT_NE(
      gwy_refusal(gwy_file(gwy_part("/0/data", 'o', gwy_field("m", {1, 2, 3}))))
          .find("the field /0/data has 3 x 2 points, but 3 values"),
      std::string::npos);
  EXPECT_NE(gwy_refusal(gwy_file(gwy_part("a", 'z', "x")))
                .find("a component of the unknown type 'z'"),
            std::string::npos);
}

// A file without units is read with those of the case, which must not
// contradict a unit of the file. A channel with units is preferred.
TEST(GwyScan, TakesUnitsThatTheFileLacks) {
  const auto with = [](const std::string& bytes, const MapScale& scale,
                       const std::optional<std::string>& channel = {}) {
    return read_scan_bytes(bytes, "map.gwy", {"auto", channel, scale});
  };
  const auto refused = [&](const std::string& bytes, const MapScale& scale) {
    return tests::message_of<input::InputError>([&] { with(bytes, scale); });
  };
  const std::string no_unit = gwy_file(gwy_channel("0", "Height", "", 7));
  std::string no_units = no_unit; // of equal length: the sides have none either
  const std::string metres = std::string("unitstr") + '\0' + 's' + "m" + '\0';
  no_units.replace(no_units.find(metres), metres.size(),
                   std::string("unitstX") + '\0' + 's' + "m" + '\0');

  EXPECT_NEAR(with(no_unit, {{}, 1e-9}).map.heights[0], 7e-9, 1e-23);
  EXPECT_EQ(with(no_unit, {{}, 1e-9}).map.grid.length_x, 3e-6);
  EXPECT_EQ(refused(no_unit, {}),
            "surface.height_unit is missing: the values of map.gwy have no "
            "unit");
  EXPECT_EQ(
      refused(no_unit, {1e-6, 1e-9}).find("surface.length = 1e-06 m, but"), 0U);
  const Grid by_length = with(no_units, {6e-3, 1e-9}).map.grid;
  EXPECT_NEAR(by_length.length_x, 6e-3, 1e-12);
  EXPECT_NEAR(by_length.length_y, 2e-3, 1e-12);
  EXPECT_NEAR(with(no_units, {{}, 1e-9, {}, 1e3}).map.grid.length_y, 1e-3,
              1e-12);
  EXPECT_EQ(refused(no_units, {{}, 1e-9}).find("surface.length is missing"),
            0U);
  const std::string both = gwy_file(gwy_channel("0", "Height", "", 7) +
                                    gwy_channel("1", "Z", "m", 8));
  EXPECT_EQ(with(both, {}).map.heights[0], 8.0);
  EXPECT_NEAR(with(both, {{}, 1e-9}, "Height").map.heights[0], 7e-9, 1e-23);
}

// Of two channels of one name, the second has its number.
TEST(GwyScan, ReadsChannelsByTheirNumbers) {
  const std::string twice = gwy_file(gwy_channel("0", "Height", "m", 1) +
                                     gwy_channel("1", "Height", "m", 2));
  EXPECT_EQ(gwy_scan(twice, "1").map.heights[0], 1.0);
  EXPECT_EQ(gwy_scan(twice, "2").map.heights[0], 2.0);
}

} // namespace asperity::surfaces::gwy_scan_test
