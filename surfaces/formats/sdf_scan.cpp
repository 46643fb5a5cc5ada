#include "base/plain_text.hpp"
#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
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
};

/// Checks everything but the grid, which depends on the bytes that follow.
void check_header(const SdfHeader& header, const std::string& name) {
  if (header.compression != 0)
    throw input::InputError(fmt::format(
        "{}: Compression = {}, but only uncompressed SDF files can be read",
        name, header.compression));
  if (!std::isfinite(header.scale_z) || header.scale_z <= 0.0)
    throw input::InputError(fmt::format(
        "{}: Zscale = {:.6g} m, but must be > 0", name, header.scale_z));
  for (const double scale : {header.scale_x, header.scale_y})
    if (!std::isfinite(scale) || scale <= 0.0)
      throw input::InputError(fmt::format(
          "{}: Xscale or Yscale is {:.6g} m, but must be > 0", name, scale));
}

Grid grid_of(const SdfHeader& header) {
  return {static_cast<int>(header.points), static_cast<int>(header.profiles),
          header.scale_x * static_cast<double>(header.points),
          header.scale_y * static_cast<double>(header.profiles)};
}

Scan scan_of_sdf(const SdfHeader& header, std::vector<double> numbers,
                 const std::string& name, const char* reader) {
  Scan scan;
  scan.map.grid = grid_of(header);
  scan.map.heights = std::move(numbers);
  multiply_heights(scan, header.scale_z);
  mark_missing(scan, name);
  scan.reader = reader;
  return scan;
}

/// Takes lines from a text and counts them.
class SdfLines {
public:
  explicit SdfLines(std::string_view text) : rest_(text) {}

  std::optional<std::string_view> next() {
    if (rest_.empty())
      return std::nullopt;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    while (!line.empty() &&
           (line.back() == '\r' || line.back() == ' ' || line.back() == '\t'))
      line.remove_suffix(1);
    return line;
  }

  int number() const { return number_; }

  std::size_t remaining() const { return rest_.size(); }

private:
  std::string_view rest_;
  int number_ = 0;
};

using SdfFields = std::map<std::string, double, std::less<>>;

/// Reads the lines "Key = number" up to the line "*".
SdfFields read_fields(SdfLines& lines, const std::string& name) {
  SdfFields fields;
  for (auto line = lines.next(); line; line = lines.next()) {
    if (line->starts_with('*'))
      return fields;
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos)
      continue;
    fields[trimmed(line->substr(0, equals))] =
        number_of_text(trimmed(line->substr(equals + 1)));
  }
  throw input::InputError(name + ": the header has no end, a line with *");
}

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

std::vector<double> read_words(SdfLines& lines, std::size_t count,
                               const std::string& name) {
  std::vector<double> numbers;
  numbers.reserve(count);
  for (auto line = lines.next(); line && !line->starts_with('*');
       line = lines.next()) {
    std::size_t at = 0;
    while ((at = line->find_first_not_of(" \t", at)) !=
           std::string_view::npos) {
      const std::size_t end =
          std::min(line->find_first_of(" \t", at), line->size());
      if (numbers.size() == count)
        refuse_line(
            name, lines.number(),
            fmt::format("more than the {} numbers of the header", count));
      numbers.push_back(
          sdf_number(line->substr(at, end - at), name, lines.number()));
      at = end;
    }
  }
  if (numbers.size() != count)
    throw input::InputError(
        fmt::format("{}: has {} numbers, but the header says {}", name,
                    numbers.size(), count));
  return numbers;
}

Scan read_sdf_text(std::string_view bytes, const std::string& name) {
  SdfLines lines(bytes);
  lines.next(); // the version, which has been recognised
  const SdfFields fields = read_fields(lines, name);
  SdfHeader header;
  header.points = count_of(fields, "NumPoints", name);
  header.profiles = count_of(fields, "NumProfiles", name);
  header.scale_x = field_of(fields, "Xscale", name);
  header.scale_y = field_of(fields, "Yscale", name);
  header.scale_z = field_of(fields, "Zscale", name);
  if (fields.contains("Compression"))
    header.compression =
        static_cast<int>(count_of(fields, "Compression", name));
  check_header(header, name);
  require_sound_grid(name, header.points, header.profiles, 1.0,
                     lines.remaining());
  const auto count = static_cast<std::size_t>(header.points * header.profiles);
  return scan_of_sdf(header, read_words(lines, count, name), name,
                     "own reader of SDF (ASCII)");
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

constexpr const char* binary_reader = "own reader of SDF (binary)";

/// Reads the header up to the first number.
/// @param file_bytes  size of the file
SdfType take_header(ByteReader& bytes, std::uintmax_t file_bytes,
                    SdfHeader& header) {
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
  check_header(header, name);
  const SdfType type = type_of(header.data_type, name);
  require_sound_grid(name, header.points, header.profiles,
                     static_cast<double>(type.bytes),
                     file_bytes - bytes.offset());
  return type;
}

Scan read_sdf_binary(std::string_view content, const std::string& name) {
  ByteReader bytes(content, name);
  SdfHeader header;
  const SdfType type = take_header(bytes, content.size(), header);
  std::vector<double> numbers(
      static_cast<std::size_t>(header.points * header.profiles));
  type.take(bytes, numbers);
  return scan_of_sdf(header, std::move(numbers), name, binary_reader);
}

} // namespace

Scan read_sdf_scan(std::string_view bytes, const std::string& name) {
  return bytes.starts_with('b') ? read_sdf_binary(bytes, name)
                                : read_sdf_text(bytes, name);
}

std::optional<RowFile> sdf_row_file(const std::string& path,
                                    std::string_view beginning,
                                    const ScanRequest& request) {
  if (!beginning.starts_with('b') || !request.channel.value_or("").empty())
    return std::nullopt;
  refuse_scale(request.scale, path);
  ByteReader bytes(beginning, path);
  SdfHeader header;
  const SdfType type =
      take_header(bytes, std::filesystem::file_size(path), header);
  RowFile file{grid_of(header), "", binary_reader, {}};
  file.rows = [numbers = StoredNumbers{
                   path, bytes.offset(), type.bytes,
                   static_cast<std::size_t>(header.points), header.scale_z,
                   [type](std::string_view of_rows, std::span<double> taken) {
                     ByteReader rows(of_rows, "");
                     type.take(rows, taken);
                   }}](int first, int count) {
    return stored_rows(numbers, first, count);
  };
  return file;
}

} // namespace asperity::surfaces
