#pragma once

// Reduces two elastic rough bodies to an equivalent contact of a rigid rough
// surface and a flat elastic block, see Sec. 2 of Yang and Persson (2008).

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// Elastic constants of one body.
struct ElasticBody {
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1] -1 to 1/2
};

/// E/(1 - nu^2), the contact modulus against a rigid counter-surface [Pa].
/// @throws std::domain_error  a member is outside its range, as for all
///                            functions of this file
double contact_modulus(const ElasticBody& body);

/// E* of two bodies, 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2 [Pa]. This is
/// the relation in the line before Eq. (1) of Yang and Persson (2008), with
/// E/(1 - nu^2) = E*.
double combined_contact_modulus(const ElasticBody& first,
                                const ElasticBody& second);

/// The spectrum of h_1 + h_2 for statistically independent surfaces, C_1 + C_2;
/// Sec. 7 of Yang and Persson (2008) adds those of two patches of one film.
///
/// @param first, second  both given by formulas, or both by shells
/// @throws std::domain_error  one is a formula and the other shells
/// @par Accuracy  roundoff; the quadrature nodes of the sum are computed anew.
///            The result does not apply to two surfaces that are the same patch
///            or that match each other.
HeightSpectrum combined_spectrum(const HeightSpectrum& first,
                                 const HeightSpectrum& second);

} // namespace asperity::theory
