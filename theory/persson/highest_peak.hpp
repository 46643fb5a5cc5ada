#pragma once

// Computes the expected maximum height of a Gaussian surface of given size,
// which quantifies the statement in Sec. 6 of Yang and Persson (2008) that no
// asperity of their system is higher than about 3 h_rms.

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// Expected number of peaks above z = x h_rms of an isotropic Gaussian surface
/// on an area A, if z is so high that each peak is a separate patch: the
/// expected Euler characteristic of the set above z,
///
///     n(x) = A m_2/((2 pi)^{3/2} m_0) x e^{-x^2/2}.
///
/// @param moments         m_0 > 0 [m^2], m_2 > 0 [1] of a profile
/// @param area            A [m^2] > 0 of a periodic cell, without boundary
///                        terms
/// @param reduced_height  x [1]
/// @return                n [1]; a number of patches for x above about 2
/// @throws std::domain_error  an argument outside its range or not finite
/// @see  R. J. Adler, The Geometry of Random Fields (1981), Sec. 5.3
double peaks_above(const ProfileMoments& moments, double area,
                   double reduced_height);

/// Mean of the highest point divided by h_rms, if the high peaks are randomly
/// distributed: P(highest > x) = 1 - e^{-n(x)}, for x beyond the maximum of n.
/// It grows like sqrt(2 ln n).
///
/// @param moments, area  as above, with at least 4 patches: n(1) >= 4
/// @throws std::domain_error  also for a smaller area
/// @par Accuracy  1e-9. Model: the n(x) patches are independent; for areas of
///            at least 31 m_0/m_2 the mean over random fields agrees within its
///            statistical scatter.
double expected_highest(const ProfileMoments& moments, double area);

} // namespace asperity::theory
