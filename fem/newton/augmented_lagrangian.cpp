#include "fem/newton/augmented_lagrangian.hpp"

#include "base/require.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::fem {
namespace {

using dealii::Utilities::MPI::max;
using dealii::Utilities::MPI::min;

/// Bounds of the first working penalty in Newton's method, in shear moduli per
/// node spacing. With a softer one the multiplier needs many augmentations;
/// with a stiffer one the roundoff of the gap may no longer be small in the
/// pressure.
constexpr double softest_spring = 1e3;
constexpr double stiffest_spring = 1e5;

/// The working penalty grows by this factor if an augmentation has left more
/// than this share of the violation.
constexpr double stiffer = 10.0;
constexpr double slow = 0.25;

/// Share of the tolerance of forces that the roundoff of gaps may have in the
/// pressure of the working penalty.
constexpr double roundoff_share = 0.1;

} // namespace

/// The working penalty in Newton's method. A penalty within the bounds is used
/// itself; for hard contact the solution does not depend on the working
/// penalty.
double AugmentedLagrangian::first_penalty(const BlockContact& contact) const {
  const double low = mechanics::has_wall(contact.law)
                         ? softest_spring * state_.stiffness_scale()
                         : 0.0;
  return std::clamp(contact.penalty, low,
                    stiffest_spring * state_.stiffness_scale());
}

/// The working penalty [Pa/m] above which the roundoff of a gap in contact, the
/// difference of rigid gap, displacement and height, is no longer small in the
/// pressure.
double AugmentedLagrangian::stiffest_penalty(double tolerance) const {
  double length =
      std::max(std::abs(state_.rigid_gap), std::numeric_limits<double>::min());
  double highest = 0.0;
  for (std::size_t i = 0; i < state_.pressure.size(); ++i) {
    if (state_.pressure[i] <= 0.0)
      continue;
    length = std::max({length, std::abs(state_.face_displacement[i]),
                       std::abs(state_.heights[i])});
    highest = std::max(highest, state_.pressure[i]);
  }
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return roundoff_share * tolerance * max(highest, MPI_COMM_WORLD) /
         (epsilon * max(length, MPI_COMM_WORLD));
}

/// The next working penalty [Pa/m] if augmentations with the present one reduce
/// the violation slowly, because modes of the block are stiffer: a thin, nearly
/// incompressible coating is stiffer than its shear modulus per node spacing by
/// a factor of 1e4 and more. A penalty stays softer than that of the contact.
double AugmentedLagrangian::stiffer_penalty(const BlockContact& working,
                                            const BlockContact& contact) const {
  double limit = stiffest_penalty(working.tolerance);
  if (!mechanics::has_wall(contact.law))
    limit = std::min(limit, contact.penalty);
  return std::max(working.penalty, std::min(stiffer * working.penalty, limit));
}

/// The next working penalty [Pa/m] if forces are not balanced with the present
/// one, because the roundoff of a gap is not small in its pressure. The first
/// penalty is a multiple of the largest shear modulus at the contact surface,
/// but the displacement is that of the softest cells.
double AugmentedLagrangian::softer_penalty(const BlockContact& working) {
  if (state_.unbalanced() <= working.tolerance)
    return working.penalty;
  return std::min(working.penalty,
                  std::max(softest_spring * state_.stiffness_scale(),
                           stiffest_penalty(working.tolerance)));
}

void AugmentedLagrangian::solve(const mechanics::LoadTarget& load,
                                const BlockContact& contact,
                                double height_scale, BlockSolution& answer) {
  std::fill(state_.multiplier.begin(), state_.multiplier.end(), 0.0);
  BlockContact spring = contact;
  spring.penalty = first_penalty(contact);
  const double compliance = contact.local_compliance();
  double last = std::numeric_limits<double>::infinity();
  while (newton_.solve(load, spring, answer)) {
    const bool is_own =
        !mechanics::has_wall(contact.law) && spring.penalty == contact.penalty;
    answer.residual =
        is_own ? 0.0 : state_.violation(compliance) / height_scale;
    const double softer = softer_penalty(spring);
    answer.converged =
        answer.residual <= contact.tolerance && softer == spring.penalty;
    if (answer.converged)
      break;
    const double missing = missing_pressure(load, compliance);
    if (missing > 0.0 &&
        !can_bear(missing, contact.tolerance * height_scale, answer))
      break;
    if (softer < spring.penalty)
      spring.penalty = softer;
    else if (answer.residual > slow * last)
      spring.penalty = stiffer_penalty(spring, contact);
    last = answer.residual;
    // The part of a pressure that the working penalty does not represent in the
    // gap.
    const double kept = 1.0 - spring.penalty * compliance;
    for (std::size_t i = 0; i < state_.multiplier.size(); ++i)
      state_.multiplier[i] = kept * (state_.pressure[i] + missing);
  }
}

/// The uniform pressure [Pa] by which the points must be pressed more to have
/// the prescribed mean gap; 0 if it is not known. If all points are in contact,
/// the mean gap under a penalty k is minus the nominal pressure over k, so that
/// the multipliers need not approach this pressure in steps of the working
/// penalty.
double AugmentedLagrangian::missing_pressure(const mechanics::LoadTarget& load,
                                             double compliance) const {
  const bool is_full = std::ranges::all_of(
      state_.pressure, [](double pressure) { return pressure > 0.0; });
  if (load.control != mechanics::Control::mean_gap || compliance == 0.0 ||
      min(is_full ? 1 : 0, MPI_COMM_WORLD) == 0)
    return 0.0;
  return std::max(0.0,
                  -load.amount / compliance - state_.borne() / state_.area());
}

/// Whether the gaps are known to the tolerance [m] under a nominal pressure
/// that is greater by `missing` [Pa]. The rigid gap grows with the pressure, by
/// the compression of the block, and gaps are differences from it.
bool AugmentedLagrangian::can_bear(double missing, double gap_tolerance,
                                   BlockSolution& answer) const {
  const double pressure = state_.borne() / state_.area() + missing;
  const double compression =
      std::abs(state_.rigid_gap) / (state_.borne() / state_.area()) * pressure;
  const double roundoff = std::numeric_limits<double>::epsilon() * compression;
  if (roundoff <= gap_tolerance)
    return true;
  answer.note = fmt::format(
      "the mean gap requires a nominal pressure of {:.3g} Pa, which compresses "
      "the block by {:.3g} m; the roundoff of gaps is then {} m, but must "
      "be at most the tolerance of {} m: choose a softer penalty or a "
      "larger mean gap",
      pressure, compression, number_text(roundoff, gap_tolerance, 2),
      number_text(gap_tolerance, roundoff, 2));
  return false;
}

} // namespace asperity::fem
