#pragma once

// The surface operator of a laterally homogeneous block: a convolution with one
// real compliance per wavevector, periodic or with free boundaries.

#include "base/ranks/convolution.hpp"
#include "contact/operators/even_symbol.hpp"
#include "contact/operators/surface_operator.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace asperity::contact {

/// Twice the points and lengths in both directions: the grid of the convolution
/// without periodic images.
Grid padded_grid(const Grid& grid);

/// A quarter more points and lengths in both directions, for the preconditioner
/// with free boundaries. That of a coarse grid is the coarse one of this.
Grid grid_with_margin(const Grid& grid);

/// The operator displacement(q) = C(q) pressure(q), used for the half-space,
/// the elastic slab and the condensed linear finite-element block. C is even in
/// q_x and q_y. With free boundaries it is the convolution without periodic
/// images on padded_grid(), and its preconditioner that on grid_with_margin().
///
/// If ranks share the rows, each holds its rows of the fields and C(q) of its
/// columns of the spectrum. The calls that transform fields are then
/// collective, also the construction; there are no operators on coarser grids
/// or tiles.
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

  /// The displacement by a unit pressure on the cell of a node of a grid
  /// [m/Pa], on the periodic continuation of that grid.
  using FreeKernel = std::function<EvenSymbol::KernelRow(const Grid&)>;

  /// With free boundaries, all rows in this process.
  FourierOperator(const Grid& grid, const FreeKernel& kernel, int threads);

protected:
  std::unique_ptr<SurfaceOperator> do_clone() const override;
  void do_displacement(std::span<const double> pressure,
                       std::span<double> displacement) override;
  void do_displacement_change(std::span<const float> pressure_change,
                              std::span<float> displacement_change) override;
  void do_pressure_estimate(std::span<const float> gap, double local_compliance,
                            std::span<float> pressure) override;
  void do_pressure_of(std::span<const double> displacement,
                      std::span<double> pressure) override;
  std::unique_ptr<SurfaceOperator> do_periodic_extension() const override;

  /// See mirrored_operator.hpp. Null if a number of points is odd.
  std::unique_ptr<SurfaceOperator> do_mirrored() const override;

  /// The operator on half the points per side, which keeps C(q) of the
  /// wavevectors that the coarse grid resolves. Null if the number of points is
  /// odd or the coarse grid would have fewer than 32 points per side.
  std::unique_ptr<SurfaceOperator> do_coarsened() const override;

  /// See tile_operator.hpp. Null if the grid has no tiles.
  std::unique_ptr<SurfaceOperator>
  do_on_tiles(const Tiles& tiles) const override;

private:
  struct Shared; // immutable: transforms and symbol, shared by all clones
  FourierOperator(const SharedRows& rows, const EvenColumn& compliance,
                  int threads);
  explicit FourierOperator(std::shared_ptr<const Shared> shared);

  std::shared_ptr<const Shared> shared_;
  Convolution<double> exact_;
  Convolution<float> convolution_;
  std::optional<Convolution<float>> wide_convolution_; ///< free boundaries
};

} // namespace asperity::contact
