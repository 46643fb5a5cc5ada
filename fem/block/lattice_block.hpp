#pragma once

// Geometric multigrid for a block whose mesh is a lattice of boxes: which
// unknown is at which of its nodes, and what pins and contact points do there.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_solver.hpp"
#include "fem/block/block_system.hpp"
#include "fem/multigrid/lattice_multigrid.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// The lattice of a problem if its mesh consists of equal columns of boxes
/// numbered as by layered_mesh; none for other meshes, two bodies and several
/// ranks.
std::optional<BoxLattice> box_lattice(const BlockProblem& problem);

/// The stiffness of the block and its inverse on the lattice, on one rank.
///
/// Pins (BlockSpace) that only prevent a rigid motion carry the sum of the
/// forces, and the motion is subtracted from the solution. A pin in z of a
/// block that contact supports as well is held.
class LatticeBlock : public MatrixFreeBlock {
public:
  /// @param system must outlive this object; its mesh is that of the lattice
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
    std::size_t place = 0;
    unsigned int component = 0;
  };

  void number_unknowns();
  void number_cell(const dealii::DoFHandler<3>::active_cell_iterator& cell);
  void take(dealii::types::global_dof_index unknown, unsigned int component,
            std::size_t place);
  void number_points();
  void to_lattice(const Vector& from, std::vector<double>& to) const;
  void from_lattice(const std::vector<double>& from, Vector& to) const;
  void find_modes();
  std::vector<double> at_pins(const std::vector<double>& right_sides,
                              bool is_transposed) const;

  const BlockSystem& system_;
  LatticeMultigrid multigrid_;
  std::vector<double> depths_;      ///< of the sides of the layers [m]
  std::vector<std::size_t> places_; ///< on the lattice, of each unknown
  std::vector<Pin> pins_;
  SparseRows points_; ///< contact points by face nodes
  bool has_contact_ = false;
  std::vector<Pin> loose_; ///< pins that hold a rigid motion only
  std::vector<std::vector<double>> modes_; ///< as many rigid motions
  mutable std::vector<double> from_, to_;
};

} // namespace asperity::fem
