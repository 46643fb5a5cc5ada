#include "mechanics/material.hpp"

#include "base/require.hpp"

#include <stdexcept>

namespace asperity::mechanics {

double MaterialSpec::block_youngs_modulus() const {
  require_positive("contact_modulus", contact_modulus, "Pa");
  if (!poisson_ratio)
    throw std::domain_error(
        "poisson_ratio is not known, but the block's Young's modulus needs it");
  return contact_modulus * (1.0 - *poisson_ratio * *poisson_ratio);
}

BodyModuli MaterialSpec::first_body() const {
  const double of_pair = block_youngs_modulus();
  const double ratio = *poisson_ratio;
  if (!counter)
    return {of_pair, ratio};
  const double share = (1.0 - counter->poisson_ratio * counter->poisson_ratio) /
                       counter->youngs_modulus;
  return {(1.0 - ratio * ratio) / (1.0 / contact_modulus - share), ratio};
}

} // namespace asperity::mechanics
