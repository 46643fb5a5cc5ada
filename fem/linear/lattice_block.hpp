#pragma once

// Geometric multigrid for a block whose mesh is a lattice of boxes, and what
// pins and contact points do there.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/linear/block_solver.hpp"
#include "fem/linear/lattice_exchange.hpp"
#include "fem/multigrid/lattice_multigrid.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// The lattice of a problem if its mesh consists of equal columns of boxes
/// numbered as by layered_mesh; none for other meshes and two bodies.
std::optional<BoxLattice> box_lattice(const BlockProblem& problem);

/// The stiffness of the block and its inverse on the lattice. On several ranks,
/// each solves for the nodes of its rows of cells (LatticeSlab), or all do the
/// same if there are few rows; unknowns and contact are sent there and back.
///
/// Pins (BlockSpace) that only prevent a rigid motion carry the sum of the
/// forces, and the motion is subtracted from the solution. A pin in z of a
/// block that contact supports as well is held.
class LatticeBlock : public MatrixFreeBlock {
public:
  /// @param system  its mesh is that of the lattice
  LatticeBlock(const BlockSystem& system, const BoxLattice& lattice);

  void vmult(Vector& to, const Vector& from) const override;
  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking) override;
  LinearSolution solve(Vector& unknowns, const Vector& forces, double tolerance,
                       int most_iterations) override;

  /// A decade costs one iteration. Under a pressure-loaded far boundary the
  /// response to the approach is a small difference, and without this factor it
  /// is too inaccurate for a stationary contact set.
  double tightness() const override { return 1e-3; }

  /// Contact is transferred to the same lattices.
  int setups() const override { return 1; }

  std::string name() const override;
  std::size_t bytes() const override;

  std::size_t levels() const { return multigrid_.levels(); }

private:
  struct Pin {
    std::size_t node = 0;  ///< number of the node's component on the lattice
    std::size_t place = 0; ///< in a vector of this rank, or nowhere
    unsigned int component = 0;
  };

  LatticeBlock(const BlockSystem& system, const BoxLattice& lattice,
               const LatticeNumbering& numbering);
  void take_pins(const LatticeNumbering& numbering);
  void find_modes();
  std::vector<double> at_pins(const std::vector<double>& right_sides,
                              bool is_transposed) const;
  void balance_forces();
  void remove_motions();

  RankGroup* ranks_; ///< null if there is only one
  LatticeMultigrid multigrid_;
  LatticeExchange exchange_;
  std::vector<Pin> pins_; ///< the same on all ranks
  bool has_contact_ = false;
  std::vector<Pin> loose_;             ///< pins that hold a rigid motion only
  std::vector<std::size_t> held_pins_; ///< places of the others
  std::vector<std::vector<double>> modes_; ///< as many rigid motions
  std::vector<double> at_loose_;           ///< each motion at each of these
  mutable std::vector<double> from_, to_;
};

} // namespace asperity::fem
