// Tests of surfaces/formats/map_writer.hpp: our readers and, where it is
// installed, the program Gwyddion read back what is written.
#include "base/child_process.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/map_writer.hpp"
#include "surfaces/formats/scan.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace asperity::surfaces::map_writer_test {

namespace fs = std::filesystem;

/// Not square, with pixels that are not square, and numbers that need all
/// digits.
HeightMap odd_map() {
  HeightMap map{{5, 4, 3.1e-6, 1.7e-6}, {}};
  for (int i = 0; i < 20; ++i)
    map.heights.push_back(1e-9 / (i + 1.0) - 3e-10);
  return map;
}

class MapWriter : public testing::Test {
protected:
  MapWriter()
      : folder_(fs::path(testing::TempDir()) /
                ("asperity_map_writer_" +
                 std::string(testing::UnitTest::GetInstance()
                                 ->current_test_info()
                                 ->name()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  ~MapWriter() override { fs::remove_all(folder_); }

  std::string written(const std::string& name) const {
    write_map(folder_ / name, odd_map(), "A title");
    return folder_ / name;
  }

  fs::path folder_;
};

// Heights are read back bit for bit and lengths to roundoff.
TEST_F(MapWriter, WritesWhatTheReadersRead) {
  for (const std::string name : {"a.h5", "a.gwy", "a.txt", "a.x3p"}) {
    const Scan scan = read_scan(written(name), {});
    EXPECT_EQ(scan.map.heights, odd_map().heights) << name;
    EXPECT_EQ(scan.map.grid.points_x, 5) << name;
    EXPECT_DOUBLE_EQ(scan.map.grid.length_x, 3.1e-6) << name;
    EXPECT_DOUBLE_EQ(scan.map.grid.length_y, 1.7e-6) << name;
    EXPECT_EQ(count_missing(scan), 0U) << name;
  }
  EXPECT_EQ(read_scan(written("a.gwy"), {}).channel, "A title");
  EXPECT_EQ(list_channels(folder_ / "a.gwy").front().unit, "m");
  ScanRequest request;
  request.scale = {3.1e-6, 1.0, 1.7e-6};
  EXPECT_EQ(read_scan(written("a.npy"), request).map.heights,
            odd_map().heights);
}

TEST_F(MapWriter, RefusesAnotherEnding) {
  try {
    write_map(folder_ / "a.png", odd_map(), "");
    FAIL();
  } catch (const input::InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              (folder_ / "a.png").string() +
                  ": has the ending \".png\", but a map can be written as "
                  ".npy, .h5, .gwy, .txt, .x3p");
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

// A matrix without lengths or a unit needs those of the case; those that the
// file states must not be given again.
TEST_F(MapWriter, RequestsTheScalesThatAFileLacks) {
  const auto refusal = [](const std::string& path, const MapScale& scale) {
    try {
      read_scan(path, {"auto", {}, scale});
    } catch (const input::InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::string npy = written("a.npy");
  EXPECT_EQ(refusal(npy, {}), "surface.length is missing: " + npy +
                                  " is an .npy file, which does not give its "
                                  "width\nsurface.height_unit is missing: " +
                                  npy +
                                  " is an .npy file, which does not give the "
                                  "unit of its heights");
  const std::string hdf5 = written("a.h5");
  EXPECT_EQ(refusal(hdf5, {1e-6, {}}),
            "surface.length = 1e-06 m, but must be left out: " + hdf5 +
                ": /heights gives it as an attribute");
  EXPECT_NE(refusal(written("a.x3p"), {1e-6, {}})
                .find("surface.length = 1e-06 m, but must be left out"),
            std::string::npos);
}

// A dataset is chosen by its path; for a file with several one must be given,
// and a truncated file is refused.
TEST_F(MapWriter, ChoosesADataset) {
  const std::string path = written("a.h5");
  EXPECT_EQ(read_scan(path, {"auto", "/heights", {}}).channel, "/heights");
  EXPECT_EQ(read_scan(path, {"auto", "heights", {}}).channel, "/heights");
  EXPECT_THROW(read_scan(path, {"auto", "/height", {}}), input::InputError);
  const std::vector<ChannelInfo> channels = list_channels(path);
  ASSERT_EQ(channels.size(), 1U);
  EXPECT_EQ(channels[0].title, "/heights");
  EXPECT_EQ(channels[0].unit, "m");
  fs::resize_file(path, fs::file_size(path) / 2);
  EXPECT_THROW(read_scan(path, {}), input::InputError);
}

// Verifies that Gwyddion agrees with our readers on every format that both
// read.
TEST_F(MapWriter, IsReadByGwyddion) {
  if (program_on_path("gwyddion").empty())
    GTEST_SKIP() << "skipped: needs gwyddion";
  for (const std::string name : {"a.gwy", "a.x3p"}) {
    const std::string path = written(name);
    const Scan own = read_scan(path, {});
    const Scan other = read_scan(path, {"convert", {}, {}});
    EXPECT_EQ(other.reader.substr(0, 9), "Gwyddion ") << other.reader;
    EXPECT_EQ(own.map.heights, other.map.heights) << name;
    EXPECT_DOUBLE_EQ(own.map.grid.length_x, other.map.grid.length_x) << name;
    EXPECT_DOUBLE_EQ(own.map.grid.length_y, other.map.grid.length_y) << name;
  }
}

TEST_F(MapWriter, ReportsAFileThatNoReaderAccepts) {
  const std::string path = folder_ / "scan.ibw";
  std::ofstream(path, std::ios::binary) << std::string(300, '\0');
  try {
    read_scan(path, {});
    FAIL();
  } catch (const input::InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("no own reader knows this format (Igor binary wave, "
                        "Asylum Research)"),
              std::string::npos)
        << error.what();
  }
}

} // namespace asperity::surfaces::map_writer_test
