#include "fem/multigrid/lattice_multigrid.hpp"

#include <utility>

namespace asperity::fem {
namespace {

BoxLattice in_units(const BoxLattice& lattice, double& unit) {
  require_lattice(lattice);
  return normalised(lattice, unit);
}

LatticeSlab slab_of(const BoxLattice& lattice, RankGroup* ranks) {
  require_lattice(lattice);
  return MultigridCycle::has_levels(lattice) ? divided(lattice, ranks)
                                             : LatticeSlab(lattice);
}

} // namespace

LatticeMultigrid::LatticeMultigrid(const BoxLattice& lattice, RankGroup* ranks)
    : lattice_(lattice),
      stiffness_(lattice, slab_of(lattice, ranks)),
      cycle_(in_units(lattice, unit_), slab()),
      places_(face_places(stiffness_.layout())) {
  lattice_.moduli.clear();
  gradients_.ranks = slab().ranks();
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
  force.resize(layout().size());
  stiffness_.apply(displacement.data(), force.data(),
                   {&contact_.springs, &places_});
  clear_far_boundary(lattice_, layout(), force.data());
  clear_held(force);
}

/// Sets the unknowns that contact or a pin holds to zero.
void LatticeMultigrid::clear_held(std::vector<double>& vector) const {
  for (const std::size_t place : held_)
    vector[place] = 0.0;
  for (const std::size_t place : pinned_)
    vector[place] = 0.0;
}

void LatticeMultigrid::set_contact(FaceContact contact) {
  contact_ = std::move(contact);
  share_held(layout(), slab(), contact_);
  held_ = held_places(layout(), contact_);
  FaceContact scaled = contact_;
  for (double& spring : scaled.springs.weight)
    spring /= unit_;
  cycle_.set_contact(scaled);
}

LinearSolution LatticeMultigrid::solve(const std::vector<double>& force,
                                       std::vector<double>& displacement,
                                       double tolerance, int most_iterations) {
  gradients_.residual = force;
  return conjugate_gradients(*this, displacement, tolerance, most_iterations,
                             gradients_);
}

std::size_t LatticeMultigrid::bytes() const {
  return cycle_.bytes() + stiffness_.bytes() + contact_.springs.bytes() +
         places_.size() * sizeof(std::size_t) +
         3 * layout().size() * sizeof(double);
}

} // namespace asperity::fem
