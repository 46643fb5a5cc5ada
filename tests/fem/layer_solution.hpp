#pragma once

// The surface compliance under a normal pressure cos(q x) without shear
// traction: that of a condensed block, and the exact one of a homogeneous
// elastic layer of depth d.

#include "fem/waves/condensed_q1.hpp"
#include "fem/waves/condensed_q2.hpp"
#include "fem/waves/q2_operator.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::fem {

/// C(q) [m/Pa], plane strain, a = q d (e.g. Johnson, Contact Mechanics, 1985,
/// sec. 5.8 for the sliding and clamped far boundaries); all tend to 2/(E* q):
///
///     sliding   2/(E* q) (cosh 2a - 1)/(sinh 2a + 2a)
///     clamped   2/(E* q) (2 k sinh 2a - 4a)/(2 k cosh 2a + 4a^2 + 1 + k^2)
///     pressure  1/(E* q) [(cosh a - 1)/(sinh a + a)
///                         + (cosh a + 1)/(sinh a - a)],      k = 3 - 4 nu
///
/// The last is half the sum of two layers of depth d/2: one whose middle plane
/// slides (equal pressures on both surfaces) and one that bends (opposite
/// pressures).
inline double layer_compliance(double wavevector, double depth,
                               double youngs_modulus, double poisson_ratio,
                               mechanics::FarBoundary far_boundary) {
  const double half_space = 2.0 * (1.0 - poisson_ratio * poisson_ratio) /
                            (youngs_modulus * wavevector);
  const double a = wavevector * depth;
  const double k = 3.0 - 4.0 * poisson_ratio;
  if (far_boundary == mechanics::FarBoundary::sliding)
    return half_space * (std::cosh(2 * a) - 1) / (std::sinh(2 * a) + 2 * a);
  if (far_boundary == mechanics::FarBoundary::clamped)
    return half_space * (2 * k * std::sinh(2 * a) - 4 * a) /
           (2 * k * std::cosh(2 * a) + 4 * a * a + 1 + k * k);
  return 0.5 * half_space *
         ((std::cosh(a) - 1) / (std::sinh(a) + a) +
          (std::cosh(a) + 1) / (std::sinh(a) - a));
}

/// The compliance of `waves` periods along x [m/Pa], of second order by virtual
/// work.
inline double condensed_wave(int degree, const Grid& grid,
                             const LayeredBlock& block, int waves = 1) {
  if (degree == 1)
    return condensed_compliance_q1(grid,
                                   block)[static_cast<std::size_t>(waves)];
  Q2Operator condensed(condensed_compliance_q2(grid, block));
  std::vector<double> wave(grid.size()), displacement(grid.size());
  for (std::size_t i = 0; i < wave.size(); ++i)
    wave[i] = std::cos(2.0 * std::numbers::pi * waves * static_cast<double>(i) /
                       grid.points_x);
  condensed.displacement(wave, displacement);
  double work = 0.0, square = 0.0;
  for (std::size_t i = 0; i < wave.size(); ++i) {
    work += condensed.nodal_weights()[i] * wave[i] * displacement[i];
    square += condensed.nodal_weights()[i] * wave[i] * wave[i];
  }
  return work / square;
}

} // namespace asperity::fem
