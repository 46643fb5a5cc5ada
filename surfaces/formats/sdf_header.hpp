#pragma once

// This internal header of surfaces/formats contains what binary SDF files and
// those as text (ISO 25178-71) have in common.

#include "surfaces/formats/scan.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace asperity::surfaces {

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

/// A file as text.
OpenMap open_sdf_text(std::string_view text, const std::string& name);

} // namespace asperity::surfaces
