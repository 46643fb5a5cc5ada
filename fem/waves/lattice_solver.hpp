#pragma once

// Exact solution for the full 3-D, laterally uniform block by fast
// diagonalisation in lateral Fourier space, with or without springs on its
// contact surface. It preconditions blocks that are not exactly uniform. This
// header does not depend on deal.II.

#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/lattice_share.hpp"
#include "fem/waves/spring_solve.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace asperity::fem {

/// The nodes of a block of boxes, periodic in x and y: planes of grid nodes
/// from the contact surface upwards, including the far boundary; degree 2 has a
/// further plane at mid-height of each layer. Vectors on it hold component c of
/// a node at
///
///     (plane * 3 + c) * grid.size() + grid.index(ix, iy).
struct NodeLattice {
  Grid grid;
  int degree = 1;
  std::size_t planes = 0;

  std::size_t size() const { return 3 * planes * grid.size(); }

  std::size_t index(std::size_t plane, std::size_t component,
                    std::size_t node) const {
    return (3 * plane + component) * grid.size() + node;
  }
};

/// Computes u = K^-1 f or (K + springs)^-1 f, where K is deal.II's stiffness
/// matrix of the uniform block with FE_Q(degree) and QGauss(degree + 1).
///
/// A solve transforms all planes, eliminates by (L.1) to (L.3) and transforms
/// back. With springs d_i at nodes of the contact surface, the forces q that
/// they carry are computed between elimination and back-substitution from
///
///     (D^-1 + C_0) q = u_0,   C_0 = (K^-1)_zz of the face,             (L.4)
///
/// where u_0 is the displacement of the contact surface without springs. (L.4)
/// is solved by conjugate gradients on the nodes with springs. The
/// preconditioner is (c + C_0)^-1 on the complete surface, restricted to these
/// nodes, where c is the mean of 1/d_i by node class. The cost is therefore
/// independent of the stiffness of a spring, including a held node (D^-1 = 0).
///
/// Rigid motions that K does not prevent at q = 0 (a lateral shift with a
/// sliding far boundary, any shift with a pressure-loaded one) are held by a
/// spring on the far boundary. Under balanced loads it carries no force, and u
/// is correct up to that shift. With a pressure-loaded far boundary, springs on
/// the contact surface hold the block in z themselves, so that
/// sum_i q_i = sum f_z exactly.
///
/// Several ranks share the fields and the wavevectors (LatticeShare); every
/// rank solves the surface problem (L.4) itself. The result is bitwise
/// independent of the number of ranks.
///
/// Both solution operators are linear in f, symmetric and positive: the first
/// to roundoff, the second to its tolerance. If that tolerance is far above
/// that of an outer conjugate-gradient method, the outer method must be a
/// flexible one.
class LatticeSolver {
public:
  /// @param grid     nodes of the contact surface, as in BlockSystem
  /// @param degree   1 or 2
  /// @param threads  used by each solve; the result is bitwise independent of
  ///                 it
  /// @param among    the processes that share the work; with all ranks every
  ///                 call except lattice() and bytes() is collective
  /// @throws std::domain_error  an argument is outside its range
  LatticeSolver(const Grid& grid, int degree, const LayeredBlock& block,
                int threads = 1, Among among = Among::this_process);
  ~LatticeSolver();

  const NodeLattice& lattice() const;

  const LatticeShare& share() const;

  /// Memory of this rank's factors and of the spectra [bytes]. Per cell layer,
  /// the factors take 15 numbers for degree 1 and 588 for degree 2 for each
  /// wavevector of a quarter of the cell wavevectors (for degree 2 this quarter
  /// is a sixteenth of the number of grid nodes).
  std::size_t bytes() const;

  /// Computes u = K^-1 f. Each rank reads and writes only its own fields of
  /// force and displacement, share().fields(); the field number is
  /// 3 plane + component.
  /// @param force         lattice().size() values [N]; not read at held
  ///                      unknowns of the far boundary
  /// @param displacement  lattice().size() values [m], overwritten; 0 where the
  ///                      far boundary is held. It may be `force`.
  void solve(std::span<const double> force, std::span<double> displacement);

  /// Sets the springs on u_z of the contact surface.
  /// @param springs  grid.size() values [N/m] >= 0, equal on each rank: 0 for
  ///                 no spring, infinity for a held node
  /// @throws std::domain_error  a wrong size, or a value that is out of range
  void set_springs(std::span<const double> springs);

  /// Computes u = (K + springs)^-1 f.
  /// @param tolerance  residual of (L.4) in the 2-norm on the nodes with
  ///                   springs, relative to u_0 [1] > 0
  SpringSolve solve_with_springs(std::span<const double> force,
                                 std::span<double> displacement,
                                 double tolerance = 1e-12);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace asperity::fem
