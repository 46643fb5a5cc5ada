#pragma once

// A system without atoms for the tests of the minimisers: independent unknowns
// whose balance is known in closed form.

#include "md/minimise/system.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace asperity::md::problems {

/// Unknowns with one energy each: E = sum of energy(i, x_i). The contact force
/// is 1 N, so that residuals are root mean square forces.
class Separate final : public System {
public:
  using Term = std::function<double(std::size_t, double)>;

  Separate(std::size_t size, Term energy, Term force)
      : size_(size), energy_(std::move(energy)), force_(std::move(force)) {}

  const Grid& layer() const override { return grid_; }

  std::size_t size() const override { return size_; }

  void set_load(const Load&) override {}

  std::vector<double> undeformed(double height) const override {
    return std::vector<double>(size_, height);
  }

  Evaluation energy_and_forces(std::span<const double> state,
                               std::span<double> forces) const override {
    Evaluation evaluation{0.0, contact_force};
    for (std::size_t i = 0; i < size_; ++i) {
      evaluation.energy += energy_(i, state[i]);
      forces[i] = force_(i, state[i]);
    }
    evaluated.emplace_back(state.begin(), state.end());
    return evaluation;
  }

  void precondition(std::span<const double> forces, double contact_stiffness,
                    std::span<double> step) const override {
    for (std::size_t i = 0; i < size_; ++i)
      step[i] = forces[i] / contact_stiffness;
  }

  double elastic_energy(std::span<const double>) const override { return 0.0; }

  const Interface& interface() const override {
    throw std::logic_error("there is none");
  }

  double contact_force = 1.0;
  mutable std::vector<std::vector<double>> evaluated; ///< every state, in order

private:
  std::size_t size_;
  Term energy_;
  Term force_;
  Grid grid_{1, 1, 1.0, 1.0};
};

} // namespace asperity::md::problems
