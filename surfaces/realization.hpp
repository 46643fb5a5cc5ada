#pragma once

// Realises a random surface with a given spectrum. The map from (spectrum, key)
// to heights does not depend on the grid spacing.

#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/isotropic_spectrum.hpp"
#include "surfaces/maps/random_modes.hpp"

namespace asperity::surfaces {

/// The periodic surface
///
///     h(x) = sum_q a_q exp(i q.x),  q = 2 pi (i/L_x, j/L_y),  a_{-q} = a_q^*
///     a_q  = s_q exp(2 pi i v)                    Amplitudes::spectrum
///     a_q  = s_q sqrt(-ln u) exp(2 pi i v)        Amplitudes::gaussian
///     s_q  = sqrt(C(q) (2 pi)^2 / (L_x L_y)),  a_0 = 0
///
/// with (u, v) = draw_mode(key, i, j) of the mode of the pair q, -q that has
/// i > 0, or i = 0 and j > 0. Hence <|a_q|^2> = s_q^2 (the complex Gaussian) or
/// |a_q| = s_q (the exact spectrum). A mode depends only on the key, the
/// lengths and (i, j): a finer grid of the same lengths samples the same
/// surface at more points, to roundoff. No mode reaches the Nyquist row of the
/// grid.
///
/// The sum over modes approaches the integral of C only if the band contains
/// many of them: <h^2> of the realisation is sum_q |a_q|^2, which is not
/// exactly spectrum.mean_square_height.
///
/// @param grid  at least points_needed in each direction
/// @throws std::domain_error  the grid has too few points for the band, the
///                            realization is negative, or the band contains no
///                            mode
/// @par Accuracy  the heights at common points of two grids agree to about
///                1e-15 h_rms (two transforms of different size)
HeightMap
realize(const IsotropicSpectrum& spectrum, const Grid& grid,
        const RandomKey& key,
        mechanics::Amplitudes amplitudes = mechanics::Amplitudes::spectrum);

/// The smallest even number of points along a side of this length for which
/// every mode up to wavevector_high lies strictly below the Nyquist row.
int points_needed(double wavevector_high, double length);

} // namespace asperity::surfaces
