#pragma once

// The response of a material to a strain. This is the only place where the
// constitutive law of the block's interior is written.
// Include this header in .cpp files of fem/ only.

#include "fem/waves/moduli_field.hpp"

#include <deal.II/base/symmetric_tensor.h>

namespace asperity::fem {

/// Stress and its derivative at a quadrature point.
struct PointResponse {
  dealii::SymmetricTensor<2, 3> stress;  ///< sigma [Pa]
  dealii::SymmetricTensor<4, 3> tangent; ///< d sigma / d epsilon [Pa]
};

/// The stress sigma = lambda tr(epsilon) 1 + 2 mu epsilon of a small strain
/// [Pa].
inline dealii::SymmetricTensor<2, 3>
elastic_stress(const dealii::SymmetricTensor<2, 3>& strain,
               const Moduli& moduli) {
  return moduli.lame_modulus * dealii::trace(strain) *
             dealii::unit_symmetric_tensor<3>() +
         2.0 * moduli.shear_modulus * strain;
}

/// The product sigma : C^-1 : tau of two stresses, of which twice the energy
/// per volume is the one with itself [J/m^3].
inline double elastic_product(const dealii::SymmetricTensor<2, 3>& stress,
                              const dealii::SymmetricTensor<2, 3>& other,
                              const Moduli& moduli) {
  const double lateral = moduli.lame_modulus / (3.0 * moduli.lame_modulus +
                                                2.0 * moduli.shear_modulus);
  return (stress * other -
          lateral * dealii::trace(stress) * dealii::trace(other)) /
         (2.0 * moduli.shear_modulus);
}

/// Evaluates sigma = lambda tr(epsilon) 1 + 2 mu epsilon for small strains in
/// an isotropic material. A history-dependent law would take its state in
/// addition to the strain and return the same type.
inline PointResponse
elastic_response(const dealii::SymmetricTensor<2, 3>& strain,
                 const Moduli& moduli) {
  const auto one = dealii::unit_symmetric_tensor<3>();
  PointResponse response;
  response.stress = elastic_stress(strain, moduli);
  response.tangent = moduli.lame_modulus * dealii::outer_product(one, one) +
                     2.0 * moduli.shear_modulus * dealii::identity_tensor<3>();
  return response;
}

} // namespace asperity::fem
