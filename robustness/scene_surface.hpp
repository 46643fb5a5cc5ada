#pragma once

// The heights of a scene, smooth and nasty shapes alike. Owns how each is
// scaled to the slope that was asked.

#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/isotropic_spectrum.hpp"

#include "robustness/scene.hpp"

namespace asperity::robustness {

/// The heights of a scene and what they are measured by.
struct SceneSurface {
  surfaces::HeightMap map;
  /// rms height [m] > 0; of a flat surface rms_slope * spacing, so that a
  /// tolerance can be a share of it.
  double height_scale = 0.0;
};

/// Every shape but the flat one is scaled to scene.rms_slope as
/// surfaces::statistics finds it; the checkerboard, whose waves the statistics
/// count at the Nyquist row, like the others.
/// @param grid  of scene.length a side; the scene's own unless a layer of atoms
///              asks for another
/// @throws std::domain_error  what surfaces/ refuses: a shortest wave of
/// exactly
///                            two points
SceneSurface surface_of(const Scene& scene, const Grid& grid);

/// scene.points nodes a side on scene.length.
Grid grid_of(const Scene& scene);

/// The scene's rough spectrum. @throws std::domain_error  see surface_of
surfaces::IsotropicSpectrum spectrum_of(const Scene& scene);

} // namespace asperity::robustness
