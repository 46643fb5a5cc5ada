#include "suite/robustness/verify_adhesive.hpp"

#include "base/field_sums.hpp"
#include "base/maximum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

using contact::ContactSolution;
using mechanics::LoadTarget;

constexpr double adhesive_rounding =
    1e-12; ///< of sums and transforms, relative

} // namespace

/// <p u>/2 + <W(g)> + p_0 d [J/m^2], with the displacement u and the distance d
/// of the mean planes far away.
double AdhesiveCheck::energy(const ContactSolution& state,
                             double nominal) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.gap.size(); ++i)
    sum += 0.5 * state.pressure[i] * state.displacement[i] +
           law_.energy(state.gap[i]) +
           nominal * (state.gap[i] + heights_[i] - state.displacement[i]);
  return sum / static_cast<double>(state.gap.size());
}

/// Nodes of the grid on which the problem is solved.
double AdhesiveCheck::solved_nodes() const {
  return (elasticity_.is_periodic() ? 1.0 : 4.0) *
         static_cast<double>(heights_.size());
}

/// Bound of the pressures that are left outside free boundaries, the root of
/// the sum of their squares over the nodes [Pa].
double AdhesiveCheck::pressure_left() const {
  return elasticity_.is_periodic()
             ? 0.0
             : scales_.gap_tolerance * stiffest() * std::sqrt(solved_nodes());
}

/// Bound of the error of energy() [J/m^2] by the pressures e that the solver
/// leaves outside free boundaries. With the compliance C of the wide grid and
/// the pressure p inside, the surface is d + C (p + e) and the energy that no
/// iteration raises has <(p + e) C (p + e)>/2 + p_0 d in place of
/// <p C p>/2 + p_0 <d + C e>. They differ by <(p_0 - p) C e> - <e C e>/2, which
/// Cauchy-Schwarz bounds. The norm of e over the nodes is at most
/// pressure_left(), and that of C at most the displacement in the middle of a
/// uniformly pressed square of side 2 L, 8 ln(1 + sqrt 2)/pi L/E*.
double AdhesiveCheck::energy_left(const ContactSolution& state,
                                  double nominal) const {
  const double left = pressure_left();
  const double softness = 8.0 * std::numbers::inv_pi *
                          std::log(1.0 + std::numbers::sqrt2) *
                          elasticity_.grid().length_x / scales_.contact_modulus;
  double square = 0.0;
  for (const double pressure : state.pressure)
    square += (nominal - pressure) * (nominal - pressure);
  return left * softness * (std::sqrt(square) + 0.5 * left) /
         static_cast<double>(state.pressure.size());
}

/// Largest stiffness of the elastic surface on the grid, and k_c. The shortest
/// waves are 2 sqrt 2 times as short as those of the compliance [Pa/m].
double AdhesiveCheck::stiffest() const {
  return 2.0 * std::numbers::sqrt2 / elasticity_.short_wave_compliance() +
         scales_.stiffness;
}

std::optional<Failure>
AdhesiveCheck::verify_law(const LoadTarget& target,
                          const ContactSolution& found) const {
  // The rms of M r is at most the tolerance, and M at least S (K + k_c)^-1 S
  // with S = (1 + W''/k_c)^-1/2 in the repulsion of a law without a wall.
  // A spring adds its stiffness to the mean.
  const bool has_wall = mechanics::has_wall(law_.law);
  const double spring = std::isfinite(target.spring) ? target.spring : 0.0;
  double repulsion = 0.0;
  for (const double gap : found.gap)
    if (!has_wall)
      repulsion = std::max(repulsion, law_.stiffness(gap));
  const double allowed =
      scales_.gap_tolerance * (stiffest() + spring) *
          (1.0 + repulsion / scales_.stiffness) * std::sqrt(solved_nodes()) +
      adhesive_rounding *
          (largest_magnitude(found.pressure) - law_.pressure_bounds().smallest);
  for (std::size_t i = 0; i < found.gap.size(); ++i) {
    const double gap = found.gap[i];
    const double off = found.pressure[i] - law_.pressure(gap);
    if (has_wall && gap < 0.0)
      return Failure{"wall", fmt::format("a gap of {:.3g} m", gap)};
    if (off < -allowed || ((gap > 0.0 || !has_wall) && off > allowed))
      return Failure{"law",
                     fmt::format("at the gap {:.3g} m, p differs from -W' by "
                                 "{:.3g} Pa, allowed {:.3g} Pa",
                                 gap, off, allowed)};
  }
  return {};
}

std::optional<Failure>
AdhesiveCheck::verify_balance(const LoadTarget& target,
                              const ContactSolution& found) const {
  const bool by_pressure =
      target.control == mechanics::Control::nominal_pressure;
  const double asked = found.is_detached ? 0.0
                       : by_pressure     ? target.amount
                                         : found.nominal_pressure;
  const double nominal = mean(found.pressure);
  if (std::abs(nominal - asked) >
      adhesive_rounding * largest_magnitude(found.pressure) + pressure_left())
    return Failure{"balance",
                   fmt::format("mean pressure {:.17g} Pa instead of {:.17g} Pa",
                               nominal, asked)};
  const double asked_gap = target.amount + nominal / target.spring;
  if (!by_pressure &&
      std::abs(mean(found.gap) - asked_gap) >
          adhesive_rounding *
              (std::abs(target.amount) + largest_magnitude(found.gap) +
               largest_magnitude(found.pressure) / target.spring))
    return Failure{"balance", fmt::format("mean gap {:.17g} m instead of "
                                          "{:.17g} m",
                                          mean(found.gap), asked_gap)};
  return {};
}

std::optional<Failure>
AdhesiveCheck::verify_fields(const ContactSolution& found) {
  std::vector<double> displacement(found.gap.size());
  elasticity_.displacement(found.pressure, displacement);
  const double level = mean(found.gap) + mean(heights_) - mean(displacement);
  const double allowed =
      adhesive_rounding *
          (largest_magnitude(found.gap) + largest_magnitude(heights_) +
           largest_magnitude(found.pressure) / scales_.stiffness) +
      pressure_left() * elasticity_.grid().length_x / scales_.contact_modulus;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const double off = found.gap[i] + heights_[i] - level - displacement[i];
    if (std::abs(off) > allowed)
      return Failure{"gap field", fmt::format("C p differs from the gap by "
                                              "{:.3g} m, allowed {:.3g} m",
                                              off, allowed)};
  }
  return {};
}

/// Whether the state is a minimum, and below the state where the solver began
/// under the same load.
std::optional<Failure>
AdhesiveCheck::verify_minimum(const LoadTarget& target,
                              const ContactSolution& found) const {
  if (found.smallest_stiffness < -1e-3 * scales_.stiffness)
    return Failure{"minimum",
                   fmt::format("the smallest eigenvalue of the Hessian is "
                               "{:.3g} Pa/m",
                               found.smallest_stiffness)};
  if (!begun_ || target.control == mechanics::Control::mean_gap)
    return {};
  const double before = energy(*begun_, target.amount);
  const double after = energy(found, target.amount);
  const double allowed =
      1e-10 * (std::abs(before) + std::abs(after) + law_.work_of_adhesion) +
      energy_left(*begun_, target.amount) + energy_left(found, target.amount);
  if (after > before + allowed)
    return Failure{"energy", fmt::format("rises by {:.3g} J/m^2, allowed "
                                         "{:.3g} J/m^2",
                                         after - before, allowed)};
  return {};
}

std::optional<Failure>
AdhesiveCheck::verify_state(const LoadTarget& target,
                            const ContactSolution& found) {
  if (!all_finite(found.pressure) || !all_finite(found.gap))
    return Failure{"finite", "a field holds a number that is not finite"};
  if (auto failure = verify_balance(target, found))
    return failure;
  if (auto failure = verify_fields(found))
    return failure;
  if (found.is_detached) {
    if (target.amount <= 0.0)
      return {};
    return Failure{"detached", "under a load that presses"};
  }
  if (target.control == mechanics::Control::nominal_pressure &&
      target.amount < law_.pressure_bounds().smallest)
    return Failure{"detached", "a tension beyond the law is held"};
  if (auto failure = verify_law(target, found))
    return failure;
  return verify_minimum(target, found);
}

std::optional<Failure> AdhesiveCheck::verify(const LoadTarget& target,
                                             const ContactSolution& found) {
  auto failure = verify_state(target, found);
  begun_.reset();
  if (!found.is_detached)
    begun_ = found;
  return failure;
}

} // namespace asperity::robustness
