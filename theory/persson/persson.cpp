#include "theory/persson/persson.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace asperity::theory {

/// Evaluates the outer integrals of Eqs. (9) and (14) and of their derivative
/// at one pressure, from quantities that are computed once per spectrum: a
/// point of u(p) takes microseconds. Sums over the nodes, x_k = p/(E* sqrt(pi)
/// m_k). Nodes with x_k < sqrt(1/2) enter together through their power moments;
/// only the others, about three octaves of m, are summed one by one.
class GapSums {
public:
  /// @param nodes  in descending order of root_moment
  explicit GapSums(std::span<const RoughnessNode> nodes);

  /// Both parts of u(p), Eq. (14) [m].
  /// @param pressure_ratio  p/E* [1] > 0
  GammaParts mean_gap(double pressure_ratio) const;

  /// Both parts of D = -du/dln p [m].
  GammaParts mean_gap_slope(double pressure_ratio) const;

  /// Both parts of U_el/(A_0 E*), Eq. (9) [m].
  GammaParts elastic_energy(double pressure_ratio) const;

  /// Sum of the weights = 2 int dm/q = u_0/gamma of Eq. (18) [m].
  double weight_sum() const { return weight_sum_; }

  /// Weighted mean of ln w, the quotient of the integrals in Eq. (19) [1].
  double mean_log_factor() const { return mean_log_factor_; }

private:
  using Moments = std::array<double, SmallPressureSeries::n_terms>;

  struct Node {
    double factor;      ///< w = 1/(sqrt(pi) m) [1], ascending
    double weight;      ///< [m]
    double log_sum;     ///< cumulative sum of weight * ln w [m]
    Moments power_sums; ///< cumulative sums of weight_i (w_i/w)^{2n} [m]
  };

  /// Number of nodes with x < limit, which come first.
  std::size_t n_small(double pressure_ratio) const;

  /// Adds the terms of all other nodes.
  template <class Kernel>
  GammaParts beyond_small(GammaParts sum, double pressure_ratio,
                          const Kernel& kernel) const;

  std::vector<Node> nodes_;
  double weight_sum_ = 0.0;
  double mean_log_factor_ = 0.0;
};

namespace {

using Series = SmallPressureSeries;

template <class Moments>
GammaParts contract(const Series::Coefficients& linear,
                    const Series::Coefficients& cubic, const Moments& moments,
                    double square) {
  GammaParts sum;
  double power = 1.0;
  for (std::size_t n = 0; n < moments.size(); ++n) {
    sum.linear += linear[n] * power * moments[n];
    sum.cubic += cubic[n] * power * moments[n];
    power *= square;
  }
  return sum;
}

// Both kernels fall at least as fast as e^{-x^2}: beyond this value the
// remaining terms are below roundoff, even compared with the first term alone.
bool is_negligible(double x, double smallest_x) {
  const double exponent_of_rounding = 45.0; // e^{-45} = 3e-20
  return x * x > smallest_x * smallest_x + exponent_of_rounding;
}

} // namespace

GapSums::GapSums(std::span<const RoughnessNode> nodes) {
  nodes_.reserve(nodes.size());
  Moments sums{};
  double log_sum = 0.0;
  double last_factor = 0.0;
  for (const RoughnessNode& node : nodes) {
    const double factor =
        1.0 / (std::sqrt(std::numbers::pi) * node.root_moment);
    const double square = (last_factor / factor) * (last_factor / factor);
    double power = 1.0;
    for (double& sum : sums) {
      sum = sum * power + node.weight;
      power *= square;
    }
    log_sum += node.weight * std::log(factor);
    nodes_.push_back({factor, node.weight, log_sum, sums});
    last_factor = factor;
  }
  weight_sum_ = sums[0];
  mean_log_factor_ = log_sum / weight_sum_;
}

std::size_t GapSums::n_small(double pressure_ratio) const {
  const auto end =
      std::partition_point(nodes_.begin(), nodes_.end(), [&](const Node& node) {
        return node.factor * pressure_ratio < Series::limit;
      });
  return static_cast<std::size_t>(end - nodes_.begin());
}

template <class Kernel>
GammaParts GapSums::beyond_small(GammaParts sum, double pressure_ratio,
                                 const Kernel& kernel) const {
  const double smallest = nodes_.front().factor * pressure_ratio;
  for (std::size_t k = n_small(pressure_ratio); k < nodes_.size(); ++k) {
    const double x = nodes_[k].factor * pressure_ratio;
    if (is_negligible(x, smallest))
      break;
    const GammaParts at = kernel(x);
    sum.linear += nodes_[k].weight * at.linear;
    sum.cubic += nodes_[k].weight * at.cubic;
  }
  return sum;
}

GammaParts GapSums::mean_gap(double pressure_ratio) const {
  const Series& series = small_pressure_series();
  GammaParts gap;
  if (const std::size_t small = n_small(pressure_ratio); small > 0) {
    const Node& last = nodes_[small - 1];
    const double x = last.factor * pressure_ratio;
    gap = contract(series.gap_linear, series.gap_cubic, last.power_sums, x * x);
    gap.linear -= last.log_sum + std::log(pressure_ratio) * last.power_sums[0];
  }
  return beyond_small(gap, pressure_ratio, gap_kernel);
}

GammaParts GapSums::mean_gap_slope(double pressure_ratio) const {
  const Series& series = small_pressure_series();
  GammaParts slope;
  if (const std::size_t small = n_small(pressure_ratio); small > 0) {
    const Node& last = nodes_[small - 1];
    const double x = last.factor * pressure_ratio;
    slope = contract(series.slope_linear, series.slope_cubic, last.power_sums,
                     x * x);
  }
  return beyond_small(slope, pressure_ratio, gap_kernel_slope);
}

GammaParts GapSums::elastic_energy(double pressure_ratio) const {
  GammaParts energy;
  for (const Node& node : nodes_) { // (pi/2) weight m = (sqrt(pi)/2) weight/w
    const double part =
        0.5 * std::sqrt(std::numbers::pi) * node.weight / node.factor;
    const double probability =
        std::erf(node.factor * pressure_ratio); // Eq. (11)
    energy.linear += part * probability;
    energy.cubic += part * probability * probability * probability;
  }
  return energy;
}

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

} // namespace asperity::theory
