#pragma once

// The inner integral of Eq. (14) of Yang and Persson (2008) and its
// derivatives: functions of one reduced pressure from which every separation of
// Persson's theory is computed. Equation numbers in this file are those of that
// paper.

#include <array>

namespace asperity::theory {

/// A quantity that is linear in gamma of Eq. (10), as W is: the part for W = P
/// (gamma = 1) and the part for W = P^3 (gamma = 0).
struct GammaParts {
  double linear = 0.0; ///< the quantity at gamma = 1
  double cubic = 0.0;  ///< the quantity at gamma = 0

  double at(double gamma) const {
    return gamma * linear + (1.0 - gamma) * cubic;
  }
};

/// The inner integral of Eq. (14), with x = w(q) p/E*:
///
///     J(x) = int_x^inf [gamma + 3 (1 - gamma) erf^2 t] e^{-t^2} dt/t
///          = gamma E_1(x^2)/2 + (1 - gamma) 3 int_x^inf erf^2 t e^{-t^2} dt/t
///
/// For x -> 0 it is gamma ln(eps/x), Eqs. (15) and (16), plus terms of order
/// x^2.
///
/// @param reduced_pressure  x [1] > 0, not checked because this is the inner
///                          loop
/// @return                  both parts [1], underflowing to 0 above x = 27
/// @par Accuracy  relative error 1e-14, for x >= 1e-150
GammaParts gap_kernel(double reduced_pressure);

/// -dJ/dln x = [gamma + 3 (1 - gamma) erf^2 x] e^{-x^2}, both parts [1], for
/// x >= 0, to a few ulp.
GammaParts gap_kernel_slope(double reduced_pressure);

/// Derivative d/dln x of gap_kernel_slope(), with
/// S = [gamma + 3 (1 - gamma) erf^2 x] e^{-x^2}:
/// -2 x^2 S + (12/sqrt pi) (1 - gamma) x erf(x) e^{-2 x^2} [1].
GammaParts gap_kernel_slope_rate(double reduced_pressure);

/// Power series of J below `limit` in y = x^2 (index = power of y):
///
///     J linear = -ln x + sum_n gap_linear[n] y^n
///     J cubic  =         sum_n gap_cubic[n] y^n
///
/// and the same for -dJ/dln x. With them a sum over many x at one pressure can
/// be computed from moments instead of term by term.
struct SmallPressureSeries {
  static constexpr int n_terms = 26; ///< next term at `limit` is below 1e-19
  static constexpr double limit = 0.70710678118654752; ///< x = sqrt(1/2)
  using Coefficients = std::array<double, n_terms>;
  Coefficients gap_linear{};
  Coefficients gap_cubic{};
  Coefficients slope_linear{};
  Coefficients slope_cubic{};
};

/// The series, computed at the first call; safe to call from any thread.
const SmallPressureSeries& small_pressure_series();

/// K = 3 int_0^inf erf^2(x) e^{-x^2} dx/x, the constant in
///
///     ln eps = -gamma_Euler/2 + K (1 - gamma)/gamma                   (16)
///
/// evaluated as (12/pi) int_0^{asinh 1} atan(tanh t) dt, to roundoff.
double cubic_energy_constant();

} // namespace asperity::theory
