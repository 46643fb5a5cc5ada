#include "base/plain_text.hpp"
#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace asperity::surfaces {
namespace {

constexpr std::size_t sur_header_bytes = 512;

/// What a file contains, by the code of its type.
const char* sur_type_name(int type) {
  static constexpr std::pair<int, const char*> names[] = {
      {1, "a profile"},
      {2, "a surface"},
      {3, "a binary image"},
      {4, "a series of profiles"},
      {5, "a series of surfaces"},
      {6, "a meridian disc"},
      {7, "a profile of several layers"},
      {8, "a surface of several layers"},
      {9, "a parallel disc"},
      {10, "an image of intensities"},
      {11, "a surface with an image"},
      {12, "an image of colours"},
      {13, "a surface with an image"},
      {16, "a surface with an image"},
      {17, "a contour"},
      {18, "a series of images"},
      {20, "a spectrum"},
      {21, "a map of spectra"}};
  for (const auto& [code, name] : names)
    if (type == code)
      return name;
  return "an object of unknown type";
}

/// The axes in the order of the header.
enum SurAxis { sur_x, sur_y, sur_z };

/// The fields of a header that determine the heights.
struct SurHeader {
  int objects = 0;
  int type = 0;
  bool has_special_points = false;
  int bits = 0; ///< of a number, 16 or 32
  bool is_big_endian = false;
  std::int32_t least = 0, largest = 0; ///< numbers of measured points
  std::int32_t columns = 0, rows = 0;
  std::uint32_t points = 0;
  double step[3] = {};   ///< [unit] per column, row and number
  double unit[3] = {};   ///< [m]
  double height = 0.0;   ///< of the number 0 [unit of z]
  int inversion = 0;     ///< 0: none
  std::size_t begin = 0; ///< first byte of the numbers

  std::size_t width() const { return static_cast<std::size_t>(bits / 8); }
};

double sur_unit(std::string_view text, SurAxis axis, const std::string& name) {
  std::string unit(text.substr(0, text.find('\0')));
  unit.erase(unit.find_last_not_of(' ') + 1);
  unit.erase(0, unit.find_first_not_of(' '));
  if (unit.starts_with('\xE6')) // micro sign in the character set of DOS
    unit.front() = '\xB5';
  const std::optional<double> metres = length_unit(unit);
  if (!metres)
    throw input::InputError(fmt::format(
        "{}: the step along {} is in '{}', but must be in one of {}", name,
        "xyz"[axis], printable(unit), known_length_units()));
  return *metres;
}

/// Reads the whole header.
SurHeader sur_header(std::string_view beginning, const std::string& name) {
  ByteReader bytes(beginning, name);
  SurHeader header;
  // The size of a number, 16 or 32, shows the order of the bytes.
  constexpr std::size_t place_of_bits = 98;
  if (beginning.size() > place_of_bits + 1 &&
      beginning[place_of_bits] == '\0') {
    header.is_big_endian = true;
    bytes.expect_big_endian();
  }
  bytes.skip(12 + 2); // signature and format
  header.objects = bytes.take<std::uint16_t>();
  bytes.skip(2); // version
  header.type = bytes.take<std::uint16_t>();
  bytes.skip(30 + 30 + 6); // names, channels, instrument and range
  header.has_special_points = bytes.take<std::uint16_t>() != 0;
  bytes.skip(2 + 8); // absolute heights, resolution, points of a spectrum
  header.bits = bytes.take<std::uint16_t>();
  header.least = bytes.take<std::int32_t>();
  header.largest = bytes.take<std::int32_t>();
  header.columns = bytes.take<std::int32_t>();
  header.rows = bytes.take<std::int32_t>();
  header.points = bytes.take<std::uint32_t>();
  for (double& step : header.step)
    step = bytes.take<float>();
  bytes.skip(std::size_t{3} * 16); // names of the axes
  std::string_view units[3];
  for (std::string_view& unit : units)
    unit = bytes.take_bytes(16);
  bytes.skip(std::size_t{3} * 16 + std::size_t{3} * 4 +
             2); // other units, their ratios
  header.inversion = bytes.take<std::uint16_t>();
  bytes.skip(2 + 12 + 14 + 4 + 4 + 6); // levelling, time, compressed size
  header.begin = sur_header_bytes + bytes.take<std::uint16_t>();
  header.begin += bytes.take<std::uint16_t>();
  bytes.skip(128 + 4 + 4); // client zone, offsets along x and y
  header.height = bytes.take<float>();
  bytes.skip(sur_header_bytes - bytes.offset());
  if (header.type == 2)
    for (const SurAxis axis : {sur_x, sur_y, sur_z})
      header.unit[axis] = sur_unit(units[axis], axis, name);
  return header;
}

void check_sur(const SurHeader& header, std::uintmax_t file_bytes,
               const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw input::InputError(name + ": " + what);
  };
  if (header.type != 2 || header.objects > 1)
    refuse(fmt::format("is a Digital Surf file of {} object(s), {} (type {}), "
                       "but must contain one surface (type 2)",
                       header.objects, sur_type_name(header.type),
                       header.type));
  if (header.bits != 16 && header.bits != 32)
    refuse(fmt::format("has numbers of {} bits, but they must have 16 or 32",
                       header.bits));
  for (const SurAxis axis : {sur_x, sur_y, sur_z})
    if (!std::isfinite(header.step[axis]) || header.step[axis] <= 0.0)
      refuse(fmt::format("the step along {} is {:.6g}, but must be > 0",
                         "xyz"[axis], header.step[axis]));
  if (header.has_special_points && header.largest <= header.least)
    refuse(fmt::format("announces special points outside the numbers {} to {} "
                       "(Zmin, Zmax), which leave no heights",
                       header.least, header.largest));
  if (!std::isfinite(header.height))
    refuse("the height of the number 0 is not finite");
  if (header.inversion != 0)
    refuse(fmt::format(
        "states the inversion {}, and programs differ in whether its numbers "
        "are heights or depths; save it without an inversion, or let Gwyddion "
        "decide by format = \"convert\"",
        header.inversion));
  const auto available =
      file_bytes - std::min<std::uintmax_t>(file_bytes, header.begin);
  require_sound_grid(name, header.columns, header.rows,
                     static_cast<double>(header.width()), available);
  const auto points = static_cast<std::uintmax_t>(header.columns) *
                      static_cast<std::uintmax_t>(header.rows);
  if (header.points != points || available != points * header.width())
    refuse(fmt::format(
        "has {} x {} points of {} bytes from byte {} on, but states {} points "
        "and ends at byte {}",
        header.columns, header.rows, header.width(), header.begin,
        header.points, file_bytes));
}

/// The heights; numbers outside the range of the measured ones are special
/// points: not measured (least - 2) or saturated.
template <class Number>
std::vector<double> sur_heights(const SurHeader& header,
                                std::string_view stored) {
  ByteReader bytes(stored, "");
  if (header.is_big_endian)
    bytes.expect_big_endian();
  std::vector<double> heights(header.points);
  for (double& height : heights) {
    const auto number = bytes.take<Number>();
    height = header.has_special_points &&
                     (number < header.least || number > header.largest)
                 ? std::numeric_limits<double>::quiet_NaN()
                 : header.unit[sur_z] *
                       (header.step[sur_z] * number + header.height);
  }
  return heights;
}

Scan read_sur(const MapBytes& bytes, const ScanRequest&) {
  const std::string& name = bytes.name();
  const std::string_view file = bytes.all();
  if (file.starts_with("DSCOMPRESSED"))
    throw input::InputError(
        name + ": is a compressed Digital Surf file (DSCOMPRESSED), but only "
               "uncompressed ones (DIGITAL SURF) can be read; save it without "
               "compression");
  if (!file.starts_with("DIGITAL SURF"))
    throw input::InputError(name + ": is no Digital Surf file: it does not "
                                   "begin with DIGITAL SURF");
  const SurHeader header = sur_header(file, name);
  check_sur(header, file.size(), name);
  const Grid grid{header.columns, header.rows,
                  header.unit[sur_x] * header.step[sur_x] * header.columns,
                  header.unit[sur_y] * header.step[sur_y] * header.rows};
  require_sound_lengths(name, grid);
  const std::string_view stored = file.substr(header.begin);
  return scan_of_numbers(grid,
                         header.bits == 16
                             ? sur_heights<std::int16_t>(header, stored)
                             : sur_heights<std::int32_t>(header, stored),
                         "own reader of Digital Surf", {.has_own_marks = true});
}

/// Gwyddion takes the special points of Digital Surf files for heights.
void refuse_special_points(const MapBytes& bytes) {
  constexpr std::size_t place = 86;
  const std::string_view beginning = bytes.beginning();
  if (beginning.size() > place + 1 &&
      (beginning[place] != '\0' || beginning[place + 1] != '\0'))
    throw input::InputError(
        bytes.name() +
        ": its header announces special points, whose numbers Gwyddion "
        "takes for heights; format = \"sur\" is our own reader");
}

} // namespace

MapFormat sur_format() {
  return {.name = "sur",
          .words = {"Digital Surf", "`DIGITAL SURF`", "header",
                    "numbers outside Zmin to Zmax if the header announces "
                    "special points",
                    "one"},
          .reads =
              [](std::string_view bytes) {
                return bytes.starts_with("DIGITAL SURF") ||
                       bytes.starts_with("DSCOMPRESSED");
              },
          .heights = read_sur,
          .scales = FileScales::all,
          .endings = {".sur"},
          .before_conversion = refuse_special_points};
}

} // namespace asperity::surfaces
