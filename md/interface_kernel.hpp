#pragma once

// The sum over the pairs of one atom, in vectors of four. Owns the arithmetic,
// in lengths of r_0 and energies of eps.

#include "md/interaction.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace asperity::md {

/// What the kernel needs of the pair law: with y = (r_0/r)^6, D = y_begin -
/// y_end and u = y - y_end kept within 0..D,
///
///     taper    u^2 (taper_square + taper_cube u)
///     energy   u^3 (rise + u (rise_slope + rise_curvature u))
///              + (y_max - y_begin)(y_max + y_begin - 2 attraction)
///
/// y_max = max(y, y_begin): the closed form of pair_term without a branch.
struct ReducedLaw {
  double y_begin = 0.0;
  double y_end = 0.0;
  double attraction = 0.0;
  double taper_square = 0.0;
  double taper_cube = 0.0;
  double rise = 0.0;
  double rise_slope = 0.0;
  double rise_curvature = 0.0;
};

ReducedLaw reduced(const Interaction& interaction);

constexpr int strip_width = 4;

/// Four substrate atoms next to each other in a row, as one atom sees them.
struct Strip {
  double x = 0.0;         ///< from the first of them to the atom [r_0]
  double y = 0.0;         ///< the same across the rows
  std::int64_t first = 0; ///< where its height is
};

struct AtomSum {
  double energy = 0.0; ///< [eps]
  double x = 0.0;      ///< force [12 eps/r_0]
  double y = 0.0;
  double z = 0.0;
};

/// @param heights  of the substrate [r_0]; strips index it
/// @param spacing  of the substrate [r_0]
/// @param z        height of the atom [r_0]
AtomSum sum_strips(const ReducedLaw& law, std::span<const Strip> strips,
                   const double* heights, double spacing, double z);

} // namespace asperity::md
