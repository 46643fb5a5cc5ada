#pragma once

// The paper's numbers out of one curve: gamma as a slope, gamma as the
// parameter of (10), beta, kappa. Owns the choice of the fit windows.

#include "reports/numbers/estimate.hpp"
#include "results/types/result.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// What a realisation is measured in.
struct SurfaceScales {
  double contact_modulus = 0.0; ///< E* [Pa] > 0
  double rms_height = 0.0;      ///< h_rms [m] > 0
  double rms_slope = 0.0;       ///< h', both directions [1] > 0
};

/// The rows a loading fit may use: converged, loading, p > 0 and both p and u
/// finite, in ascending pressure.
std::vector<results::CurvePoint>
loading_rows(std::span<const results::CurvePoint> points);

/// The stretch of a curve that a fit used.
struct Window {
  double gap_low = not_a_number;           ///< [m]
  double gap_high = not_a_number;          ///< [m]
  double pressure_low = not_a_number;      ///< [Pa]
  double pressure_high = not_a_number;     ///< [Pa]
  double largest_deviation = not_a_number; ///< from the fit, over h_rms [1]
  double tolerance = not_a_number;         ///< largest deviation allowed [1]
  int points = 0;
};

/// gamma as the slope of Sec. 7: p ~ exp(-u / (gamma h_rms)), that is u_0/h_rms
/// of (17), from the line u = u_0 ln(beta E*/p).
struct SlopeFit {
  FittedValue gamma_slope; ///< u_0 / h_rms [1]
  FittedValue beta;        ///< of (17) [1]
  Window window;
  std::string reason; ///< why there is no fit; empty if there is one
};

/// Fits the outermost straight stretch: (17) is the limit of small pressure,
/// and the theory's own curve has a point of inflection further in, where it
/// looks straight with a slope some 15 % above u_0. The window
///  - starts at the largest u <= 2 h_rms: beyond, the finite size of the block
///    ends the exponential;
///  - goes on inwards as far as no row is farther than 0.5 % of h_rms from the
///    least-squares line, which ends it where near contact bends the curve;
///  - has at least 4 rows and a width of 0.5 h_rms at least; where the stretch
///    from the largest u is too short it starts at the next row, and so on,
///    down to u = 1.5 h_rms.
/// If there is none, the 0.5 % is doubled, up to 8 %; `window.tolerance` tells.
/// Only if that fails too may the window start below 1.5 h_rms.
SlopeFit fit_slope(std::span<const results::CurvePoint> points,
                   const SurfaceScales& scales);

/// u(p) of (14) is linear in gamma: u = gamma * at_one + (1 - gamma) * at_zero.
struct GapSplit {
  double at_one = 0.0;  ///< u for gamma = 1 [m]
  double at_zero = 0.0; ///< u for gamma = 0 [m]
};

using GapTheory = std::function<GapSplit(double nominal_pressure)>;

/// gamma as the parameter of (10): closed-form least squares of u(p) over the
/// at least 3 rows with 0 < u <= 2 h_rms. Its error is that of the fit.
struct ParameterFit {
  FittedValue gamma_theory;
  Window window;
  std::string reason;
};

ParameterFit fit_parameter(std::span<const results::CurvePoint> points,
                           const SurfaceScales& scales,
                           const GapTheory& theory);

/// kappa of A/A_0 = kappa p / (E* h') in the limit of no load: the intercept of
/// the line through A E* h' / (A_0 p) against A/A_0 over the rows with
/// 0 < A/A_0 <= light_load_area. At least 3 such rows.
struct AreaFit {
  FittedValue kappa;         ///< of the corrected area
  FittedValue kappa_counted; ///< of the counted area
  Window window;
  std::string reason;
};

/// The light-load rows end here. Persson's own coefficient has fallen by 0.6 %
/// at this area, and by symmetry of erf without a linear term, so the line's
/// intercept misses his sqrt(8/pi) by about 0.1 %.
inline constexpr double light_load_area = 0.15;

AreaFit fit_area(std::span<const results::CurvePoint> points,
                 const SurfaceScales& scales);

} // namespace asperity::reports
