#pragma once

// Solves for the displacement of a block on a lattice of boxes by conjugate
// gradients, preconditioned by geometric multigrid.

#include "fem/multigrid/conjugate_gradients.hpp"
#include "fem/multigrid/face_contact.hpp"
#include "fem/multigrid/lattice_operator.hpp"
#include "fem/multigrid/multigrid_cycle.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace asperity::fem {

/// K + S without a matrix, in double precision, and its inverse, where S are
/// springs on the contact surface. Unknowns that the far boundary or contact
/// holds are zero in all displacements and forces that are returned.
///
/// Ranks may share the rows of cells, as slab() says. Displacements, forces and
/// contact are then those of the rank's rows, and all calls are collective. The
/// results depend on the number of ranks by rounding only.
class LatticeMultigrid {
public:
  /// @throws std::domain_error  under the conditions of require_lattice, or if
  ///                            the block can tilt
  /// @param ranks  may be null; otherwise it must outlive this object
  explicit LatticeMultigrid(const BoxLattice& lattice,
                            RankGroup* ranks = nullptr);

  const NodeLayout& layout() const { return stiffness_.layout(); }

  const BoxLattice& lattice() const { return lattice_; } ///< without moduli

  /// The rows of this rank: all rows if there are too few to share.
  const LatticeSlab& slab() const { return stiffness_.slab(); }

  /// Computes force = K displacement, without springs; not masked at held nodes
  /// of the contact surface.
  /// @param displacement  layout().size() values [m]; the images are
  ///                      overwritten
  /// @param force         layout().size() values [N]
  void apply(std::vector<double>& displacement,
             std::vector<double>& force) const;

  /// @param contact  springs [N/m]
  void set_contact(FaceContact contact);

  /// Holds the unknowns at these places in addition. The coarse lattices ignore
  /// them, so they should be few.
  void pin(std::vector<std::size_t> places) { pinned_ = std::move(places); }

  /// Solves (K + S) displacement = force, starting from `displacement`, which
  /// must be zero at held unknowns.
  ///
  /// Rigid motions that nothing prevents (rigid_modes.hpp) require forces that
  /// are in balance; the solution then contains any such motion.
  /// @param force      [N], zero at images
  /// @param tolerance  of the l2 norm of the residual [N]
  LinearSolution solve(const std::vector<double>& force,
                       std::vector<double>& displacement, double tolerance,
                       int most_iterations);

  std::size_t levels() const { return cycle_.levels(); }

  std::size_t bytes() const; ///< on this rank

  // The parts of the iteration (conjugate_gradients.hpp).
  void clear_held(std::vector<double>& vector) const;
  void apply_all(std::vector<double>& displacement,
                 std::vector<double>& force) const;

  std::vector<float>& cycle_force() { return cycle_.force(); }

  const std::vector<float>& cycle_displacement() const {
    return cycle_.displacement();
  }

  void run_cycle() { cycle_.run(); }

private:
  BoxLattice lattice_;
  LatticeOperator<double> stiffness_;
  double unit_ = 1.0; ///< of the cycle's stiffness [N/m]
  MultigridCycle cycle_;
  FaceContact contact_;
  std::vector<std::size_t> held_; ///< places that contact holds
  std::vector<std::size_t> pinned_;
  std::vector<std::size_t> places_; ///< of the surface's nodes
  GradientVectors gradients_;
};

} // namespace asperity::fem
