#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/sdf_header.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>

namespace asperity::surfaces {
namespace {

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
  header.check(name);
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
  return header.scan(std::move(numbers), name, binary_reader);
}

} // namespace

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

Scan SdfHeader::scan(std::vector<double> numbers, const std::string& name,
                     const char* reader) const {
  Scan scan;
  scan.map.grid = grid();
  scan.map.heights = std::move(numbers);
  scan.numbers = file_numbers();
  multiply_heights(scan, scale_z);
  mark_missing(scan, name);
  scan.reader = reader;
  return scan;
}

Scan read_sdf_scan(std::string_view bytes, const std::string& name) {
  return bytes.starts_with('b') ? read_sdf_binary(bytes, name)
                                : read_sdf_text(bytes, name);
}

std::optional<RowFile> sdf_row_file(const std::string& path,
                                    std::string_view beginning,
                                    const ScanRequest& request) {
  if (names_another(request.channel, ""))
    return std::nullopt;
  refuse_scale(request.scale, path);
  if (!beginning.starts_with('b'))
    return sdf_text_rows(path);
  ByteReader bytes(beginning, path);
  SdfHeader header;
  const SdfType type =
      take_header(bytes, std::filesystem::file_size(path), header);
  RowFile file{header.grid(), "", binary_reader, {}};
  file.numbers = header.file_numbers();
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
