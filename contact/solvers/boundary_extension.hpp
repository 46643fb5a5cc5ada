#pragma once

// This file extends a residual from the active nodes across the contact
// boundary, and applies the transpose to the result, which makes the masked
// preconditioner efficient.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ranks/workers.hpp"

namespace asperity::contact {

/// The linear map E from a residual on the active nodes to a field on the grid.
/// It is the identity on the active nodes. Cells of 2, 4 and 8 nodes per side,
/// the levels 1, 2 and 3, hold the mean of the residual over their active
/// nodes. Cells without an active node, and inactive nodes, take
///
///     e_l = share gain_l (interpolation of e_(l+1))                    (R.1)
///
/// where the interpolation is bilinear between the centres of the cells; on
/// level 3 they take 0. The grid is continued periodically.
///
/// Reason: the inverse of C on the active nodes corresponds to the continuation
/// of the residual with the least energy. F^-1 C^-1 F corresponds to the
/// continuation by 0, whose jump at the contact boundary has an energy that
/// grows with the logarithm of contact size over grid spacing. The least energy
/// has a continuation that decays over the length on which the residual varies,
/// short waves sooner than long ones, and a mean over a large cell contains
/// only the latter.
///
/// All calls are collective; fields have the nodes of this process.
class BoundaryExtension {
public:
  static constexpr std::size_t levels = 3;

  /// Of nodes, and of cells of levels 1 and 2: measured, see
  /// docs/numerics/solver-measurements.md.
  static constexpr std::array<float, levels> gains{0.85F, 0.75F, 0.65F};

  /// @param workers  whose ranks share the rows of the grid, if there are any
  BoundaryExtension(const Grid& grid, const Workers& workers);

  /// Counts the active nodes of each cell, those with is_free[i] > 0.
  void build(std::span<const std::uint8_t> is_free);

  /// extended = E residual.
  /// @param residual  0 at the inactive nodes
  /// @param extended  overwritten; not `residual`
  void extend(double share, std::span<const std::uint8_t> is_free,
              std::span<const float> residual, std::span<float> extended);

  /// field = E^T field on the active nodes; elsewhere the result has no
  /// meaning.
  void fold(double share, std::span<const std::uint8_t> is_free,
            std::span<float> field);

private:
  /// The cells of one level. Arrays with ghost rows begin with the row before
  /// those of this process.
  struct Level {
    explicit Level(const SharedRows& rows_);

    SharedRows rows;
    std::vector<float> inverse; ///< 1 / active nodes, 0 if there are none
    std::vector<float> values;  ///< with ghost rows
    std::vector<float> outside; ///< with ghost rows; 0 where a cell has nodes

    float* row(std::vector<float>& field, int iy) const {
      return field.data() + static_cast<std::size_t>(iy + 1) * rows.width();
    }
  };

  template <class DoRow>
  void each_row(const SharedRows& rows, const DoRow& do_row) const;
  template <class Value>
  void sum_cells(const SharedRows& fine, const Value* nodes,
                 const SharedRows& cells, float* sums) const;
  void interpolate(std::size_t coarse, double share, int iy,
                   std::vector<float>& scratch, float* fine);
  void gather(std::size_t coarse, double share, const SharedRows& fine_rows,
              const std::vector<float>& outside);

  SharedRows rows_;
  int threads_;
  std::vector<Level> levels_;
  std::vector<float> outside_; ///< with ghost rows; 0 at the active nodes
};

} // namespace asperity::contact
