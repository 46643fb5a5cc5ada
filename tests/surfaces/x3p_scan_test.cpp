// Tests of the reader of ISO 5436-2 (X3P), with archives that the tests write.
#include "base/content_hash.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/zip_archive.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "tests/message_of.hpp"
#include "tests/surfaces/missing_of.hpp"

namespace asperity::surfaces::x3p_scan_test {

using tests_of_formats::missing_of;
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

  std::string text() const {
    return "<q:ISO5436_2 xmlns:q='u'><Record1><FeatureType>" + feature +
           "</FeatureType><Axes><CX>" + x + "</CX><CY>" + y + "</CY><CZ>" + z +
           "</CZ></Axes></Record1><Record3><MatrixDimension><SizeX>3</SizeX>"
           "<SizeY>2</SizeY><SizeZ>" +
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

/// @param tolerance  [m]; the default is the roundoff of a few operations
void expect_six(const Scan& scan, double tolerance = 1e-22) {
  EXPECT_EQ(scan.map.grid.points_x, 3);
  EXPECT_EQ(scan.map.grid.points_y, 2);
  EXPECT_NEAR(scan.map.grid.length_x, 3e-6, 1e-12);
  EXPECT_NEAR(scan.map.grid.length_y, 4e-6, 1e-12);
  ASSERT_EQ(scan.map.heights.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(scan.map.heights[i], six[i], tolerance) << i;
}

TEST(X3pScan, ReadsEveryTypeOfNumber) {
  X3pText document;
  expect_six(x3p_scan(document, numbers_as_bytes(six)));
  document.z = "<AxisType>A</AxisType><DataType>F</DataType>";
  expect_six(
      x3p_scan(document, numbers_as_bytes<float>(
                             {1e-9F, -2e-9F, 3e-9F, 4e-9F, 5e-9F, 60e-9F})),
      60e-9 * 0x1p-24); // half a unit
  document.z = "<AxisType>A</AxisType><DataType>I</DataType><Increment>1e-9"
               "</Increment>";
  expect_six(
      x3p_scan(document, numbers_as_bytes<std::int16_t>({1, -2, 3, 4, 5, 60})));
  document.z = "<AxisType>A</AxisType><DataType>L</DataType><Increment>1e-10"
               "</Increment><Offset>1e-9</Offset>";
  expect_six(x3p_scan(
      document, numbers_as_bytes<std::int32_t>({0, -30, 20, 30, 40, 590})));
}

// Absolute axes are stored with each point and must be regular.
TEST(X3pScan, ReadsAbsoluteAxes) {
  X3pText document;
  document.x = document.y = document.z;
  std::vector<double> points;
  for (int i = 0; i < 6; ++i)
    points.insert(points.end(), {7e-6 + (i % 3) * 1e-6, (i / 3) * 2e-6,
                                 six[static_cast<std::size_t>(i)]});
  expect_six(x3p_scan(document, numbers_as_bytes(points)));
  points[3] += 0.1e-6;
  EXPECT_EQ(x3p_refusal(document, numbers_as_bytes(points)),
            "map.x3p: main.xml: the absolute positions along x are not regular "
            "at point (1, 0)");
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
  const std::string whole = zip_bytes({{"main.xml", document.text()}});
  EXPECT_THROW(
      read_scan_bytes(whole.substr(0, whole.size() / 2), "map.x3p", {}),
      input::InputError);
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

} // namespace asperity::surfaces::x3p_scan_test
