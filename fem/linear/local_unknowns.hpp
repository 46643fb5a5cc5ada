#pragma once

// The unknowns that the cells of this rank need, numbered for vectors without
// deal.II: its own ones, then those of other ranks.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/hexahedra/hexahedron_operator.hpp"
#include "fem/hexahedra/smoothed_level.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ranks/ghost_values.hpp"

namespace asperity::fem {

/// Numbers the unknowns of hexahedra by node: those of this rank in the order
/// of their global numbers, then the ghosts, which are the nodes of its cells
/// that other ranks own, the masters of all these and what else is needed. On
/// one process the numbers are the global ones.
class LocalUnknowns {
public:
  using Unknown = dealii::types::global_dof_index;

  /// This call is collective.
  /// @param needed  further unknowns
  LocalUnknowns(const BlockSpace& space, const dealii::IndexSet& needed);

  std::size_t size() const { return owned() + 3 * ghost_nodes_.size(); }

  std::size_t owned() const { return owned_.n_elements(); }

  std::size_t of(Unknown unknown) const;

  std::vector<Unknown> global() const; ///< number of each unknown

  /// As BlockSpace::cell_nodes(), in these numbers.
  const std::vector<std::uint32_t>& cell_nodes() const { return cell_nodes_; }

  void forget_cells() { cell_nodes_ = {}; } ///< frees their memory

  /// The constraints of the unknowns of cells.
  const SharedConstraints& constraints() const { return constraints_; }

  /// Null on one process.
  const GhostValues* ghosts() const { return ghosts_.get(); }

  std::size_t bytes() const;

private:
  void find_ghosts(const BlockSpace& space, const dealii::IndexSet& needed);
  void take_constraints(const BlockSpace& space);

  dealii::IndexSet owned_;
  Unknown first_ = 0;
  std::vector<std::size_t> ghost_nodes_; ///< global numbers, increasing
  std::unique_ptr<GhostValues> ghosts_;
  std::vector<std::uint32_t> cell_nodes_;
  SharedConstraints constraints_;
};

/// The contact of a block for the linear solver of its mesh [m, N]. This call
/// is collective.
/// @param unknowns  must outlive the result
/// @param springs, held, is_sticking  as BlockSolver::set_contact has them
/// @param is_pair  whether each point is a contact pair; or empty, on all ranks
MeshContact mesh_contact(const BlockSystem& system,
                         const LocalUnknowns& unknowns,
                         std::span<const double> springs,
                         const std::vector<bool>& held, bool is_sticking,
                         const std::vector<bool>& is_pair = {});

} // namespace asperity::fem
