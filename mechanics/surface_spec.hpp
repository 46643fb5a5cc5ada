#pragma once

// The specification of the rough surface: how its heights are generated, or
// which file they are read from and how that map is prepared.

#include <cstdint>
#include <optional>
#include <string>

namespace asperity::mechanics {

enum class SurfaceKind {
  self_affine,
  spectrum,
  measured,
  sphere,
  wave_1d,
  wave_2d,
  punch,
  cone,
  rounded_punch
};
enum class Amplitudes { spectrum, gaussian };
enum class Levelling { none, plane, bow, sphere, cylinder };
enum class LineAlignment { none, median };
enum class Filling { harmonic, none };
enum class Edges { periodic, window, mirror, free };

/// Part of a measured map [m]: distances of its corner from the first column
/// and row, and its sides.
struct MapWindow {
  double x = 0.0;
  double y = 0.0;
  double length_x = 0.0;
  double length_y = 0.0;
};

/// [surface]. Lengths [m], wavevectors [rad/m]. Members that a kind does not
/// use stay empty: the length and points of a measured map come from its file.
struct SurfaceSpec {
  SurfaceKind kind = SurfaceKind::self_affine;
  std::optional<double> length; ///< side of the periodic square > 0
  std::optional<int> points;    ///< nodes per side, even, >= 4
  std::uint64_t seed = 0;
  int realizations = 1;
  Amplitudes amplitudes = Amplitudes::spectrum;
  bool rescale = false; ///< scale each realisation exactly to the prescribed
                        ///< rms value

  std::optional<double> rms_height; ///< of the complete spectrum
  std::optional<double> rms_slope;
  double hurst = 0.0;               ///< 0..1
  double wavevector_low = 0.0;      ///< q_L
  double wavevector_roll_off = 0.0; ///< q_0, q_L <= q_0 <= q_1
  double wavevector_high = 0.0;     ///< q_1

  std::string file; ///< path of the map or spectrum, made absolute or
                    ///< relative to the working directory by the reader
  std::string format =
      "auto"; ///< of the file (surfaces/formats/map_format.hpp)
  Levelling level = Levelling::plane;
  Edges edges = Edges::periodic; ///< free: half-spaces have free boundaries,
                                 ///< and the surface of all other methods is
                                 ///< continued, a map by its mirror images
  std::optional<double> height_unit; ///< m per unit of the numbers in a plain
                                     ///< file

  std::optional<std::string> channel; ///< title, or path of a dataset
  std::optional<double> length_y;     ///< period in y > 0; empty: square pixels
  std::optional<double> length_unit;  ///< m per unit of x and y of a list
  std::optional<double> missing_value; ///< number in the file at points
                                       ///< without a height
  std::optional<MapWindow> crop;       ///< part of the map that is used
  LineAlignment align_lines = LineAlignment::none;
  std::optional<double> spikes;     ///< threshold in robust standard deviations
  Filling fill = Filling::harmonic; ///< of missing points
  double max_missing = 0.05;        ///< largest fraction that is filled
  std::optional<double> cut_off;    ///< shortest wavelength of a map that is
                                    ///< kept; 0: before the noise floor
  bool has_images = true; ///< a map that is not periodic is continued by its
                          ///< mirror images; false: it is used alone

  /// R of the paraboloid r^2/(2 R) that a rough surface lies on > 0; empty: the
  /// surface is nominally flat.
  std::optional<double> form_radius;

  double radius = 0.0;      ///< sphere; flat end of a punch
  double recess = 0.0;      ///< punch: depth of the surface around its flat end
  double tilt = 0.0;        ///< punch: slope of its flat end along x [1]
  double slope = 0.0;       ///< cone: of its flank [1]
  double edge_radius = 0.0; ///< rounded punch: R beyond its flat end
  double amplitude = 0.0;   ///< waves
  double wavelength = 0.0;  ///< waves; length is an integer multiple of it

  /// Whether the surface is one indenter of an exact shape.
  bool is_indenter() const {
    return kind == SurfaceKind::sphere || kind == SurfaceKind::punch ||
           kind == SurfaceKind::cone || kind == SurfaceKind::rounded_punch;
  }

  /// Whether the surface is a single shape in the middle of the map.
  bool has_middle() const { return is_indenter() || form_radius.has_value(); }
};

} // namespace asperity::mechanics
