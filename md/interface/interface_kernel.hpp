#pragma once

// The SIMD kernels that sum over the pairs of some atoms. Lengths are in units
// of r_0 and energies in units of eps.

#include "md/interface/interaction.hpp"
#include "md/interface/symmetric_block.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::md {

/// Parameters of the pair potential in the form used by the kernel. With
/// y = (r_0/r)^6, p = max(y - y_end, 0), u = min(p, width) and v = p - u,
///
///     G           = u^2 (square + cube u) + v
///     U           = u^3 (2/3 square + 1/2 cube u) + v (v + lever)      [eps]
///     -U'(r)/r    = G y (r_0/r)^2                            [12 eps/r_0^2]
///
/// This equals pair_term() and needs no branches.
struct ReducedLaw {
  double y_end = 0.0;
  double width = 0.0; ///< y_begin - y_end
  double square = 0.0;
  double cube = 0.0;
  double lever = 0.0; ///< 2 (y_begin - attraction)
};

ReducedLaw reduced(const Interaction& interaction);

constexpr int tile_columns = 4;
constexpr int tile_rows = 2;

/// Eight substrate atoms, four columns of two rows, relative to the corner of a
/// cell. They are stored column by column.
struct Tile {
  double x = 0.0;          ///< of the first atom [r_0]
  double y = 0.0;          ///< [r_0]
  std::int64_t height = 0; ///< index of its height; the others follow
};

/// An atom and its surroundings.
struct Window {
  double x = 0.0;                  ///< position of the atom relative to the
                                   ///< corner [r_0]
  double y = 0.0;                  ///< [r_0]
  double z = 0.0;                  ///< height of the atom [r_0]
  const double* heights = nullptr; ///< [r_0], starting at the corner
  std::span<const Tile> tiles;
};

/// Force on an atom [12 eps/r_0].
struct AtomForce {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// Sums over the window of each atom with the widest vectors of the processor:
/// two, four or eight lanes. All give bitwise identical results.
/// @param spacing  of the substrate [r_0]
/// @param forces   one for each window, zero where it has no tiles
/// @return         energy of all pairs [eps]
double sum_windows(const ReducedLaw& law, std::span<const Window> windows,
                   double spacing, std::span<AtomForce> forces);

/// Computes the second derivatives of this energy with respect to the position
/// of each atom [12 eps/r_0^2]. With g = -U'(r)/r as in ReducedLaw and
/// G' = dG/dy = u (2 square + 3 cube u), a pair at distance d contributes
///
///     -g 1 + 2 y (r_0/r)^4 (3 y G' + 4 G) d d
///
/// The number of lanes is that of sum_windows().
/// @param blocks  one for each window, zero where it has no tiles
void sum_second_derivatives(const ReducedLaw& law,
                            std::span<const Window> windows, double spacing,
                            std::span<SymmetricBlock> blocks);

} // namespace asperity::md
