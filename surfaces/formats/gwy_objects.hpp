#pragma once

// Reads the serialised objects of Gwyddion's native format (.gwy) and finds the
// channels and masks among them.

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace asperity::surfaces {

/// A GwyDataField. Its values are not copied.
struct GwyField {
  int points_x = 0;
  int points_y = 0;
  double length_x = 0.0; ///< in unit_xy
  double length_y = 0.0;
  std::string unit_xy;     ///< may be empty
  std::string unit_z;      ///< may be empty
  std::string_view values; ///< points_x * points_y little-endian doubles
};

/// A channel "/n/data" with "/n/data/title" and "/n/mask".
struct GwyChannel {
  std::string title;
  std::optional<GwyField> field;
  std::optional<GwyField> mask;
};

/// Reads a file that begins with GWYP.
/// @param bytes  must outlive the result
/// @return  the channels by their number n
/// @throws input::InputError  with name and byte: malformed objects, fields
///                            whose sizes do not agree with their values
std::map<int, GwyChannel> read_gwy_channels(std::string_view bytes,
                                            const std::string& name);

} // namespace asperity::surfaces
