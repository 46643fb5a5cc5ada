#include "theory/persson/adhesion.hpp"

#include "base/require.hpp"
#include "theory/persson/absorbed_flux.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::theory {

using std::numbers::pi;

double true_area_factor(double mean_square_slope) {
  require_not_negative("mean_square_slope", mean_square_slope, "1");
  if (mean_square_slope == 0.0)
    return 1.0;
  const double slope = std::sqrt(mean_square_slope);
  const double inverse = 1.0 / slope;
  const double gentle = 20.0;
  if (inverse < gentle)
    return 1.0 + 0.5 * std::sqrt(pi) * slope * std::exp(inverse * inverse) *
                     std::erfc(inverse);
  // Asymptotic series of erfc:
  // x e^{x^2} erfc(x) sqrt(pi) = sum (2n - 1)!! (-1/2x^2)^n
  double sum = 1.0;
  for (int n = 6; n > 0; --n)
    sum = 1.0 - (2 * n - 1) * 0.5 * mean_square_slope * sum;
  return 1.0 + 0.5 * mean_square_slope * sum;
}

RoughAdhesion::RoughAdhesion(const HeightSpectrum& spectrum,
                             const AdhesivePair& pair, int n_steps)
    : pair_(pair) {
  require_positive("contact_modulus", pair.contact_modulus, "Pa");
  require_positive("work_of_adhesion", pair.work_of_adhesion, "J/m^2");
  require_positive("detachment_factor", pair.detachment_factor, "1");
  if (!(pair.gamma > 0.0 && pair.gamma <= 1.0))
    refuse_argument("gamma", pair.gamma, "above 0 and at most 1");
  require_between("n_steps", n_steps, 10, 100000, "1");
  const std::span<const double> breaks = spectrum.breaks();
  if (breaks.empty())
    refuse_argument("number of breaks", 0.0, ">= 2: give a formula");
  const double all = std::log(breaks.back() / breaks.front());
  nodes_.push_back({breaks.front(), 0.0, 0.0});
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double part = std::log(breaks[i] / breaks[i - 1]);
    const int n =
        std::max(2, static_cast<int>(std::ceil(n_steps * part / all)));
    for (int k = 1; k <= n; ++k) {
      const double at = static_cast<double>(k) / n;
      const double log_ratio = part * (i == 1 ? at * at : at);
      add_node(spectrum,
               k == n ? breaks[i] : breaks[i - 1] * std::exp(log_ratio));
    }
  }
}

void RoughAdhesion::add_node(const HeightSpectrum& spectrum,
                             double wavevector) {
  const Node& last = nodes_.back();
  const auto moment = [&](int power) {
    return boost::math::quadrature::gauss<double, 10>::integrate(
        [&](double q) { return std::pow(q, power) * spectrum.density(q); },
        last.wavevector, wavevector);
  };
  nodes_.push_back({wavevector, last.moment + moment(3), moment(2)});
}

// gamma_eff(q) for given P(q), computed from q_1 downwards.
AdhesiveState RoughAdhesion::state_of(std::vector<double> area_fractions,
                                      double height_ratio) const {
  const double square = height_ratio * height_ratio;
  const double modulus = pair_.contact_modulus;
  const auto energy_factor = [&](double p) {
    return p * (pair_.gamma + (1.0 - pair_.gamma) * p * p); // Eq. (10)
  };
  AdhesiveState state;
  state.exists = true;
  const std::size_t n = nodes_.size();
  state.effective_works.resize(n);
  double held = 0.0; // gamma_eff(q) A*(q)/A_0
  for (std::size_t i = n; i-- > 0;) {
    const double area =
        area_fractions[i] *
        true_area_factor(2.0 * pi * square * nodes_[i].moment); // A*/A_0
    if (i + 1 == n)
      held = pair_.work_of_adhesion * area;
    else
      held -= 0.25 * pi * modulus * square * nodes_[i + 1].energy_step *
              (energy_factor(area_fractions[i]) +
               energy_factor(area_fractions[i + 1]));
    state.effective_works[i] = area > 0.0 ? held / area : 0.0;
    state.wavevectors.push_back(nodes_[n - 1 - i].wavevector);
  }
  state.effective_work = state.effective_works.front();
  state.area_fraction = area_fractions.back();
  state.area_fractions = std::move(area_fractions);
  return state;
}

AdhesiveState RoughAdhesion::complete_contact(double height_ratio) const {
  require_positive("height_ratio", height_ratio, "1");
  AdhesiveState state =
      state_of(std::vector<double>(nodes_.size(), 1.0), height_ratio);
  state.converged = true;
  return state;
}

// In units of E*: tau = (pi/4) M, b = sqrt(c gamma_eff q/E*).
std::vector<double> RoughAdhesion::area_fractions(std::span<const double> works,
                                                  double height_ratio) const {
  const double square = height_ratio * height_ratio;
  const std::size_t n = nodes_.size();
  MovingBoundary wall{std::vector<double>(n), std::vector<double>(n),
                      std::vector<double>(n, 0.0)};
  for (std::size_t i = 0; i < n; ++i) {
    wall.time[i] = 0.25 * pi * square * nodes_[i].moment;
    wall.distance[i] = std::sqrt(pair_.detachment_factor * works[i] *
                                 nodes_[i].wavevector / pair_.contact_modulus);
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double last = wall.time[i] - wall.time[i - 1];
    const double slope = (wall.distance[i] - wall.distance[i - 1]) / last;
    wall.rate[i] = slope;
    if (i + 1 < n) {
      const double next = wall.time[i + 1] - wall.time[i];
      const double slope_next =
          (wall.distance[i + 1] - wall.distance[i]) / next;
      wall.rate[i] = (slope * next + slope_next * last) / (last + next);
    }
  }
  return absorbed_flux(wall).survival;
}

AdhesiveState RoughAdhesion::partial_contact(double height_ratio) const {
  require_positive("height_ratio", height_ratio, "1");
  const double full = pair_.work_of_adhesion;
  const double least = 1e-6 * full, tolerance = 1e-10 * full;
  const int most_iterations = 500;
  std::vector<double> works(nodes_.size(), full);
  AdhesiveState state;
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    state = state_of(area_fractions(works, height_ratio), height_ratio);
    state.n_iterations = iteration;
    double change = 0.0;
    bool parts = false;
    for (std::size_t i = 0; i < works.size(); ++i) {
      const double next = std::max(least, state.effective_works[i]);
      parts = parts || state.effective_works[i] < least;
      change = std::max(change, std::abs(next - works[i]));
      works[i] = 0.5 * (works[i] + next);
    }
    if (change < tolerance) {
      state.converged = true;
      if (parts)
        state = {false, true, iteration, 0.0, 0.0, {}, {}, {}};
      return state;
    }
  }
  return state;
}

AdhesiveState RoughAdhesion::equilibrium(double height_ratio) const {
  AdhesiveState complete = complete_contact(height_ratio);
  AdhesiveState partial = partial_contact(height_ratio);
  AdhesiveState& best =
      partial.exists && partial.effective_work > complete.effective_work
          ? partial
          : complete;
  if (best.effective_work > 0.0)
    return best;
  return {false, partial.converged, partial.n_iterations, 0.0, 0.0, {}, {}, {}};
}

double RoughAdhesion::flip(double from_height_ratio,
                           double to_height_ratio) const {
  const auto is_partial = [&](double ratio) {
    const AdhesiveState partial = partial_contact(ratio);
    return partial.exists &&
           partial.effective_work > complete_contact(ratio).effective_work;
  };
  double low = from_height_ratio, high = to_height_ratio;
  const bool at_low = is_partial(low);
  if (at_low == is_partial(high))
    refuse_argument("to_height_ratio", high, "beyond the flip");
  while (std::abs(high - low) > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (is_partial(middle) == at_low ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double rough_pull_off_force(double sphere_radius, double effective_work) {
  require_positive("sphere_radius", sphere_radius, "m");
  return 1.5 * pi * sphere_radius * std::max(0.0, effective_work);
}

} // namespace asperity::theory
