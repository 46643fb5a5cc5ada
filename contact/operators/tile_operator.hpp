#pragma once

// The displacement of some squares of a grid by the pressure in them, for
// contact that covers a small part of the surface.

#include "base/ranks/convolution.hpp"
#include "contact/operators/even_symbol.hpp"
#include "contact/operators/surface_operator.hpp"
#include "contact/operators/tiles.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace asperity::contact {

/// An approximation of an operator with a C(q) between the nodes of some tiles,
/// whose work grows with their number and not with the grid. C(q) is divided
/// into two positive parts (Ewald's method with a plane of charges),
///
///     C(q) = C(q) erf(q s / sqrt 2) + C(q) erfc(q s / sqrt 2),
///
/// with s = 7 spacings. On a half-space, the kernel of the first part is
/// proportional to erfc(r / (sqrt 2 s)) / r, 4e-6 of 1/r at r = half a tile: it
/// is a convolution on a window of twice the side around each tile. The second
/// part is applied on every fourth node of the whole grid, to which pressures
/// are spread, and from which displacements are interpolated, by cubic
/// B-splines. Its C(q) is divided by their transforms (U. Essmann et al., J.
/// Chem. Phys. 103, 8577 (1995)).
///
/// The grid is that of the tiles one below the other.
/// The mean of the displacement is arbitrary, so that only loads can be
/// prescribed.
///
/// @par Accuracy  On a half-space, the displacements differ from those of the
///            whole surface by 3e-5 of the largest and a constant. On a slab
///            of few spacings the difference is larger.
class TileOperator final : public SurfaceOperator {
public:
  /// What the operators of all tiles of a grid share; immutable.
  struct Symbols;

  /// Makes the operator of a whole periodic grid by its C(q) [m/Pa].
  using WholeGrid = std::unique_ptr<SurfaceOperator> (*)(
      const Grid& grid, const EvenColumn& compliance, int threads);

  /// @param compliance  C(q) [m/Pa] of the grid of the nodes, or with free
  ///                    boundaries of one of twice the points and lengths,
  ///                    whose first columns and rows are the nodes; spacings
  ///                    equal, points a multiple of 128
  /// @param short_wave  see SurfaceOperator
  /// @param whole       for the coarse nodes
  static std::shared_ptr<const Symbols> symbols(const EvenSymbol& compliance,
                                                double short_wave, int threads,
                                                WholeGrid whole);

  TileOperator(const std::shared_ptr<const Symbols>& symbols, Tiles tiles);

protected:
  std::unique_ptr<SurfaceOperator> do_clone() const override;
  void do_displacement(std::span<const double> pressure,
                       std::span<double> displacement) override;
  void do_displacement_change(std::span<const float> pressure_change,
                              std::span<float> displacement_change) override;

  /// By a convolution in the window of each tile, in which other tiles have no
  /// gap.
  void do_pressure_estimate(std::span<const float> gap, double local_compliance,
                            std::span<float> pressure) override;

private:
  template <class Real>
  using Windows = std::vector<Convolution<Real>>; ///< one per thread

  template <class Real>
  void displace(std::span<const Real> pressure,
                const typename Convolution<Real>::Symbol& symbol,
                Windows<Real>& windows, std::span<Real> displacement);
  template <class Real>
  void convolve(std::span<const Real> field,
                const typename Convolution<Real>::Symbol& symbol,
                Windows<Real>& windows, std::span<Real> answer);
  template <class Real>
  std::vector<Real> spread(std::span<const Real> field) const;
  template <class Real>
  void interpolate(const std::vector<Real>& coarse,
                   std::span<Real> field) const;
  template <class Real>
  void fill_window(std::span<const Real> field, std::size_t slot,
                   std::span<Real> window) const;

  std::shared_ptr<const Symbols> symbols_;
  Tiles tiles_;
  /// The places of the tiles around each tile, row by row; -1: not there.
  std::vector<std::array<int, 9>> around_;
  std::unique_ptr<SurfaceOperator> smooth_; ///< on the coarse nodes
  Windows<float> windows_;
  Windows<double> exact_windows_;
};

} // namespace asperity::contact
