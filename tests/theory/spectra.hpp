#pragma once

// The spectra of the tests of the theory, and the moment of the self-affine one
// in closed form, which verifies the quadrature.

#include "theory/persson/height_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::theory {

/// C = strength from q_L to q_0, strength (q/q_0)^(-2-2H) from there to q_1.
struct SelfAffine {
  double hurst = 0.8;
  double low = 6.04e7;        // q_L [rad/m]
  double roll_off = 1.81e8;   // q_0 [rad/m]
  double high = 4.0 * 1.81e8; // q_1 [rad/m]
  double strength = 1.0;      // [m^4]

  double operator()(double q) const {
    return q < roll_off ? strength
                        : strength * std::pow(q / roll_off, -2.0 - 2.0 * hurst);
  }

  /// int_{q_L}^{q_L + excess} q^n C dq by the antiderivatives of the two
  /// branches, to rounding also for a tiny excess.
  double moment_over(double excess, int n) const {
    const auto growth = [](double power, double ratio) {
      return std::expm1(power * std::log1p(ratio)) / power;
    };
    const double flat = std::min(excess, roll_off - low);
    double sum = std::pow(low, n + 1.0) * growth(n + 1.0, flat / low);
    if (excess > flat)
      sum += std::pow(roll_off, n + 1.0) *
             growth(n - 1.0 - 2.0 * hurst, (excess - flat) / roll_off);
    return strength * sum;
  }

  /// The same up to a wavevector q.
  double moment(double q, int n) const { return moment_over(q - low, n); }

  SelfAffine with_rms_height(double rms_height) const {
    SelfAffine scaled = *this;
    const double mean_square =
        2.0 * std::numbers::pi * moment(high, 1) / strength;
    scaled.strength = rms_height * rms_height / mean_square;
    return scaled;
  }

  HeightSpectrum spectrum() const {
    if (roll_off > low)
      return HeightSpectrum(SpectrumFormula{*this, {low, roll_off, high}});
    return HeightSpectrum(SpectrumFormula{*this, {low, high}});
  }
};

/// The paper's molecular-dynamics surface, h_rms = 1 nm, cut off at zeta = 4.
inline SelfAffine surface_of_the_paper() {
  return SelfAffine{}.with_rms_height(1e-9);
}

/// The contact modulus of its block: E = 77.2 GPa, nu = 0.42 [Pa].
inline constexpr double modulus_of_the_paper = 77.2e9 / (1.0 - 0.42 * 0.42);

} // namespace asperity::theory
