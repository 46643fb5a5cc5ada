#pragma once

// Which unknown of a block is at which node of its lattice of boxes, and how
// unknowns and contact get from the rank that has them in deal.II's numbering
// to the rank that has the rows of the lattice, and back.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/linear/unknown_exchange.hpp"
#include "fem/multigrid/lattice_slab.hpp"
#include "fem/multigrid/mesh_contact.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace asperity::fem {

/// The nodes of the unknowns on the cells of this rank. The number of a node's
/// component is its index in a vector of the whole lattice (NodeLayout).
struct LatticeNumbering {
  struct Pin {
    std::size_t node = 0;
    unsigned int component = 0;
  };

  /// Of each unknown that this rank owns, or SlabPlaces::nowhere if it is
  /// constrained.
  std::vector<std::size_t> nodes;
  /// Of each unconstrained u_z on the contact surface; periodic images count as
  /// their roots.
  std::map<dealii::types::global_dof_index, std::size_t> face;
  std::vector<Pin> pins; ///< unknowns held that the far boundary does not hold

  LatticeNumbering(const BlockSystem& system, const BoxLattice& lattice);

private:
  void add_cell(const BlockSystem& system, const BoxLattice& lattice,
                const dealii::DoFHandler<3>::active_cell_iterator& cell);
  void take(const BlockSpace& space, const BoxLattice& lattice,
            dealii::types::global_dof_index unknown, unsigned int component,
            std::size_t node);

  dealii::types::global_dof_index first_owned_ = 0;
  NodeLayout layout_;          ///< of the whole lattice
  std::vector<double> depths_; ///< of the sides of the layers [m]
};

/// All calls are collective.
class LatticeExchange {
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// @param slab   the rows of this rank
  /// @param ranks  null if there is only one
  LatticeExchange(const BlockSystem& system, const BoxLattice& lattice,
                  const LatticeSlab& slab, RankGroup* ranks,
                  const LatticeNumbering& numbering);

  /// Sets the values on the lattice, zero at images and constrained unknowns.
  void to_lattice(const Vector& from, std::vector<double>& to) const;

  /// Sets the unknowns, zero if constrained.
  void from_lattice(const std::vector<double>& from, Vector& to) const;

  /// The contact of the slab.
  /// @param springs, held  of the contact points of this rank
  MeshContact contact(std::span<const double> springs,
                      const std::vector<bool>& held, bool is_sticking) const;

  std::size_t bytes() const;

private:
  static UnknownExchange unknowns_of(const BoxLattice& lattice,
                                     const LatticeSlab& slab, RankGroup* ranks,
                                     const LatticeNumbering& numbering);
  void number_points(const BlockSystem& system, const BoxLattice& lattice,
                     const LatticeSlab& slab,
                     const LatticeNumbering& numbering);

  RankGroup* ranks_;
  RankGroup* sharing_; ///< the same, but null if each has all rows
  std::size_t size_;   ///< of a vector of the slab
  UnknownExchange unknowns_;
  std::vector<std::size_t> order_; ///< contact points of this rank by target
  SparseRows points_; ///< contact points received, by places on the slab
  std::unique_ptr<ValueExchange> point_values_; ///< null on one rank
};

} // namespace asperity::fem
