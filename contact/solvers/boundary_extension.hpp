#pragma once

// Extends a residual from the active nodes across the contact boundary, and
// applies the transpose to the result, which makes the masked preconditioner
// efficient.

#include "base/ranks/workers.hpp"
#include "contact/solvers/extension_levels.hpp"
#include "contact/solvers/extension_rows.hpp"
#include "contact/solvers/node_blocks.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace asperity::contact {

/// The linear map E from a residual on the active nodes to a field on the grid.
/// It is the identity on the active nodes. On the inactive ones it is an
/// estimate of the residual there from that on the active ones, as if the
/// residual were a random field with the spectrum C(q), proportional to 1/q:
/// squares of 2 by 2 nodes are the cells of level 1, 2 by 2 cells of level l
/// those of level l + 1, until at most four remain per side, and the values of
/// the nodes in a cell, or of the cells in a larger one, differ from its value
/// independently of each other, by variances v_l = 2^-l. With r_0 the residual
/// and n_0 = 1 on the active nodes, both 0 elsewhere, and sums over the nodes
/// or cells in a cell, the values e_l are computed from the finest level to the
/// coarsest one and back:
///
///     n_1 = s sum n_0,            r_1 = s sum r_0
///     n_(l+1) = sum k_l n_l,      r_(l+1) = sum k_l r_l,
///     k_l = 1 / (1 + v_l n_l)                                        (R.1)
///     e_l = k_l (v_l r_l + interpolation of e_(l+1))
///
/// On inactive nodes, E r is the interpolation of e_1. The interpolation is
/// bilinear between the centres of the cells, on the continuation of the grid;
/// on the coarsest level it is 0. s <= 1 is the share of the
/// compliance of short waves in that of a node, which also has the compliance
/// of a penalty: the latter is noise of the nodes.
///
/// Reason: the inverse of C on the active nodes corresponds to the continuation
/// of the residual with the least energy, sum |r(q)|^2 / C(q), which is that
/// estimate (both are the mean of a Gaussian field under a condition).
/// F^-1 C^-1 F corresponds to the continuation by 0, whose jump at the contact
/// boundary has an energy that grows with contact size over grid spacing. With
/// E, the condition number was 1.2 on contacts of 512^2, 1024^2 and 2048^2
/// nodes, see docs/measurements/solver.md.
///
/// The calls are collective; fields have the nodes of this process.
class BoundaryExtension {
public:
  /// @param workers  whose ranks share the rows of the grid, if there are any
  /// @param continuation  mirrored only without ranks
  BoundaryExtension(const Grid& grid, const Workers& workers,
                    Continuation continuation = Continuation::periodic);

  /// Determines k_l. Required before the other calls.
  /// @param share    s in 0..1
  /// @param is_free  > 0 at the active nodes
  void build(double share, std::span<const std::uint8_t> is_free);

  /// The active nodes.
  struct Active {
    std::span<const std::uint8_t> is_free; ///< > 0 there
    const BlockFlags& blocks;              ///< those that contain some
  };

  /// extended = E residual.
  /// @param residual  0 at the inactive nodes
  /// @param extended  overwritten; may be `residual`
  void extend(const Active& active, std::span<const float> residual,
              std::span<float> extended);

  /// field = E^T field on the active nodes; elsewhere the result has no
  /// meaning.
  void fold(const Active& active, std::span<float> field);

private:
  /// Memory of a loop over rows.
  struct Scratch {
    std::vector<float> cells, row;
    std::vector<float> inactive; ///< four rows of nodes, row y at y modulo 4
    int last_inactive = -2;      ///< the last of them
  };

  /// s on the finest level.
  float scale_of(const ExtensionLevel& level) const {
    return &level == &levels_[0] ? share_ : 1.0F;
  }

  template <class DoRow>
  void each_row(const SharedRows& rows, const DoRow& do_row) const;
  template <class Value, class SumRow>
  void each_row_of_cells(const SharedRows& fine, const Value* nodes,
                         ExtensionLevel& level, const SumRow& sum_row) const;
  template <class Value, class SumRow>
  void sum_levels(const Value* nodes, const SumRow& sum_row);
  void interpolate(ExtensionLevel& level, std::size_t points, int iy,
                   std::vector<float>& scratch, float* fine) const;
  void fill_ghost_rows(ExtensionLevel& level) const;

  bool is_mirrored() const { return continuation_ == Continuation::mirrored; }
  template <class Row>
  void gather(const SharedRows& fine, const Row& row,
              ExtensionLevel& level) const;
  void swap_edges(const Active& active, std::span<const float> field);
  MaskedRow row_of(const Active& active, const float* field, int iy) const;
  const float* inactive_row(const Active& active, const float* field, int iy,
                            Scratch& scratch) const;
  void pass_down_to(std::size_t l, int iy);

  SharedRows rows_;
  int threads_;
  Continuation continuation_;
  float share_ = 1.0F; ///< s
  std::vector<ExtensionLevel> levels_;
  /// The first and the last row of this process between those of other ranks
  /// beside them, 0 at the active nodes; empty if there are no ranks.
  std::vector<float> edges_;
  std::vector<std::uint8_t> no_freedom_; ///< of such a row
};

} // namespace asperity::contact
