#pragma once

// The response of a material that flows to a strain: the constitutive law with
// history.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_problem.hpp"
#include "fem/block/elastic_response.hpp"
#include "fem/hexahedra/cell_tangents.hpp"

#include <cmath>

namespace asperity::fem {

/// What a quadrature point has gone through.
struct PointHistory {
  dealii::SymmetricTensor<2, 3> plastic_strain; ///< without a trace [1]
  double equivalent = 0.0; ///< integral of sqrt(2/3) |d plastic_strain| [1]
};

/// The stress of a point that had a history, the history that it then has, and
/// d sigma / d epsilon.
struct FlowResponse {
  PointHistory history;
  PointTangent tangent;
  bool is_flowing = false;
};

/// The stress sigma = C : (epsilon - plastic strain) [Pa].
inline dealii::SymmetricTensor<2, 3>
plastic_stress(const dealii::SymmetricTensor<2, 3>& strain,
               const PointHistory& history, const Moduli& moduli) {
  return elastic_stress(strain - history.plastic_strain, moduli);
}

/// J2 flow from a history to a strain by radial return, which is the implicit
/// Euler method, with its consistent tangent (Simo and Hughes, Computational
/// Inelasticity, 1998, Box 3.2, with isotropic linear hardening).
inline FlowResponse
plastic_response(const dealii::SymmetricTensor<2, 3>& strain,
                 const PointHistory& before, const Moduli& moduli,
                 const Plasticity& law) {
  // A point that flowed to the end of the last step is on the yield surface to
  // roundoff.
  constexpr double rounding = 1e-10;
  const double mu = moduli.shear_modulus;
  FlowResponse response{before, {moduli.lame_modulus, mu, {}}, false};
  const auto trial =
      2.0 * mu * (dealii::deviator(strain) - before.plastic_strain);
  const double radius = std::sqrt(2.0 / 3.0);
  const double magnitude = trial.norm();
  const double excess =
      magnitude - radius * law.yield_stress_after(before.equivalent);
  if (!(excess > rounding * magnitude))
    return response;
  const double flow = excess / (2.0 * mu + 2.0 / 3.0 * law.hardening);
  const auto direction = trial / magnitude;
  response.history.plastic_strain += flow * direction;
  response.history.equivalent += radius * flow;
  response.is_flowing = true;
  const double theta = 1.0 - 2.0 * mu * flow / magnitude;
  const double theta_bar =
      1.0 / (1.0 + law.hardening / (3.0 * mu)) - (1.0 - theta);
  const double softening = std::sqrt(2.0 * mu * theta_bar);
  PointTangent& tangent = response.tangent;
  tangent.shear = mu * theta;
  tangent.lame = moduli.lame_modulus + 2.0 / 3.0 * (mu - tangent.shear);
  tangent.softening = {
      softening * direction[0][0], softening * direction[1][1],
      softening * direction[2][2], softening * direction[1][2],
      softening * direction[2][0], softening * direction[0][1]};
  return response;
}

} // namespace asperity::fem
