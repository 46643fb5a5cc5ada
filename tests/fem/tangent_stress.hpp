#pragma once

// The stress change of a tangent, written out as tensors.

#include "fem/hexahedra/cell_tangents.hpp"

#include <deal.II/base/symmetric_tensor.h>

namespace asperity::fem {

/// lambda tr(e) 1 + 2 mu e - (s : e) s [Pa], s the softening of the tangent.
/// @param strain  e [1]
inline dealii::SymmetricTensor<2, 3>
stress_of(const PointTangent& tangent,
          const dealii::SymmetricTensor<2, 3>& strain) {
  dealii::SymmetricTensor<2, 3> s;
  const auto& own = tangent.softening;
  s[0][0] = own[0];
  s[1][1] = own[1];
  s[2][2] = own[2];
  s[1][2] = own[3];
  s[2][0] = own[4];
  s[0][1] = own[5];
  return tangent.lame * trace(strain) * dealii::unit_symmetric_tensor<3>() +
         2.0 * tangent.shear * strain - (s * strain) * s;
}

} // namespace asperity::fem
