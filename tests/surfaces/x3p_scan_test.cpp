// Tests of the reader of ISO 5436-2 (X3P), with archives that the tests write:
// every type of number, positions, missing points, checksums and damage.
#include "base/content_hash.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/zip_archive.hpp"
#include "tests/message_of.hpp"
#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/map_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace asperity::surfaces::x3p_scan_test {

using namespace tests_of_formats;
using Members = std::map<std::string, std::string>;

template <class Number>
std::string numbers_as_bytes(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

struct X3pText {
  std::string feature = "SUR";
  std::string x = "<AxisType>I</AxisType><Increment>1e-6</Increment>";
  std::string y = "<AxisType>I</AxisType><Increment>2e-6</Increment>";
  std::string z = "<AxisType>A</AxisType><DataType>D</DataType>";
  std::string record3 = "<DataLink><PointDataLink>bindata/data.bin"
                        "</PointDataLink></DataLink>";
  std::string layers = "1";
  int columns = 3;

  std::string text() const {
    return "<q:ISO5436_2 xmlns:q='u'><Record1><FeatureType>" + feature +
           "</FeatureType><Axes><CX>" + x + "</CX><CY>" + y + "</CY><CZ>" + z +
           "</CZ></Axes></Record1><Record3><MatrixDimension><SizeX>" +
           std::to_string(columns) + "</SizeX><SizeY>2</SizeY><SizeZ>" +
           layers + "</SizeZ></MatrixDimension>" + record3 +
           "</Record3><Record4><ChecksumFile>md5checksum.hex</ChecksumFile>"
           "</Record4></q:ISO5436_2>";
  }
};

const std::vector<double> six{1e-9, -2e-9, 3e-9, 4e-9, 5e-9, 60e-9};

Scan x3p_scan(const Members& members) {
  return read_scan_bytes(zip_bytes(members), "map.x3p", {});
}

Scan x3p_scan(const X3pText& document, const std::string& data) {
  return x3p_scan({{"main.xml", document.text()}, {"bindata/data.bin", data}});
}

template <class... Arguments>
std::string x3p_refusal(const Arguments&... arguments) {
  return tests::message_of<input::InputError>([&] { x3p_scan(arguments...); });
}

/// Tolerance: the roundoff of a few operations.
void expect_six(const Scan& scan) {
  EXPECT_EQ(scan.map.grid.points_x, 3);
  EXPECT_EQ(scan.map.grid.points_y, 2);
  EXPECT_NEAR(scan.map.grid.length_x, 3e-6, 1e-12);
  EXPECT_NEAR(scan.map.grid.length_y, 4e-6, 1e-12);
  ASSERT_EQ(scan.map.heights.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(scan.map.heights[i], six[i], 1e-22) << i;
}

TEST(X3pScan, ReadsTheMaskAndTheList) {
  X3pText document;
  document.record3 = "<DataLink><PointDataLink>d</PointDataLink>"
                     "<ValidPointsLink>v</ValidPointsLink></DataLink>";
  const Scan masked = x3p_scan({{"main.xml", document.text()},
                                {"d", numbers_as_bytes(six)},
                                {"v", std::string(1, '\x2E')}});
  EXPECT_EQ(missing_of(masked), (std::vector<char>{1, 0, 0, 0, 1, 0}));
  document.record3 = "<DataList><Datum>1e-9</Datum><Datum/><Datum>3e-9</Datum>"
                     "<Datum>4e-9</Datum><Datum>5e-9</Datum><Datum>6e-8"
                     "</Datum></DataList>";
  const Scan listed = x3p_scan({{"main.xml", document.text()}});
  EXPECT_EQ(missing_of(listed), (std::vector<char>{0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(listed.map.heights[5], 60e-9);
}

// A missing point of an absolute axis has no position, wherever it is.
TEST(X3pScan, ReadsListsWithPositions) {
  for (std::size_t missing = 0; missing < 6; ++missing)
    for (const char* const form :
         {"", "{x};{y};", "{x};{y};NaN", "NaN;nan;nan"}) {
      X3pText document;
      document.x = document.y = document.z;
      std::string list = "<DataList>";
      for (std::size_t i = 0; i < 6; ++i)
        list +=
            "<Datum>" +
            fmt::format(fmt::runtime(i == missing ? form : "{x};{y};{z}"),
                        fmt::arg("x", 7e-6 + static_cast<double>(i % 3) * 1e-6),
                        fmt::arg("y", static_cast<double>(i / 3) * 2e-6),
                        fmt::arg("z", six.at(i))) +
            "</Datum>";
      document.record3 = list + "</DataList>";

      const Scan scan = x3p_scan({{"main.xml", document.text()}});

      EXPECT_NEAR(scan.map.grid.length_x, 3e-6, 1e-12);
      EXPECT_NEAR(scan.map.grid.length_y, 4e-6, 1e-12);
      std::vector<char> expected(6, 0);
      expected.at(missing) = 1;
      EXPECT_EQ(missing_of(scan), expected) << form;
    }
  X3pText document;
  document.record3 = "<DataList><Datum>1</Datum><Datum>x</Datum><Datum>3"
                     "</Datum><Datum>4</Datum><Datum>5</Datum><Datum>6"
                     "</Datum></DataList>";
  EXPECT_EQ(x3p_refusal(Members{{"main.xml", document.text()}}),
            "map.x3p: main.xml: found the point 'x', but must be 1 number(s), "
            "separated by semicolons, or empty at a missing point");
}

TEST(X3pScan, ComparesTheChecksums) {
  const X3pText document;
  const std::string text = document.text();
  const Members good{{"main.xml", text},
                     {"bindata/data.bin", numbers_as_bytes(six)},
                     {"md5checksum.hex", md5_hash(text) + " *main.xml"}};
  expect_six(x3p_scan(good));
  Members bad = good;
  bad["md5checksum.hex"] = std::string(32, '0') + " *main.xml";
  EXPECT_NE(
      x3p_refusal(bad).find("main.xml has the MD5 checksum " + md5_hash(text)),
      std::string::npos);
  X3pText summed;
  summed.record3 =
      "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>"
      "<MD5ChecksumPointData>ABC</MD5ChecksumPointData></DataLink>";
  EXPECT_NE(x3p_refusal(summed, numbers_as_bytes(six))
                .find("but the file states abc"),
            std::string::npos);
}

TEST(X3pScan, NamesTheMistake) {
  const std::string data = numbers_as_bytes(six);
  X3pText document;
  EXPECT_EQ(x3p_refusal(document, data.substr(1)),
            "map.x3p: bindata/data.bin: has 3 x 2 points according to its "
            "header, which need 48 bytes, but only 47 follow");
  document.feature = "PRF";
  EXPECT_NE(x3p_refusal(document, data).find("profiles and point clouds"),
            std::string::npos);
  document = {};
  document.layers = "2";
  EXPECT_NE(x3p_refusal(document, data).find("SizeZ is 2, but must be 1"),
            std::string::npos);
  document = {};
  document.x = "<AxisType>I</AxisType><Increment>-1</Increment>";
  EXPECT_NE(x3p_refusal(document, data).find("CX/Increment is -1 m"),
            std::string::npos);
  EXPECT_NE(x3p_refusal(Members{{"main.xml", "<a"}, {"b", "c"}})
                .find("main.xml: byte"),
            std::string::npos);
  document = {};
  EXPECT_EQ(x3p_refusal(Members{{"main.xml", document.text()}}),
            "map.x3p: bindata/data.bin: the archive has no such file");
}

// Programs that pack a folder put its name before all others, with either
// slash. The checksum of main.xml is in the same folder.
TEST(X3pScan, ReadsAnArchiveOfAFolder) {
  const std::string document = X3pText().text();
  for (const std::string folder : {"scan/", "a/b/", "scan\\"}) {
    const std::string inner = folder == "scan\\" ? "bindata\\" : "bindata/";
    const Members members{
        {folder + "main.xml", document},
        {folder + inner + "data.bin", numbers_as_bytes(six)},
        {folder + "md5checksum.hex", md5_hash(document) + " *main.xml\n"}};
    expect_six(x3p_scan(members));
  }
  EXPECT_NE(
      x3p_refusal(Members{{"a/main.xml", document}, {"b/main.xml", document}})
          .find("has several files main.xml"),
      std::string::npos);
  EXPECT_NE(x3p_refusal(Members{{"a/main.xml", document},
                                {"a/md5checksum.hex", "12 *main.xml\n"},
                                {"a/bindata/data.bin", numbers_as_bytes(six)}})
                .find("main.xml has the MD5 checksum"),
            std::string::npos);
}

template <class Number>
void expect_numbers(const std::string& type, double unit, double offset) {
  X3pText document;
  document.z =
      "<AxisType>A</AxisType><DataType>" + type + "</DataType>" +
      fmt::format("<Increment>{}</Increment><Offset>{}</Offset>", unit, offset);
  const std::vector<Number> numbers{1, -2, 3, 4, 5, 30000};
  const Scan scan = x3p_scan(document, numbers_as_bytes(numbers) + "more");
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(scan.map.heights[i],
              offset + unit * static_cast<double>(numbers[i]))
        << type << i;
}

TEST(X3pScan, HasHeightsOfEveryType) {
  expect_numbers<double>("D", 1.0, 0.0);
  expect_numbers<float>("F", 1.0, 0.1);
  expect_numbers<std::int16_t>("I", 1e-12, 0.0);
  expect_numbers<std::int32_t>("L", 1e-10, 1e-9);
}

/// Positions of both axes and heights of each point; one is moved.
std::string positions(std::size_t moved_x, std::size_t moved_y) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto x = static_cast<double>(i % 3);
    const auto y = static_cast<double>(i / 3);
    numbers.insert(numbers.end(),
                   {1e-6 * (x + (i == moved_x ? 0.05 : 0.01)),
                    -2e-6 * (y + (i == moved_y ? 0.05 : 0.01)), six[i]});
  }
  return numbers_as_bytes(numbers);
}

TEST(X3pScan, HasRegularPositions) {
  X3pText document;
  document.x = document.y = document.z;
  expect_six(x3p_scan(document, positions(9, 9)));
  EXPECT_NE(x3p_refusal(document, positions(4, 9))
                .find("positions along x are not regular at point (1, 1)"),
            std::string::npos);
  EXPECT_NE(x3p_refusal(document, positions(9, 4))
                .find("positions along y are not regular at point (1, 1)"),
            std::string::npos);
}

TEST(X3pScan, IsRefusedIfAMemberIsWrong) {
  X3pText document;
  const std::string mask(1, '\x2E');
  document.record3 =
      "<DataLink><PointDataLink>d</PointDataLink><MD5ChecksumPointData>" +
      md5_hash(numbers_as_bytes(six)) +
      "</MD5ChecksumPointData><ValidPointsLink>v</ValidPointsLink>"
      "<MD5ChecksumValidPoints>" +
      md5_hash(mask) + "</MD5ChecksumValidPoints></DataLink>";
  const Members good{
      {"main.xml", document.text()}, {"d", numbers_as_bytes(six)}, {"v", mask}};
  EXPECT_EQ(x3p_refusal(good), "accepted");
  const auto refusal = [&](const std::string& member,
                           const std::string& bytes) {
    Members bad = good;
    bad[member] = bytes;
    return x3p_refusal(bad);
  };

  EXPECT_NE(refusal("d", numbers_as_bytes(six) + "x").find("d has the MD5"),
            std::string::npos);
  EXPECT_NE(refusal("v", "\x2F").find("v has the MD5"), std::string::npos);
  EXPECT_NE(refusal("v", "").find("points need"), std::string::npos);
  for (const int columns : {1, -3, 2000000000}) {
    X3pText other = document;
    other.columns = columns;
    EXPECT_NE(refusal("main.xml", other.text()).find("points, but a map must"),
              std::string::npos);
  }
  Members absent = good;
  absent.erase("v");
  EXPECT_NE(x3p_refusal(absent).find("the archive has no such file"),
            std::string::npos);
  EXPECT_NE(
      refusal_of(written("map.x3p", zip_bytes(good)), {"auto", {}, {1e-6, {}}})
          .find("surface.length = 1e-06 m, but must be left out"),
      std::string::npos);
}

/// An archive of many points.
Members long_members() {
  X3pText document;
  document.columns = 3000;
  std::vector<double> numbers(6000);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = std::sin(static_cast<double>(i));
  return {{"main.xml", document.text()},
          {"bindata/data.bin", numbers_as_bytes(numbers)}};
}

TEST(X3pScan, IsRefusedIfItIsDamaged) {
  const std::string whole = zip_bytes(long_members());
  for (const std::size_t bytes : {whole.size() - 1, whole.size() / 2})
    EXPECT_NE(refusal_of(written("short.x3p", whole.substr(0, bytes)), {"x3p"})
                  .find("is a damaged zip archive"),
              std::string::npos);
  std::string damaged = whole;
  for (std::size_t i = 1000; i < 1100; ++i)
    damaged[i] = '\x55';
  EXPECT_NE(refusal_of(written("damaged.x3p", damaged), {})
                .find("data.bin: is damaged"),
            std::string::npos);
}

/// An archive that states another size of its points.
std::string with_size(std::string bytes, std::uint32_t stated) {
  constexpr std::size_t size_in_directory = 24;
  const std::size_t entry = bytes.find("PK\x01\x02");
  bytes.replace(entry + size_in_directory, 4, little_endian(stated));
  return bytes;
}

// The archive cannot make the program unpack more than it says, or allocate
// what it says.
TEST(X3pScan, IsRefusedIfItStatesOtherSizes) {
  const std::string whole = zip_bytes(long_members());
  EXPECT_NE(refusal_of(written("less.x3p", with_size(whole, 1000)), {})
                .find("data.bin: is longer than the archive says"),
            std::string::npos);
  EXPECT_NE(refusal_of(written("more.x3p", with_size(whole, 1U << 29)), {})
                .find("data.bin: is shorter than the archive says"),
            std::string::npos);
  EXPECT_NE(
      refusal_of(written("most.x3p", with_size(whole, 0xFFFFFFFFU - 9)), {})
          .find("must have at most"),
      std::string::npos);
}

// The name main.xml is behind the first 64 kB of the file.
TEST(X3pScan, MayBeginWithThePoints) {
  std::string noise(400000, '\0');
  for (std::size_t i = 0; i < noise.size(); ++i)
    noise[i] = static_cast<char>(i * i * 2654435761U >> 13);
  Members members = long_members();
  members["a"] = noise;
  const std::string path = written("map.x3p", zip_bytes(members));
  std::ifstream stream(path, std::ios::binary);
  std::string beginning(1 << 16, '\0');
  stream.read(beginning.data(), 1 << 16);
  ASSERT_EQ(beginning.find("main.xml"), std::string::npos);

  EXPECT_EQ(read_scan(path, {}).map.heights[1], std::sin(1.0));
}

} // namespace asperity::surfaces::x3p_scan_test
