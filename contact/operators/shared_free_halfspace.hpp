#pragma once

// This file contains the half-space with free boundaries whose rows of nodes
// are shared by several ranks.

#include "contact/operators/inverse_symbol.hpp"
#include "contact/operators/surface_operator.hpp"

#include <memory>
#include <span>

#include "ranks/shared_convolution.hpp"

namespace asperity::contact {

/// The operator of FreeHalfspace with bitwise the same numbers on any number of
/// ranks. Each rank holds its rows of the fields, its rows of the wide grid,
/// and the columns of both symbols that it multiplies. The rows of zeros around
/// the grid are neither held nor sent. All calls but grid(), wide_grid(),
/// shared_rows(), wide_shared_rows(), short_wave_compliance() and threads() are
/// collective, also the construction.
class SharedFreeHalfspace final : public SurfaceOperator {
public:
  /// @param ranks            share the rows by row_bounds(); must outlive the
  ///                         operator and its clones
  /// @param contact_modulus  E* [Pa] > 0
  /// @param threads          number used by each rank, >= 1
  /// @throws std::domain_error  an argument is outside its range, or the grid
  ///                            has more ranks than most_ranks()
  SharedFreeHalfspace(const Grid& grid, RankGroup& ranks,
                      double contact_modulus, int threads = 1);

  std::unique_ptr<SurfaceOperator> clone() const override;

  const Grid& grid() const override { return rows_->own.grid(); }

  const SharedRows* shared_rows() const override { return &rows_->own; }

  bool is_periodic() const override { return false; }

  std::span<const double> nodal_weights() const override { return {}; }

  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override;
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override;
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override;

  const Grid& wide_grid() const override { return rows_->wide.grid(); }

  const SharedRows* wide_shared_rows() const override { return &rows_->wide; }

  void wide_pressure_estimate(std::span<const float> gap,
                              double local_compliance,
                              std::span<float> pressure) override;

  double short_wave_compliance() const override { return symbols_->short_wave; }

  int threads() const override { return exact_.threads(); }

  /// The operator on half the points per side, as that of FreeHalfspace. It is
  /// shared if the ranks then hold whole groups of chunks (workers.hpp);
  /// otherwise each rank has the operator of all rows.
  std::unique_ptr<SurfaceOperator> coarsened() const override;

private:
  /// The rows of the grid and of the wide grid.
  struct Rows {
    SharedRows own, wide;
  };

  /// Symbols of the columns of this rank [m/Pa] > 0.
  struct Symbols {
    EvenSymbol compliance, wide_compliance;
    double short_wave; ///< C at half the Nyquist wavevector [m/Pa]
    SharedConvolution<float>::Symbol symbol; ///< of `compliance`
  };

  /// Without symbols.
  SharedFreeHalfspace(std::shared_ptr<const Rows> rows, int threads);
  void keep(EvenSymbol compliance, EvenSymbol wide_compliance);

  RankGroup& ranks() const { return *rows_->own.ranks(); }

  std::shared_ptr<const Rows> rows_;
  SharedConvolution<double> exact_;
  SharedConvolution<float> convolution_, wide_convolution_;
  std::shared_ptr<const Symbols> symbols_;
  InverseSymbol<SharedConvolution<float>> inverse_, wide_inverse_;
};

} // namespace asperity::contact
