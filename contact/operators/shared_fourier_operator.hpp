#pragma once

// This file contains the surface operator of a laterally homogeneous block
// whose rows of nodes are shared by several ranks.

#include "contact/operators/surface_operator.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "ranks/shared_convolution.hpp"

namespace asperity::contact {

/// C [m/Pa] at the wavevectors (jx, jy) of a grid with jy = 0..n-1, where n is
/// the length of the answer, at most points_y/2 + 1. C is even in jy. The value
/// at (0, 0) is not read. Threads call it at the same time.
using ComplianceColumn = std::function<void(int jx, std::span<double> of_jy)>;

/// The operator of FourierOperator with bitwise the same numbers on any number
/// of ranks. Each rank holds its rows of the fields and C(q) of its columns of
/// the spectrum. All calls but grid(), shared_rows(), short_wave_compliance()
/// and threads() are collective, also the construction.
class SharedFourierOperator final : public SurfaceOperator {
public:
  /// @param ranks       share the rows by row_bounds(); must outlive the
  ///                    operator and its clones
  /// @param compliance  C of the grid, > 0 and finite; each rank computes its
  ///                    columns
  /// @param threads     number used by each rank, >= 1
  /// @throws std::domain_error  a compliance is outside its range, or the grid
  ///                            has more ranks than most_ranks()
  SharedFourierOperator(const Grid& grid, RankGroup& ranks,
                        ComplianceColumn compliance, int threads = 1);

  /// The same for rows that hold whole groups of chunks (ranks/workers.hpp).
  SharedFourierOperator(SharedRows rows, ComplianceColumn compliance,
                        int threads);

  std::unique_ptr<SurfaceOperator> clone() const override;

  const Grid& grid() const override { return rows_->grid(); }

  const SharedRows* shared_rows() const override { return rows_.get(); }

  std::span<const double> nodal_weights() const override { return {}; }

  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override;
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override;
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override;
  double short_wave_compliance() const override;

  bool is_shift_invariant() const override { return true; }

  int threads() const override { return threads_; }

  /// The operator on half the points per side, as that of FourierOperator. It
  /// is shared if the ranks then hold whole groups of chunks (workers.hpp);
  /// otherwise each rank has the operator of all rows.
  std::unique_ptr<SurfaceOperator> coarsened() const override;

private:
  SharedFourierOperator(std::shared_ptr<const SharedRows> rows,
                        ComplianceColumn compliance, int threads);
  void find_symbols();
  /// C of the column jx with these jy >= 0, checked.
  void take_column(int jx, std::span<double> of_jy) const;
  /// @param jx  of a column of this rank
  double compliance_at(int jx, int jy) const;

  std::shared_ptr<const SharedRows> rows_;
  ComplianceColumn compliance_;
  int threads_;
  /// C(q) of the columns of this rank [m/Pa], jy = 0..points_y/2 of each.
  std::shared_ptr<const std::vector<double>> columns_;
  double softest_ = 0.0; ///< largest C(q) [m/Pa]
  SharedConvolution<double> exact_;
  SharedConvolution<float> convolution_;
  std::size_t first_column_; ///< of this rank
  std::shared_ptr<const SharedConvolution<float>::Symbol> symbol_;
  double inverted_compliance_ = -1.0; ///< local compliance in inverse_ [m/Pa]
  SharedConvolution<float>::Symbol inverse_;
};

} // namespace asperity::contact
