#pragma once

// Builds the heights of a surface from its specification in a case. It selects
// the builder for each kind of surface.

#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/isotropic_spectrum.hpp"
#include "surfaces/measured_map.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// Whether surfaces of this kind are random, so that realisations differ.
bool is_random(mechanics::SurfaceKind kind);

/// The height spectrum of a case of kind self-affine or spectrum, with the
/// prescribed rms height or slope over its whole band; a table keeps its own
/// amplitude if none is prescribed.
/// @throws input::InputError   the table cannot be read, or there is no
///                             amplitude
/// @throws std::domain_error  another kind, or values that no case can have
IsotropicSpectrum formula_spectrum(const mechanics::SurfaceSpec& surface);

/// The heights [m] of one realisation, with mean 0, including the paraboloid of
/// surface.form_radius. With surface.rescale a
/// random surface is scaled to exactly the prescribed rms height or slope (a
/// table without either: to the rms height of the table). Kinds that are not
/// random have only realisation 0 and are rebuilt for any other number; the
/// caller should build them once.
/// @param measured  receives what was found of a measured map, which is without
///                  its heights there
/// @throws input::InputError   a missing key, a file that cannot be read, or
///                             too few points for the shortest wavelength
/// @throws std::domain_error  values that no case can have
HeightMap build_surface(const mechanics::SurfaceSpec& surface, int realization,
                        MeasuredMap* measured = nullptr);

/// The same surface at the nodes of another grid, optionally without its
/// shorter wavelengths.
///
/// A random surface is realised on that grid with the same phases; if the case
/// rescales, its amplitudes have the factor of the whole surface, whatever
/// modes are omitted. A measured map is resampled. The exact shapes are
/// evaluated by their formula; the paraboloid has its apex at node (n/2, n/2)
/// and mean 0 over the nodes of this grid.
/// @param grid                has the lengths of the surface
/// @param highest_wavevector  modes of larger |q| are omitted [rad/m] > 0
/// @throws input::InputError   as build_surface, or the grid is too coarse for
///                             the remaining modes
/// @throws std::domain_error  values that no case can have, another length, or
///                            a highest_wavevector that leaves no mode of a
///                            random surface
HeightMap build_surface_on(const mechanics::SurfaceSpec& surface,
                           int realization, const Grid& grid,
                           std::optional<double> highest_wavevector = {});

/// Checks that the grid of a random surface resolves its spectrum.
/// @throws  as build_surface()
void require_resolved(const mechanics::SurfaceSpec& surface);

/// The grid of the surface, without its heights if possible
/// (measured_grid()).
/// @throws  as build_surface()
Grid surface_grid(const mechanics::SurfaceSpec& surface);

} // namespace asperity::surfaces
