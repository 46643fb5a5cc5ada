#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/sdf_header.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace asperity::surfaces {
namespace {

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
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end =
        std::min(text.find_first_of(" \t", at), text.size());
    if (numbers.size() == most)
      refuse_line(name, line,
                  fmt::format("more than the {} numbers of the header", most));
    numbers.push_back(sdf_number(text.substr(at, end - at), name, line));
    at = end;
  }
}

} // namespace

OpenMap open_sdf_text(std::string_view text, const std::string& name) {
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
  return map_in_memory(header.grid(), std::move(numbers),
                       "own reader of SDF (ASCII)", header.file_numbers());
}

} // namespace asperity::surfaces
