#pragma once

// What a material answers to a strain: the one place where the law of the
// block's inside is written. Include from .cpp files of fem/ only.

#include "fem/waves/moduli_field.hpp"

#include <deal.II/base/symmetric_tensor.h>

namespace asperity::fem {

/// Stress and its derivative at a quadrature point.
struct PointResponse {
  dealii::SymmetricTensor<2, 3> stress;  ///< sigma [Pa]
  dealii::SymmetricTensor<4, 3> tangent; ///< d sigma / d epsilon [Pa]
};

/// sigma = lambda tr(epsilon) 1 + 2 mu epsilon: small strains, isotropic. A
/// law with a memory takes its state beside the strain and answers the same.
inline PointResponse
elastic_response(const dealii::SymmetricTensor<2, 3>& strain,
                 const Moduli& moduli) {
  const auto one = dealii::unit_symmetric_tensor<3>();
  PointResponse response;
  response.stress = moduli.lame_modulus * dealii::trace(strain) * one +
                    2.0 * moduli.shear_modulus * strain;
  response.tangent = moduli.lame_modulus * dealii::outer_product(one, one) +
                     2.0 * moduli.shear_modulus * dealii::identity_tensor<3>();
  return response;
}

} // namespace asperity::fem
