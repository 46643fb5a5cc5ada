#pragma once

// How high a Gaussian surface of a given size reaches: what Sec. 6 of the paper
// says of its system, "no asperity above some 3 h_rms", as a number.

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// The number of peaks, of those so high that each is a patch of its own, that
/// an isotropic Gaussian surface has above z = x h_rms on an area A: the
/// expected Euler characteristic of what lies above,
///
///     n(x) = A m_2/((2 pi)^{3/2} m_0) x e^{-x^2/2}.
///
/// @param moments         m_0 > 0 [m^2], m_2 > 0 [1] of a profile
/// @param area            A [m^2] > 0, of a periodic cell: no rim counts
/// @param reduced_height  x [1]
/// @return                n [1]; a count of patches from some x = 2 on
/// @throws std::domain_error  an argument outside its range or not finite
/// @see  R. J. Adler, The Geometry of Random Fields (1981), Sec. 5.3
double peaks_above(const ProfileMoments& moments, double area,
                   double reduced_height);

/// Mean of the highest point over h_rms, if the high peaks are strewn at
/// random: P(highest > x) = 1 - e^{-n(x)}, from n's largest value on. It grows
/// as sqrt(2 ln n) does.
///
/// @param moments, area  as above, and 4 patches at the least: n(1) >= 4
/// @throws std::domain_error  also for a smaller area
/// @par Accuracy  1e-9. Model: n(x) patches are independent; on 31 m_0/m_2 and
///      more the mean of random fields is met to their own scatter.
double expected_highest(const ProfileMoments& moments, double area);

} // namespace asperity::theory
