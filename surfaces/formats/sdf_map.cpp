#include "base/plain_text.hpp"
#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>

namespace asperity::surfaces {
namespace {

/// The fields of an SDF header that determine the heights.
struct SdfHeader {
  std::int64_t points = 0;   ///< in a profile, along x
  std::int64_t profiles = 0; ///< along y
  double scale_x = 0.0;      ///< spacing of the points [m]
  double scale_y = 0.0;      ///< spacing of the profiles [m]
  double scale_z = 0.0;      ///< metres per unit of the numbers
  int compression = 0;
  int data_type = 0;

  /// Checks everything but the grid, which depends on the bytes that follow.
  /// @throws input::InputError  the file is compressed, or a scale is not > 0
  void check(const std::string& name) const;

  Grid grid() const;

  FileNumbers file_numbers() const {
    return {.unit = scale_z, .has_own_marks = true};
  }
};

void SdfHeader::check(const std::string& name) const {
  if (compression != 0)
    throw input::InputError(fmt::format(
        "{}: Compression = {}, but only uncompressed SDF files can be read",
        name, compression));
  if (!std::isfinite(scale_z) || scale_z <= 0.0)
    throw input::InputError(
        fmt::format("{}: Zscale = {:.6g} m, but must be > 0", name, scale_z));
  for (const double scale : {scale_x, scale_y})
    if (!std::isfinite(scale) || scale <= 0.0)
      throw input::InputError(fmt::format(
          "{}: Xscale or Yscale is {:.6g} m, but must be > 0", name, scale));
}

Grid SdfHeader::grid() const {
  return {static_cast<int>(points), static_cast<int>(profiles),
          scale_x * static_cast<double>(points),
          scale_y * static_cast<double>(profiles)};
}

/// Takes numbers; the smallest signed integer marks a missing point.
template <class Number>
void take_numbers(ByteReader& bytes, std::span<double> numbers) {
  for (double& number : numbers) {
    const Number taken = bytes.take<Number>();
    number = static_cast<double>(taken);
    if constexpr (std::numeric_limits<Number>::is_integer &&
                  std::numeric_limits<Number>::is_signed)
      if (taken == std::numeric_limits<Number>::min())
        number = std::numeric_limits<double>::quiet_NaN();
  }
}

/// The number types of the standard, by their code.
struct SdfType {
  std::size_t bytes;
  void (*take)(ByteReader&, std::span<double>);
};

SdfType type_of(int code, const std::string& name) {
  static constexpr SdfType types[] = {
      {1, take_numbers<std::uint8_t>},  {2, take_numbers<std::uint16_t>},
      {4, take_numbers<std::uint32_t>}, {4, take_numbers<float>},
      {1, take_numbers<std::int8_t>},   {2, take_numbers<std::int16_t>},
      {4, take_numbers<std::int32_t>},  {8, take_numbers<double>}};
  if (code < 0 || code >= static_cast<int>(std::size(types)))
    throw input::InputError(
        fmt::format("{}: DataType = {}, but must lie between 0 and {}", name,
                    code, std::size(types) - 1));
  return types[code];
}

/// Reads the header up to the first number.
SdfType take_header(ByteReader& bytes, SdfHeader& header) {
  const std::string& name = bytes.name();
  bytes.take_bytes(8 + 10 + 12 + 12); // version, maker, two dates
  header.points = bytes.take<std::uint16_t>();
  header.profiles = bytes.take<std::uint16_t>();
  header.scale_x = bytes.take<double>();
  header.scale_y = bytes.take<double>();
  header.scale_z = bytes.take<double>();
  bytes.take<double>(); // resolution of the heights
  header.compression = bytes.take<std::uint8_t>();
  header.data_type = bytes.take<std::uint8_t>();
  bytes.take<std::uint8_t>(); // type of checksum, behind the numbers
  header.check(name);
  const SdfType type = type_of(header.data_type, name);
  require_sound_grid(name, header.points, header.profiles,
                     static_cast<double>(type.bytes), bytes.remaining());
  return type;
}

Scan read_binary_sdf(const MapBytes& file) {
  ByteReader bytes(file.all(), file.name());
  SdfHeader header;
  const SdfType type = take_header(bytes, header);
  const Grid grid = header.grid();
  std::vector<double> numbers(grid.size());
  type.take(bytes, numbers);
  return scan_of_numbers(grid, std::move(numbers), "own reader of SDF (binary)",
                         header.file_numbers());
}

using SdfFields = std::map<std::string, double, std::less<>>;

double field_of(const SdfFields& fields, const char* key,
                const std::string& name) {
  const auto found = fields.find(key);
  if (found == fields.end() || !std::isfinite(found->second))
    throw input::InputError(
        fmt::format("{}: the header has no line '{} = number'", name, key));
  return found->second;
}

std::int64_t count_of(const SdfFields& fields, const char* key,
                      const std::string& name) {
  const double number = field_of(fields, key, name);
  if (number != std::floor(number) || std::abs(number) > 1e9)
    throw input::InputError(fmt::format(
        "{}: {} = {:.6g}, but must be a whole number", name, key, number));
  return static_cast<std::int64_t>(number);
}

double sdf_number(std::string_view word, const std::string& name, int line) {
  if (word == "BAD" || word == "bad" || word == "NaN" || word == "nan")
    return std::numeric_limits<double>::quiet_NaN();
  const double number = number_of_text(word);
  if (!std::isfinite(number))
    refuse_line(name, line,
                fmt::format("found '{}', but must be a finite number or BAD",
                            printable(word)));
  return number;
}

SdfHeader header_of(const SdfFields& fields, const std::string& name) {
  SdfHeader header;
  header.points = count_of(fields, "NumPoints", name);
  header.profiles = count_of(fields, "NumProfiles", name);
  header.scale_x = field_of(fields, "Xscale", name);
  header.scale_y = field_of(fields, "Yscale", name);
  header.scale_z = field_of(fields, "Zscale", name);
  if (fields.contains("Compression"))
    header.compression =
        static_cast<int>(count_of(fields, "Compression", name));
  header.check(name);
  return header;
}

/// Takes the next line, without its end and the blanks before that.
std::string_view take_sdf_line(std::string_view& rest) {
  const std::string_view line = rest.substr(0, rest.find('\n'));
  rest.remove_prefix(std::min(line.size() + 1, rest.size()));
  return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

/// Takes the lines of the header, to the line "*".
/// @param line  receives the number of that line
SdfHeader take_sdf_header(std::string_view& rest, const std::string& name,
                          int& line) {
  SdfFields fields;
  take_sdf_line(rest); // the version, which has been recognised
  for (line = 2; !rest.empty(); ++line) {
    const std::string_view text = take_sdf_line(rest);
    if (text.starts_with('*'))
      return header_of(fields, name);
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos)
      fields[trimmed(text.substr(0, equals))] =
          number_of_text(trimmed(text.substr(equals + 1)));
  }
  throw input::InputError(name + ": the header has no end, a line with *");
}

/// Takes the numbers of a line.
void take_sdf_numbers(std::string_view text, std::size_t most,
                      const std::string& name, int line,
                      std::vector<double>& numbers) {
  for (const std::string_view word : words_of(text, " \t")) {
    if (numbers.size() == most)
      refuse_line(name, line,
                  fmt::format("more than the {} numbers of the header", most));
    numbers.push_back(sdf_number(word, name, line));
  }
}

Scan read_sdf_text(std::string_view text, const std::string& name) {
  int line = 0;
  const SdfHeader header = take_sdf_header(text, name, line);
  require_sound_grid(name, header.points, header.profiles, 1.0, text.size());
  const auto count = static_cast<std::size_t>(header.points * header.profiles);
  std::vector<double> numbers;
  numbers.reserve(count);
  while (!text.empty() && !text.starts_with('*'))
    take_sdf_numbers(take_sdf_line(text), count, name, ++line, numbers);
  if (numbers.size() != count)
    throw input::InputError(
        fmt::format("{}: has {} numbers, but the header says {}", name,
                    numbers.size(), count));
  return scan_of_numbers(header.grid(), std::move(numbers),
                         "own reader of SDF (ASCII)", header.file_numbers());
}

constexpr std::string_view sdf_versions[] = {"aISO-1.0", "bISO-1.0", "aBCR-1.0",
                                             "bBCR-1.0"};

bool is_sdf(std::string_view bytes) {
  return std::ranges::any_of(sdf_versions, [&](std::string_view version) {
    return bytes.starts_with(version);
  });
}

Scan read_sdf(const MapBytes& bytes, const ScanRequest&) {
  return bytes.beginning().starts_with('b')
             ? read_binary_sdf(bytes)
             : read_sdf_text(bytes.all(), bytes.name());
}

} // namespace

MapFormat sdf_format() {
  return {.name = "sdf",
          .words = {"ISO 25178-71",
                    "`aISO-1.0`, `bISO-1.0`, `aBCR-1.0`, `bBCR-1.0`",
                    "header [m]", "`BAD`; smallest signed integer; NaN", "one"},
          .reads = is_sdf,
          .heights = read_sdf,
          .scales = FileScales::all};
}

} // namespace asperity::surfaces
