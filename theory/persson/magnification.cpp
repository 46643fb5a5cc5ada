#include "theory/persson/magnification.hpp"

#include "base/require.hpp"
#include "theory/persson/gap_kernel.hpp"

#include <boost/math/special_functions/erf.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace asperity::theory {

using std::numbers::pi;

namespace {

// A as a function of M_z, and its derivative.
struct VisibleArea {
  double moment = 0.0;        // M_z
  double exponent = 0.0;      // x_0^2
  double area_fraction = 1.0; // A/A_0
  double fall = 0.0;          // -dA/dM_z = P e^{-x_0^2}/(pi M_z^{3/2})
};

VisibleArea visible_area(double moment, double pressure_ratio) {
  if (moment == 0.0)
    return {};
  const double x = pressure_ratio / std::sqrt(pi * moment);
  return {moment, x * x, std::erf(x),
          pressure_ratio * std::exp(-x * x) /
              (pi * moment * std::sqrt(moment))};
}

/// u(M_z, p) is Eq. (14) for the unresolved roughness, with wavevectors above
/// q, where q is a function of M_z + m^2 and M_z is the moment M of the
/// resolved roughness:
///
///     u = 2 int_0^{m_1} J(x) dm/q(M_z + m^2),   x = p/(E* sqrt(pi) m).
///
/// Its derivatives do not contain C(q), not even as a divisor, because
/// dq/dM = 1/(q^3 C):
///
///     -du/dM_z = J(x_1)/(q_1 m_1) + int J(x) dq/(q^2 m)
///
/// with every term positive; the integral extends over the unresolved
/// roughness.
struct OpeningSums {
  double mean_gap = 0.0;      ///< u [m]
  double slope = 0.0;         ///< D = -du/dln p [m]
  double slope_rate = 0.0;    ///< dD/dln p [m]
  double closing = 0.0;       ///< beta = -du/dM_z at fixed p [m] >= 0
  double closing_rate = 0.0;  ///< dbeta/dln p [m]
  double closing_shift = 0.0; ///< dbeta/dM_z [m]
};

// J and S = -dJ/dln x at one m.
struct Kernels {
  double gap = 0.0;
  double slope = 0.0;
};

// Adds `step` times the integrand of beta and its derivatives: with x ~ 1/m,
// d(J/m)/dln p = -S/m, and m^2 = M - M_z gives d(J/m)/dM_z = (J - S)/(2 m^3).
void add_closing(OpeningSums& sums, const Kernels& kernels, double root_moment,
                 double step) {
  const double m = root_moment;
  sums.closing += step * kernels.gap / m;
  sums.closing_rate -= step * kernels.slope / m;
  sums.closing_shift +=
      step * (kernels.gap - kernels.slope) / (2.0 * m * m * m);
}

/// Computes u and its derivatives.
/// @param hidden          the spectrum above q, given by a formula
/// @param pressure_ratio  p/E* [1] > 0, not checked
/// @param gamma           gamma of Eq. (10) [1]
/// @par Accuracy  about 1e-13 relative, as for the nodes
OpeningSums opening_sums(const HeightSpectrum& hidden, double pressure_ratio,
                         double gamma) {
  const double root_pi = std::sqrt(std::numbers::pi);
  const auto reduced = [&](double m) { return pressure_ratio / (root_pi * m); };
  const auto kernels_at = [&](double x) {
    return Kernels{gap_kernel(x).at(gamma), gap_kernel_slope(x).at(gamma)};
  };
  OpeningSums sums;
  for (const RoughnessNode& node : hidden.nodes()) {
    const double x = reduced(node.root_moment);
    const double underflows = 27.5;
    if (x > underflows)
      break;
    const Kernels kernels = kernels_at(x);
    sums.mean_gap += node.weight * kernels.gap;
    sums.slope += node.weight * kernels.slope;
    sums.slope_rate += node.weight * gap_kernel_slope_rate(x).at(gamma);
    add_closing(sums, kernels, node.root_moment, node.inverse_step);
  }
  const double largest =
      hidden.rms_slope() / std::sqrt(2.0 * std::numbers::pi); // m_1
  add_closing(sums, kernels_at(reduced(largest)), largest,
              1.0 / hidden.wavevector_high());
  return sums;
}

} // namespace

/// All quantities that Eqs. (25) and (27) need at one magnification.
struct MagnifiedContact::View {
  VisibleArea visible;
  OpeningSums hidden; // for u at the pressure p/A

  // -d(A u)/dM_z
  double volume_fall() const {
    return (hidden.mean_gap + hidden.slope) * visible.fall +
           visible.area_fraction * hidden.closing;
  }
};

MagnifiedContact::MagnifiedContact(PerssonContact contact,
                                   double nominal_pressure,
                                   double reference_wavevector)
    : contact_(std::move(contact)),
      nominal_pressure_(nominal_pressure),
      reference_wavevector_(reference_wavevector) {
  require_positive("nominal_pressure", nominal_pressure, "Pa");
  require_positive("reference_wavevector", reference_wavevector, "rad/m");
}

double MagnifiedContact::wavevector(double magnification) const {
  require_positive("magnification", magnification, "1");
  return magnification * reference_wavevector_;
}

double MagnifiedContact::pressure_ratio() const {
  return nominal_pressure_ / contact_.contact_modulus();
}

double MagnifiedContact::lowest_magnification() const {
  return contact_.spectrum().wavevector_low() / reference_wavevector_;
}

double MagnifiedContact::highest_magnification() const {
  return contact_.spectrum().wavevector_high() / reference_wavevector_;
}

// At the magnification of a shell, the shell itself is resolved; for a formula
// a single q has no weight.
std::optional<HeightSpectrum>
MagnifiedContact::hidden(double magnification) const {
  const HeightSpectrum& whole = contact_.spectrum();
  const double q = wavevector(magnification);
  if (q >= whole.wavevector_high())
    return std::nullopt;
  if (q < whole.wavevector_low())
    return whole;
  return whole.between(q, std::numeric_limits<double>::infinity());
}

double MagnifiedContact::visible_moment(double magnification) const {
  const HeightSpectrum& whole = contact_.spectrum();
  const double q = wavevector(magnification);
  if (q < whole.wavevector_low() ||
      (whole.has_density() && q == whole.wavevector_low()))
    return 0.0;
  const double slope = q >= whole.wavevector_high()
                           ? whole.rms_slope()
                           : whole.between(0.0, q).rms_slope();
  return slope * slope / (2.0 * pi);
}

double MagnifiedContact::rms_height(double magnification) const {
  const std::optional<HeightSpectrum> below = hidden(magnification);
  return below ? below->rms_height() : 0.0;
}

double MagnifiedContact::area_fraction(double magnification) const {
  return visible_area(visible_moment(magnification), pressure_ratio())
      .area_fraction;
}

double MagnifiedContact::apparent_pressure(double magnification) const {
  return nominal_pressure_ / area_fraction(magnification);
}

std::optional<double>
MagnifiedContact::magnification_of_area(double area_fraction) const {
  if (!(area_fraction > 0.0 && area_fraction < 1.0))
    refuse_argument("area_fraction", area_fraction, "above 0 and below 1");
  const double low = lowest_magnification();
  const double high = highest_magnification();
  if (area_fraction < this->area_fraction(high))
    return std::nullopt;
  const double x = boost::math::erf_inv(area_fraction);
  const double moment = std::pow(pressure_ratio() / x, 2) / pi;
  const auto excess = [&](double log_magnification) {
    return visible_moment(std::exp(log_magnification)) - moment;
  };
  // The bracket extends beyond zeta_0..zeta_1 by roundoff, so that the function
  // has opposite signs at its ends.
  const double edge = 4.0 * std::numeric_limits<double>::epsilon();
  const double from = std::log(low) - edge, to = std::log(high) + edge;
  if (excess(to) <= 0.0)
    return high;
  std::uintmax_t steps = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, from, to, boost::math::tools::eps_tolerance<double>(52), steps);
  return std::exp(bracket.second);
}

double MagnifiedContact::mean_gap(double magnification) const {
  const std::optional<HeightSpectrum> below = hidden(magnification);
  if (!below)
    return 0.0;
  return PerssonContact(*below, contact_.contact_modulus(), contact_.gamma())
      .mean_gap(apparent_pressure(magnification)); // Eqs. (23), (24)
}

double MagnifiedContact::mean_gap_as_printed(double magnification) const {
  const std::optional<HeightSpectrum> below = hidden(magnification);
  if (!below)
    return 0.0;
  const double moment = visible_moment(magnification);
  const double ratio =
      apparent_pressure(magnification) / contact_.contact_modulus();
  double gap = 0.0;
  for (const RoughnessNode& node : below->nodes()) {
    const double m = node.root_moment;
    const double printed_weight =
        node.weight * m / std::hypot(m, std::sqrt(moment));
    gap += printed_weight *
           gap_kernel(ratio / (std::sqrt(pi) * m)).at(contact_.gamma());
  }
  return gap;
}

MagnifiedContact::View MagnifiedContact::view(double magnification) const {
  if (!contact_.spectrum().has_density())
    refuse_argument("magnification", magnification,
                    "of a spectrum that is a formula: with shells the area "
                    "jumps, so ask between two magnifications");
  View view;
  view.visible = visible_area(visible_moment(magnification), pressure_ratio());
  if (const std::optional<HeightSpectrum> below = hidden(magnification))
    view.hidden =
        opening_sums(*below, pressure_ratio() / view.visible.area_fraction,
                     contact_.gamma());
  return view;
}

double MagnifiedContact::opening_gap(double magnification) const {
  const View at = view(magnification);
  if (at.hidden.mean_gap == 0.0)
    return 0.0;
  return at.volume_fall() / at.visible.fall; // Eq. (25)
}

double MagnifiedContact::opening_gap(double from_magnification,
                                     double to_magnification) const {
  const double from = area_fraction(from_magnification);
  const double to = area_fraction(to_magnification);
  if (!(from > to))
    refuse_argument("to_magnification", to_magnification,
                    "high enough for some area to open");
  return (mean_gap(from_magnification) * from -
          mean_gap(to_magnification) * to) /
         (from - to);
}

// With K = -dA/dM_z, K'/K = (x_0^2 - 3/2)/M_z, and dln p(zeta)/dM_z = K/A:
//   du/dM_z = -beta - D K/A,
//   u_1     = u + D + A beta/K,
//   K du_1/dM_z = -2 beta K - D K^2/A + 2 beta_p K + D_p K^2/A
//                 - (K'/K) A beta + A beta_M.
double MagnifiedContact::gap_density(double magnification) const {
  const View at = view(magnification);
  const auto& [moment, exponent, area, fall] = at.visible;
  if (fall == 0.0 || at.hidden.mean_gap == 0.0)
    return 0.0;
  const OpeningSums& sums = at.hidden;
  const double rate =
      2.0 * (sums.closing_rate - sums.closing) * fall +
      (sums.slope_rate - sums.slope) * fall * fall / area +
      area * (sums.closing_shift - (exponent - 1.5) / moment * sums.closing);
  return -fall * fall / rate; // Eq. (27)
}

} // namespace asperity::theory
