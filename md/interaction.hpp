#pragma once

// The law between one atom of the block and one of the substrate. Owns U(r),
// its cut-off and its taper.

namespace asperity::md {

/// U(r) = eps [(r_0/r)^12 - attraction 2 (r_0/r)^6]
///
/// attraction = 0 is the paper's repulsion (Sec. 4); attraction = 1 is
/// Lennard-Jones with its minimum -eps at r_0, scaled in between. The force is
/// -dU/dr times the taper
///
///     T = 3 t^2 - 2 t^3,  t = (y - y_end)/(y_begin - y_end) kept within 0..1,
///     y = (r_0/r)^6, y_end at the cut-off, y_begin at taper_begin
///
/// and the energy is the integral of that force from the cut-off inwards,
/// int 2 (y - attraction) T dy in units of eps: a polynomial in y, and force =
/// -grad U holds exactly. The force has a continuous slope. What it costs:
/// inside taper_begin the energy of every pair is shifted by a constant.
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
