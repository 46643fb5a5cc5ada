#pragma once

// The law between one atom of the block and one of the substrate. Owns U(r),
// its cut-off and its taper.

namespace asperity::md {

/// U(r) = eps [(r_0/r)^12 - attraction 2 (r_0/r)^6]
///
/// attraction = 0 is the paper's repulsion (Sec. 4); attraction = 1 is
/// Lennard-Jones with its minimum -eps at r_0, scaled in between. The force is
/// -dU/dr times a taper that falls smoothly from 1 at taper_begin to 0 at the
/// cut-off, and the energy is the integral of that force from the cut-off
/// inwards, so force = -grad U holds exactly.
struct Interaction {
  double energy = 0.0;      ///< eps [J] > 0
  double distance = 0.0;    ///< r_0 [m] > 0
  double cutoff = 0.0;      ///< [m] > taper_begin
  double taper_begin = 0.0; ///< [m] > 0
  double attraction = 0.0;  ///< [1] 0..1
};

/// U and -U'(r)/r at one distance r > 0 [m]: the plain version, judge of the
/// vectorised kernel.
struct PairTerm {
  double energy = 0.0;              ///< U [J]
  double force_over_distance = 0.0; ///< -U'(r)/r [N/m]
};

PairTerm pair_term(const Interaction& interaction, double distance);

/// Pressure of the untruncated repulsion on a plane of atoms, one an
/// atom_area, at height d over a plane of atoms, one a substrate_area, both
/// smeared out: p = 2 pi eps r_0^12 / (atom_area substrate_area d^11) [Pa].
double wall_pressure(const Interaction& interaction, double atom_area,
                     double substrate_area, double height);

} // namespace asperity::md
