#pragma once

// The exact surface compliance of a homogeneous elastic layer of depth d under
// a normal pressure cos(q x) without shear traction: the reference solution for
// long waves.

#include "mechanics/far_boundary.hpp"

#include <cmath>

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

} // namespace asperity::fem
