#pragma once

// Determines the quantities of Yang and Persson (2008) from one curve: gamma as
// a slope, gamma as the parameter of Eq. (10), beta and kappa. It owns the
// choice of the fit windows. Equation and section numbers are those of that
// paper.

#include "reports/numbers/estimate.hpp"
#include "results/types/result.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// The scales by which the results of a realisation are normalised.
struct SurfaceScales {
  double contact_modulus = 0.0; ///< E* [Pa] > 0
  double rms_height = 0.0;      ///< h_rms [m] > 0
  double rms_slope = 0.0;       ///< h', both directions [1] > 0
};

/// Returns the rows that a fit to the loading curve may use: converged,
/// loading, p > 0 and both p and u finite, in ascending pressure.
std::vector<results::CurvePoint>
loading_rows(std::span<const results::CurvePoint> points);

/// The section of a curve that a fit used.
struct Window {
  double gap_low = not_a_number;           ///< [m]
  double gap_high = not_a_number;          ///< [m]
  double pressure_low = not_a_number;      ///< [Pa]
  double pressure_high = not_a_number;     ///< [Pa]
  double largest_deviation = not_a_number; ///< from the fit, over h_rms [1]
  double tolerance = not_a_number;         ///< largest deviation allowed [1]
  int points = 0;
};

/// gamma as the slope of Sec. 7: p ~ exp(-u / (gamma h_rms)). It is u_0/h_rms
/// of Eq. (17), from the line u = u_0 ln(beta E*/p).
struct SlopeFit {
  FittedValue gamma_slope; ///< u_0 / h_rms [1]
  FittedValue beta;        ///< beta of Eq. (17) [1]
  Window window;
  std::string reason; ///< why there is no fit; empty if there is one
};

/// Fits the outermost straight section of the curve, because Eq. (17) is the
/// limit of small pressure. The curve of the theory itself has a point of
/// inflection at smaller separations, where it appears straight with a slope
/// some 15 % above u_0. The window
///  - starts at the largest u <= 2 h_rms, because beyond it the finite size of
///    the block ends the exponential;
///  - extends to smaller u as long as no row deviates from the least-squares
///    line by more than 0.5 % of h_rms, so that it ends where near-complete
///    contact bends the curve;
///  - has at least 4 rows and a width of at least 0.5 h_rms. If the section
///    from the largest u is too short, the window starts at the next row, and
///    so on, down to u = 1.5 h_rms.
/// If there is no such window, the 0.5 % is doubled repeatedly, up to 8 %;
/// `window.tolerance` holds the value used. Only if this also fails may the
/// window start below 1.5 h_rms.
SlopeFit fit_slope(std::span<const results::CurvePoint> points,
                   const SurfaceScales& scales);

/// Upper end of the light-load rows. Persson's own coefficient has fallen by
/// 0.6 % at this area and, by the symmetry of erf, has no linear term, so that
/// the intercept of the line deviates from his sqrt(8/pi) by about 0.1 %.
inline constexpr double light_load_area = 0.15;

/// A quantity of the theory that is linear in gamma of Eq. (10), u(p) of Eq.
/// (14) or U_el(p) of Eq. (9): gamma * at_one + (1 - gamma) * at_zero.
struct LossSplit {
  double at_one = 0.0;  ///< for gamma = 1
  double at_zero = 0.0; ///< for gamma = 0
};

using TheoryParts = std::function<LossSplit(double nominal_pressure)>;

/// gamma as the parameter of Eq. (10), from one property of a curve. It has a
/// closed form, because u and U_el are linear in gamma; its error is that of
/// the fit.
struct ParameterFit {
  FittedValue gamma;
  Window window;
  std::string reason; ///< why there is no fit; empty if there is one
};

/// gamma by the whole curve: least squares of u(p) over the rows with
/// 0 < u <= 2 h_rms, of which at least 3 are required.
ParameterFit fit_curve(std::span<const results::CurvePoint> points,
                       const SurfaceScales& scales, const TheoryParts& gap);

/// Window in u/h_rms of fit_matched(): light loads, but not so light that the
/// finite size of the surface ends the exponential.
inline constexpr double matched_from = 1.0;
inline constexpr double matched_to = 2.0;

/// gamma by the slope: that with which the theory has the mean slope of u
/// against ln p of the rows with matched_from <= u/h_rms <= matched_to, of
/// which at least 4 are required, at the same loads. Both slopes are those of
/// least-squares lines,
///
///     gamma = (s - s_0) / (s_1 - s_0),
///
/// s_1 and s_0 those of the theory with gamma = 1 and 0. Unlike gamma_slope, it
/// needs no load at which the curve of the theory is straight.
ParameterFit fit_matched(std::span<const results::CurvePoint> points,
                         const SurfaceScales& scales, const TheoryParts& gap);

/// gamma by the energy: least squares of U_el/p over the rows with
/// 0 < A/A_0 <= light_load_area, of which at least 3 are required. In the limit
/// of small loads U_el/p is u_0 = dU_el/dp of Eq. (18).
ParameterFit fit_energy(std::span<const results::CurvePoint> points,
                        const SurfaceScales& scales, const TheoryParts& energy);

/// kappa of A/A_0 = kappa p / (E* h') in the limit of zero load: the intercept
/// of the line through A E* h' / (A_0 p) against A/A_0 over the rows with
/// 0 < A/A_0 <= light_load_area. At least 3 such rows are required.
struct AreaFit {
  FittedValue kappa;         ///< from the corrected area
  FittedValue kappa_counted; ///< from the counted area
  Window window;
  std::string reason;
};

AreaFit fit_area(std::span<const results::CurvePoint> points,
                 const SurfaceScales& scales);

} // namespace asperity::reports
