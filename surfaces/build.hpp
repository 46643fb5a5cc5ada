#pragma once

// From what a case says of its surface to the heights. Owns which builder
// stands behind which kind.

#include "cases/case.hpp"
#include "surfaces/height_map.hpp"
#include "surfaces/isotropic_spectrum.hpp"

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

} // namespace asperity::surfaces
