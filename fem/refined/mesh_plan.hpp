#pragma once

// What a mesh of boxes becomes if some of its cells refine and others merge.
// Does not depend on deal.II; every rank makes the same plan.

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace asperity::fem {

/// What is to become of a cell.
enum class CellChange : char { none, refine, coarsen };

/// The number of cells that a mesh change refines and coarsens.
struct ChangedCells {
  std::size_t refined = 0;
  std::size_t coarsened = 0; ///< cells that vanish, eight per new one
};

/// A box that has been halved `level` times from a coarsest one.
struct BoxCell {
  int level = 0; ///< 0..15
  /// Number of cells of this level before it along x, y and z, below 2^20.
  std::array<int, 3> place{};

  std::uint64_t key() const;
};

/// The mesh after a change, in which two cells that share a vertex differ by
/// one level at most, as they must before. All cells that are to refine do,
/// others refine for this rule, and as many of those that are to merge do as it
/// permits: all eight of a parent, or none. With periodic sides both cells at a
/// pair of opposite faces change alike. The plan is unique, so that it depends
/// on no order of the cells.
class MeshPlan {
public:
  /// A cell of the mesh and what is to become of it.
  struct Wish {
    BoxCell cell;
    CellChange change = CellChange::none;
  };

  /// @param coarsest     number of coarsest cells along x, y and z
  /// @param is_periodic  along x and y
  /// @param cells        all of the mesh, in any order
  MeshPlan(const std::array<int, 3>& coarsest, bool is_periodic,
           const std::vector<Wish>& cells);

  /// What becomes of a cell, of the mesh or of a coarser one that covers cells
  /// of the mesh: the latter refines if something in it stays finer.
  CellChange change_of(const BoxCell& cell) const;

  const ChangedCells& count() const { return count_; }

  std::size_t cells_before() const { return leaves_.size(); }

  /// Number of cells after the change.
  std::size_t cells_after() const {
    return leaves_.size() + 7 * count_.refined - count_.coarsened / 8 * 7;
  }

private:
  bool is_periodic_;
  std::array<int, 3> coarsest_;
  /// The cells, by key, and whether each refines.
  std::unordered_map<std::uint64_t, bool> leaves_;
  std::unordered_set<std::uint64_t> inner_;   ///< cells that have been halved
  std::unordered_set<std::uint64_t> merging_; ///< parents whose cells merge
  ChangedCells count_;

  std::array<int, 3> extent(int level) const;
  std::vector<BoxCell> partners(const BoxCell& cell) const;
  void refine(std::vector<BoxCell> cells);
  void merge(std::vector<BoxCell> parents);
  bool may_merge(const BoxCell& parent) const;
};

} // namespace asperity::fem
