#pragma once

// The pair potential between an atom of the block and an atom of the substrate,
// with its cutoff and taper.

namespace asperity::md {

/// The pair potential is
///
///     U(r) = eps [(r_0/r)^12 - attraction 2 (r_0/r)^6]
///
/// attraction = 0 is the repulsion of Yang and Persson (2008), Sec. 4;
/// attraction = 1 is the Lennard-Jones potential with its minimum -eps at r_0.
/// With y = (r_0/r)^6 this is eps (y^2 - 2 attraction y). Between taper_begin
/// and the cutoff, its derivative with respect to y, 2 (y - attraction) in
/// units of eps, is replaced by a cubic in y that matches value and slope at
/// taper_begin and has zero value and slope at the cutoff:
///
///     dU/dy = 2 eps t^2 [(3 - 2t)(y_begin - attraction) - (1 - t) D]
///     t = (y - y_end)/D,  D = y_begin - y_end
///
/// The energy is the integral of this derivative from the cutoff inwards, which
/// is a polynomial in y. Hence force = -grad U holds exactly, and the force has
/// a continuous derivative. For r up to taper_begin the force is that of the
/// untruncated potential, and the energy of every pair is shifted by a
/// constant.
struct Interaction {
  double energy = 0.0;      ///< eps [J] > 0
  double distance = 0.0;    ///< r_0 [m] > 0
  double cutoff = 0.0;      ///< [m] > taper_begin
  double taper_begin = 0.0; ///< [m] > 0
  double attraction = 0.0;  ///< [1] 0..1
};

/// Checks that the parameters are valid.
/// @throws std::domain_error  a member is outside its range
void require_interaction(const Interaction& interaction);

/// Energy U and -U'(r)/r of one pair.
struct PairTerm {
  double energy = 0.0;              ///< U [J]
  double force_over_distance = 0.0; ///< -U'(r)/r [N/m]
};

/// Returns the pair term at a distance r > 0 [m]. This is the scalar reference
/// implementation, against which the vectorised kernel is verified. Both values
/// are 0 from the cutoff on.
/// @throws std::domain_error  invalid interaction or distance
PairTerm pair_term(const Interaction& interaction, double distance);

} // namespace asperity::md
