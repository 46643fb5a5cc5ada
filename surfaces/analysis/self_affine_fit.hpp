#pragma once

// Fits the self-affine model to a measured spectrum by maximum likelihood, with
// confidence intervals of its parameters.

#include "surfaces/analysis/spectrum_estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// A fitted number with its 95 % confidence interval. Where the measurement
/// does not determine it, value, low or high are NaN and the reason is stated.
struct FittedParameter {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::string reason; ///< empty if the value and both limits are determined
};

/// The model
///
///     C(q) = S(q) T(q)^2 + N               q <= q_1
///     S(q) = C_0                           q <= q_0
///     S(q) = C_0 (q/q_0)^(-2 - 2 H)        q >  q_0
///     T(q) = exp(-s^2 q^2/2)
///
/// with the noise N >= 0 and the blur s >= 0: an instrument that averages over
/// a Gaussian of this standard deviation has the transfer function T, and other
/// smooth ones begin like it. The cut-off q_1 is the ring beyond which the
/// rings depart from C by more than a factor of 1.5 or 3.2 standard deviations,
/// whichever is larger: the end of a band-limited spectrum or another filter.
///
/// No interval is determined of rings that scatter about C more than those of
/// 999 of 1000 surfaces of the model: the spectrum is another one.
struct SelfAffineFit {
  FittedParameter hurst;    ///< H [1]; not determined if its interval is wider
                            ///< than 1, or H outside -0.5..1.5; above 1, where
                            ///< no surface is self-affine, it has a reason
  FittedParameter roll_off; ///< q_0 [rad/m]
  FittedParameter cutoff;   ///< q_1 [rad/m]
  FittedParameter blur;     ///< s [m]
  FittedParameter rms_height; ///< [m]: root of 2 pi int q S T^2 dq over the
                              ///< rings up to q_1
  double exponent = 0.0; ///< -2 - 2 H of the fit, also where H is not stated
  double plateau = 0.0;  ///< S at the lowest ring [m^4]
  double noise = 0.0;    ///< N [m^4]
  double wavevector_low = 0.0;  ///< lowest ring [rad/m]
  double wavevector_high = 0.0; ///< q_1, or the highest ring [rad/m]
  double blur_square = 0.0;     ///< s^2 of the fit [m^2], also where s is not
                                ///< stated
  double dispersion = 1.0; ///< deviance over its expected value [1]; above 1
                           ///< the model or the independence of the modes
                           ///< fails, and the intervals are widened by its root
  bool is_model = true; ///< whether the dispersion is one that the model allows

  /// S(q) T(q)^2 + N [m^4] between wavevector_low and wavevector_high.
  double density(double wavevector) const;
};

/// Maximises the likelihood of the rings, nu C_ring/C(q) being chi-squared
/// distributed (Whittle's likelihood for a Gaussian surface). Intervals of H,
/// s^2, q_0 and h_rms follow from the Fisher information, those of q_0 and
/// h_rms in logarithms; they allow for a blur and a noise that the rings do not
/// exclude. That of q_1 are the rings whose log-likelihood is within 1.92 of
/// the maximum, and one more on either side. The last ring before q_1, which
/// the cut-off may deplete, is left out.
/// @param rings  complete rings in the reliable range, ascending
/// @param wavevector_end  end of that range [rad/m]; if the rings end below it,
///               there is no power above and the last ring is the cut-off
/// @return  empty if there are fewer than 10 rings or less than a factor of 3
///          between the wavevectors of the first and the last
/// @see  P. Whittle, Biometrika 41, 434 (1954)
std::optional<SelfAffineFit>
fit_self_affine(const std::vector<SpectrumRing>& rings, double wavevector_end);

} // namespace asperity::surfaces
