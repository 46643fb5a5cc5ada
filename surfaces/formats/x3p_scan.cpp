#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/x3p_document.hpp"
#include "surfaces/formats/zip_archive.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace asperity::surfaces {
namespace {

constexpr double x3p_missing = std::numeric_limits<double>::quiet_NaN();

double take_coordinate(const X3pAxis& axis, ByteReader& bytes) {
  const double number = axis.type == 'I'   ? bytes.take<std::int16_t>()
                        : axis.type == 'L' ? bytes.take<std::int32_t>()
                        : axis.type == 'F'
                            ? static_cast<double>(bytes.take<float>())
                            : bytes.take<double>();
  return axis.offset + axis.increment * number;
}

/// Reads the points that main.xml describes.
class X3pReader {
public:
  X3pReader(std::string_view bytes, const std::string& name)
      : name_(name),
        archive_(bytes, name),
        text_(archive_.member("main.xml")),
        document_(text_, name),
        header_(document_.header()) {}

  Scan read() {
    check_file_sum();
    Scan scan;
    scan.map.heights = document_.text_at(link_ + "PointDataLink").empty()
                           ? listed_heights()
                           : linked_heights();
    scan.map.grid = grid();
    require_sound_lengths(name_, scan.map.grid);
    mark_missing(scan, name_);
    scan.reader = "own reader of X3P";
    return scan;
  }

private:
  std::size_t count() const {
    return static_cast<std::size_t>(header_.size_x * header_.size_y);
  }

  std::vector<double> linked_heights() {
    const std::string member = document_.text_at(link_ + "PointDataLink");
    const std::string content = archive_.member(member);
    const std::string part = name_ + ": " + printable(member);
    const std::size_t per_point = header_.x.stored_bytes() +
                                  header_.y.stored_bytes() +
                                  header_.z.stored_bytes();
    require_sound_grid(part, header_.size_x, header_.size_y,
                       static_cast<double>(per_point), content.size());
    check_sum("MD5ChecksumPointData", member, content);
    ByteReader bytes(content, part);
    std::vector<double> heights(count());
    for (double& height : heights) {
      if (header_.x.is_absolute)
        positions_x_.push_back(take_coordinate(header_.x, bytes));
      if (header_.y.is_absolute)
        positions_y_.push_back(take_coordinate(header_.y, bytes));
      height = take_coordinate(header_.z, bytes);
    }
    apply_valid_points(heights);
    return heights;
  }

  /// Bit i of the file of valid points, from the least significant one of each
  /// byte, is 0 if point i is missing.
  void apply_valid_points(std::vector<double>& heights) const {
    const std::string member = document_.text_at(link_ + "ValidPointsLink");
    if (member.empty())
      return;
    const std::string bits = archive_.member(member);
    if (bits.size() < (heights.size() + 7) / 8)
      document_.refuse(fmt::format("{} has {} bytes, but {} points need {}",
                                   printable(member), bits.size(),
                                   heights.size(), (heights.size() + 7) / 8));
    check_sum("MD5ChecksumValidPoints", member, bits);
    for (std::size_t i = 0; i < heights.size(); ++i)
      if ((static_cast<unsigned char>(bits[i / 8]) >> (i % 8) & 1) == 0)
        heights[i] = x3p_missing;
  }

  /// Reads the numbers in main.xml itself: per point the absolute coordinates,
  /// separated by semicolons; an empty point is missing.
  std::vector<double> listed_heights() {
    const std::vector<std::string> points =
        document_.texts_in("Record3/DataList");
    if (points.empty())
      document_.refuse("Record3 has neither a PointDataLink nor a DataList");
    require_sound_grid(name_ + ": main.xml", header_.size_x, header_.size_y,
                       1.0, points.size());
    if (points.size() != count())
      document_.refuse(fmt::format("{} points in DataList, but {} in "
                                   "MatrixDimension",
                                   points.size(), count()));
    std::vector<double> heights;
    heights.reserve(points.size());
    for (const std::string& point : points)
      heights.push_back(listed_height(point));
    return heights;
  }

  double listed_height(const std::string& text) {
    if (text.empty() && !header_.x.is_absolute && !header_.y.is_absolute)
      return x3p_missing;
    std::vector<double> numbers;
    std::string_view rest = text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(';'), rest.size());
      numbers.push_back(number_of_text(trimmed(rest.substr(0, end))));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const std::size_t stored = 1 + (header_.x.is_absolute ? 1U : 0U) +
                               (header_.y.is_absolute ? 1U : 0U);
    if (numbers.size() != stored)
      document_.refuse(fmt::format("found the point '{}', but must be {} "
                                   "number(s)",
                                   printable(text), stored));
    std::size_t at = 0;
    const auto next = [&](const X3pAxis& axis) {
      return axis.offset + axis.increment * numbers[at++];
    };
    if (header_.x.is_absolute)
      positions_x_.push_back(next(header_.x));
    if (header_.y.is_absolute)
      positions_y_.push_back(next(header_.y));
    return next(header_.z);
  }

  Grid grid() const {
    Grid grid;
    grid.points_x = static_cast<int>(header_.size_x);
    grid.points_y = static_cast<int>(header_.size_y);
    grid.length_x =
        grid.points_x * (header_.x.is_absolute ? regular_spacing(grid, true)
                                               : header_.x.increment);
    grid.length_y =
        grid.points_y * (header_.y.is_absolute ? regular_spacing(grid, false)
                                               : header_.y.increment);
    return grid;
  }

  /// The spacing of an absolute axis, whose positions must be equidistant
  /// within 2 % of their spacing.
  double regular_spacing(const Grid& grid, bool is_x) const {
    const std::vector<double>& positions = is_x ? positions_x_ : positions_y_;
    const std::size_t last = is_x ? grid.index(grid.points_x - 1, 0)
                                  : grid.index(0, grid.points_y - 1);
    const double step = (positions[last] - positions[0]) /
                        ((is_x ? grid.points_x : grid.points_y) - 1);
    for (int iy = 0; iy < grid.points_y; ++iy)
      for (int ix = 0; ix < grid.points_x; ++ix) {
        const double regular = positions[0] + (is_x ? ix : iy) * step;
        if (!(std::abs(positions[grid.index(ix, iy)] - regular) <=
              0.02 * std::abs(step)))
          document_.refuse(fmt::format("the absolute positions along {} are "
                                       "not regular at point ({}, {})",
                                       is_x ? "x" : "y", ix, iy));
      }
    return std::abs(step);
  }

  void check_sum(const std::string& key, const std::string& member,
                 const std::string& content) const {
    const std::string stated = document_.text_at(link_ + key);
    if (!stated.empty())
      compare_sums(stated, member, content);
  }

  void compare_sums(std::string stated, const std::string& member,
                    const std::string& content) const {
    for (char& digit : stated)
      digit =
          static_cast<char>(std::tolower(static_cast<unsigned char>(digit)));
    const std::string found = md5_hash(content);
    if (stated != found)
      throw input::InputError(fmt::format(
          "{}: {} has the MD5 checksum {}, but the file states {}; it is "
          "damaged or was changed",
          name_, printable(member), found, printable(stated)));
  }

  /// Compares main.xml with the file of its checksum, if there is one.
  void check_file_sum() const {
    const std::string member = document_.text_at("Record4/ChecksumFile");
    if (member.empty() || !archive_.has(member))
      return;
    const std::string line = archive_.member(member);
    compare_sums(line.substr(0, line.find_first_of(" \t\r\n*")), "main.xml",
                 text_);
  }

  const std::string link_ = "Record3/DataLink/";
  std::string name_;
  ZipArchive archive_;
  std::string text_; ///< of main.xml
  X3pDocument document_;
  X3pHeader header_;
  std::vector<double> positions_x_, positions_y_; ///< of absolute axes
};

} // namespace

Scan read_x3p_scan(std::string_view bytes, const std::string& name) {
  return X3pReader(bytes, name).read();
}

} // namespace asperity::surfaces
