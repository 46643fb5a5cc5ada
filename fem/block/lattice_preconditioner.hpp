#pragma once

// The lattice solver as preconditioner of a distributed block: which unknown is
// which node of the lattice. Include from .cpp files of fem/ only.

#include "fem/block/block_solver.hpp"
#include "fem/waves/lattice_solver.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace asperity::fem {

/// (K_0 + springs)^-1 of the laterally uniform block K_0 nearest to a periodic
/// one on the same lattice. The residual goes to the ranks that solve for its
/// fields, as LatticeShare divides them, and the answer back.
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

  std::string failure() const override;

  std::size_t bytes() const override { return solver_.bytes(); }

private:
  void number_unknowns(const LayeredBlock& uniform);
  std::size_t lattice_index(const dealii::Point<3>& place,
                            std::size_t component) const;
  void agree_on_numbers();
  void send(const dealii::TrilinosWrappers::MPI::Vector& from);
  void send_back(dealii::TrilinosWrappers::MPI::Vector& to);
  template <class DoPin>
  void each_pin(const DoPin& do_pin);
  void balance();
  void rest();

  const BlockSystem& system_;
  LatticeSolver solver_;
  std::vector<double> plane_depths_;     ///< of the lattice's planes [m]
  std::vector<std::size_t> own_numbers_; ///< on the lattice, in owned() order;
                                         ///< constrained ones have `nowhere`

  struct Mail {
    std::vector<int> counts, starts; ///< of each rank
    std::vector<std::size_t> at;     ///< where each value is, rank after rank
    std::vector<double> values;
  };

  Mail unknowns_; ///< from and to the own unknowns
  Mail lattice_;  ///< to and from the fields of this rank
  std::array<std::optional<std::size_t>, 3> pins_; ///< a component
  bool has_springs_ = false;
  bool has_converged_ = true; ///< each surface problem since prepare()
  std::vector<double> lattice_values_;
};

} // namespace asperity::fem
