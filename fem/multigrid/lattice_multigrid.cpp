#include "fem/multigrid/lattice_multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace asperity::fem {
namespace {

double inner(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

BoxLattice in_units(const BoxLattice& lattice, double& unit) {
  require_lattice(lattice);
  return normalised(lattice, unit);
}

} // namespace

LatticeMultigrid::LatticeMultigrid(const BoxLattice& lattice)
    : lattice_(lattice),
      stiffness_(lattice),
      cycle_(in_units(lattice, unit_)),
      places_(face_places(stiffness_.layout())) {
  lattice_.moduli.clear();
  set_contact({});
}

void LatticeMultigrid::apply(std::vector<double>& displacement,
                             std::vector<double>& force) const {
  force.resize(layout().size());
  stiffness_.apply(displacement.data(), force.data());
  clear_far_boundary(lattice_, layout(), force.data());
}

void LatticeMultigrid::apply_all(std::vector<double>& displacement,
                                 std::vector<double>& force) const {
  apply(displacement, force);
  if (!contact_.springs.is_empty())
    add_spring_force(contact_.springs, places_, displacement.data(),
                     force.data());
  clear_contact(force);
}

/// Sets the unknowns that contact or a pin holds to zero.
void LatticeMultigrid::clear_contact(std::vector<double>& vector) const {
  for (std::size_t node = 0; node < contact_.held.size(); ++node)
    if (contact_.held[node])
      vector[places_[node]] = 0.0;
  for (const std::size_t place : pinned_)
    vector[place] = 0.0;
}

void LatticeMultigrid::set_contact(FaceContact contact) {
  contact_ = std::move(contact);
  FaceContact scaled = contact_;
  for (double& spring : scaled.springs.weight)
    spring /= unit_;
  cycle_.set_contact(scaled);
}

/// Runs a cycle on the residual over its norm.
/// @return  the product of the residual and the result
double LatticeMultigrid::precondition(double scale) {
  std::vector<float>& force = cycle_.force();
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] = static_cast<float>(scale * residual_[i]);
  cycle_.run();
  const std::vector<float>& result = cycle_.displacement();
  double sum = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i)
    sum += residual_[i] * static_cast<double>(result[i]);
  return sum / scale;
}

LatticeSolution LatticeMultigrid::solve(const std::vector<double>& force,
                                        std::vector<double>& displacement,
                                        double tolerance, int most_iterations) {
  LatticeSolution solution;
  direction_.assign(layout().size(), 0.0);
  apply_all(displacement, residual_);
  for (std::size_t i = 0; i < residual_.size(); ++i)
    residual_[i] = force[i] - residual_[i];
  clear_contact(residual_);
  double norm = std::sqrt(inner(residual_, residual_));
  solution.first_residual = norm;
  double before = 1.0;
  while (norm > tolerance && solution.iterations < most_iterations) {
    ++solution.iterations;
    const double product = precondition(1.0 / norm);
    const std::vector<float>& result = cycle_.displacement();
    const double kept = solution.iterations == 1 ? 0.0 : product / before;
    before = product;
    for (std::size_t i = 0; i < direction_.size(); ++i)
      direction_[i] =
          norm * static_cast<double>(result[i]) + kept * direction_[i];
    clear_contact(direction_);
    apply_all(direction_, product_);
    const double step = product / inner(direction_, product_);
    if (!(step > 0.0) || !std::isfinite(step))
      break;
    double square = 0.0;
    for (std::size_t i = 0; i < residual_.size(); ++i) {
      displacement[i] += step * direction_[i];
      residual_[i] -= step * product_[i];
      square += residual_[i] * residual_[i];
    }
    norm = std::sqrt(square);
  }
  solution.last_residual = norm;
  solution.has_converged = norm <= tolerance;
  return solution;
}

std::size_t LatticeMultigrid::bytes() const {
  return cycle_.bytes() + stiffness_.bytes() + contact_.springs.bytes() +
         places_.size() * sizeof(std::size_t) +
         3 * layout().size() * sizeof(double);
}

} // namespace asperity::fem
