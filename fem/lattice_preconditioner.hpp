#pragma once

// The lattice solver as preconditioner of a distributed block: which unknown is
// which node of the lattice. Include from .cpp files of fem/ only.

#include "fem/block_solver.hpp"
#include "fem/lattice_solver.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace asperity::fem {

/// (K_0 + springs)^-1 of the laterally uniform block K_0 nearest to a periodic
/// one on the same lattice. Every rank gathers the residual, solves for all of
/// it and keeps its own: the work is not divided among ranks.
///
/// A component whose rigid shift only a pin holds is solved balanced: the pin
/// bears the sum of the forces, and the shift is taken off until it rests.
class LatticePreconditioner final : public BlockPreconditioner {
public:
  /// @param system   periodic, its mesh the lattice of `uniform` on the grid
  /// @throws std::domain_error  an unknown is at no node of the lattice
  LatticePreconditioner(const BlockSystem& system, int degree,
                        const LayeredBlock& uniform);

  /// Springs at Gauss points count for the nodes around by their shape values.
  void prepare(std::span<const double> springs,
               const std::vector<bool>& held) override;

  void vmult(dealii::TrilinosWrappers::MPI::Vector& to,
             const dealii::TrilinosWrappers::MPI::Vector& from) override;

  std::string name() const override;

  std::size_t bytes() const override { return solver_.bytes(); }

private:
  void number_unknowns(const LayeredBlock& uniform);
  std::size_t lattice_index(const dealii::Point<3>& place,
                            std::size_t component) const;
  void find_pins(cases::TopFace top);
  void share_numbers();
  void gather(const dealii::TrilinosWrappers::MPI::Vector& from);
  void balance();
  void rest();

  const BlockSystem& system_;
  LatticeSolver solver_;
  std::vector<double> plane_depths_;     ///< of the lattice's planes [m]
  std::vector<std::size_t> own_numbers_; ///< on the lattice, in owned() order;
                                         ///< constrained ones have `nowhere`
  std::vector<std::size_t> all_numbers_; ///< of all ranks, in their order
  std::vector<int> counts_, starts_;     ///< of each rank among these
  std::array<std::optional<std::size_t>, 3> pins_; ///< a component
  bool has_springs_ = false;
  std::vector<double> lattice_values_, own_values_, all_values_;
};

} // namespace asperity::fem
