#pragma once

// Solves for the displacement of a mesh by conjugate gradients, preconditioned
// by a smoother on the mesh and a correction by coarser functions, which the
// caller supplies.

#include "fem/multigrid/conjugate_gradients.hpp"
#include "fem/multigrid/mesh_units.hpp"
#include "fem/multigrid/smoothed_level.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace asperity::fem {

/// The stiffness of a mesh in both precisions.
struct MeshStiffness {
  std::unique_ptr<MeshOperator<double>> in_si; ///< [N/m]
  double unit = 1.0;                           ///< of the stiffness below [N/m]
  std::unique_ptr<MeshOperator<float>> in_units;
  std::vector<double> diagonal; ///< of the latter, as SmoothedLevel needs it
  double bound = no_bound;      ///< as SmoothedLevel needs it
};

/// @tparam Operator  HexahedronOperator or BoxOperator
template <template <class> class Operator>
MeshStiffness stiffness_of(const typename Operator<double>::Mesh& mesh,
                           const MeshUnits& units) {
  const auto in_units = scaled(mesh, units);
  return {std::make_unique<Operator<double>>(mesh), units.stiffness(),
          std::make_unique<Operator<float>>(in_units), diagonal_of(in_units)};
}

/// K + S without a matrix, in double precision, and its inverse, where S are
/// the springs of the contact. Unknowns that constraints or contact determine
/// are zero in all displacements and forces that are returned. Calls are
/// collective; the results depend on the number of ranks by rounding only.
class MeshMultigrid {
public:
  /// Adds to a displacement the correction for a residual force, both in the
  /// units of the cycle and zero at constrained and held unknowns.
  using Correction = std::function<void(const std::vector<float>& residual,
                                        std::vector<float>& displacement)>;

  explicit MeshMultigrid(MeshStiffness stiffness);

  const UnknownLayout& unknowns() const { return stiffness_->layout(); }

  MeshOperator<double>& stiffness() { return *stiffness_; }

  double unit() const { return unit_; } ///< of the cycle's stiffness [N/m]

  /// An upper bound on the stiffness of an unknown against any displacement
  /// [N/m].
  double stiffness_bound(std::size_t unknown) const {
    return unit_ * level_.stiffness_bound(unknown);
  }

  void set_correction(Correction correction) {
    correction_ = std::move(correction);
  }

  void set_contact(MeshContact contact); ///< springs [N/m]

  /// Computes force = K displacement, without springs; not masked at held
  /// unknowns.
  /// @param displacement  [m]; constrained values are overwritten
  void apply(std::vector<double>& displacement,
             std::vector<double>& force) const;

  /// The force of the next solve(), to be written before it [N]; zero at
  /// constrained unknowns and those of other ranks.
  std::vector<double>& force() { return vectors_.residual; }

  /// Solves (K + S) displacement = force(), which becomes the residual,
  /// starting from `displacement`, which must be zero at held unknowns.
  /// @param tolerance  of the l2 norm of the residual [N]
  LinearSolution solve(std::vector<double>& displacement, double tolerance,
                       int most_iterations) {
    return conjugate_gradients(*this, displacement, tolerance, most_iterations,
                               vectors_);
  }

  std::size_t bytes() const;

  // The parts of the iteration (conjugate_gradients.hpp).
  void apply_all(std::vector<double>& displacement,
                 std::vector<double>& force) const;

  void clear_held(std::vector<double>& vector) const {
    level_.clear_held(vector);
  }

  std::vector<float>& cycle_force() { return level_.residual; }

  const std::vector<float>& cycle_displacement() const {
    return level_.displacement;
  }

  void run_cycle();

private:
  std::unique_ptr<MeshOperator<double>> stiffness_;
  double unit_;
  SmoothedLevel level_; ///< in units
  MeshContact contact_; ///< [N/m]
  GradientVectors vectors_;
  Correction correction_;
};

} // namespace asperity::fem
