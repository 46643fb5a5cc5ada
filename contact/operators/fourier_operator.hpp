#pragma once

// The surface operator of a laterally homogeneous block: a convolution with one
// real compliance per wavevector.

#include "contact/operators/even_symbol.hpp"
#include "contact/operators/inverse_symbol.hpp"
#include "contact/operators/surface_operator.hpp"
#include "ranks/convolution.hpp"

#include <memory>
#include <vector>

namespace asperity::contact {

/// The operator displacement(q) = C(q) pressure(q), used for the half-space,
/// the elastic slab and the condensed linear finite-element block. C is even in
/// q_x and q_y.
///
/// If ranks share the rows, each holds its rows of the fields and C(q) of its
/// columns of the spectrum. All calls but grid(), shared_rows(),
/// short_wave_compliance() and threads() are then collective, also the
/// construction; there are no operators on coarser grids or tiles.
class FourierOperator final : public SurfaceOperator {
public:
  /// All rows in this process.
  /// @param compliance  C [m/Pa] of the grid, > 0 and finite; the value at (0,
  /// 0)
  ///                    is not read
  /// @param threads     number used by each application, >= 1; the result does
  ///                    not depend on it
  /// @throws std::domain_error  a compliance is outside its range
  FourierOperator(const Grid& grid, const EvenColumn& compliance,
                  int threads = 1);

  /// All rows in this process, and known values.
  /// @param compliance  grid.half_spectrum_size() values in the order of
  ///                    Grid::half_spectrum_size; those of jy > points_y/2 are
  ///                    not read
  /// @throws std::domain_error  also if the array has the wrong size
  FourierOperator(const Grid& grid, const std::vector<double>& compliance,
                  int threads = 1);

  /// The rows of this rank.
  /// @param ranks    share the rows by row_bounds(); must outlive the operator
  ///                 and its clones
  /// @param threads  number used by each rank, >= 1
  FourierOperator(const Grid& grid, RankGroup& ranks,
                  const EvenColumn& compliance, int threads = 1);

  std::unique_ptr<SurfaceOperator> clone() const override;

  const Grid& grid() const override;
  const SharedRows* shared_rows() const override;

  std::span<const double> nodal_weights() const override { return {}; }

  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override;
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override;
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override;

  bool has_inverse() const override { return true; }

  void pressure_of(std::span<const double> displacement,
                   std::span<double> pressure) override;
  double short_wave_compliance() const override;

  bool is_shift_invariant() const override { return true; }

  int threads() const override { return convolution_.threads(); }

  /// The operator on half the points per side, which keeps C(q) of the
  /// wavevectors that the coarse grid resolves. Null if the number of points is
  /// odd or the coarse grid would have fewer than 32 points per side.
  std::unique_ptr<SurfaceOperator> coarsened() const override;

  /// See tile_operator.hpp. Null if the grid has no tiles.
  std::unique_ptr<SurfaceOperator> on_tiles(const Tiles& tiles) const override;

private:
  struct Shared; // immutable: transforms and symbol, shared by all clones
  FourierOperator(SharedRows rows, const EvenColumn& compliance, int threads);
  explicit FourierOperator(std::shared_ptr<const Shared> shared);

  std::shared_ptr<const Shared> shared_;
  Convolution<double> exact_;
  Convolution<float> convolution_;
  InverseSymbol inverse_;
};

} // namespace asperity::contact
