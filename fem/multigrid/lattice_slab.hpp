#pragma once

// Which rows of cells of a lattice a process holds, and the order of their
// unknowns.

#include "base/ranks/rank_sums.hpp"
#include "base/ranks/shared_rows.hpp"
#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_lattice.hpp"
#include "fem/multigrid/unknown_layout.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// The rows of cells along y that this process holds: all of them, or its share
/// of those that the ranks of a group hold together.
class LatticeSlab : public SharedRows {
public:
  /// This process holds all rows.
  explicit LatticeSlab(const BoxLattice& lattice);

  /// @param bounds  as SharedRows has them, of rows of cells
  LatticeSlab(const BoxLattice& lattice, RankGroup& ranks,
              std::vector<int> bounds);

  bool is_shared() const { return ranks() != nullptr; }

  /// The order of the nodes of these rows in vectors.
  NodeLayout layout(const BoxLattice& lattice) const;

  /// The axis y of these rows, with the image slice if they are shared.
  LatticeAxis axis_y(const BoxLattice& lattice) const;

  /// The rank that holds a slice of nodes of the whole lattice.
  int rank_of(int slice, int degree) const;

  /// The sum over the ranks, in their order, so that each has the same bits.
  double sum(double own) const { return rank_sum(ranks(), own); }
};

/// The unknowns of these rows: periodic images and supports of the far boundary
/// are constrained, and the first slice of the next rank follows those of this
/// one. Collective if the rows are shared.
UnknownLayout unknowns_of(const BoxLattice& lattice, const LatticeSlab& slab);

/// Finds nodes of the whole lattice in the vectors of a slab. The number of a
/// node's component is its index in a vector of the whole lattice.
class SlabPlaces {
public:
  static constexpr auto nowhere = static_cast<std::size_t>(-1);

  SlabPlaces(const BoxLattice& lattice, const LatticeSlab& slab);

  int slice_of(std::size_t node) const { ///< on the whole lattice
    return static_cast<int>(node / whole_.slice_size());
  }

  /// The index in a vector of the slab, or nowhere; never an image.
  std::size_t of(std::size_t node) const;

  /// The same, but that of an image if the node is at the next rank.
  std::size_t with_images(std::size_t node) const;

private:
  NodeLayout whole_, own_;
  int first_; ///< slice
  bool is_shared_;
};

/// Divides a lattice among ranks so that their boundaries are, as far as the
/// shares differ little, also those of rows of coarser lattices.
/// @param ranks  may be null
/// @return  all rows if there are too few to share
LatticeSlab divided(const BoxLattice& lattice, RankGroup* ranks);

/// The rows of the next coarser lattice: those that consist of this process's
/// rows; all rows if there are too few or if they do not consist of whole rows.
LatticeSlab coarser(const BoxLattice& lattice, const LatticeSlab& slab,
                    const BoxLattice& coarse);

} // namespace asperity::fem
