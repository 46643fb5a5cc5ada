#include "theory/exact/contact_stiffness.hpp"

#include "base/require.hpp"
#include "theory/exact/hertz.hpp"

#include <numbers>

namespace asperity::theory {
namespace {

double shear_modulus(double contact_modulus, double poisson) {
  return 0.5 * contact_modulus * (1.0 - poisson);
}

} // namespace

StiffnessPair halfspace_stiffness(double radius, double contact_modulus,
                                  double poisson) {
  require_positive("radius", radius, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
  if (!(poisson >= -1.0 && poisson <= 0.5))
    refuse_argument("poisson", poisson, "-1 to 1/2");
  return {2.0 * contact_modulus * radius,
          8.0 * radius * shear_modulus(contact_modulus, poisson) /
              (2.0 - poisson)};
}

StiffnessPair stiffness_alone(const StiffnessPair& in_array,
                              const ContactArray& array) {
  const double nu = array.poisson;
  require_positive("in_array.normal", in_array.normal, "N/m");
  require_positive("in_array.tangential", in_array.tangential, "N/m");
  require_positive("array.side", array.side, "m");
  require_positive("array.depth", array.depth, "m");
  require_positive("array.contact_modulus", array.contact_modulus, "Pa");
  if (!(nu > -1.0 && nu < 0.5))
    refuse_argument("array.poisson", nu, "between -1 and 1/2");
  const double shear = shear_modulus(array.contact_modulus, nu);
  const double strain = array.depth / (shear * array.side * array.side);
  const double others =
      square_array_constant() / (2.0 * std::numbers::pi * shear * array.side);
  return {1.0 / (1.0 / in_array.normal -
                 strain * (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu)) +
                 others * (1.0 - nu)),
          1.0 /
              (1.0 / in_array.tangential - strain + others * (1.0 - 0.5 * nu))};
}

} // namespace asperity::theory
