#pragma once

// Solves for the displacement of a mesh by conjugate gradients, preconditioned
// by a smoother on the mesh and a correction by coarser functions, which the
// caller supplies.

#include "fem/hexahedra/smoothed_level.hpp"
#include "fem/multigrid/conjugate_gradients.hpp"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace asperity::fem {

/// K + S without a matrix, in double precision, and its inverse, where S are
/// the springs of the contact.
template <template <class> class Operator>
class MeshMultigrid {
public:
  using Mesh = typename Operator<double>::Mesh;

  /// Adds to a displacement the correction for a residual force, both in the
  /// units of the cycle and zero at constrained and held unknowns.
  using Correction = std::function<void(const std::vector<float>& residual,
                                        std::vector<float>& displacement)>;

  explicit MeshMultigrid(const Mesh& mesh)
      : stiffness_(mesh), level_(normalised(mesh, unit_)) {}

  double unit() const { return unit_; } ///< of the cycle's stiffness [N/m]

  /// An upper bound on the stiffness of an unknown against any displacement
  /// [N/m].
  double stiffness_bound(std::size_t unknown) const {
    return unit_ * level_.stiffness_bound(unknown);
  }

  Operator<double>& stiffness() { return stiffness_; }

  void set_correction(Correction correction) {
    correction_ = std::move(correction);
  }

  void set_contact(MeshContact contact) {
    springs_ = contact.springs;
    pairs_ = contact.pairs;
    for (double& spring : contact.springs.weight)
      spring /= unit_;
    for (double& spring : contact.pairs.springs)
      spring /= unit_;
    level_.set_contact(std::move(contact));
  }

  /// Computes force = K displacement, without springs; not masked at held
  /// unknowns.
  /// @param displacement  [m]; constrained values are overwritten
  void apply(std::vector<double>& displacement,
             std::vector<double>& force) const {
    force.resize(stiffness_.size());
    stiffness_.apply(displacement.data(), force.data());
  }

  /// Solves (K + S) displacement = force, starting from `displacement`, which
  /// must be zero at held unknowns.
  /// @param tolerance  of the l2 norm of the residual [N]
  /// @param vectors    their residual is the force, and is overwritten
  LinearSolution solve(std::vector<double>& displacement, double tolerance,
                       int most_iterations, GradientVectors& vectors) {
    return conjugate_gradients(*this, displacement, tolerance, most_iterations,
                               vectors);
  }

  std::size_t bytes() const {
    return stiffness_.bytes() + level_.bytes() + springs_.bytes() +
           pairs_.bytes();
  }

  // The parts of the iteration (conjugate_gradients.hpp).
  void apply_all(std::vector<double>& displacement,
                 std::vector<double>& force) const {
    force.resize(stiffness_.size());
    stiffness_.apply_own(displacement.data(), force.data());
    if (!springs_.is_empty())
      add_spring_force(springs_, level_.contact().unknowns, displacement.data(),
                       force.data());
    pairs_.add_spring_force(displacement.data(), force.data());
    stiffness_.collect(force.data());
    clear_held(force);
  }

  void clear_held(std::vector<double>& vector) const {
    level_.clear_held(vector);
  }

  std::vector<float>& cycle_force() { return level_.residual; }

  const std::vector<float>& cycle_displacement() const {
    return level_.displacement;
  }

  void run_cycle() {
    level_.smooth_before();
    if (correction_)
      level_.add_correction(correction_);
    level_.smooth_after();
  }

private:
  Operator<double> stiffness_;
  double unit_ = 1.0;
  SmoothedLevel<Operator> level_; ///< in units
  SparseRows springs_;            ///< [N/m]
  ContactPairs pairs_;            ///< [N/m]
  Correction correction_;
};

} // namespace asperity::fem
