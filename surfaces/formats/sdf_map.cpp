#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/sdf_header.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
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

OpenMap open_binary_sdf(const MapBytes& file) {
  const std::string beginning = file.beginning();
  ByteReader bytes(beginning, file.name());
  SdfHeader header;
  const SdfType type = take_header(bytes, file.size(), header);
  OpenMap map{header.grid(),
              "",
              "own reader of SDF (binary)",
              {},
              header.file_numbers()};
  map.rows = [numbers = StoredNumbers{
                  file, bytes.offset(), type.bytes,
                  static_cast<std::size_t>(header.points), header.scale_z,
                  [type](std::string_view of_rows, std::span<double> taken) {
                    ByteReader rows(of_rows, "");
                    type.take(rows, taken);
                  }}](int first, int count) {
    return numbers.rows(first, count);
  };
  return map;
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

OpenMap open_sdf(const MapBytes& bytes, const ScanRequest& request) {
  refuse_scale(request.scale, bytes.name());
  refuse_channel(request, "", bytes.name());
  return bytes.beginning().starts_with('b')
             ? open_binary_sdf(bytes)
             : open_sdf_text(bytes.all(), bytes.name());
}

} // namespace asperity::surfaces
