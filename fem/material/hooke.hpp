#pragma once

// Hooke's law of an isotropic material: the linear part of every material law
// of the block. The matrix-free products (multigrid/, refined/, hexahedra/)
// apply its stiffness, which the block assembles from elastic_tangent().
// Include this header in .cpp files of fem/ only.

#include "fem/waves/moduli_field.hpp"

#include <deal.II/base/symmetric_tensor.h>

namespace asperity::fem {

/// The stress sigma = C : epsilon = lambda tr(epsilon) 1 + 2 mu epsilon of a
/// small strain [Pa].
inline dealii::SymmetricTensor<2, 3>
elastic_stress(const dealii::SymmetricTensor<2, 3>& strain,
               const Moduli& moduli) {
  return moduli.lame_modulus * dealii::trace(strain) *
             dealii::unit_symmetric_tensor<3>() +
         2.0 * moduli.shear_modulus * strain;
}

/// C = d sigma / d epsilon [Pa].
inline dealii::SymmetricTensor<4, 3> elastic_tangent(const Moduli& moduli) {
  const auto one = dealii::unit_symmetric_tensor<3>();
  return moduli.lame_modulus * dealii::outer_product(one, one) +
         2.0 * moduli.shear_modulus * dealii::identity_tensor<3>();
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

} // namespace asperity::fem
