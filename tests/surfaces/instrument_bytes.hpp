#pragma once

// Bytes of files in the formats of instruments.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace asperity::surfaces::tests_of_formats {

template <class Number>
std::string little_endian(Number number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

/// A binary SDF file, spacings 1 and 2 um.
template <class Number>
std::string binary_sdf(char type, const std::vector<Number>& numbers,
                       double scale_z, std::uint16_t columns = 3) {
  std::string bytes =
      "bISO-1.0" + std::string("maker     ") + "010120200000" + "010120200000" +
      little_endian(columns) +
      little_endian(static_cast<std::uint16_t>(numbers.size() / columns)) +
      little_endian(1e-6) + little_endian(2e-6) + little_endian(scale_z) +
      little_endian(-1.0) + std::string(1, '\0') + std::string(1, type) +
      std::string(1, '\0');
  for (const Number number : numbers)
    bytes += little_endian(number);
  return bytes;
}

inline std::string gwy_object(const std::string& type,
                              const std::string& content) {
  return type + '\0' +
         little_endian(static_cast<std::uint32_t>(content.size())) + content;
}

inline std::string gwy_part(const std::string& name, char type,
                            const std::string& value) {
  return name + '\0' + type + value;
}

inline std::string gwy_unit(const std::string& name, const std::string& unit) {
  return gwy_part(
      name, 'o',
      gwy_object("GwySIUnit", gwy_part("unitstr", 's', unit + '\0')));
}

/// A field of 3 um by 1 um.
inline std::string gwy_field(const std::string& unit,
                             const std::vector<double>& numbers,
                             std::int32_t columns = 3, std::int32_t rows = 2) {
  std::string data = little_endian(static_cast<std::uint32_t>(numbers.size()));
  for (const double number : numbers)
    data += little_endian(number);
  return gwy_object("GwyDataField",
                    gwy_part("xres", 'i', little_endian(columns)) +
                        gwy_part("yres", 'i', little_endian(rows)) +
                        gwy_part("xreal", 'd', little_endian(3e-6)) +
                        gwy_part("yreal", 'd', little_endian(1e-6)) +
                        gwy_unit("si_unit_xy", "m") +
                        gwy_unit("si_unit_z", unit) +
                        gwy_part("data", 'D', data));
}

inline std::string gwy_channel(const std::string& number,
                               const std::string& title,
                               const std::string& unit, double first) {
  return gwy_part("/" + number + "/data", 'o',
                  gwy_field(unit, {first, 2, 3, 4, 5, 6})) +
         gwy_part("/" + number + "/data/title", 's', title + '\0');
}

inline std::string gwy_file(const std::string& content) {
  return "GWYP" + gwy_object("GwyContainer", content);
}

} // namespace asperity::surfaces::tests_of_formats
