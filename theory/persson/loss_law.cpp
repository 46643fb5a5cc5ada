#include "theory/persson/loss_law.hpp"

#include "base/require.hpp"

#include <boost/math/interpolators/cubic_hermite.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::theory {
namespace {

using LawGauss = boost::math::quadrature::gauss<double, 7>;
using LawCurve = boost::math::interpolators::cubic_hermite<std::vector<double>>;

constexpr double lowest_argument = 1e-10; // s; below, the limit x -> 0 holds
constexpr double highest_argument = 8.0;  // e^{-64} = 2e-28

enum class Form { wang_mueser, xu };

/// P, S and their derivatives d/dln s.
struct LossFactor {
  double area = 0.0;
  double area_rate = 0.0;
  double factor = 0.0;
  double factor_rate = 0.0;
};

LossFactor loss_factor_at(Form form, double gamma, double s) {
  const double area = std::erf(s);
  const double square = area * area;
  const double area_rate =
      2.0 / std::sqrt(std::numbers::pi) * s * std::exp(-s * s);
  if (form == Form::xu)
    return {area, area_rate, gamma + (1.0 - gamma) * area,
            (1.0 - gamma) * area_rate};
  const double quartic = 11.0 / 9.0 - gamma;
  return {area, area_rate,
          gamma - 2.0 / 9.0 * square + quartic * square * square,
          (-4.0 / 9.0 * area + 4.0 * quartic * area * square) * area_rate};
}

/// W with dW/dln s and dln x/dln s at one s.
struct LawEnergy {
  double energy = 0.0;
  double energy_rate = 0.0;
  double argument_rate = 0.0;
};

/// @param reduction  F(s)
LawEnergy law_energy_at(Form form, double gamma, double s, double reduction) {
  const LossFactor at = loss_factor_at(form, gamma, s);
  const double energy = at.area * at.factor;
  const double rate = at.area_rate * at.factor + at.area * at.factor_rate;
  if (form == Form::wang_mueser)
    return {energy, rate, 1.0 / (reduction * at.factor)};
  // V = S V_f and V ~ 1/s^2 give dV/dV_f = S/D with D = dln x/dln s.
  const double half = 0.5 * at.factor_rate / at.factor;
  const double spread = 1.0 + half;
  const double spread_rate = half * (1.0 - 2.0 * s * s) - 2.0 * half * half;
  return {energy / spread, (rate - energy * spread_rate / spread) / spread,
          spread};
}

} // namespace

struct LossLaw::Tables {
  Tables(Form form_of_law, double gamma_of_law)
      : form(form_of_law), gamma(gamma_of_law) {
    // S of Wang and Mueser is positive for every P only above 0.0102.
    const double least =
        form == Form::wang_mueser ? least_wang_mueser_gamma : 0.0;
    if (!(gamma > least && gamma <= 1.0))
      refuse_argument("gamma", gamma,
                      fmt::format("above {:g} and at most 1", least));
    tabulate();
  }

  /// s of x.
  double argument(double x) const {
    if (x <= lowest)
      return x / std::sqrt(gamma);
    return x >= highest ? x : std::exp((*log_argument)(std::log(x)));
  }

  LawEnergy energy(double x) const {
    const double s = argument(x);
    return law_energy_at(form, gamma, s, (s / x) * (s / x));
  }

  Form form;
  double gamma;
  double lowest = 0.0; ///< x at both ends of the tables
  double highest = 0.0;
  double log_epsilon = 0.0;
  std::shared_ptr<const LawCurve> log_argument; ///< ln s of ln x
  std::shared_ptr<const LawCurve> log_kernel;   ///< ln J of ln x

private:
  /// F at s from F at a higher one.
  double reduction(double s, double high, double high_reduction) const {
    if (form == Form::xu)
      return 1.0 / loss_factor_at(form, gamma, s).factor;
    const double share = LawGauss::integrate(
        [this](double t) {
          return 2.0 / (t * t * t * loss_factor_at(form, gamma, t).factor);
        },
        s, high);
    return s * s * (high_reduction / (high * high) + share);
  }

  /// -dJ/ds at one s.
  double kernel_density(double s, double reduction_at_s) const {
    return 0.5 * std::sqrt(std::numbers::pi * reduction_at_s) / (s * s) *
           law_energy_at(form, gamma, s, reduction_at_s).energy_rate;
  }

  // From the top downwards, where J starts with the first term of its
  // asymptotic series, by Simpson's rule.
  void tabulate() {
    std::vector<double> log_x, log_s, s_rate, log_j, j_rate;
    double s = highest_argument;
    double at_s = 1.0; // F
    double kernel = kernel_density(s, at_s) / (2.0 * s);
    const auto keep = [&] {
      const double x = s / std::sqrt(at_s);
      const LawEnergy found = law_energy_at(form, gamma, s, at_s);
      log_x.push_back(std::log(x));
      log_s.push_back(std::log(s));
      s_rate.push_back(1.0 / found.argument_rate);
      log_j.push_back(std::log(kernel));
      j_rate.push_back(-kernel_density(s, at_s) * s /
                       (found.argument_rate * kernel));
    };
    keep();
    highest = std::exp(log_x.back());
    while (s > lowest_argument) {
      const double low = s - std::min(0.005 * s, 0.02 / s);
      const double middle = 0.5 * (low + s);
      const double at_middle = reduction(middle, s, at_s);
      const double at_low = reduction(low, middle, at_middle);
      kernel +=
          (s - low) / 6.0 *
          (kernel_density(s, at_s) + 4.0 * kernel_density(middle, at_middle) +
           kernel_density(low, at_low));
      s = low;
      at_s = at_low;
      keep();
    }
    lowest = std::exp(log_x.back());
    log_epsilon = kernel / std::sqrt(gamma) + log_x.back();
    for (std::vector<double>* column :
         {&log_x, &log_s, &s_rate, &log_j, &j_rate})
      std::reverse(column->begin(), column->end());
    log_kernel = std::make_shared<const LawCurve>(
        std::vector<double>(log_x), std::move(log_j), std::move(j_rate));
    log_argument = std::make_shared<const LawCurve>(
        std::move(log_x), std::move(log_s), std::move(s_rate));
  }
};

LossLaw LossLaw::wang_mueser(double gamma) {
  return LossLaw(std::make_shared<const Tables>(Form::wang_mueser, gamma));
}

LossLaw LossLaw::xu(double gamma) {
  return LossLaw(std::make_shared<const Tables>(Form::xu, gamma));
}

double LossLaw::variance_reduction(double x) const {
  const double ratio = tables_->argument(x) / x;
  return ratio * ratio;
}

double LossLaw::energy(double x) const {
  return tables_->energy(x).energy;
}

double LossLaw::gap_kernel(double x) const {
  if (x <= tables_->lowest)
    return decay_factor() * (log_epsilon() - std::log(x));
  return x >= tables_->highest ? 0.0
                               : std::exp((*tables_->log_kernel)(std::log(x)));
}

double LossLaw::gap_kernel_slope(double x) const {
  const LawEnergy at = tables_->energy(x);
  return 0.5 * std::sqrt(std::numbers::pi) * at.energy_rate /
         (x * at.argument_rate);
}

double LossLaw::decay_factor() const {
  return std::sqrt(tables_->gamma);
}

double LossLaw::log_epsilon() const {
  return tables_->log_epsilon;
}

} // namespace asperity::theory
