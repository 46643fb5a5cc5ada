#pragma once

// Which rows of cells of a lattice a process holds, what it exchanges with the
// processes beside it, and sums over all of them.

#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_lattice.hpp"

#include <cstddef>
#include <span>
#include <vector>

#include "ranks/rank_sums.hpp"

namespace asperity::fem {

/// The rows of cells along y that this process holds: all of them, or its share
/// of those that the ranks of a group hold together. The calls that exchange
/// something are collective if the rows are shared.
class LatticeSlab {
public:
  /// This process holds all rows.
  explicit LatticeSlab(const BoxLattice& lattice);

  /// @param ranks   must outlive this object
  /// @param bounds  rank r holds the rows bounds[r]..bounds[r+1]-1, at least
  ///                one; ranks.size() + 1 values from 0 to lattice.cells_y
  /// @throws std::domain_error  the bounds are not of this kind
  LatticeSlab(const BoxLattice& lattice, RankGroup& ranks,
              std::vector<int> bounds);

  /// The group of ranks, null if this process holds all rows.
  RankGroup* ranks() const { return ranks_; }

  bool is_shared() const { return ranks_ != nullptr; }

  const std::vector<int>& bounds() const { return bounds_; }

  int first() const { return bounds_[own_]; }

  int count() const { return bounds_[own_ + 1] - bounds_[own_]; }

  /// The order of the nodes of these rows in vectors.
  NodeLayout layout(const BoxLattice& lattice) const;

  /// The axis y of these rows, with the image row if they are shared.
  LatticeAxis axis_y(const BoxLattice& lattice) const;

  /// The rank that holds a row of nodes of the whole lattice.
  int rank_of(int node_row, int degree) const;

  /// The sum over the ranks, in their order, so that each has the same bits.
  double sum(double own) const { return rank_sum(ranks_, own); }

  void sum(std::span<double> own) const;

  /// The first row of nodes of the next rank, of this one's first row.
  /// @param own   values of the first row
  /// @param next  receives as many, if the last row is an image
  template <class Number>
  void copy_to_previous(std::span<const Number> own,
                        std::span<Number> next) const {
    ranks_->pass(RankGroup::Direction::backwards,
                 std::as_bytes(own.first(has_previous_ ? own.size() : 0)),
                 std::as_writable_bytes(
                     next.first(has_next_ ? next.size() : std::size_t{0})));
  }

  /// The image row of the previous rank, of this one's image row.
  /// @param own       values of the image row
  /// @param previous  receives as many, unless there is no previous rank; then
  ///                  it keeps its values
  template <class Number>
  void pass_to_next(std::span<const Number> own,
                    std::span<Number> previous) const {
    ranks_->pass(RankGroup::Direction::forwards,
                 std::as_bytes(own.first(has_next_ ? own.size() : 0)),
                 std::as_writable_bytes(previous.first(
                     has_previous_ ? previous.size() : std::size_t{0})));
  }

private:
  RankGroup* ranks_ = nullptr;
  std::vector<int> bounds_;
  std::size_t own_ = 0; ///< number of this rank
  bool has_previous_ = false, has_next_ = false;
};

/// Finds nodes of the whole lattice in the vectors of a slab. The number of a
/// node's component is its index in a vector of the whole lattice.
class SlabPlaces {
public:
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  SlabPlaces(const BoxLattice& lattice, const LatticeSlab& slab);

  int row_of(std::size_t node) const; ///< on the whole lattice

  /// The index in a vector of the slab, or nowhere; never an image.
  std::size_t of(std::size_t node) const;

  /// The number of a node of the contact surface in FaceContact, or nowhere.
  std::size_t on_face(std::size_t node) const;

private:
  NodeLayout whole_, own_;
  int first_; ///< row of nodes
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

/// Copies the displacements of the nodes at x = 0 and of the first row of nodes
/// (of the next rank) to their images.
template <class Number>
void write_images(const NodeLayout& layout, const LatticeSlab& slab,
                  Number* displacement);

/// Adds the forces on images to those of their nodes and sets them to zero.
template <class Number>
void fold_images(const NodeLayout& layout, const LatticeSlab& slab,
                 Number* force);

/// Numbers in [-0.5, 0.5) that do not depend on the division among ranks; zero
/// at images.
std::vector<float> random_displacement(const BoxLattice& lattice,
                                       const LatticeSlab& slab);

} // namespace asperity::fem
