#pragma once

// The whole laterally uniform block solved exactly by its lateral waves, with
// or without springs under its contact face: the preconditioner of a block
// that is not quite uniform. Nothing of deal.II shows here.

#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/lattice_share.hpp"
#include "fem/waves/spring_solve.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace asperity::fem {

/// The nodes of a block of boxes, periodic in x and y: planes of grid nodes
/// from the contact face up, top included; degree 2 has a plane half way up
/// each layer. Vectors on it hold component c of a node at
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

/// u = K^-1 f, or (K + springs)^-1 f, K deal.II's stiffness of the uniform
/// block with FE_Q(degree) and QGauss(degree + 1).
///
/// Transforms of all planes, elimination by (L.1) to (L.3), transforms back.
/// With springs d_i under face nodes, between elimination and
/// back-substitution, the forces q they bear come from
///
///     (D^-1 + C_0) q = u_0,   C_0 = (K^-1)_zz of the face,             (L.4)
///
/// u_0 the face's displacement without springs, by conjugate gradients on the
/// nodes with springs; the preconditioner is (c + C_0)^-1 on the whole face,
/// masked to them, c the mean of 1/d_i by kind. So a spring costs the same at
/// any stiffness, a held node (D^-1 = 0) included.
///
/// What K leaves free at q = 0 (lateral shift under a sliding top, any shift
/// under a pressed one) has a spring on the top: under balanced loads it bears
/// nothing, and u is right up to that shift. Springs under a pressed top hold
/// it in z themselves: then sum_i q_i = sum f_z exactly.
///
/// Several ranks divide fields and waves among them (LatticeShare); the face's
/// problem (L.4) every rank solves for itself. The number of ranks changes no
/// bit.
///
/// Both answers are linear in f, symmetric and positive: the first to rounding,
/// the second to its tolerance, so a tolerance far above that of an outer
/// conjugate-gradient method asks for a flexible one.
class LatticeSolver {
public:
  /// @param grid    nodes of the contact face, as BlockSystem's
  /// @param degree  1 or 2
  /// @param threads used by each solve; changes no bit
  /// @param among   who divides the work; with all ranks every call but
  ///                lattice() and bytes() is collective
  /// @throws std::domain_error  an argument is outside its range
  LatticeSolver(const Grid& grid, int degree, const LayeredBlock& block,
                int threads = 1, Among among = Among::this_process);
  ~LatticeSolver();

  const NodeLattice& lattice() const;

  const LatticeShare& share() const;

  /// Memory of this rank's factors and of the spectra [B]. A cell layer and a
  /// fourth of the lattice's wavevectors keep 15 numbers for degree 1, 588 for
  /// degree 2 (a fourth of its wavevectors is a sixteenth of the nodes).
  std::size_t bytes() const;

  /// u = K^-1 f. Of force and displacement each rank reads and writes its own
  /// fields only, share().fields(); field 3 plane + component.
  /// @param force         lattice().size() values [N]; at held unknowns of the
  ///                      top they are not read
  /// @param displacement  lattice().size() values [m], overwritten; 0 where
  ///                      the top is held. May be `force`.
  void solve(std::span<const double> force, std::span<double> displacement);

  /// @param springs  the same on each rank, grid.size() values on u_z of the
  /// face [N/m] >= 0: 0 for
  ///                 none, infinity holds the node
  /// @throws std::domain_error  a wrong size, or a value that is out of range
  void set_springs(std::span<const double> springs);

  /// u = (K + springs)^-1 f.
  /// @param tolerance  left of (L.4), 2-norms on the nodes with springs,
  ///                   relative to u_0 [1] > 0
  SpringSolve solve_with_springs(std::span<const double> force,
                                 std::span<double> displacement,
                                 double tolerance = 1e-12);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace asperity::fem
