#pragma once

// The unknowns that the cells of this rank need, numbered for vectors without
// deal.II: its own ones, then those of other ranks.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/multigrid/mesh_contact.hpp"
#include "fem/multigrid/unknown_layout.hpp"

#include <cstdint>
#include <vector>

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

  /// With the constraints of the unknowns of cells.
  const UnknownLayout& layout() const { return layout_; }

  std::size_t size() const { return layout_.size; }

  std::size_t owned() const { return owned_.n_elements(); }

  std::size_t of(Unknown unknown) const;

  std::vector<Unknown> global() const; ///< number of each unknown

  /// As BlockSpace::cell_nodes(), in these numbers.
  const std::vector<std::uint32_t>& cell_nodes() const { return cell_nodes_; }

  void forget_cells() { cell_nodes_ = {}; } ///< frees their memory

  std::size_t bytes() const;

private:
  void find_ghosts(const BlockSpace& space, const dealii::IndexSet& needed);
  void take_constraints(const BlockSpace& space);

  dealii::IndexSet owned_;
  Unknown first_ = 0;
  std::vector<std::size_t> ghost_nodes_; ///< global numbers, increasing
  std::vector<std::uint32_t> cell_nodes_;
  UnknownLayout layout_;
};

/// The values of shape functions at the contact points, a row per point, by
/// these unknowns.
SparseRows contact_rows(const BlockSystem& system,
                        const LocalUnknowns& unknowns);

} // namespace asperity::fem
