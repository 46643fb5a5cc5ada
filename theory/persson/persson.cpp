#include "theory/persson/persson.hpp"

#include "base/require.hpp"
#include "theory/persson/gap_sums.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace asperity::theory {
namespace {

void require_gamma(double gamma) {
  if (!(gamma > 0.0 && gamma <= 1.0))
    refuse_argument("gamma", gamma, "above 0 and at most 1");
}

double log_epsilon(double gamma) {
  return -0.5 * std::numbers::egamma +
         cubic_energy_constant() * (1.0 - gamma) / gamma; // Eq. (16)
}

/// Sum over the nodes of a spectrum, of their weight in 2 dm/q times a function
/// of x = p/(E* sqrt(pi) m) and of m.
template <class Term>
double node_sum(const HeightSpectrum& spectrum, double pressure_ratio,
                const Term& term) {
  double sum = 0.0;
  for (const RoughnessNode& node : spectrum.nodes())
    sum +=
        node.weight *
        term(pressure_ratio / (std::sqrt(std::numbers::pi) * node.root_moment),
             node.root_moment);
  return sum;
}

} // namespace

double persson_epsilon(double gamma) {
  require_gamma(gamma);
  return std::exp(log_epsilon(gamma));
}

PerssonContact::PerssonContact(HeightSpectrum spectrum, double contact_modulus,
                               double gamma)
    : spectrum_(std::move(spectrum)),
      contact_modulus_(contact_modulus),
      gamma_(gamma) {
  require_positive("contact_modulus", contact_modulus, "Pa");
  require_gamma(gamma);
  sums_ = std::make_shared<const GapSums>(spectrum_.nodes());
}

PerssonContact PerssonContact::with_gamma(double gamma) const {
  require_gamma(gamma);
  PerssonContact other = *this;
  other.gamma_ = gamma;
  return other;
}

PerssonContact PerssonContact::with_law(LossLaw law) const {
  PerssonContact other = *this;
  other.law_ = std::move(law);
  return other;
}

double PerssonContact::stress_variance(double nominal_pressure) const {
  const double full = stress_variance();
  if (!law_ || !(nominal_pressure > 0.0))
    return full;
  return full /
         law_->variance_reduction(0.5 * nominal_pressure / std::sqrt(full));
}

double PerssonContact::stress_variance() const {
  return theory::stress_variance(contact_modulus_, spectrum_.rms_slope());
}

double PerssonContact::pressure_density(double contact_pressure,
                                        double nominal_pressure) const {
  return theory::pressure_density(contact_pressure, nominal_pressure,
                                  stress_variance(nominal_pressure));
}

double PerssonContact::area_fraction(double nominal_pressure) const {
  return theory::area_fraction(nominal_pressure,
                               stress_variance(nominal_pressure));
}

PressureMoments
PerssonContact::pressure_moments(double nominal_pressure) const {
  return theory::pressure_moments(nominal_pressure,
                                  stress_variance(nominal_pressure));
}

double PerssonContact::pressure_ratio(double nominal_pressure) const {
  require_positive("nominal_pressure", nominal_pressure, "Pa");
  return nominal_pressure / contact_modulus_;
}

double PerssonContact::elastic_energy(double nominal_pressure) const {
  if (!law_ || nominal_pressure == 0.0)
    return elastic_energy_parts(nominal_pressure).at(gamma_);
  return contact_modulus_ *
         node_sum(spectrum_, pressure_ratio(nominal_pressure),
                  [&](double x, double root_moment) { // Eq. (9)
                    return 0.5 * std::numbers::pi * root_moment *
                           law_->energy(x);
                  });
}

GammaParts PerssonContact::elastic_energy_parts(double nominal_pressure) const {
  require_not_negative("nominal_pressure", nominal_pressure, "Pa");
  const GammaParts parts =
      sums_->elastic_energy(nominal_pressure / contact_modulus_); // Eq. (9)
  return {contact_modulus_ * parts.linear, contact_modulus_ * parts.cubic};
}

double PerssonContact::full_contact_energy() const {
  return 0.5 * std::numbers::pi * contact_modulus_ *
         spectrum_.full_contact_moment();
}

double PerssonContact::mean_gap(double nominal_pressure) const {
  if (!law_)
    return mean_gap_parts(nominal_pressure).at(gamma_); // Eq. (14)
  return node_sum(spectrum_, pressure_ratio(nominal_pressure),
                  [&](double x, double) { return law_->gap_kernel(x); });
}

GammaParts PerssonContact::mean_gap_parts(double nominal_pressure) const {
  return sums_->mean_gap(pressure_ratio(nominal_pressure));
}

double PerssonContact::mean_gap_slope(double nominal_pressure) const {
  if (!law_)
    return sums_->mean_gap_slope(pressure_ratio(nominal_pressure)).at(gamma_);
  return node_sum(spectrum_, pressure_ratio(nominal_pressure),
                  [&](double x, double) { return law_->gap_kernel_slope(x); });
}

double PerssonContact::contact_stiffness(double nominal_pressure) const {
  return nominal_pressure / mean_gap_slope(nominal_pressure);
}

double PerssonContact::gap_decay_length() const {
  return (law_ ? law_->decay_factor() : gamma_) *
         sums_->weight_sum(); // Eq. (18)
}

double PerssonContact::log_prefactor() const {
  return (law_ ? law_->log_epsilon() : log_epsilon(gamma_)) -
         sums_->mean_log_factor(); // Eq. (19)
}

double PerssonContact::pressure_prefactor() const {
  return std::exp(log_prefactor());
}

double PerssonContact::asymptotic_pressure(double mean_gap) const {
  require_not_negative("mean_gap", mean_gap, "m");
  return contact_modulus_ *
         std::exp(log_prefactor() - mean_gap / gap_decay_length()); // Eq. (17)
}

// Newton's iteration for ln u as a function of ln p, confined to a bracket. ln
// u decreases monotonically with ln p, like the logarithm of a linear function
// of ln p at small p and like -p^2 near full contact; its slope is -D/u.
double PerssonContact::nominal_pressure(double mean_gap) const {
  require_positive("mean_gap", mean_gap, "m");
  const double log_least = -340.0 * std::numbers::ln10 / 3.0; // p/E* = 1e-113
  const double log_small =
      std::log(asymptotic_pressure(mean_gap) / contact_modulus_);
  if (!(log_small > log_least))
    return asymptotic_pressure(mean_gap); // relative error below 1e-100

  double low = log_least;
  double high = std::log(30.0 * spectrum_.rms_slope()); // u(high) = 0
  double log_ratio = std::min(log_small, std::log(spectrum_.rms_slope()));
  const int most_steps = 200; // bisection alone would take 60
  for (int step = 0; step < most_steps; ++step) {
    const double ratio = std::exp(log_ratio);
    const double gap = this->mean_gap(contact_modulus_ * ratio);
    (gap > mean_gap ? low : high) = log_ratio;
    const double slope = mean_gap_slope(contact_modulus_ * ratio);
    double next = log_ratio + std::log(gap / mean_gap) * gap / slope;
    if (!(next > low && next < high))
      next = 0.5 * (low + high);
    if (std::abs(next - log_ratio) <
        2.0 * std::numeric_limits<double>::epsilon() *
            std::max(1.0, std::abs(next)))
      return contact_modulus_ * std::exp(next);
    log_ratio = next;
  }
  return contact_modulus_ * std::exp(log_ratio);
}

double fit_gamma(const PerssonContact& contact,
                 std::span<const GapPoint> points) {
  if (points.empty())
    refuse_argument("number of points", 0.0, ">= 1");
  double above = 0.0;
  double below = 0.0;
  for (const GapPoint& point : points) {
    const GammaParts gap = contact.mean_gap_parts(point.nominal_pressure);
    const double lever = gap.linear - gap.cubic; // du/dgamma
    above += lever * (point.mean_gap - gap.cubic);
    below += lever * lever;
  }
  return above / below;
}

} // namespace asperity::theory
