// Tests of X3P files whose rows are read separately: bits, missing points and
// messages are those of the file as a whole. Tolerance: none.
#include "base/content_hash.hpp"
#include "surfaces/formats/zip_archive.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <map>

#include "tests/surfaces/instrument_bytes.hpp"
#include "tests/surfaces/row_file_check.hpp"

namespace asperity::surfaces::x3p_rows_test {

using namespace tests_of_rows;
using namespace tests_of_formats;

/// More points than are decoded at a time, and rows that do not begin with a
/// byte of the file of valid points.
constexpr int n_columns = 211;
constexpr int n_rows = 201;
constexpr std::size_t n_points = std::size_t{n_columns} * n_rows;

const std::string absolute = "<AxisType>A</AxisType><DataType>D</DataType>";
const std::string regular = "<AxisType>I</AxisType><Increment>1e-6</Increment>";

struct X3pParts {
  std::string x = regular, y = regular, z = absolute;
  std::string sums; ///< entries beside the links
  bool has_mask = false;
  int columns = n_columns;

  std::string text() const {
    return "<p:ISO5436_2><Record1><FeatureType>SUR</FeatureType><Axes><CX>" +
           x + "</CX><CY>" + y + "</CY><CZ>" + z +
           "</CZ></Axes></Record1><Record3><MatrixDimension><SizeX>" +
           std::to_string(columns) + "</SizeX><SizeY>" +
           std::to_string(n_rows) +
           "</SizeY><SizeZ>1</SizeZ></MatrixDimension><DataLink>"
           "<PointDataLink>bindata/data.bin</PointDataLink>" +
           (has_mask ? "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>"
                     : "") +
           sums + "</DataLink></Record3></p:ISO5436_2>";
  }
};

double height_of(std::size_t i) {
  return i % 1000 == 77 ? std::nan("")
                        : std::sin(0.37 * static_cast<double>(i));
}

template <class Number>
std::string heights_as(double factor) {
  std::string bytes;
  for (std::size_t i = 0; i < n_points; ++i) {
    const double height = height_of(i);
    bytes += little_endian(static_cast<Number>(
        std::isnan(height) && std::numeric_limits<Number>::is_integer
            ? 0.0
            : factor * height));
  }
  return bytes;
}

std::string mask() {
  std::string bits((n_points + 7) / 8, '\xFF');
  for (std::size_t i = 0; i < n_points; i += 13)
    bits[i / 8] = static_cast<char>(bits[i / 8] & ~(1 << (i % 8)));
  return bits;
}

using Members = std::map<std::string, std::string>;

Members members_of(const X3pParts& parts, const std::string& points) {
  Members members{{"main.xml", parts.text()}, {"bindata/data.bin", points}};
  if (parts.has_mask)
    members["bindata/valid.bin"] = mask();
  return members;
}

std::string x3p(const Members& members) {
  return written("map.x3p", zip_bytes(members));
}

TEST(X3pRows, OfEveryTypeAreThoseOfTheWholeFile) {
  X3pParts parts;
  expect_rows_of(x3p(members_of(parts, heights_as<double>(1e-9))), {});
  parts.has_mask = true;
  parts.z = "<AxisType>A</AxisType><DataType>F</DataType><Offset>0.1</Offset>";
  expect_rows_of(x3p(members_of(parts, heights_as<float>(1e-9))), {});
  parts.z = "<AxisType>A</AxisType><DataType>I</DataType><Increment>1e-12"
            "</Increment>";
  expect_rows_of(x3p(members_of(parts, heights_as<std::int16_t>(3e4))), {});
  parts.z = "<AxisType>A</AxisType><DataType>L</DataType>";
  expect_rows_of(x3p(members_of(parts, heights_as<std::int32_t>(2e9) + "more")),
                 {});
}

/// Positions of both axes and heights of each point.
std::string positions(std::size_t moved_x, std::size_t moved_y) {
  std::string bytes;
  for (std::size_t i = 0; i < n_points; ++i) {
    const auto x = static_cast<double>(i % n_columns);
    const auto y = static_cast<double>(i / n_columns);
    bytes += little_endian(1e-6 * (x + (i == moved_x ? 0.05 : 0.01)));
    bytes += little_endian(-2e-6 * (y + (i == moved_y ? 0.05 : 0.01)));
    bytes += little_endian(1e-9 * height_of(i));
  }
  return bytes;
}

TEST(X3pRows, WithAbsoluteAxesAreThoseOfTheWholeFile) {
  X3pParts parts;
  parts.x = parts.y = absolute;
  expect_rows_of(x3p(members_of(parts, positions(n_points, n_points))), {});
  EXPECT_NE(refusal_of(x3p(members_of(parts, positions(40000, 3))), {})
                .find("positions along x are not regular at point (121, 189)"),
            std::string::npos);
  EXPECT_NE(refusal_of(x3p(members_of(parts, positions(n_points, 17000))), {})
                .find("positions along y are not regular at point (120, 80)"),
            std::string::npos);
}

TEST(X3pRows, AreRefusedAsTheWholeFileIs) {
  X3pParts parts;
  parts.has_mask = true;
  parts.sums = "<MD5ChecksumPointData>" + md5_hash(heights_as<double>(1.0)) +
               "</MD5ChecksumPointData><MD5ChecksumValidPoints>" +
               md5_hash(mask()) + "</MD5ChecksumValidPoints>";
  const Members good = members_of(parts, heights_as<double>(1.0));
  expect_rows_of(x3p(good), {});
  const auto refusal = [&](const std::string& member,
                           const std::string& bytes) {
    Members bad = good;
    bad[member] = bytes;
    return refusal_of(x3p(bad), {});
  };

  EXPECT_NE(refusal("bindata/data.bin", heights_as<double>(2.0))
                .find("data.bin has the MD5 checksum"),
            std::string::npos);
  EXPECT_NE(refusal("bindata/valid.bin", std::string(mask().size(), '\xFE'))
                .find("valid.bin has the MD5 checksum"),
            std::string::npos);
  EXPECT_NE(refusal("bindata/valid.bin", mask().substr(1)).find("points need"),
            std::string::npos);
  EXPECT_NE(refusal("bindata/data.bin", heights_as<double>(1.0).substr(8))
                .find("bytes, but only"),
            std::string::npos);
  for (const int columns : {1, -3, 2000000000}) {
    X3pParts other = parts;
    other.columns = columns;
    refusal("main.xml", other.text());
  }
  Members absent = good;
  absent.erase("bindata/valid.bin");
  EXPECT_NE(refusal_of(x3p(absent), {}).find("the archive has no such file"),
            std::string::npos);
  refusal_of(x3p(good), {mechanics::MapFormat::automatic, {}, {1e-6, {}}});
}

TEST(X3pRows, OfADamagedArchiveAreRefusedAsTheWholeFileIs) {
  const std::string whole = zip_bytes(members_of({}, heights_as<double>(1e-9)));
  for (const std::size_t bytes : {whole.size() - 1, whole.size() / 2})
    EXPECT_NE(refusal_of(written("short.x3p", whole.substr(0, bytes)),
                         {mechanics::MapFormat::x3p})
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
TEST(X3pRows, OfAnArchiveThatStatesOtherSizesAreRefused) {
  const std::string whole = zip_bytes(members_of({}, heights_as<double>(1e-9)));
  refusal_of(written("less.x3p", with_size(whole, 1000)), {});
  refusal_of(written("more.x3p", with_size(whole, 1U << 29)), {});
  EXPECT_NE(
      refusal_of(written("most.x3p", with_size(whole, 0xFFFFFFFFU - 9)), {})
          .find("must have at most"),
      std::string::npos);
}

// The name main.xml is behind the first 64 kB of the file.
TEST(X3pRows, OfAnArchiveThatBeginsWithThePointsAreRead) {
  std::string noise(400000, '\0');
  for (std::size_t i = 0; i < noise.size(); ++i)
    noise[i] = static_cast<char>(i * i * i / 7 + i / 3);
  Members members = members_of({}, heights_as<double>(1e-9));
  members["a"] = noise;
  const std::string path = x3p(members);
  std::ifstream stream(path, std::ios::binary);
  std::string beginning(1 << 16, '\0');
  stream.read(beginning.data(), 1 << 16);
  ASSERT_EQ(beginning.find("main.xml"), std::string::npos);

  expect_rows_of(path, {});
}

TEST(X3pRows, OfAFileThatChangesAreRefused) {
  const std::string path = x3p(members_of({}, heights_as<double>(1e-9)));
  const auto file = row_file(path, {});
  ASSERT_TRUE(file);
  file->rows(0, 2);
  std::filesystem::resize_file(path, 3000);
  EXPECT_EQ(tests::message_of<input::InputError>([&] { file->rows(4, 2); }),
            path + ": has changed since the run began");
}

// The XML parser holds all numbers.
TEST(X3pRows, OfAListInMainXmlAreNotReadByRows) {
  std::string text = X3pParts().text();
  const std::size_t begin = text.find("<DataLink>");
  text.replace(begin, text.find("</Record3>") - begin,
               "<DataList><Datum>1</Datum></DataList>");
  EXPECT_FALSE(row_file(x3p({{"main.xml", text}}), {}));
}

} // namespace asperity::surfaces::x3p_rows_test
