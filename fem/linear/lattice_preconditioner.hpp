#pragma once

// The Fourier solver as preconditioner of a distributed block. This file maps
// unknowns to nodes of the regular node grid.
// Include this header in .cpp files of fem/ only.

#include "fem/linear/block_solver.hpp"
#include "fem/linear/unknown_exchange.hpp"
#include "fem/multigrid/box_lattice.hpp"
#include "fem/waves/lattice_solver.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace asperity::fem {

/// Applies (K_0 + springs)^-1, where K_0 is the stiffness of the laterally
/// uniform block nearest to a periodic block on the same node grid. The
/// residual is sent to the ranks that solve for its fields, as LatticeShare
/// distributes them, and the result is sent back.
///
/// A displacement component whose rigid shift is prevented by a pin only is
/// solved under balanced forces: the pin carries the sum of the forces, and the
/// shift is then subtracted so that the pin does not move.
class LatticePreconditioner final : public BlockPreconditioner {
public:
  /// @param system   must be periodic
  /// @param lattice  the mesh of the system
  /// @param uniform  with the layers of the lattice
  LatticePreconditioner(const BlockSystem& system, const BoxLattice& lattice,
                        const LayeredBlock& uniform);

  /// Springs at Gauss points are distributed to the surrounding nodes by their
  /// shape values.
  void prepare(std::span<const double> springs,
               const std::vector<bool>& held) override;

  void vmult(dealii::TrilinosWrappers::MPI::Vector& to,
             const dealii::TrilinosWrappers::MPI::Vector& from) override;

  std::string name() const override;

  std::string failure() const override;

  std::size_t bytes() const override { return solver_.bytes(); }

private:
  void number_unknowns(const BoxLattice& lattice);
  template <class DoPin>
  void each_pin(const DoPin& do_pin);
  void balance();
  void rest();

  const BlockSystem& system_;
  LatticeSolver solver_;
  /// Numbers on the node grid, in owned() order; constrained unknowns have
  /// `nowhere`.
  std::vector<std::size_t> own_numbers_;

  std::optional<UnknownExchange> unknowns_;
  std::array<std::optional<std::size_t>, 3> pins_; ///< one per component
  bool has_springs_ = false;
  bool has_converged_ = true; ///< whether all solves of (L.4) since prepare()
                              ///< converged
  std::vector<double> lattice_values_;
};

} // namespace asperity::fem
