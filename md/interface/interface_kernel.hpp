#pragma once

// This file declares the SIMD kernel that sums over the pairs of one atom.
// Lengths are in units of r_0 and energies in units of eps.

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

constexpr int strip_width = 4;

/// Four consecutive substrate atoms of one row, relative to the corner of a
/// cell.
struct Strip {
  double x = 0.0;          ///< of the first atom [r_0]
  double y = 0.0;          ///< [r_0]
  std::int64_t height = 0; ///< index of its height
};

/// The surroundings of one atom.
struct Window {
  double x = 0.0;                  ///< position of the atom relative to the
                                   ///< corner [r_0]
  double y = 0.0;                  ///< [r_0]
  const double* heights = nullptr; ///< [r_0], starting at the corner
  std::span<const Strip> strips;
};

struct AtomSum {
  double energy = 0.0; ///< [eps]
  double x = 0.0;      ///< force [12 eps/r_0]
  double y = 0.0;
  double z = 0.0;
};

/// Sums over the window with the widest vectors of the processor: two, four or
/// eight lanes. All give bitwise identical results.
/// @param spacing  of the substrate [r_0]
/// @param z        height of the atom [r_0]
AtomSum sum_window(const ReducedLaw& law, const Window& window, double spacing,
                   double z);

/// Returns the second derivatives of this energy with respect to the position
/// of the atom [12 eps/r_0^2]. With g = -U'(r)/r as in ReducedLaw and
/// G' = dG/dy = u (2 square + 3 cube u), a pair at distance d contributes
///
///     -g 1 + 2 y (r_0/r)^4 (3 y G' + 4 G) d d
///
/// The number of lanes is that of sum_window().
SymmetricBlock sum_second_derivatives(const ReducedLaw& law,
                                      const Window& window, double spacing,
                                      double z);

/// The sum by each width that this processor has, two lanes first.
std::vector<AtomSum> sums_of_all_widths(const ReducedLaw& law,
                                        const Window& window, double spacing,
                                        double z);

} // namespace asperity::md
