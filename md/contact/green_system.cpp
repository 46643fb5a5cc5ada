#include "md/contact/green_system.hpp"

#include "base/field_sums.hpp"
#include "base/require.hpp"
#include "md/contact/step_reading.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace asperity::md {
namespace {

/// Ratio of the lateral to the normal contact stiffness.
constexpr double lateral_share = 0.1;

void shift(std::span<double> values, double amount) {
  for (double& value : values)
    value += amount;
}

} // namespace

GreenSystem::GreenSystem(SurfaceStiffness bulk, Interface interface)
    : bulk_(std::move(bulk)),
      interface_(std::move(interface)),
      local_stiffness_(bulk_.local_stiffness()),
      curvature_(bulk_.layer().size(), local_stiffness_,
                 bulk_.modes() == mechanics::AtomModes::normal),
      contact_(bulk_.layer().size(), 0.0),
      scratch_(3 * bulk_.layer().size()) {
  if (!(interface_.layer() == bulk_.layer()))
    refuse_argument("points_x of the interface's layer",
                    interface_.layer().points_x, "that of the bulk's layer");
}

std::vector<double> GreenSystem::undeformed(double height) const {
  std::vector<double> state(size(), 0.0);
  std::fill(state.end() - static_cast<std::ptrdiff_t>(layer().size()),
            state.end(), height);
  return state;
}

LayerForces GreenSystem::planes_of(std::span<double> unknowns) const {
  const std::size_t n = layer().size();
  return {unknowns.subspan(0, n), unknowns.subspan(n, n),
          unknowns.subspan(2 * n, n)};
}

/// Removes the components of forces, or of a step, that the load and the modes
/// constrain.
void GreenSystem::hold(const LayerForces& forces) const {
  if (bulk_.modes() == mechanics::AtomModes::normal) {
    std::ranges::fill(forces.x, 0.0);
    std::ranges::fill(forces.y, 0.0);
  } else {
    shift(forces.x, -mean(forces.x));
    shift(forces.y, -mean(forces.y));
  }
  if (load_.kind == Load::Kind::height)
    shift(forces.z, -mean(forces.z));
}

Evaluation GreenSystem::energy_and_forces(std::span<const double> state,
                                          std::span<double> forces) const {
  const LayerView atoms = layer_of(*this, state);
  const LayerForces total = planes_of(forces);
  Evaluation evaluation;
  evaluation.energy = interface_.energy_and_forces(atoms, total);
  evaluation.contact_force = mean_size(total.z);
  const double per_force = 13.0 / interface_.interaction().distance;
  for (std::size_t i = 0; i < contact_.size(); ++i)
    contact_[i] = per_force * std::abs(total.z[i]);

  evaluation.energy += bulk_.apply(atoms, planes_of(scratch_));
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] -= scratch_[i];
  if (load_.kind == Load::Kind::nominal_pressure) {
    const double force = load_.amount * layer().cell_area();
    shift(total.z, -force);
    evaluation.energy +=
        force * mean(atoms.z) * static_cast<double>(layer().size());
  }
  hold(total);
  return evaluation;
}

/// Computes planes = S planes, where S is diagonal with
/// S_i^2 = (k + k_c) / (k + k_i). Here k is the bulk stiffness of a single
/// atom, k_i the contact stiffness of atom i, and k_c the given contact
/// stiffness.
void GreenSystem::scale(const LayerForces& planes,
                        double contact_stiffness) const {
  const auto factor = [&](double mean, double local) {
    return std::sqrt((local_stiffness_ + mean) / (local_stiffness_ + local));
  };
  for (std::size_t i = 0; i < contact_.size(); ++i) {
    planes.z[i] *= factor(contact_stiffness, contact_[i]);
    if (bulk_.modes() == mechanics::AtomModes::normal)
      continue;
    const double lateral =
        factor(lateral_share * contact_stiffness, lateral_share * contact_[i]);
    planes.x[i] *= lateral;
    planes.y[i] *= lateral;
  }
}

void GreenSystem::precondition(std::span<const double> forces,
                               double contact_stiffness,
                               std::span<double> step) const {
  std::ranges::copy(forces, scratch_.begin());
  const LayerForces given = planes_of(scratch_);
  const LayerForces answer = planes_of(step);
  hold(given);
  scale(given, contact_stiffness);
  bulk_.solve({given.x, given.y, given.z},
              {lateral_share * contact_stiffness, contact_stiffness}, answer);
  if (load_.kind == Load::Kind::nominal_pressure)
    shift(answer.z, mean(given.z) / contact_stiffness);
  scale(answer, contact_stiffness);
  hold(answer);
}

void GreenSystem::linearise(std::span<const double> state) {
  curvature_.take(interface_, layer_of(*this, state));
}

void GreenSystem::limit_negative_curvature(double share) {
  curvature_.limit_negative_curvature(share);
}

void GreenSystem::curvature_times(std::span<const double> step,
                                  std::span<double> forces) const {
  const LayerForces product = planes_of(forces);
  bulk_.apply(layer_of(*this, step), product);
  curvature_.add_product(layer_of(*this, step), product);
  hold(product);
}

void GreenSystem::precondition_curved(std::span<const double> forces,
                                      std::span<double> step) const {
  std::ranges::copy(forces, scratch_.begin());
  const LayerForces given = planes_of(scratch_);
  const LayerForces answer = planes_of(step);
  const double contact = curvature_.mean_stiffness();
  hold(given);
  curvature_.scale(given);
  bulk_.solve({given.x, given.y, given.z}, {contact, contact}, answer);
  if (load_.kind == Load::Kind::nominal_pressure)
    shift(answer.z, mean(given.z) / contact);
  curvature_.scale(answer);
  hold(answer);
}

void GreenSystem::shorten(std::span<double> step, double longest) const {
  const LayerForces moved = planes_of(step);
  for (std::size_t i = 0; i < layer().size(); ++i) {
    const double length = std::hypot(moved.x[i], moved.y[i], moved.z[i]);
    if (!(length > longest))
      continue;
    const double share = longest / length;
    moved.x[i] *= share;
    moved.y[i] *= share;
    moved.z[i] *= share;
  }
  hold(moved);
}

double GreenSystem::elastic_energy(std::span<const double> state) const {
  return bulk_.apply(layer_of(*this, state), planes_of(scratch_));
}

} // namespace asperity::md
