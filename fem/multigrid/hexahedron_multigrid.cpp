#include "fem/multigrid/hexahedron_multigrid.hpp"

#include "fem/multigrid/face_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::fem {
namespace {

/// Terms of the polynomial before and after the correction.
constexpr int smoother_terms = 4;

} // namespace

HexahedronMultigrid::HexahedronMultigrid(const HexahedronMesh& mesh)
    : stiffness_(mesh),
      scaled_(normalised(mesh, unit_)),
      constrained_(mesh.constraints.unknowns) {
  eigenvalue_ = static_cast<float>(eigenvalue_estimate(
      scaled_.diagonal(),
      [&](float* from, float* to) { scaled_.apply(from, to); }, mesh.ranks()));
  gradients_.ranks = mesh.ranks();
  own_.displacement.assign(mesh.unknowns, 0.0F);
  own_.residual = own_.direction = product_ = own_.displacement;
  set_contact({});
}

void HexahedronMultigrid::set_contact(HexahedronContact contact) {
  contact_ = std::move(contact);
  const std::vector<float>& diagonal = scaled_.diagonal();
  inverse_.resize(diagonal.size());
  for (std::size_t i = 0; i < inverse_.size(); ++i)
    inverse_[i] =
        diagonal[i] > 0.0F ? 1.0F / (eigenvalue_ * diagonal[i]) : 0.0F;
  scaled_springs_ = contact_.springs;
  for (double& spring : scaled_springs_.weight)
    spring /= unit_;
  if (contact_.has_springs)
    soften();
  for (const std::size_t unknown : contact_.held)
    inverse_[unknown] = 0.0F;
}

/// Adds the sum of the magnitudes in each row of the springs to the diagonal.
void HexahedronMultigrid::soften() {
  const std::vector<float>& diagonal = scaled_.diagonal();
  std::vector<double> sums(diagonal.size(), 0.0);
  for (std::size_t row = 0; row < scaled_springs_.rows(); ++row)
    for (std::size_t i = scaled_springs_.start[row];
         i < scaled_springs_.start[row + 1]; ++i)
      sums[contact_.unknowns[row]] += std::abs(scaled_springs_.weight[i]);
  stiffness_.collect(sums.data());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i] > 0.0)
      inverse_[i] = static_cast<float>(
          1.0 / (static_cast<double>(eigenvalue_ * diagonal[i]) + sums[i]));
}

void HexahedronMultigrid::apply(std::vector<double>& displacement,
                                std::vector<double>& force) const {
  force.resize(stiffness_.size());
  stiffness_.apply(displacement.data(), force.data());
}

void HexahedronMultigrid::apply_all(std::vector<double>& displacement,
                                    std::vector<double>& force) const {
  force.resize(stiffness_.size());
  stiffness_.apply_own(displacement.data(), force.data());
  if (!contact_.springs.is_empty())
    add_spring_force(contact_.springs, contact_.unknowns, displacement.data(),
                     force.data());
  stiffness_.collect(force.data());
  clear_held(force);
}

/// Sets the unknowns to zero that constraints or contact determine.
void HexahedronMultigrid::clear_held(std::vector<double>& vector) const {
  for (const std::size_t unknown : constrained_)
    vector[unknown] = 0.0;
  for (const std::size_t unknown : contact_.held)
    vector[unknown] = 0.0;
}

/// Subtracts (K + S) direction from the residual.
void HexahedronMultigrid::subtract() {
  scaled_.apply_own(own_.direction.data(), product_.data());
  if (!scaled_springs_.is_empty())
    add_spring_force(scaled_springs_, contact_.unknowns, own_.direction.data(),
                     product_.data());
  scaled_.collect(product_.data());
  for (std::size_t i = 0; i < product_.size(); ++i)
    own_.residual[i] -= product_[i];
}

void HexahedronMultigrid::run_cycle() {
  const auto subtracts = [&] { subtract(); };
  const auto clear = [&](std::vector<float>& vector) {
    for (const std::size_t unknown : constrained_)
      vector[unknown] = 0.0F;
    for (const std::size_t unknown : contact_.held)
      vector[unknown] = 0.0F;
  };
  std::fill(own_.displacement.begin(), own_.displacement.end(), 0.0F);
  smooth_by_chebyshev(own_, inverse_, smoother_terms, false, subtracts);
  if (correction_) {
    clear(own_.residual);
    std::fill(own_.direction.begin(), own_.direction.end(), 0.0F);
    correction_(own_.residual, own_.direction);
    clear(own_.direction);
    for (std::size_t i = 0; i < product_.size(); ++i)
      own_.displacement[i] += own_.direction[i];
    subtract();
  }
  smooth_by_chebyshev(own_, inverse_, smoother_terms, true, subtracts);
  clear(own_.displacement);
}

LinearSolution HexahedronMultigrid::solve(const std::vector<double>& force,
                                          std::vector<double>& displacement,
                                          double tolerance,
                                          int most_iterations) {
  return conjugate_gradients(*this, force, displacement, tolerance,
                             most_iterations, gradients_);
}

std::size_t HexahedronMultigrid::bytes() const {
  return stiffness_.bytes() + scaled_.bytes() +
         5 * product_.size() * sizeof(float) +
         3 * product_.size() * sizeof(double) + 2 * contact_.springs.bytes() +
         (constrained_.size() + contact_.unknowns.size() +
          contact_.held.size()) *
             sizeof(std::size_t);
}

} // namespace asperity::fem
