#pragma once

// Which rows of cells of a grid of boxes a process holds, and the order of
// their unknowns.

#include "base/ranks/rank_sums.hpp"
#include "base/ranks/shared_rows.hpp"
#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_grid.hpp"
#include "fem/multigrid/unknown_layout.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// The rows of cells along y that this process holds: all of them, or its share
/// of those that the ranks of a group hold together.
class BoxGridSlab : public SharedRows {
public:
  /// This process holds all rows.
  explicit BoxGridSlab(const BoxGrid& box_grid);

  /// @param bounds  as SharedRows has them, of rows of cells
  BoxGridSlab(const BoxGrid& box_grid, RankGroup& ranks,
              std::vector<int> bounds);

  bool is_shared() const { return ranks() != nullptr; }

  /// The order of the nodes of these rows in vectors.
  NodeLayout layout(const BoxGrid& box_grid) const;

  /// The axis y of these rows, with the image slice if they are shared.
  BoxGridAxis axis_y(const BoxGrid& box_grid) const;

  /// The rank that holds a slice of nodes of the whole grid of boxes.
  int rank_of(int slice, int degree) const;

  /// The sum over the ranks, in their order, so that each has the same bits.
  double sum(double own) const { return rank_sum(ranks(), own); }
};

/// The unknowns of these rows: periodic images and supports of the far boundary
/// are constrained, and the first slice of the next rank follows those of this
/// one. Collective if the rows are shared.
UnknownLayout unknowns_of(const BoxGrid& box_grid, const BoxGridSlab& slab);

/// Finds nodes of the whole grid of boxes in the vectors of a slab. The number
/// of a node's component is its index in a vector of the whole grid of boxes.
class SlabPlaces {
public:
  static constexpr auto nowhere = static_cast<std::size_t>(-1);

  SlabPlaces(const BoxGrid& box_grid, const BoxGridSlab& slab);

  int slice_of(std::size_t node) const { ///< on the whole grid of boxes
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

/// Divides a grid of boxes among ranks so that their boundaries are, as far as
/// the shares differ little, also those of rows of coarser grids of boxes.
/// @param ranks  may be null
/// @return  all rows if there are too few to share
BoxGridSlab divided(const BoxGrid& box_grid, RankGroup* ranks);

/// The rows of the next coarser grid of boxes: those that consist of this
/// process's rows; all rows if there are too few or if they do not consist of
/// whole rows.
BoxGridSlab coarser(const BoxGrid& box_grid, const BoxGridSlab& slab,
                    const BoxGrid& coarse);

} // namespace asperity::fem
