#pragma once

// Two elastic, rough bodies as one: the rigid rough face and the flat elastic
// block of Sec. 2 that make the same contact.

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// One body.
struct ElasticBody {
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1] -1 to 1/2
};

/// E/(1 - nu^2) against a rigid face [Pa].
/// @throws std::domain_error  a member outside its range, here and below
double contact_modulus(const ElasticBody& body);

/// E* of two bodies, 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2 [Pa]. The
/// paper's line before (1) with E/(1 - nu^2) = E*.
double combined_contact_modulus(const ElasticBody& first,
                                const ElasticBody& second);

/// The spectrum of h_1 + h_2 for faces that know nothing of each other, C_1 +
/// C_2: the paper's Sec. 7 adds those of two patches of one film.
///
/// @param first, second  both formulas, or both shells
/// @throws std::domain_error  one is a formula and the other shells
/// @par Accuracy  the sum is prepared anew, to rounding. Of two faces that are
///      the same patch, or fit into each other, it is not the spectrum.
HeightSpectrum combined_spectrum(const HeightSpectrum& first,
                                 const HeightSpectrum& second);

} // namespace asperity::theory
