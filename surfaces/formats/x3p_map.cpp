#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/zip_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace asperity::surfaces {
namespace {

/// The first child with this name, whatever its namespace prefix.
pugi::xml_node child_named(const pugi::xml_node& parent,
                           std::string_view name) {
  for (const pugi::xml_node& node : parent.children()) {
    const std::string_view full = node.name();
    if (full.substr(full.rfind(':') + 1) == name)
      return node;
  }
  return {};
}

/// One axis of Record1. A coordinate is offset + increment * n, where n is the
/// number of the point or, if the axis is absolute, the stored number.
struct X3pAxis {
  bool is_absolute = false;
  char type = 'D';        ///< I, L, F or D: int16, int32, float or double
  double increment = 1.0; ///< [m] > 0
  double offset = 0.0;    ///< [m]

  /// Size of a stored number; 0 if the axis is not absolute.
  std::size_t stored_bytes() const {
    if (!is_absolute)
      return 0;
    return type == 'I' ? 2 : type == 'D' ? 8 : 4;
  }
};

struct X3pHeader {
  X3pAxis x, y, z; ///< z is absolute
  std::int64_t size_x = 0;
  std::int64_t size_y = 0;
};

class X3pDocument {
public:
  /// @param name  of the X3P file, for messages
  /// @throws input::InputError  the text is no XML
  X3pDocument(const std::string& text, std::string name)
      : name_(std::move(name)) {
    const pugi::xml_parse_result parsed =
        document_.load_buffer(text.data(), text.size());
    if (!parsed)
      refuse(fmt::format("byte {}: is no XML ({})", parsed.offset,
                         parsed.description()));
  }

  /// @throws input::InputError  the file is no surface with one layer, or an
  ///                            entry is missing or malformed
  X3pHeader header() const {
    const std::string feature = needed_text("Record1/FeatureType");
    if (feature != "SUR")
      refuse(fmt::format("Record1/FeatureType is '{}', but must be SUR, a "
                         "surface; profiles and point clouds are no maps",
                         printable(feature)));
    X3pHeader header;
    header.x = axis("CX");
    header.y = axis("CY");
    header.z = axis("CZ");
    if (!header.z.is_absolute)
      refuse("the axis CZ must be absolute (A)");
    if (!node_at("Record3/MatrixDimension"))
      refuse("there is no MatrixDimension: the points are a list, not a map");
    header.size_x = count_at("Record3/MatrixDimension/SizeX");
    header.size_y = count_at("Record3/MatrixDimension/SizeY");
    if (const auto layers = count_at("Record3/MatrixDimension/SizeZ");
        layers != 1)
      refuse(fmt::format("Record3/MatrixDimension/SizeZ is {}, but must be 1",
                         layers));
    return header;
  }

  /// The text of an entry such as "Record3/DataLink/PointDataLink", whatever
  /// the namespace prefixes; "" if there is none.
  std::string text_at(std::string_view path) const {
    return trimmed(node_at(path).child_value());
  }

  /// The texts of the entries of an element; empty if there is none.
  std::vector<std::string> texts_in(std::string_view path) const {
    std::vector<std::string> texts;
    for (const pugi::xml_node& node : node_at(path).children())
      texts.push_back(trimmed(node.child_value()));
    return texts;
  }

  /// @throws input::InputError  "name: main.xml: what"
  [[noreturn]] void refuse(const std::string& what) const {
    throw input::InputError(fmt::format("{}: main.xml: {}", name_, what));
  }

private:
  pugi::xml_node node_at(std::string_view path) const {
    pugi::xml_node node = document_.document_element();
    while (!path.empty()) {
      const std::size_t end = std::min(path.find('/'), path.size());
      node = child_named(node, path.substr(0, end));
      path.remove_prefix(std::min(end + 1, path.size()));
    }
    return node;
  }

  std::string needed_text(const std::string& path) const {
    std::string text = text_at(path);
    if (text.empty())
      refuse("there is no " + path);
    return text;
  }

  double number_at(const std::string& path, double otherwise) const {
    const std::string text = text_at(path);
    if (text.empty())
      return otherwise;
    const double number = number_of_text(text);
    if (!std::isfinite(number))
      refuse(fmt::format("{} is '{}', but must be a finite number", path,
                         printable(text)));
    return number;
  }

  std::int64_t count_at(const std::string& path) const {
    const std::string text = needed_text(path);
    std::int64_t number = 0;
    const auto [stop, error] =
        std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || stop != text.data() + text.size())
      refuse(fmt::format("{} is '{}', but must be a whole number", path,
                         printable(text)));
    return number;
  }

  X3pAxis axis(const std::string& name) const {
    const std::string path = "Record1/Axes/" + name;
    X3pAxis axis;
    const std::string kind = needed_text(path + "/AxisType");
    if (kind != "A" && kind != "I")
      refuse(fmt::format("{}/AxisType is '{}', but must be A (absolute) or I "
                         "(incremental)",
                         path, printable(kind)));
    axis.is_absolute = kind == "A";
    const std::string type =
        axis.is_absolute ? needed_text(path + "/DataType") : "D";
    if (type != "I" && type != "L" && type != "F" && type != "D")
      refuse(fmt::format("{}/DataType is '{}', but must be I, L, F or D", path,
                         printable(type)));
    axis.type = type[0];
    axis.increment = number_at(path + "/Increment", 1.0);
    axis.offset = number_at(path + "/Offset", 0.0);
    if (axis.increment <= 0.0)
      refuse(fmt::format("{}/Increment is {:.6g} m, but must be > 0", path,
                         axis.increment));
    return axis;
  }

  pugi::xml_document document_;
  std::string name_;
};

/// Where main.xml names the members with the points.
const std::string x3p_link_path = "Record3/DataLink/";

/// @param member  in words
void refuse_other_sum(const std::string& name, const std::string& member,
                      std::string stated, const std::string& found) {
  for (char& digit : stated)
    digit = static_cast<char>(std::tolower(static_cast<unsigned char>(digit)));
  if (stated != found)
    throw input::InputError(fmt::format(
        "{}: {} has the MD5 checksum {}, but the file states {}; it is "
        "damaged or was changed",
        name, printable(member), found, printable(stated)));
}

/// Compares main.xml with the file of its checksum, if there is one.
void compare_sum_of_document(const std::string& name, const ZipArchive& archive,
                             const std::string& text,
                             const X3pDocument& document) {
  const std::string member = document.text_at("Record4/ChecksumFile");
  if (member.empty() || !archive.has(member))
    return;
  const std::string line = archive.member(member);
  refuse_other_sum(name, "main.xml",
                   line.substr(0, line.find_first_of(" \t\r\n*")),
                   md5_hash(text));
}

/// A member that main.xml names.
struct X3pMember {
  std::string name;
  std::string bytes;
};

/// The points of a file [m]; x and y are empty unless their axes are absolute.
struct X3pPoints {
  std::vector<double> x, y, z;
};

/// Reads the points, from members of the archive or from main.xml itself.
class X3pReader {
public:
  X3pReader(const std::string& name, const ZipArchive& archive,
            const X3pDocument& document)
      : name_(name),
        archive_(archive),
        document_(document),
        header_(document.header()) {}

  Scan scan() {
    if (document_.text_at(x3p_link_path + "PointDataLink").empty())
      take_listed_points();
    else
      take_stored_points();
    const Grid found = grid(); // asks which heights are missing
    return scan_of_numbers(found, std::move(points_.z), "own reader of X3P",
                           {.has_own_marks = true});
  }

private:
  std::size_t count() const {
    return static_cast<std::size_t>(header_.size_x * header_.size_y);
  }

  X3pMember linked_member(const char* link) const {
    const std::string member = document_.text_at(x3p_link_path + link);
    return {member, archive_.member(member)};
  }

  /// @param sum  key of main.xml with the checksum of the member
  void compare_sum(const X3pMember& member, const char* sum) const {
    const std::string stated = document_.text_at(x3p_link_path + sum);
    if (!stated.empty())
      refuse_other_sum(name_, member.name, stated, md5_hash(member.bytes));
  }

  void take_stored_points() {
    const X3pMember stored = linked_member("PointDataLink");
    const std::string full_name = name_ + ": " + printable(stored.name);
    require_sound_grid(full_name, header_.size_x, header_.size_y,
                       static_cast<double>(header_.x.stored_bytes() +
                                           header_.y.stored_bytes() +
                                           header_.z.stored_bytes()),
                       stored.bytes.size());
    compare_sum(stored, "MD5ChecksumPointData");
    ByteReader bytes(stored.bytes, full_name);
    take_points([&](const X3pAxis& axis, std::size_t) {
      return axis.type == 'I'   ? bytes.take<std::int16_t>()
             : axis.type == 'L' ? bytes.take<std::int32_t>()
             : axis.type == 'F' ? static_cast<double>(bytes.take<float>())
                                : bytes.take<double>();
    });
    if (!document_.text_at(x3p_link_path + "ValidPointsLink").empty())
      remove_points_not_valid();
  }

  /// Bit i of the file of valid points, from the least significant one of each
  /// byte, is 0 if point i is missing.
  void remove_points_not_valid() {
    const X3pMember valid = linked_member("ValidPointsLink");
    const std::size_t needed = (count() + 7) / 8;
    if (valid.bytes.size() < needed)
      document_.refuse(fmt::format("{} has {} bytes, but {} points need {}",
                                   printable(valid.name), valid.bytes.size(),
                                   count(), needed));
    compare_sum(valid, "MD5ChecksumValidPoints");
    for (std::size_t i = 0; i < count(); ++i)
      if ((static_cast<unsigned char>(valid.bytes[i / 8]) >> (i % 8) & 1) == 0)
        points_.z[i] = std::numeric_limits<double>::quiet_NaN();
  }

  /// Takes the points of main.xml: the absolute coordinates, separated by
  /// semicolons; an empty text is a missing point, without coordinates.
  void take_listed_points() {
    const std::vector<std::string> texts =
        document_.texts_in("Record3/DataList");
    if (texts.empty())
      document_.refuse("Record3 has neither a PointDataLink nor a DataList");
    require_sound_grid(name_ + ": main.xml", header_.size_x, header_.size_y,
                       1.0, texts.size());
    if (texts.size() != count())
      document_.refuse(fmt::format("{} points in DataList, but {} in "
                                   "MatrixDimension",
                                   texts.size(), count()));
    std::vector<double> numbers; // of one point, the next one last
    take_points([&](const X3pAxis&, std::size_t point) {
      if (numbers.empty())
        numbers = listed_numbers(texts[point]);
      const double number = numbers.back();
      numbers.pop_back();
      return number;
    });
  }

  /// The numbers of a listed point from the last one to the first.
  std::vector<double> listed_numbers(const std::string& text) const {
    const std::size_t stored = 1 + (header_.x.is_absolute ? 1U : 0U) +
                               (header_.y.is_absolute ? 1U : 0U);
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    if (text.empty())
      return std::vector<double>(stored, missing);
    std::vector<double> numbers;
    bool is_good = true;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(';', begin), text.size());
      const std::string word = trimmed(text.substr(begin, end - begin));
      numbers.push_back(number_of_text(word));
      is_good = is_good && (word.empty() || lower_case(word) == "nan" ||
                            !std::isnan(numbers.back()));
      begin = end + 1;
    }
    if (!is_good || numbers.size() != stored)
      document_.refuse(fmt::format(
          "found the point '{}', but must be {} number(s), separated by "
          "semicolons, or empty at a missing point",
          printable(text), stored));
    std::ranges::reverse(numbers);
    return numbers;
  }

  /// Takes the absolute coordinates of all points, x, y and z of each.
  /// @param next  the next number, of an axis of a point
  template <class Next>
  void take_points(const Next& next) {
    const std::pair<const X3pAxis*, std::vector<double>*> axes[] = {
        {&header_.x, &points_.x},
        {&header_.y, &points_.y},
        {&header_.z, &points_.z}};
    for (const auto& [axis, coordinates] : axes)
      coordinates->reserve(axis->is_absolute ? count() : 0);
    for (std::size_t i = 0; i < count(); ++i)
      for (const auto& [axis, coordinates] : axes)
        if (axis->is_absolute)
          coordinates->push_back(axis->offset +
                                 axis->increment * next(*axis, i));
  }

  Grid grid() const {
    const auto width = static_cast<std::size_t>(header_.size_x);
    Grid grid;
    grid.points_x = static_cast<int>(header_.size_x);
    grid.points_y = static_cast<int>(header_.size_y);
    const double spacing_x =
        header_.x.is_absolute
            ? regular_step(points_.x, "x",
                           [&](std::size_t i) { return i % width; })
            : header_.x.increment;
    const double spacing_y =
        header_.y.is_absolute
            ? regular_step(points_.y, "y",
                           [&](std::size_t i) { return i / width; })
            : header_.y.increment;
    grid.length_x = grid.points_x * spacing_x;
    grid.length_y = grid.points_y * spacing_y;
    require_sound_lengths(name_, grid);
    return grid;
  }

  /// The distance of adjacent points, whose positions along an absolute axis
  /// must be equidistant within 2 % of it. A missing point may have none.
  /// @param place_of  number of a point along the axis
  template <class Place>
  double regular_step(const std::vector<double>& positions, const char* axis,
                      const Place& place_of) const {
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (!std::isnan(positions[i]) || !std::isnan(points_.z[i]))
        known.push_back(i);
    const auto place = [&](std::size_t point) {
      return static_cast<double>(place_of(point));
    };
    const auto ends = std::ranges::minmax_element(known, {}, place);
    if (known.empty() || place(*ends.min) == place(*ends.max))
      document_.refuse(fmt::format("too many points are missing to tell the "
                                   "absolute positions along {}",
                                   axis));
    const double first_place = place(*ends.min);
    const double first = positions[*ends.min];
    const double step =
        (positions[*ends.max] - first) / (place(*ends.max) - first_place);
    for (const std::size_t i : known)
      if (!(std::abs(positions[i] -
                     (first + (place(i) - first_place) * step)) <=
            0.02 * std::abs(step))) {
        const auto width = static_cast<std::size_t>(header_.size_x);
        document_.refuse(fmt::format("the absolute positions along {} are not "
                                     "regular at point ({}, {})",
                                     axis, i % width, i / width));
      }
    return std::abs(step);
  }

  const std::string& name_;
  const ZipArchive& archive_;
  const X3pDocument& document_;
  X3pHeader header_;
  X3pPoints points_;
};

bool is_x3p(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") &&
         bytes.find("main.xml") != std::string_view::npos;
}

Scan read_x3p(const MapBytes& bytes, const ScanRequest&) {
  const std::string& name = bytes.name();
  ZipArchive archive(bytes.all(), name);
  archive.enter_folder_of("main.xml"); // some programs pack a folder
  const std::string text = archive.member("main.xml");
  const X3pDocument document(text, name);
  X3pReader reader(name, archive, document);
  compare_sum_of_document(name, archive, text, document);
  return reader.scan();
}

} // namespace

MapFormat x3p_format() {
  return {.name = "x3p",
          .words = {"ISO 5436-2", "zip archive with `main.xml`",
                    "`main.xml` [m]",
                    "file of valid points; NaN; empty `Datum`", "one"},
          .reads = is_x3p,
          .heights = read_x3p,
          .scales = FileScales::all};
}

} // namespace asperity::surfaces
