#include "fem/multigrid/mesh_multigrid.hpp"

namespace asperity::fem {

MeshMultigrid::MeshMultigrid(MeshStiffness stiffness)
    : stiffness_(std::move(stiffness.in_si)),
      unit_(stiffness.unit),
      level_(std::move(stiffness.in_units), stiffness.diagonal,
             stiffness.bound) {
  vectors_.ranks = unknowns().ranks();
}

void MeshMultigrid::set_contact(MeshContact contact) {
  level_.set_contact(contact.in_units_of(unit_));
  contact_ = std::move(contact);
}

void MeshMultigrid::apply(std::vector<double>& displacement,
                          std::vector<double>& force) const {
  force.resize(stiffness_->size());
  stiffness_->apply(displacement.data(), force.data());
}

void MeshMultigrid::apply_all(std::vector<double>& displacement,
                              std::vector<double>& force) const {
  force.resize(stiffness_->size());
  stiffness_->apply_own(displacement.data(), force.data());
  contact_.add_spring_force(displacement.data(), force.data());
  contact_.pairs.add_spring_force(displacement.data(), force.data());
  unknowns().collect(force.data());
  clear_held(force);
}

void MeshMultigrid::run_cycle() {
  level_.smooth_before();
  if (correction_)
    level_.add_correction(correction_);
  level_.smooth_after();
}

std::size_t MeshMultigrid::bytes() const {
  return stiffness_->bytes() + level_.bytes() + contact_.bytes() +
         3 * unknowns().size * sizeof(double);
}

} // namespace asperity::fem
