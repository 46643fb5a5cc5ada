#include "reports/explore/packed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <zlib.h>

namespace asperity::reports {
namespace {

constexpr int no_value = map_steps + 1;

int step_of(double value, double low, double high) {
  if (!std::isfinite(value))
    return no_value;
  if (!(high > low) || value <= low)
    return 0;
  // Halves, because the difference of two doubles may exceed the largest.
  const double share = (value / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0);
  return static_cast<int>(
      std::clamp(std::round(share * map_steps), 1.0, double{map_steps}));
}

} // namespace

std::string base64(std::string_view bytes) {
  static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                              "abcdefghijklmnopqrstuvwxyz"
                                              "0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8U |
              (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k])
                                    : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text +=
          i + k <= bytes.size() ? letters[three >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

std::string packed(std::string_view text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                reinterpret_cast<const Bytef*>(text.data()), text.size(),
                Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib cannot compress the data of a figure");
  return base64(std::string_view(bytes).substr(0, size));
}

PackedMap packed_map(const std::vector<double>& values, std::size_t columns) {
  PackedMap map;
  bool has_value = false;
  for (const double value : values) {
    if (!std::isfinite(value))
      continue;
    map.low = has_value ? std::min(map.low, value) : value;
    map.high = has_value ? std::max(map.high, value) : value;
    has_value = true;
  }
  map.shown_low = map.low;
  map.shown_high = map.high;
  std::vector<int> steps;
  steps.reserve(values.size());
  for (const double value : values)
    steps.push_back(step_of(value, map.low, map.high));
  std::string bytes(2 * values.size(), '\0');
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool has_left = columns > 0 && i % columns != 0;
    const bool has_up = columns > 0 && i >= columns;
    const int difference = steps[i] - (has_left ? steps[i - 1] : 0) -
                           (has_up ? steps[i - columns] : 0) +
                           (has_left && has_up ? steps[i - columns - 1] : 0);
    const int code = difference >= 0 ? 2 * difference : -2 * difference - 1;
    bytes[i] = static_cast<char>(code & 255);
    bytes[values.size() + i] = static_cast<char>(code >> 8);
  }
  map.data = packed(bytes);
  return map;
}

} // namespace asperity::reports
