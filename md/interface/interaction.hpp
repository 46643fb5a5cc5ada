#pragma once

// The law between one atom of the block and one of the substrate. Owns U(r),
// its cut-off and its taper.

namespace asperity::md {

/// U(r) = eps [(r_0/r)^12 - attraction 2 (r_0/r)^6]
///
/// attraction = 0 is the paper's repulsion (Sec. 4); attraction = 1 is
/// Lennard-Jones with its minimum -eps at r_0, scaled in between. With
/// y = (r_0/r)^6 this is eps (y^2 - 2 attraction y), and between taper_begin
/// and the cut-off its slope over y, 2 (y - attraction), is replaced by a cubic
/// in y that joins it there with value and slope and is 0 with slope 0 at the
/// cut-off:
///
///     dU/dy = 2 eps t^2 [(3 - 2t)(y_begin - attraction) - (1 - t) D]
///     t = (y - y_end)/D,  D = y_begin - y_end
///
/// The energy is the integral of that from the cut-off inwards, a polynomial
/// in y, so force = -grad U holds exactly, and the force has a continuous
/// slope. Up to taper_begin the force is the untruncated one, and the energy of
/// every pair is shifted by one constant.
struct Interaction {
  double energy = 0.0;      ///< eps [J] > 0
  double distance = 0.0;    ///< r_0 [m] > 0
  double cutoff = 0.0;      ///< [m] > taper_begin
  double taper_begin = 0.0; ///< [m] > 0
  double attraction = 0.0;  ///< [1] 0..1
};

/// @throws std::domain_error  a member is outside its range
void require_sound(const Interaction& interaction);

/// U and -U'(r)/r.
struct PairTerm {
  double energy = 0.0;              ///< U [J]
  double force_over_distance = 0.0; ///< -U'(r)/r [N/m]
};

/// At one distance r > 0 [m]: the plain version, judge of the vectorised
/// kernel. Both are 0 from the cut-off on.
/// @throws std::domain_error  a bad interaction or distance
PairTerm pair_term(const Interaction& interaction, double distance);

/// Pressure of the untruncated repulsion on a plane of atoms, one an
/// atom_area, at height d over a plane of atoms, one a substrate_area, both
/// smeared out: p = 2 pi eps r_0^12 / (atom_area substrate_area d^11) [Pa].
/// The real sum over a plane without common periods is the same, but for what
/// the cut-off takes: (d/cutoff)^12 of it, and what the taper does.
/// @throws std::domain_error  an argument is not > 0
double wall_pressure(const Interaction& interaction, double atom_area,
                     double substrate_area, double height);

} // namespace asperity::md
