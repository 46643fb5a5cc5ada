#pragma once

// The sum over the pairs of one atom, in vectors of four. Owns the arithmetic,
// in lengths of r_0 and energies of eps.

#include "md/interface/interaction.hpp"
#include "md/interface/symmetric_block.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace asperity::md {

/// What the kernel needs of the pair law: with y = (r_0/r)^6, p = y - y_end >=
/// 0, u = min(p, width) and v = p - u,
///
///     G           = u^2 (square + cube u) + v
///     U           = u^3 (2/3 square + 1/2 cube u) + v (v + lever)      [eps]
///     -U'(r)/r    = G y (r_0/r)^2                            [12 eps/r_0^2]
///
/// which is pair_term without a branch.
struct ReducedLaw {
  double y_end = 0.0;
  double width = 0.0; ///< y_begin - y_end
  double square = 0.0;
  double cube = 0.0;
  double lever = 0.0; ///< 2 (y_begin - attraction)
};

ReducedLaw reduced(const Interaction& interaction);

constexpr int strip_width = 4;

/// Four substrate atoms next to each other in a row, from the corner of a cell.
struct Strip {
  double x = 0.0;          ///< of the first of them [r_0]
  double y = 0.0;          ///< [r_0]
  std::int64_t height = 0; ///< index of its height
};

/// What one atom sees.
struct Window {
  double x = 0.0;                  ///< the atom from the corner [r_0]
  double y = 0.0;                  ///< [r_0]
  const double* heights = nullptr; ///< [r_0], the first is that of the corner
  std::span<const Strip> strips;
};

struct AtomSum {
  double energy = 0.0; ///< [eps]
  double x = 0.0;      ///< force [12 eps/r_0]
  double y = 0.0;
  double z = 0.0;
};

/// Four wide where the processor has AVX2, else two wide: the same bits.
/// @param spacing  of the substrate [r_0]
/// @param z        height of the atom [r_0]
AtomSum sum_window(const ReducedLaw& law, const Window& window, double spacing,
                   double z);

/// Second derivatives of that energy with the atom's place [12 eps/r_0^2]. With
/// g = -U'(r)/r of ReducedLaw and G' = dG/dy = u (2 square + 3 cube u), a pair
/// at distance d adds
///
///     -g 1 + 2 y (r_0/r)^4 (3 y G' + 4 G) d d
///
/// Lanes as in sum_window.
SymmetricBlock sum_second_derivatives(const ReducedLaw& law,
                                      const Window& window, double spacing,
                                      double z);

/// What sum_window does on a processor without AVX2.
AtomSum sum_two_wide(const ReducedLaw& law, const Window& window,
                     double spacing, double z);

} // namespace asperity::md
