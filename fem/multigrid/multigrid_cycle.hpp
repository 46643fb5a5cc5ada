#pragma once

// The V-cycle of geometric multigrid in single precision, over the functions
// that are coarser than those of a mesh.

#include "fem/multigrid/box_grid.hpp"
#include "fem/multigrid/box_grid_slab.hpp"
#include "fem/multigrid/level_transfer.hpp"
#include "fem/multigrid/mesh_contact.hpp"
#include "fem/multigrid/smoothed_level.hpp"
#include "fem/multigrid/unknown_constraints.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace asperity::fem {

/// Factorises K + S of a small grid of boxes as a dense matrix in double
/// precision. Rigid motions that are not prevented are held by a matrix of
/// their own that does not change the solution under balanced forces.
class CoarsestBoxGrid {
public:
  explicit CoarsestBoxGrid(const BoxGrid& box_grid);
  ~CoarsestBoxGrid();

  void set_contact(const MeshContact& contact);

  /// Computes `displacement` from `force`.
  void solve();

  std::vector<float> force;        ///< on the grid of boxes
  std::vector<float> displacement; ///< zero at images

  std::size_t bytes() const;

private:
  struct Factors;
  void assemble();

  BoxGrid box_grid_;
  NodeLayout layout_;
  SharedConstraints constraints_;
  std::vector<std::size_t> places_;  ///< in a vector, of each row
  std::vector<std::size_t> numbers_; ///< of each place its row
  std::unique_ptr<Factors> factors_;
};

/// Approximates (K + S)^-1 for the residual of a mesh by coarser and coarser
/// functions, where S are the springs of contact and held unknowns are left
/// out: each level smooths before and after the correction by the next, and a
/// small grid of boxes is solved exactly. Together with the smoother of the
/// mesh it is symmetric and positive up to rounding. All calls are collective.
class MultigridCycle {
public:
  /// Appends a level.
  /// @param transfer  from the level before, or from the mesh, to this one
  void add_level(std::unique_ptr<LevelTransfer> transfer,
                 std::unique_ptr<SmoothedLevel> level);

  /// Appends a grid of boxes and coarser ones, of which the coarsest is solved
  /// by every rank. Nothing may be appended afterwards.
  /// @param transfer  from the level before, or from the mesh, to this one
  /// @param grid of boxes   in units in which its stiffness fits into a float
  /// @param slab      the rows of this rank, which may be shared only if the
  ///                  grid of boxes has coarser ones
  void add_box_grids(std::unique_ptr<LevelTransfer> transfer, BoxGrid box_grid,
                     BoxGridSlab slab);

  /// Transfers contact to all levels and factorises the coarsest grid of boxes.
  /// @param contact  of the mesh, springs in the unit of the stiffness
  void set_contact(const MeshContact& contact);

  /// Adds the correction for a residual, both over the unknowns of the mesh.
  void add_correction(const std::vector<float>& residual,
                      std::vector<float>& displacement) {
    add_correction(0, residual, displacement);
  }

  /// Number of levels, with the coarsest grid of boxes.
  std::size_t levels() const { return transfers_.size(); }

  std::size_t bytes() const;

private:
  void add_correction(std::size_t level, const std::vector<float>& residual,
                      std::vector<float>& displacement);
  void run(std::size_t level);

  /// transfers_[i] leads to level i, or to the coarsest grid of boxes.
  std::vector<std::unique_ptr<LevelTransfer>> transfers_;
  std::vector<std::unique_ptr<SmoothedLevel>> levels_;
  std::unique_ptr<CoarsestBoxGrid> coarsest_;
};

/// The slab of the grid of boxes that coarser() makes; all rows if that is
/// solved exactly.
BoxGridSlab next_slab(const BoxGrid& box_grid, const BoxGridSlab& slab,
                      const BoxGrid& next);

} // namespace asperity::fem
