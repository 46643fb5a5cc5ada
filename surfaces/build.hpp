#pragma once

// From what a case says of its surface to the heights. Owns which builder
// stands behind which kind.

#include "cases/types/case.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/isotropic_spectrum.hpp"

#include <optional>

namespace asperity::surfaces {

/// Whether the kind is random, so that realisations differ.
bool is_random(cases::SurfaceKind kind);

/// The spectrum that a case of kind self-affine or spectrum writes down, with
/// the asked rms height or slope over all of its band; a table keeps its own
/// amplitude where none is asked.
/// @throws cases::CaseError   the table cannot be read, or no amplitude
/// @throws std::domain_error  another kind, or values no case can have
IsotropicSpectrum formula_spectrum(const cases::SurfaceSpec& surface);

/// The heights [m] of one realisation, mean 0. With surface.rescale a random
/// surface is scaled to exactly the asked rms height or slope (a table without
/// either: to the table's rms height). Kinds that are not random know one
/// realisation, 0, and build it anew for any: the caller builds it once.
/// @throws cases::CaseError   a missing key, a file that cannot be read, or
///                            points too few for the shortest wave
/// @throws std::domain_error  values no case can have
HeightMap build_surface(const cases::SurfaceSpec& surface, int realization);

/// The same surface at the nodes of another grid, and no finer than asked.
///
/// A random surface is realised there: the same phases, and amplitudes with the
/// factor of the whole surface where the case rescales, whatever is left out. A
/// measured map is resampled. The exact shapes are their formula; the
/// paraboloid has its top at node (n/2, n/2) and mean 0 over the nodes of this
/// grid.
/// @param grid                of the surface's lengths
/// @param highest_wavevector  modes of |q| above are left out [rad/m] > 0
/// @throws cases::CaseError   as build_surface; a grid too coarse for what is
///                            not left out
/// @throws std::domain_error  values no case can have, another length, or a
///                            highest_wavevector that leaves no wave of a
///                            random surface
HeightMap build_surface_on(const cases::SurfaceSpec& surface, int realization,
                           const Grid& grid,
                           std::optional<double> highest_wavevector = {});

} // namespace asperity::surfaces
