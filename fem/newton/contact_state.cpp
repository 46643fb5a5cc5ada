#include "fem/newton/contact_state.hpp"

#include "mechanics/contact_nodes.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace asperity::fem {

using dealii::Utilities::MPI::max;
using dealii::Utilities::MPI::min;
using dealii::Utilities::MPI::sum;

ContactSet contact_set(std::span<const double> pressure) {
  ContactSet set(pressure.size());
  std::transform(pressure.begin(), pressure.end(), set.begin(), [](double p) {
    return mechanics::ContactCriterion{}.holds(p);
  });
  return set;
}

bool is_any(const ContactSet& set) {
  const bool here = std::find(set.begin(), set.end(), true) != set.end();
  return max(here ? 1 : 0, MPI_COMM_WORLD) == 1;
}

int n_changed(const ContactSet& a, const ContactSet& b) {
  int changed = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    changed += a[i] != b[i] ? 1 : 0;
  return sum(changed, MPI_COMM_WORLD);
}

double larger_residual(double largest, double residual) {
  if (std::isnan(residual))
    return std::numeric_limits<double>::infinity();
  return std::max(largest, residual);
}

ContactState::ContactState(const BlockSystem& system, const BlockSolver& solver)
    : displacement(system.space().make_vector()),
      pressure(system.contact().size(), 0.0),
      multiplier(system.contact().size(), 0.0),
      heights(system.contact().size(), 0.0),
      face_displacement(system.contact().size(), 0.0),
      elastic(displacement),
      imbalance(displacement),
      system_(system),
      solver_(solver),
      stiffness_scale_(system.face_shear_modulus() /
                       system.grid().spacing_x()) {
  if (system.law() != nullptr)
    material_.emplace(system);
}

double ContactState::mean_gap() const {
  double mean = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    mean += points()[i].area * gap(i);
  return sum(mean, MPI_COMM_WORLD) / area();
}

double ContactState::borne() const {
  double force = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    force += points()[i].area * pressure[i];
  return sum(force, MPI_COMM_WORLD);
}

double ContactState::touching_mean_gap() const {
  double depth = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i)
    depth -= points()[i].area * heights[i];
  return sum(depth, MPI_COMM_WORLD) / area();
}

/// The monotone equation is solved by bisection between first contact and all
/// points in contact.
double ContactState::touching_gap(double nominal_pressure,
                                  double penalty) const {
  double high = -1e300;
  double low = 1e300;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (!points()[i].is_opposed)
      continue;
    const double own =
        heights[i] - face_displacement[i] + multiplier[i] / penalty;
    high = std::max(high, own);
    low = std::min(low, own - nominal_pressure / penalty);
  }
  high = max(high, MPI_COMM_WORLD);
  low = min(low, MPI_COMM_WORLD);
  const auto bears = [&](double d) {
    double force = 0.0;
    for (std::size_t i = 0; i < pressure.size(); ++i)
      if (points()[i].is_opposed)
        force +=
            points()[i].area *
            std::max(0.0, multiplier[i] - penalty * (d + face_displacement[i] -
                                                     heights[i]));
    return sum(force, MPI_COMM_WORLD) / area();
  };
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (bears(middle) > nominal_pressure ? low : high) = middle;
  }
  return low;
}

void ContactState::take_heights(std::vector<double> absolute) {
  double top = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < absolute.size(); ++i)
    if (points()[i].is_opposed)
      top = std::max(top, absolute[i]);
  top = max(top, MPI_COMM_WORLD);
  rigid_gap += highest - top;
  highest = top;
  heights = std::move(absolute);
  for (double& height : heights)
    height -= top;
}

void ContactState::follow_displacement() {
  points().take_displacement(displacement, face_displacement);
  solver_.multiply(elastic, displacement);
  if (material_)
    material_->follow(displacement, elastic);
}

void ContactState::press_springs(double penalty) {
  for (std::size_t i = 0; i < pressure.size(); ++i)
    pressure[i] = points()[i].is_opposed
                      ? std::max(0.0, multiplier[i] - penalty * gap(i))
                      : 0.0;
}

void ContactState::leave_contact() {
  std::fill(multiplier.begin(), multiplier.end(), 0.0);
  std::fill(pressure.begin(), pressure.end(), 0.0);
}

void ContactState::lift_off(double mean_gap_target) {
  displacement = 0.0;
  elastic = 0.0;
  far_pressure = 0.0;
  std::fill(face_displacement.begin(), face_displacement.end(), 0.0);
  rigid_gap += mean_gap_target - mean_gap();
}

ContactState::Placement ContactState::placement() const {
  return {displacement, elastic, face_displacement, rigid_gap};
}

void ContactState::return_to(const Placement& placement) {
  displacement = placement.displacement;
  elastic = placement.elastic;
  face_displacement = placement.face_displacement;
  rigid_gap = placement.rigid_gap;
  if (material_)
    follow_displacement();
}

void ContactState::shorten_way(const Placement& before, double share) {
  displacement.sadd(share, 1.0 - share, before.displacement);
  elastic.sadd(share, 1.0 - share, before.elastic);
  for (std::size_t i = 0; i < face_displacement.size(); ++i)
    face_displacement[i] +=
        (1.0 - share) * (before.face_displacement[i] - face_displacement[i]);
  rigid_gap += (1.0 - share) * (before.rigid_gap - rigid_gap);
  if (material_)
    follow_displacement();
}

double ContactState::stress_work(const Placement& before, const Vector& step,
                                 double share) {
  Vector there(before.displacement);
  there.add(share, step);
  Vector force(there);
  solver_.multiply(force, there);
  if (material_)
    material_->follow(there, force);
  return force * step;
}

void ContactState::find_imbalance() {
  std::vector<double> forces(pressure.size());
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] = -points()[i].area * pressure[i];
  imbalance = 0.0;
  points().add_force(forces, imbalance);
  imbalance += elastic;
  imbalance.add(far_pressure, system_.far_load());
}

double ContactState::largest_force() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    largest =
        larger_residual(largest, points()[i].area * std::abs(pressure[i]));
  return max(largest, MPI_COMM_WORLD);
}

/// The largest of nodal forces r, or the force at a contact point by which they
/// may move the contact surface, if that is larger [N].
///
/// Forces at all depths add up. They move a wave of the surface at most as much
/// as a wave of forces at its N points does whose amplitude is
///
///     2/N sum r_i m_i <= 2/N |r| |m| <= sqrt(2 L/N) |r|,
///
/// where m_i, the displacements of the L N nodes under such a wave, are at most
/// those of its cosine at the surface, so that |m|^2 <= L N/2.
double ContactState::force_of(const Vector& nodal_forces) const {
  const double norm = nodal_forces.l2_norm();
  // A sum propagates a NaN; the maximum norm need not.
  if (!std::isfinite(norm))
    return std::numeric_limits<double>::infinity();
  const auto n_nodes = static_cast<double>(system_.n_unknowns()) / 3.0;
  const auto n_points = static_cast<double>(
      sum(static_cast<unsigned long>(points().size()), MPI_COMM_WORLD));
  return std::max(nodal_forces.linfty_norm(),
                  std::sqrt(2.0 * n_nodes) / n_points * norm);
}

double ContactState::unbalanced() {
  find_imbalance();
  const double force = force_of(imbalance);
  if (std::isinf(force))
    return force;
  const double largest = largest_force();
  return largest > 0.0 ? force / largest : 0.0;
}

double ContactState::rounding_force() const {
  constexpr double half = 0.5 * std::numeric_limits<double>::epsilon();
  Vector rounding(displacement);
  for (const auto unknown : rounding.locally_owned_elements()) {
    const bool is_odd = std::hash<double>{}(rounding(unknown)) % 2 == 1;
    rounding(unknown) = (is_odd ? -half : half) * displacement(unknown);
  }
  rounding.compress(dealii::VectorOperation::insert);
  Vector forces(rounding);
  solver_.multiply(forces, rounding);
  return force_of(forces);
}

double ContactState::violation(double compliance) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (points()[i].is_opposed)
      largest = larger_residual(
          largest, pressure[i] > 0.0
                       ? std::abs(gap(i) + compliance * pressure[i])
                       : -gap(i));
  return max(largest, MPI_COMM_WORLD);
}

} // namespace asperity::fem
