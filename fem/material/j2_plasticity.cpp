#include "fem/material/j2_plasticity.hpp"

#include "fem/material/material_law.hpp"

#include <cmath>

namespace asperity::fem {
namespace {

/// The inelastic strain is the plastic strain, which has no trace; the history
/// is the equivalent plastic strain.
class J2Plasticity final : public MaterialLaw {
public:
  J2Plasticity(double yield_stress, double hardening)
      : yield_stress_(yield_stress), hardening_(hardening) {}

  std::size_t n_history() const override { return 1; }

  /// Flow by radial return, which is the implicit Euler method, with its
  /// consistent tangent (Simo and Hughes, Computational Inelasticity, 1998, Box
  /// 3.2, with isotropic linear hardening).
  PointResponse respond(const dealii::SymmetricTensor<2, 3>& strain,
                        const dealii::SymmetricTensor<2, 3>& before,
                        const Moduli& moduli,
                        std::span<double> history) const override {
    // A point that flowed to the end of the last step is on the yield surface
    // to roundoff.
    constexpr double rounding = 1e-10;
    const double mu = moduli.shear_modulus;
    PointResponse response{before, {moduli.lame_modulus, mu, {}}, true};
    const auto trial = 2.0 * mu * (dealii::deviator(strain) - before);
    const double radius = std::sqrt(2.0 / 3.0);
    const double magnitude = trial.norm();
    const double excess = magnitude - radius * yield_stress_after(history[0]);
    if (!(excess > rounding * magnitude))
      return response;
    const double flow = excess / (2.0 * mu + 2.0 / 3.0 * hardening_);
    const auto direction = trial / magnitude;
    response.inelastic_strain += flow * direction;
    history[0] += radius * flow;
    response.is_elastic = false;
    const double theta = 1.0 - 2.0 * mu * flow / magnitude;
    const double theta_bar =
        1.0 / (1.0 + hardening_ / (3.0 * mu)) - (1.0 - theta);
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

  /// The work is the integral of the yield stress over the equivalent plastic
  /// strain.
  std::vector<MaterialQuantity> quantities() const override {
    return {{"plastic_work", true,
             [this](std::span<const double> history) {
               return history[0] * yield_stress_after(0.5 * history[0]);
             }},
            {"plastic_strain", false,
             [](std::span<const double> history) { return history[0]; }}};
  }

private:
  double yield_stress_after(double equivalent_strain) const {
    return yield_stress_ + hardening_ * equivalent_strain;
  }

  double yield_stress_, hardening_; ///< [Pa]
};

} // namespace

std::shared_ptr<const MaterialLaw> j2_plasticity(double yield_stress,
                                                 double hardening) {
  return std::make_shared<J2Plasticity>(yield_stress, hardening);
}

} // namespace asperity::fem
