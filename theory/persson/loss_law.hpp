#pragma once

// Laws of the loss factor other than Eq. (10) of Yang and Persson (2008): they
// reduce not only the elastic energy of a partial contact, but the variance of
// its stress, from which the contact area follows.

#include <memory>

namespace asperity::theory {

/// A law by which the stress variance V of the partial contact follows from
/// V_f, that of full contact, and the area P at the same wavevector:
///
///     P = erf s,  s = p/sqrt(2 V),  x = p/sqrt(2 V_f) = p/(E* sqrt(pi) m)
///     Wang and Mueser:  dV = S dV_f,  S = gamma - 2/9 P^2 + (11/9 - gamma) P^4
///     Xu et al.:        V = S V_f,    S = gamma + (1 - gamma) P
///
/// The energy of a wavevector is reduced like its stress, W = P dV/dV_f, and
/// the energy is the work of the load, so that the inner integral of Eq. (14)
/// becomes
///
///     J(x) = (sqrt(pi)/2) int_x^inf (dW/dt) dt/t.
///
/// Since F = (s/x)^2 is a function of s alone, 1/S (Xu et al.) or
/// s^2 int_s^inf 2 dt/(S t^3) (Wang and Mueser), so are P, W and J, whatever
/// the spectrum. For x -> 0, F = 1/gamma, P = 2 x/sqrt(pi gamma) and
/// J = sqrt(gamma) ln(eps/x).
///
/// @par Accuracy  1e-9 relative; J is 0 above x = 8
/// @see  A. Wang, M. H. Mueser, Tribol. Lett. 65, 103 (2017), for S; Y. Xu,
///       L. Zhu, F. Xiao, Y. Zhou, Tribol. Lett. 72 (2024),
///       10.1007/s11249-024-01838-4, for both laws in this form
class LossLaw {
public:
  /// Below it, S of Wang and Mueser is not positive for every P.
  static constexpr double least_wang_mueser_gamma = 0.011;

  /// @param gamma  least_wang_mueser_gamma < gamma <= 1 [1]; 5/9 in the
  ///               publication
  static LossLaw wang_mueser(double gamma);

  /// @param gamma  0 < gamma <= 1 [1]; 0.42 to 0.45 in the publication
  static LossLaw xu(double gamma);

  /// F = V_f/V [1] >= 1, for x > 0.
  double variance_reduction(double x) const;

  /// W [1], for x > 0.
  double energy(double x) const;

  /// J [1], for x > 0.
  double gap_kernel(double x) const;

  /// -dJ/dln x = (sqrt(pi)/2) dW/dx [1], for x > 0.
  double gap_kernel_slope(double x) const;

  /// sqrt(gamma) [1], the slope of J against -ln x as x -> 0, which Eq. (10)
  /// has as gamma.
  double decay_factor() const;

  /// ln eps [1].
  double log_epsilon() const;

private:
  struct Tables;

  explicit LossLaw(std::shared_ptr<const Tables> tables)
      : tables_(std::move(tables)) {}

  std::shared_ptr<const Tables> tables_;
};

} // namespace asperity::theory
