#include "md/contact/explicit_system.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace asperity::md {
namespace {

void centre(std::span<double> values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) /
                      static_cast<double>(values.size());
  for (double& value : values)
    value -= mean;
}

} // namespace

ExplicitSystem::ExplicitSystem(const Crystal& crystal, const BlockShape& shape,
                               Interface interface, double atom_mass,
                               int threads)
    : block_(crystal, shape, threads),
      interface_(std::move(interface)),
      masses_(block_.masses(atom_mass)),
      threads_(threads) {
  if (!(interface_.layer() == shape.layer))
    refuse_argument("points_x of the interface's layer",
                    interface_.layer().points_x,
                    "that of the block's lowest layer");
}

std::vector<double> ExplicitSystem::undeformed(double height) const {
  std::vector<double> state(size(), 0.0);
  for (int level = 0; level < block_.shape().levels; ++level) {
    const std::size_t n = block_.level_grid(level).size();
    for (int layer = 0; layer < block_.shape().layers; ++layer)
      std::fill_n(state.begin() + static_cast<std::ptrdiff_t>(
                                      block_.begin_of(level, layer) + 2 * n),
                  n, height);
  }
  state[block_.plate()] = height;
  return state;
}

Evaluation ExplicitSystem::energy_and_forces(std::span<const double> state,
                                             std::span<double> forces) const {
  const std::size_t n = layer().size();
  std::vector<double> x(n);
  std::vector<double> y(n);
  std::vector<double> z(n);
  Evaluation evaluation;
  evaluation.energy =
      interface_.energy_and_forces(layer_of(*this, state), {x, y, z});
  evaluation.energy += block_.energy_and_forces(state, forces);
  for (std::size_t i = 0; i < n; ++i) {
    evaluation.contact_force += std::abs(z[i]) / static_cast<double>(n);
    forces[i] += x[i];
    forces[n + i] += y[i];
    forces[2 * n + i] += z[i];
  }

  if (load_.kind == Load::Kind::nominal_pressure) {
    const double force = load_.amount * layer().area();
    forces[block_.plate()] -= force;
    evaluation.energy += force * state[block_.plate()];
  }
  hold(forces);
  return evaluation;
}

void ExplicitSystem::hold(std::span<double> velocities) const {
  const std::size_t n = layer().size();
  centre(velocities.subspan(0, n));
  centre(velocities.subspan(n, n));
  if (load_.kind == Load::Kind::height)
    centre(velocities.subspan(2 * n, n));
}

void ExplicitSystem::precondition(std::span<const double> forces,
                                  double contact_stiffness,
                                  std::span<double> step) const {
  const bool is_held = load_.kind == Load::Kind::height;
  if (!solver_ || solver_->support().contact_stiffness != contact_stiffness ||
      solver_->support().is_height_held != is_held)
    solver_ = std::make_unique<BlockSolver>(
        block_, BlockSupport{contact_stiffness, is_held}, threads_);
  solver_->solve(forces, step);
  hold(step); // exactly, without roundoff
}

double ExplicitSystem::elastic_energy(std::span<const double> state) const {
  return block_.energy_of_waves(state);
}

} // namespace asperity::md
