#pragma once

// The inner integral of (14) and its derivative: the two functions of one
// reduced pressure that every separation of Persson's theory is made of.

#include <array>

namespace asperity::theory {

/// A quantity that depends on gamma of (10) as W does: the part that comes of
/// W = P (gamma = 1) and the part that comes of W = P^3 (gamma = 0).
struct GammaParts {
  double linear = 0.0; ///< the quantity at gamma = 1
  double cubic = 0.0;  ///< the quantity at gamma = 0

  double at(double gamma) const {
    return gamma * linear + (1.0 - gamma) * cubic;
  }
};

/// The inner integral of (14), with x = w(q) p/E*:
///
///     J(x) = int_x^inf [gamma + 3 (1 - gamma) erf^2 t] e^{-t^2} dt/t
///          = gamma E_1(x^2)/2 + (1 - gamma) 3 int_x^inf erf^2 t e^{-t^2} dt/t
///
/// For x -> 0 it is gamma ln(eps/x), (15) and (16), plus terms of order x^2.
///
/// @param reduced_pressure  x [1] > 0, not checked: this is the inner loop
/// @return                  both parts [1], underflowing to 0 above x = 27
/// @par Accuracy  relative 1e-14, from x = 1e-150 up
GammaParts gap_kernel(double reduced_pressure);

/// -dJ/dln x = [gamma + 3 (1 - gamma) erf^2 x] e^{-x^2}, both parts [1], for
/// x >= 0, a few ulp.
GammaParts gap_kernel_slope(double reduced_pressure);

/// d/dln x of gap_kernel_slope(), of S = [gamma + 3 (1 - gamma) erf^2 x]
/// e^{-x^2}: -2 x^2 S + (12/sqrt pi) (1 - gamma) x erf(x) e^{-2 x^2} [1].
GammaParts gap_kernel_slope_rate(double reduced_pressure);

/// What J is below `limit`, as power series in y = x^2 (index = power of y):
///
///     J linear = -ln x + sum_n gap_linear[n] y^n
///     J cubic  =         sum_n gap_cubic[n] y^n
///
/// and the same for -dJ/dln x. Given away so that a sum over many x at one
/// pressure can be taken from moments instead of term by term.
struct SmallPressureSeries {
  static constexpr int n_terms = 26; ///< next term at `limit`: below 1e-19
  static constexpr double limit = 0.70710678118654752; ///< x = sqrt(1/2)
  using Coefficients = std::array<double, n_terms>;
  Coefficients gap_linear{};
  Coefficients gap_cubic{};
  Coefficients slope_linear{};
  Coefficients slope_cubic{};
};

/// Computed once, at the first call; safe to call from any thread.
const SmallPressureSeries& small_pressure_series();

/// K = 3 int_0^inf erf^2(x) e^{-x^2} dx/x, the number in
///
///     ln eps = -gamma_Euler/2 + K (1 - gamma)/gamma                   (16)
///
/// evaluated as (12/pi) int_0^{asinh 1} atan(tanh t) dt, to rounding.
double cubic_energy_constant();

} // namespace asperity::theory
