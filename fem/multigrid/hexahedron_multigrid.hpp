#pragma once

// Solves for the displacement of a mesh of second-order hexahedra by conjugate
// gradients, preconditioned by a cycle of two levels: a smoother on the mesh
// and a correction by first-order functions, which the caller supplies.

#include "fem/multigrid/chebyshev.hpp"
#include "fem/multigrid/conjugate_gradients.hpp"
#include "fem/multigrid/hexahedron_operator.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace asperity::fem {

/// Contact as the linear solver sees it.
struct HexahedronContact {
  std::vector<std::size_t> unknowns; ///< u_z of the contact surface
  SparseRows springs;       ///< symmetric matrix on these [N/m], or no rows
  bool has_springs = false; ///< on any rank
  std::vector<std::size_t> held; ///< unknowns that are held
};

/// K + S without a matrix, in double precision, and its inverse, where S are
/// the springs of the contact.
class HexahedronMultigrid {
public:
  /// Adds to a displacement the correction for a residual force, both in the
  /// units of the cycle and zero at constrained and held unknowns.
  using Correction = std::function<void(const std::vector<float>& residual,
                                        std::vector<float>& displacement)>;

  explicit HexahedronMultigrid(const HexahedronMesh& mesh);

  double unit() const { return unit_; } ///< of the cycle's stiffness [N/m]

  void set_correction(Correction correction) {
    correction_ = std::move(correction);
  }

  void set_contact(HexahedronContact contact);

  /// Gives some cells of K tangents in place of their moduli. The cycle keeps
  /// the moduli: its levels are elastic, and the iterations grow with the
  /// square root of the largest ratio of the two stiffnesses.
  /// @param cells  each cell once
  void set_tangents(std::span<const CellTangents> cells) {
    stiffness_.set_tangents(cells);
  }

  /// Computes force = K displacement, without springs; not masked at held
  /// unknowns.
  /// @param displacement  [m]; constrained values are overwritten
  void apply(std::vector<double>& displacement,
             std::vector<double>& force) const;

  /// Solves (K + S) displacement = force, starting from `displacement`, which
  /// must be zero at held unknowns.
  /// @param tolerance  of the l2 norm of the residual [N]
  LinearSolution solve(const std::vector<double>& force,
                       std::vector<double>& displacement, double tolerance,
                       int most_iterations);

  std::size_t bytes() const;

  // The parts of the iteration (conjugate_gradients.hpp).
  void apply_all(std::vector<double>& displacement,
                 std::vector<double>& force) const;
  void clear_held(std::vector<double>& vector) const;

  std::vector<float>& cycle_force() { return own_.residual; }

  const std::vector<float>& cycle_displacement() const {
    return own_.displacement;
  }

  void run_cycle();

private:
  void soften();
  void subtract();

  HexahedronOperator<double> stiffness_;
  double unit_ = 1.0;
  HexahedronOperator<float> scaled_; ///< in units
  float eigenvalue_ = 0.0F;
  std::vector<float> inverse_; ///< of the diagonal times eigenvalue_
  std::vector<std::size_t> constrained_;
  HexahedronContact contact_;
  SparseRows scaled_springs_;
  SmoothedVectors own_;
  std::vector<float> product_;
  GradientVectors gradients_;
  Correction correction_;
};

} // namespace asperity::fem
