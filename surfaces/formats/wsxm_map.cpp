#include "base/plain_text.hpp"
#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace asperity::surfaces {
namespace {

/// The lines "key: value" of a header, by "[Section] key".
struct WsxmHeader {
  std::string name; ///< of the file
  std::map<std::string, std::string> values;
  std::size_t begin = 0; ///< first byte of the numbers

  [[noreturn]] void refuse(const std::string& key,
                           const std::string& what) const {
    const auto found = values.find(key);
    throw input::InputError(
        found == values.end()
            ? fmt::format("{}: its header has no line {}", name, key)
            : fmt::format("{}: {}: found '{}', but must be {}", name, key,
                          printable(found->second), what));
  }

  std::string text(const std::string& key) const {
    const auto found = values.find(key);
    return found == values.end() ? "" : found->second;
  }

  double length(const std::string& key) const {
    const std::optional<double> metres = length_of_text(text(key));
    if (!metres || *metres <= 0.0)
      refuse(key,
             std::string("a number > 0 and a unit of ") + known_length_units());
    return *metres;
  }

  std::int64_t count(const std::string& key) const {
    const double number = number_of_text(text(key));
    if (!(number >= 0.0 && number < 1e9) || number != std::floor(number))
      refuse(key, "a number of points");
    return static_cast<std::int64_t>(number);
  }
};

WsxmHeader wsxm_header(std::string_view beginning, const std::string& name) {
  WsxmHeader header;
  header.name = name;
  std::string section;
  std::size_t at = 0;
  int line_number = 0;
  while (true) {
    const std::size_t end = beginning.find('\n', at);
    if (end == std::string_view::npos)
      throw input::InputError(name + ": no line [Header end], which must end "
                                     "the header of a WSxM file");
    std::string line(beginning.substr(at, end - at));
    if (line.ends_with('\r'))
      line.pop_back();
    line = trimmed(line);
    at = end + 1;
    if (++line_number == 2 && line != "SxM Image file")
      throw input::InputError(
          fmt::format("{}:2: found '{}', but only WSxM files with the second "
                      "line 'SxM Image file' are maps",
                      name, printable(line)));
    if (line == "[Header end]")
      break;
    if (line.starts_with('['))
      section = line;
    else if (const std::size_t colon = line.find(':');
             colon != std::string::npos)
      header.values.try_emplace(section + " " + line.substr(0, colon),
                                trimmed(line.substr(colon + 1)));
  }
  header.begin = at;
  return header;
}

template <class Number>
std::vector<double> wsxm_numbers(std::string_view stored) {
  ByteReader bytes(stored, "");
  std::vector<double> numbers(stored.size() / sizeof(Number));
  // The file begins with the last point of the last row.
  for (std::size_t i = numbers.size(); i-- > 0;)
    numbers[i] = static_cast<double>(bytes.take<Number>());
  return numbers;
}

struct WsxmType {
  const char* name;
  std::size_t bytes;
  bool is_physical; ///< the numbers have the unit of the heights
  std::vector<double> (*numbers)(std::string_view stored);
};

const WsxmType& wsxm_type(const WsxmHeader& header) {
  static constexpr WsxmType types[] = {
      {"short", 2, false, wsxm_numbers<std::int16_t>},
      {"", 2, false, wsxm_numbers<std::int16_t>}, // files before version 4
      {"integer", 2, false, wsxm_numbers<std::int16_t>},
      {"float", 4, true, wsxm_numbers<float>},
      {"double", 8, true, wsxm_numbers<double>}};
  const std::string key = "[General Info] Image Data Type";
  const std::string name = header.text(key);
  for (const WsxmType& type : types)
    if (name == type.name)
      return type;
  header.refuse(key, "short, integer, float or double");
}

/// [m] per unit of the numbers. The header gives the difference of the largest
/// and the least height.
double wsxm_height_unit(const WsxmHeader& header, const WsxmType& type,
                        const std::vector<double>& numbers) {
  const std::string key = "[General Info] Z Amplitude";
  const double amplitude = header.length(key);
  double least = HUGE_VAL, largest = -HUGE_VAL;
  for (const double number : numbers)
    if (std::isfinite(number)) {
      least = std::min(least, number);
      largest = std::max(largest, number);
    }
  const double difference = largest - least;
  if (!(difference > 0.0))
    throw input::InputError(header.name + ": all of its numbers are equal");
  if (!type.is_physical)
    return amplitude / difference;
  // The unit is the last word; the header has some six digits.
  const std::string text = header.text(key);
  const double unit =
      *length_of_text("1" + text.substr(text.find_last_of("0123456789.") + 1));
  constexpr double rounding = 1e-3;
  if (!(std::abs(difference * unit - amplitude) <= rounding * amplitude))
    throw input::InputError(
        fmt::format("{}: {} is {}, but the heights of the file differ by up to "
                    "{:.6g} m",
                    header.name, key, printable(text), difference * unit));
  return unit;
}

Scan read_wsxm(const MapBytes& bytes, const ScanRequest&) {
  const std::string& name = bytes.name();
  const std::string_view file = bytes.all();
  if (!file.starts_with("WSxM file"))
    throw input::InputError(name +
                            ": is no WSxM file: it does not begin with WSxM");
  const WsxmHeader header = wsxm_header(bytes.beginning(), name);
  const WsxmType& type = wsxm_type(header);
  const std::int64_t columns = header.count("[General Info] Number of columns");
  const std::int64_t rows = header.count("[General Info] Number of rows");
  const std::uintmax_t available = file.size() - header.begin;
  require_sound_grid(name, columns, rows, static_cast<double>(type.bytes),
                     available);
  if (available != static_cast<std::uintmax_t>(columns * rows) * type.bytes)
    throw input::InputError(fmt::format(
        "{}: has {} bytes behind its header, but {} x {} numbers of the type "
        "'{}' have {}",
        name, available, columns, rows, type.name,
        static_cast<std::uintmax_t>(columns * rows) * type.bytes));
  const Grid grid{static_cast<int>(columns), static_cast<int>(rows),
                  header.length("[Control] X Amplitude"),
                  header.length("[Control] Y Amplitude")};
  std::vector<double> heights = type.numbers(file.substr(header.begin));
  const double unit = wsxm_height_unit(header, type, heights);
  for (double& height : heights)
    height *= unit;
  return scan_of_numbers(grid, std::move(heights), "own reader of WSxM");
}

} // namespace

MapFormat wsxm_format() {
  return {
      .name = "wsxm",
      .words = {"WSxM", "`WSxM file`", "header", "NaN", "one"},
      .reads =
          [](std::string_view bytes) { return bytes.starts_with("WSxM file"); },
      .heights = read_wsxm,
      .scales = FileScales::all,
      .endings = {".stp", ".top", ".wsxm"},
      .sides = {{"X Amplitude:", true}, {"Y Amplitude:", false}}};
}

} // namespace asperity::surfaces
