#pragma once

// The height spectrum C(q), its normalisation, its band and its moments.

#include <functional>
#include <vector>

namespace asperity::surfaces {

/// An isotropic height spectrum C(q) [m^4] of the infinite surface,
///
///     C(q)       = (2 pi)^-2 int <h(x) h(0)> exp(-i q.x) d^2x
///     <h^2>      = int C d^2q       = 2 pi int q   C(q) dq
///     |grad h|^2 = int q^2 C d^2q   = 2 pi int q^3 C(q) dq
///
/// On a periodic rectangle L_x L_y it gives the mean square of the Fourier
/// coefficient of each mode, <|a_q|^2> = C(q) (2 pi)^2 / (L_x L_y).
struct IsotropicSpectrum {
  std::function<double(double)> density; ///< C(q) [m^4], 0 outside the band
  std::vector<double> kinks;       ///< [rad/m] ascending, at least two; the
                                   ///< first and the last are the band limits
  double mean_square_height = 0.0; ///< <h^2> [m^2]
  double mean_square_slope = 0.0;  ///< <|grad h|^2> [1]

  double wavevector_low() const { return kinks.front(); }

  double wavevector_high() const { return kinks.back(); }
};

/// Two wavevectors that a case gives with five digits are equal within this
/// relative difference.
constexpr double printed_rounding = 1e-4;

/// Whether q lies in [low, high], both ends included. Roundoff must not exclude
/// a mode at an end of the band: the tolerance is 1e-9 at the upper end and
/// printed_rounding at the lower end, because the few longest wavelengths of a
/// cell carry a large part of the height variance and "6.2832e5 1/m" is meant
/// to include 2 pi/(10 um).
inline bool is_in_band(double wavevector, double low, double high) {
  return wavevector >= low * (1.0 - printed_rounding) &&
         wavevector <= high * (1.0 + 1e-9);
}

/// int_{start}^{end} q^(order + 1) (q/start)^exponent dq, the integral of which
/// the moments of flat, self-affine and tabulated pieces are composed. It is
/// smooth through its logarithmic case order + 2 + exponent = 0.
/// @param start, end  0 < start <= end [rad/m]
double power_law_integral(int order, double exponent, double start, double end);

} // namespace asperity::surfaces
