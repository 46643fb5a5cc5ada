#pragma once

// The condensed Q2 block as an operator for the contact solver.

#include "contact/operators/surface_operator.hpp"
#include "fem/waves/condensed_q2.hpp"
#include "fem/waves/q2_convolution.hpp"

#include <memory>
#include <vector>

namespace asperity::fem {

/// Computes displacement = C pressure on all nodes of a Q2 surface by
/// Q2Convolution. The nodal weights are the relative areas: 4/9, 8/9, 8/9, 16/9
/// at vertices, edges and face centres. If ranks share its rows, each holds its
/// rows of the fields and the blocks of its columns of cell wavevectors, and
/// the calls that transform fields are collective, also the construction.
class Q2Operator final : public contact::SurfaceOperator {
public:
  /// All rows in this process.
  /// @param threads  used by each transform, >= 1
  explicit Q2Operator(const Q2Compliance& compliance, int threads = 1);

  /// The rows of this rank.
  /// @param ranks    share the rows by row_bounds(); must outlive the operator
  ///                 and its clones
  /// @param blocks   of the grid of all nodes (condensed_column_q2)
  /// @param threads  used by each rank, >= 1
  Q2Operator(const Grid& grid, RankGroup& ranks, Q2Column blocks,
             int threads = 1);

protected:
  std::unique_ptr<contact::SurfaceOperator> do_clone() const override;
  void do_displacement(std::span<const double> pressure,
                       std::span<double> displacement) override;
  void do_displacement_change(std::span<const float> pressure_change,
                              std::span<float> displacement_change) override;
  void do_pressure_estimate(std::span<const float> gap, double local_compliance,
                            std::span<float> pressure) override;

  /// The operator on the vertices of the cells only, accurate for waves longer
  /// than a cell; null below 64 points per side, if the cells cannot be halved,
  /// or if ranks share the rows.
  std::unique_ptr<contact::SurfaceOperator> do_coarsened() const override;

private:
  struct Shared;
  explicit Q2Operator(std::shared_ptr<const Shared> shared);

  std::shared_ptr<const Shared> shared_;
  Q2Convolution<double> exact_;
  Q2Convolution<float> convolution_;
  double inverted_compliance_ = -1.0; ///< local compliance of inverse_ [m/Pa]
  std::vector<Q2Convolution<float>::Block> inverse_;
};

} // namespace asperity::fem
