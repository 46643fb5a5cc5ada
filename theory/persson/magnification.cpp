#include "theory/persson/magnification.hpp"

#include "base/require.hpp"
#include "theory/persson/opening_sums.hpp"

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

OpeningRates MagnifiedContact::opening_rates(double magnification) const {
  const View at = view(magnification);
  const double q = wavevector(magnification);
  const double moment_rate =
      std::pow(q, 4) * contact_.spectrum().density(q); // dM/dln q
  return {at.visible.fall * moment_rate, at.volume_fall() * moment_rate};
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
