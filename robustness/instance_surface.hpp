#pragma once

// Generates the heights of an instance, for smooth and for irregular shapes. It
// owns the scaling of each shape to the prescribed slope.

#include "robustness/instance.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/isotropic_spectrum.hpp"

namespace asperity::robustness {

/// The heights of an instance and their scale.
struct InstanceSurface {
  surfaces::HeightMap map;
  /// The rms height [m] > 0; for a flat surface, rms_slope * spacing, so that a
  /// tolerance can be relative to it.
  double height_scale = 0.0;
};

/// Scales every shape except the flat one to instance.rms_slope, as determined
/// by surfaces::statistics. This includes the checkerboard, whose waves the
/// statistics count at the Nyquist wavevector.
/// @param grid  with side instance.length; that of the instance unless a layer
/// of
///     atoms requires another
/// @throws std::domain_error  a refusal by surfaces/: a shortest wave of
///     exactly two points
InstanceSurface surface_of(const Instance& instance, const Grid& grid);

/// Returns a grid with instance.points nodes per side on instance.length.
Grid grid_of(const Instance& instance);

/// Returns the spectrum of the rough instance.
/// @throws std::domain_error  see surface_of()
surfaces::IsotropicSpectrum spectrum_of(const Instance& instance);

} // namespace asperity::robustness
